//! Pairs of rounded meshes, or of an exact and a rounded one: what the boxes allow.

use isogeo::check::{Answer, Decide, Decider, Element, Report, Verdict as Found};
use isogeo::construct::*;
use isogeo::mesh::{Mesh, VertexId};
use isogeo::pair::*;
use isogeo::scalar::{Numeral, Rational, RationalField, Ring};
use isogeo::space::Point;
use proptest::prelude::*;

use super::properties::{definition, edges_at};
use super::*;
use crate::meshes::combinatorics;
use crate::nets::printed;

laws! {
    in 24 cases:
    boxes_never_refute_what_was_exact
    what_fails_in_a_box_fails_before_printing
}

/// M exact, S printed.
fn mixed<Q: RationalField>(
    m: &Mesh<Q>,
    s: &Mesh<Numeral>,
    property: PairProperty,
) -> Report<Rational> {
    let m = m.map(Q::convert::<Rational>);
    let decider = Decider::of_rationals(&m.points).followed_by(Decider::over_boxes(&s.points));
    Couple::new(&m.topology, &s.topology, &decider).unwrap().check(property)
}

/// Both printed.
fn boxed(m: &Mesh<Numeral>, s: &Mesh<Numeral>, property: PairProperty) -> Report<Rational> {
    let decider = Decider::over_boxes(&m.points).followed_by(Decider::over_boxes(&s.points));
    Couple::new(&m.topology, &s.topology, &decider).unwrap().check(property)
}

fn boxes_never_refute_what_was_exact<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let pair = inscribed_f_parallel(&m, VertexId(4), &draw.top_view()).unwrap();
    let digits = 2 + draw.index(12) as u32;
    let homothetic = m.map(|c| c * &q(2, 7));
    for s in [pair.into_image(), lift(&m), homothetic] {
        let print = |mesh: &Mesh<Q>| mesh.map(|x| printed(&x.convert(), digits));
        let (rounded, image) = (print(&m), print(&s));
        for property in PairProperty::ALL {
            if definition(&m, &s, property).verdict() != Found::Proved {
                continue;
            }
            for report in [mixed(&m, &image, property), boxed(&rounded, &image, property)] {
                prop_assert!(report.failures.is_empty(), "{} at {digits}", property.name());
            }
        }
    }
    // The control: 10⁶ units of the last digit.
    let mut s = m.clone();
    s.points[4].z += &(Q::from_i64(1_000_000) / Q::from_i64(10i64.pow(digits)));
    let image = s.map(|x| printed(&x.convert(), digits));
    prop_assert_eq!(mixed(&m, &image, PairProperty::FParallel).verdict(), Found::Refuted);
    prop_assert_eq!(mixed(&m, &image, PairProperty::Parallel).failures, edges_at(&m, VertexId(4)));
    Ok(())
}

/// The numbers before printing are in the box of the printed ones.
fn what_fails_in_a_box_fails_before_printing<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    for (count, faces) in combinatorics() {
        let m = Mesh::new((0..count).map(|_| draw.point()).collect(), faces).unwrap();
        let mut s = m.clone();
        for _ in 0..draw.index(3) {
            s.points[draw.index(count)] = draw.point();
        }
        let digits = draw.index(3) as u32;
        let print = |mesh: &Mesh<Q>| mesh.map(|x| printed(&x.convert(), digits));
        let (rounded, image) = (print(&m), print(&s));
        for property in PairProperty::ALL {
            if matches!(property, PairProperty::Cmc | PairProperty::ConstantK) {
                // The face to compare with may be another one.
                continue;
            }
            let exact = definition(&m, &s, property);
            let undefined = |e: &Element| exact.undefined.iter().any(|(u, _)| u == e);
            for report in [mixed(&m, &image, property), boxed(&rounded, &image, property)] {
                for failure in &report.failures {
                    let fails = exact.failures.contains(failure) || undefined(failure);
                    prop_assert!(fails, "{} at {}", property.name(), failure);
                }
            }
        }
    }
    Ok(())
}

/// Beside a rounded mesh an exact one stays exact, whatever its numbers.
#[test]
fn exact_points_have_no_box() {
    let huge = (0..40).fold(Rational::one(), |x, _| x * Rational::from_i64(1 << 40));
    let tiny = Rational::one() / &huge;
    let at = |z: Rational| Point::new(Rational::zero(), Rational::zero(), z);
    let exact = [at(tiny.clone()), at(tiny + &huge)];
    let printed = [Point::new(0, 0, 0).map(|&n: &i64| Numeral::from_i64(n))];
    let decider = Decider::of_rationals(&exact).followed_by(Decider::over_boxes(&printed));
    let difference = isogeo::net::planar::Difference(2);
    assert_eq!(decider.decide(difference, [VertexId(0), VertexId(1)]), Answer::Nonzero);
    assert_eq!(decider.decide(difference, [VertexId(0), VertexId(2)]), Answer::InBox);
}
