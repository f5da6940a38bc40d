//! The fast exact decider finds what the definition does, evaluated in either exact scalar, on what is
//! made by construction and on what is nearly that.

use num_bigint::BigInt;
use num_integer::Integer;
use proptest::prelude::*;

use super::{accepted, check};
use crate::campaign::law::{Law, drawn};
use crate::check::{Decide, Decider, Element, Plain, Reason, Report, Verdict};
use crate::claim::Run;
use crate::construct::minimal::MeshPair;
use crate::mesh::{Mesh, VertexId};
use crate::net::{Net, Property, RADIUS};
use crate::pair::{Couple, PairProperty};
use crate::scalar::{BigRational, Numeral, Rational, RationalField, Ring};
use crate::space::Point;
use crate::strategy::{
    any_mesh, circular, conical, delaunay_graph, f_parallel, i_minimal, jittered, koebe, lattice,
    near_degenerate, number, polygons, quad_patches, small, star, v_parallel,
};

/// Whether the definition is evaluated in the second exact scalar, which is much slower.
fn second() -> impl Strategy<Value = bool> {
    prop::bool::weighted(0.125)
}

/// Everything but the choice of the worst element, which is made by rounded numbers.
type Findings = (Verdict, [usize; 4], Vec<Element>, Vec<(Element, Reason)>);

fn findings<V>(report: Report<V>) -> Findings {
    let counts = [report.checked, report.trivial, report.consistent, report.undecided];
    (report.verdict(), counts, report.failures, report.undefined)
}

/// What the decider finds.
pub(super) fn decided(mesh: &Mesh<Rational>, property: Property) -> Report<Rational> {
    Net::new(&mesh.topology, &Decider::of_rationals(&mesh.points)).check(property)
}

/// The points of a mesh, followed by its radii if it has some, and the number of vertices.
fn with_radii(mesh: &Mesh<Rational>) -> (Vec<Point<Rational>>, Option<VertexId>) {
    let mut points = mesh.points.clone();
    let Some(radii) = mesh.data.vertex.get(RADIUS) else { return (points, None) };
    let zero = Rational::zero;
    points.extend(radii.iter().map(|radius| Point::new(radius.clone(), zero(), zero())));
    (points, Some(VertexId(mesh.points.len() as u32)))
}

fn net<'a, D: Decide>(
    mesh: &'a Mesh<Rational>,
    decider: &'a D,
    radii: Option<VertexId>,
) -> Net<'a, D> {
    let net = Net::new(&mesh.topology, decider);
    match radii {
        Some(first) => net.with_radii(first),
        None => net,
    }
}

fn agree((mesh, second): &(Mesh<Rational>, bool)) -> Run {
    let (points, radii) = with_radii(mesh);
    let decider = Decider::of_rationals(&points);
    let fast = net(mesh, &decider, radii);
    let compare = |property: Property, slow: Findings| {
        let fast = findings(fast.check(property));
        check(fast == slow, || format!("{}: {fast:?}, by definition {slow:?}", property.name()))
    };
    if *second {
        let points: Vec<_> =
            points.iter().map(|p| p.map(Rational::convert::<BigRational>)).collect();
        let plain = Plain(&points);
        let slow = net(mesh, &plain, radii);
        Property::ALL.into_iter().try_for_each(|p| compare(p, findings(slow.check(p))))
    } else {
        let plain = Plain(&points);
        let slow = net(mesh, &plain, radii);
        Property::ALL.into_iter().try_for_each(|p| compare(p, findings(slow.check(p))))
    }
}

type Pair = (Mesh<Rational>, Mesh<Rational>, bool);

fn agree_on_pairs((m, s, second): &Pair) -> Run {
    let compare = |property: PairProperty, slow: Findings| {
        let [first, image] = [m, s].map(|mesh| Decider::of_rationals(&mesh.points));
        let decider = first.followed_by(image);
        let couple = accepted("a couple", Couple::new(&m.topology, &s.topology, &decider))?;
        let fast = findings(couple.check(property));
        check(fast == slow, || format!("{}: {fast:?}, by definition {slow:?}", property.name()))
    };
    let points = [m.points.as_slice(), &s.points].concat();
    if *second {
        let points: Vec<_> =
            points.iter().map(|p| p.map(Rational::convert::<BigRational>)).collect();
        let plain = Plain(&points);
        let slow = accepted("a couple", Couple::new(&m.topology, &s.topology, &plain))?;
        PairProperty::ALL.into_iter().try_for_each(|p| compare(p, findings(slow.check(p))))
    } else {
        let plain = Plain(&points);
        let slow = accepted("a couple", Couple::new(&m.topology, &s.topology, &plain))?;
        PairProperty::ALL.into_iter().try_for_each(|p| compare(p, findings(slow.check(p))))
    }
}

/// Pairs of all kinds, of which either mesh may be nearly degenerate.
fn pairs() -> impl Strategy<Value = Pair> {
    let made = prop_oneof![f_parallel(), v_parallel(), i_minimal()];
    made.prop_flat_map(|MeshPair { surface, gauss }| {
        (near_degenerate(Just(surface)), near_degenerate(Just(gauss)), second())
    })
}

/// A number as it is printed with so many decimals.
fn printed(number: &Rational, digits: u8) -> Numeral {
    let unit = BigInt::from(10).pow(digits.into());
    let twice: BigInt = number.numerator() * &unit * 2 + number.denominator();
    let text = format!("{}e-{digits}", twice.div_floor(&(number.denominator() * 2)));
    // Digits with an exponent are a decimal; were they none, 0 would be refused by the law.
    text.parse().unwrap_or_else(|_| Numeral::from_i64(0))
}

/// What is certain in the boxes of printed digits is so for the numbers before they were printed.
fn boxes((mesh, digits): &(Mesh<Rational>, u8)) -> Run {
    let rounded = mesh.map(|number| printed(number, *digits));
    let decider = Decider::over_boxes(&rounded.points);
    let net = Net::new(&mesh.topology, &decider);
    for property in Property::ALL {
        let (exact, within) = (decided(mesh, property), net.check(property));
        // That no joint choice exists is a failure of the mesh; elsewhere in the box another element
        // may be the first to show it.
        let joint = property == Property::EdgeOffset
            && !(exact.failures.is_empty() && exact.undefined.is_empty());
        let wrong = within.failures.iter().find(|&failure| {
            let undefined = exact.undefined.iter().any(|(element, _)| element == failure);
            !(undefined || joint || exact.failures.contains(failure))
        });
        if let Some(element) = wrong {
            let why = format!("{} fails in the box of {element}, not on the mesh", property.name());
            return check(false, || why);
        }
    }
    Ok(())
}

/// The law for one kind of mesh.
macro_rules! law {
    ($id:literal, $of:literal, $meshes:expr) => {
        Law {
            id: $id,
            says: concat!("the decider finds what the definition does on ", $of),
            control: false,
            cases: || drawn((near_degenerate($meshes), second()), agree),
        }
    };
}

pub(super) const LAWS: &[Law] = &[
    law!("decider-any", "any mesh", prop_oneof![any_mesh(small()), any_mesh(number())]),
    law!("decider-planar", "planar meshes and near them", prop_oneof![quad_patches(), polygons()]),
    law!("decider-i-circular", "i-circular meshes and near them", circular()),
    law!("decider-i-conical", "i-conical meshes and near them", conical()),
    law!("decider-koebe", "i-Koebe meshes with radii and near them", koebe()),
    law!(
        "decider-triangles",
        "triangle meshes and near them",
        prop_oneof![star(), lattice(), jittered(), delaunay_graph()]
    ),
    Law {
        id: "decider-pairs",
        says: "the decider finds what the definition does on pairs of meshes and near them",
        control: false,
        cases: || drawn(pairs(), agree_on_pairs),
    },
    Law {
        id: "boxes",
        says: "what is refuted in the boxes of printed digits is so before they are printed",
        control: false,
        cases: || {
            let made = prop_oneof![circular(), conical(), koebe(), any_mesh(small())];
            drawn((near_degenerate(made), 1u8..=9), boxes)
        },
    },
];
