//! Classes of mesh: the fast decider against the definition, invariance, boxes, controls.

use isogeo::check::{Answer, Decide, Decider, Element, Plain, Reason, Report, Residual, Verdict};
use isogeo::mesh::{FaceId, Mesh, VertexId};
use isogeo::net::euclidean::ConcyclicNormals;
use isogeo::net::i_circular::Concyclic;
use isogeo::net::i_conical::{Balance, ConcyclicGradients};
use isogeo::net::planar::{Coplanar, ProjectedArea};
use isogeo::net::scribed::{EdgeTouchesSigma, OnSigma, TouchesSigma};
use isogeo::net::{Net, Property};
use isogeo::scalar::{Base, Field, Numeral, Ordered, Rational, RationalField, Ring, Sign};
use isogeo::space::{Point, Transform};
use isogeo::strategy::{motion, scaling};
use proptest::prelude::*;
use rayon::prelude::*;

use crate::meshes::{Q, any_mesh, circular, fraction, relabelled, small, translational};

fn fast(mesh: &Mesh<Q>, property: Property) -> Report<Rational> {
    let mesh = mesh.map(Q::convert::<Rational>);
    Net::new(&mesh.topology, &Decider::of_rationals(&mesh.points)).check(property)
}

fn verdict(mesh: &Mesh<Q>, property: Property) -> Verdict {
    fast(mesh, property).verdict()
}

/// Everything but the choice of the worst element, which is made by rounded numbers.
pub type Findings = (Verdict, [usize; 4], Vec<Element>, Vec<(Element, Reason)>);

pub fn findings<V>(report: &Report<V>) -> Findings {
    (
        report.verdict(),
        [report.checked, report.trivial, report.consistent, report.undecided],
        report.failures.clone(),
        report.undefined.clone(),
    )
}

/// The fast decider finds what the definition does, evaluated in `P`.
fn agree<P: RationalField>(mesh: &Mesh<Q>) -> Result<(), TestCaseError> {
    let converted = mesh.map(Q::convert::<P>);
    let definition = Plain(&converted.points);
    for property in Property::ALL {
        let slow = Net::new(&mesh.topology, &definition).check(property);
        let quick = fast(mesh, property);
        prop_assert_eq!(findings(&slow), findings(&quick), "{} on {:?}", property.name(), mesh);
        if let (Some(a), Some(b)) = (&slow.worst, &quick.worst) {
            // The defect of a sum of roots is observed in f64, and roughly where sizes are extreme.
            let exact = a.failure.residual.is_some();
            let apart = (a.failure.defect - b.failure.defect).abs();
            prop_assert!(!exact || apart <= 1e-9, "{:?} {:?}", a, b);
        }
    }
    Ok(())
}

proptest! {
    // Residuals of high degree are slow in the oracle, and none of them ends early here.
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn fast_and_plain_agree_where_classes_hold(mesh in prop_oneof![translational(), circular()]) {
        agree::<Q>(&mesh)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn fast_and_plain_agree_among_coincidences(mesh in any_mesh(small())) {
        agree::<Q>(&mesh)?;
    }

    #[test]
    fn fast_and_plain_agree_in_general(mesh in any_mesh(fraction())) {
        agree::<Q>(&mesh)?;
    }

    #[test]
    fn fast_and_plain_agree_on_huge_and_tiny_numbers(
        mesh in any_mesh(small()), up in -60i32..60, sideways in -20i32..20,
    ) {
        // Beyond any common denominator of 126 bits, up to beyond the range of doubles.
        let power = |e: i32| {
            let p = (0..e.abs()).fold(Q::one(), |p, _| p * Q::from_i64(1_000_003));
            if e < 0 { Q::one() / p } else { p }
        };
        let (a, b) = (power(sideways), power(up));
        let points = mesh.points.iter().map(|p| Point::new(&p.x * &a, &p.y * &a, &p.z * &b)).collect();
        // In the fast rationals: the binary gcd of the others takes nearly all the time here.
        agree::<Rational>(&Mesh { points, ..mesh })?;
    }

    #[test]
    fn translational_nets_have_all_three_properties(mesh in translational()) {
        for property in [Property::Planar, Property::ICircular, Property::IConical] {
            prop_assert_eq!(verdict(&mesh, property), Verdict::Proved, "{}", property.name());
        }
    }

    #[test]
    fn cauchy_nets_are_circular_and_their_duals_conical(mesh in circular()) {
        prop_assert_eq!(verdict(&mesh, Property::Planar), Verdict::Proved);
        prop_assert_eq!(verdict(&mesh, Property::ICircular), Verdict::Proved);
    }

    #[test]
    fn a_moved_vertex_is_found(mesh in circular(), at in any::<prop::sample::Index>(), up in any::<bool>()) {
        // The control: the smallest disturbance of one coordinate.
        let i = at.index(mesh.points.len());
        let mut points = mesh.points.clone();
        let step = Q::from_ratio(1, 1 << 40);
        if up { points[i].z += &step } else { points[i].x += &step };
        let mesh = Mesh { points, ..mesh };
        let (planar, circular) = (fast(&mesh, Property::Planar), fast(&mesh, Property::ICircular));
        prop_assert_eq!(circular.verdict(), Verdict::Refuted);
        if up {
            prop_assert_eq!(planar.verdict(), Verdict::Refuted);
            let around = mesh.topology.faces()
                .filter(|&f| mesh.topology.face(f).iter().any(|v| v.index() == i));
            prop_assert_eq!(planar.failures.len(), around.count());
        }
    }

    #[test]
    fn verdicts_do_not_depend_on_names(mesh in any_mesh(small()), seed in any::<u64>()) {
        let other = relabelled(&mesh, seed);
        for property in Property::ALL {
            let (a, b) = (fast(&mesh, property), fast(&other, property));
            prop_assert_eq!(a.verdict(), b.verdict(), "{}", property.name());
            prop_assert_eq!(a.failures.len(), b.failures.len(), "{}", property.name());
        }
    }

    #[test]
    fn verdicts_are_those_of_isotropic_geometry(
        mesh in prop_oneof![any_mesh(small()), translational(), circular()],
        motion in motion(), scaling in scaling(),
    ) {
        let moved = scaling.apply(&motion.apply(&mesh));
        for property in [Property::Planar, Property::ICircular, Property::IConical, Property::Delaunay] {
            prop_assert_eq!(findings(&fast(&mesh, property)), findings(&fast(&moved, property)), "{}", property.name());
        }
    }

    #[test]
    fn euclidean_verdicts_are_those_of_similarities(mesh in any_mesh(small()), q in [small(), small(), small()]) {
        // A rational rotation from the quaternion (1, q), and a factor.
        let [b, c, d] = q;
        let two = Q::from_i64(2);
        let n = (Q::one() + b.square() + c.square() + d.square()).try_inv().unwrap() * Q::from_ratio(5, 3);
        let turn = |p: &Point<Q>| {
            let (x, y, z) = (&p.x, &p.y, &p.z);
            let row = |a: Q, b: Q, c: Q| &n * (a * x + b * y + c * z);
            let one = Q::one();
            Point::new(
                row(&one + b.square() - c.square() - d.square(), &two * (&b * &c - &d), &two * (&b * &d + &c)),
                row(&two * (&b * &c + &d), &one - b.square() + c.square() - d.square(), &two * (&c * &d - &b)),
                row(&two * (&b * &d - &c), &two * (&c * &d + &b), &one - b.square() - c.square() + d.square()),
            )
        };
        let moved = Mesh { points: mesh.points.iter().map(turn).collect(), ..mesh.clone() };
        for property in [Property::Circular, Property::Conical] {
            prop_assert_eq!(findings(&fast(&mesh, property)), findings(&fast(&moved, property)), "{}", property.name());
        }
    }

    #[test]
    fn witnesses_are_exact(mesh in any_mesh(prop_oneof![small(), fraction()]), four in prop::sample::subsequence(vec![0u32, 1, 2, 3], 4).prop_shuffle()) {
        prop_assume!(mesh.points.len() > 3);
        let at: [VertexId; 4] = std::array::from_fn(|i| VertexId(four[i]));
        let rational = mesh.map(Q::convert::<Rational>);
        let (slow, quick) = (Plain(&mesh.points), Decider::of_rationals(&rational.points));
        let (a, b) = (slow.failure("", Coplanar, at, true), quick.failure("", Coplanar, at, true));
        prop_assert_eq!(a.residual, b.residual.map(|r| r.convert::<Q>()));
        let (a, b) = (slow.failure("", Concyclic, at, true), quick.failure("", Concyclic, at, true));
        prop_assert_eq!(a.residual, b.residual.map(|r| r.convert::<Q>()));
    }

    #[test]
    fn the_gradients_have_the_determinant_of_the_balance(points in prop::collection::vec([small(), small(), small()], 9)) {
        // Theory: in-circle(p₀ … p₃) = w₀ w₁ w₂ w₃ · balance; so both vanish together where no w does.
        let p: Vec<Point<Q>> = points.into_iter().map(|[x, y, z]| Point::new(x, y, z)).collect();
        let (v, x) = (&p[0], [&p[1], &p[2], &p[3], &p[4]]);
        let corner = |i: usize| [v.clone(), x[i].clone(), x[(i + 1) % 4].clone()];
        let at: Vec<Point<Q>> = (0..4).flat_map(corner).collect();
        let normal = |i: usize| (x[i] - v).cross(&(x[(i + 1) % 4] - v));
        let normals: Vec<_> = (0..4).map(normal).collect();
        prop_assume!(normals.iter().all(|n| !n.z.is_zero()));
        let gradients = ConcyclicGradients.eval(&at.try_into().unwrap(), &Q::one());
        let scale = normals.iter().fold(Q::one(), |s, n| s * n.z.square());
        let balance = Balance.eval(&[v.clone(), x[0].clone(), x[1].clone(), x[2].clone(), x[3].clone()], &Q::one());
        let gradient = |i: usize| (-&normals[i].x / &normals[i].z, -&normals[i].y / &normals[i].z);
        let w = (0..4).map(|j| {
            // p_j − p_{j−1} = w J e_j'.
            let (p, q, e) = (gradient(j), gradient((j + 3) % 4), (x[j] - v).top_view());
            let (dx, dy) = (p.0 - q.0, p.1 - q.1);
            prop_assert!((&dx * &e.x + &dy * &e.y).is_zero());
            Ok((&dy * &e.x - &dx * &e.y) / e.length2())
        }).collect::<Result<Vec<_>, _>>()?;
        let product = w.iter().fold(Q::one(), |s, w| s * w);
        prop_assert_eq!((gradients / scale).square(), (product * balance).square());
    }
}

/// Prints an exact number rounded to `digits` decimals.
pub fn printed(x: &Q, digits: u32) -> Numeral {
    let scale = Q::from_i64(10i64.pow(digits));
    let n = (x * &scale + Q::from_ratio(1, 2)).floor().to_integer();
    format!("{n}e-{digits}").parse().expect("a decimal")
}

fn boxed(mesh: &Mesh<Numeral>, property: Property) -> Verdict {
    Net::new(&mesh.topology, &Decider::over_boxes(&mesh.points)).check(property).verdict()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn what_was_exact_before_printing_is_never_refuted(
        mesh in prop_oneof![translational(), circular()], digits in 1u32..18,
    ) {
        // Rigour of the boxes: the exact mesh lies in the box of its printed numbers.
        let decider_says = |property| {
            let exact = verdict(&mesh, property);
            let rounded = boxed(&mesh.map(|x| printed(x, digits)), property);
            (exact, rounded)
        };
        for property in [Property::Planar, Property::ICircular, Property::IConical] {
            if let (Verdict::Proved, rounded) = decider_says(property) {
                prop_assert!(rounded != Verdict::Refuted, "{} at {digits} digits", property.name());
            }
        }
    }

    #[test]
    fn boxes_refute_what_is_further_than_the_digits(mesh in circular(), digits in 4u32..18) {
        // Moved by 10^6 units of the last digit that is printed, which is far outside the box.
        let mut points = mesh.points.clone();
        let middle = points.len() / 2;
        points[middle].z += &(Q::from_i64(1_000_000) / Q::from_i64(10i64.pow(digits)));
        let moved = Mesh { points, ..mesh };
        prop_assert_eq!(boxed(&moved.map(|x| printed(x, digits)), Property::Planar), Verdict::Refuted);
    }

    #[test]
    fn boxes_hold_at_their_corners(
        points in prop::collection::vec([-99i64..99, -99i64..99, -99i64..99], 4), corners in prop::collection::vec(any::<u16>(), 8),
    ) {
        // If the box excludes zero, no choice of corners makes the determinant zero or turns it over.
        let numerals: Vec<Point<Numeral>> = points.iter()
            .map(|p| Point::new(p[0], p[1], p[2]).map(|c| format!("{c}e-1").parse().unwrap())).collect();
        let decider = Decider::over_boxes(&numerals);
        let ids = [0, 1, 2, 3].map(VertexId);
        let half = Q::from_ratio(1, 20);
        for choice in corners {
            let mut bit = 0;
            let corner: Vec<Point<Q>> = numerals.iter().map(|p| p.map(|c| {
                bit += 1;
                let value = c.value::<Q>();
                if choice >> bit & 1 == 1 { value + &half } else { value - &half }
            })).collect();
            let corner: [Point<Q>; 4] = corner.try_into().unwrap();
            let (sign, certain) = decider.sign(Coplanar, ids);
            if certain { prop_assert_eq!(Coplanar.eval(&corner, &Q::one()).certain_sign(), Some(sign)); }
            let (sign, certain) = decider.sign(Concyclic, ids);
            if certain { prop_assert_eq!(Concyclic.eval(&corner, &Q::one()).certain_sign(), Some(sign)); }
        }
    }
}

/// Compares the signs of all residuals on the first points, as `compare` sees fit.
fn for_every_residual<D: Decide>(
    decide: &D,
    mut compare: impl FnMut(&'static str, (Sign, bool), &dyn Fn(&Plain<'_, Q>) -> Sign),
) {
    macro_rules! each {
        ($($residual:expr),*) => {$({
            let at = std::array::from_fn(|i| VertexId(i as u32));
            let (here, residual) = (decide.sign($residual, at), $residual);
            compare(stringify!($residual), here, &|plain| plain.sign(residual, at).0);
        })*};
    }
    each!(OnSigma, EdgeTouchesSigma, TouchesSigma, ProjectedArea::AlongX, ProjectedArea::TopView);
    each!(Coplanar, Concyclic, Balance, ConcyclicGradients);
}

/// Numerals of every kind: negative, with trailing zeros, of both bases, tiny, huge, at the limits.
fn numeral() -> impl Strategy<Value = Numeral> + Clone {
    let parsed = |text: String| text.parse::<Numeral>().unwrap();
    let double = |m: i64, e: i32| Numeral::from_f64(m as f64 * 2f64.powi(e)).unwrap();
    prop_oneof![
        6 => (-20i64..20, -2i32..2).prop_map(move |(m, e)| parsed(format!("{m}e{e}"))),
        4 => (-20i64..20, -3i32..3).prop_map(move |(m, e)| double(m, e)),
        2 => (any::<i64>(), -24i32..24).prop_map(move |(m, e)| parsed(format!("{m}e{e}"))),
        2 => (any::<i64>(), -80i32..80).prop_map(move |(m, e)| double(m, e)),
        1 => prop_oneof![Just(i64::MIN), Just(i64::MAX), Just(i64::MIN + 1)].prop_map(Numeral::from_i64),
        1 => (any::<i128>(), -400i32..400).prop_map(move |(m, e)| parsed(format!("{m}e{e}"))),
        1 => any::<f64>().prop_filter_map("finite", Numeral::from_f64),
        1 => any::<f32>().prop_filter_map("finite", Numeral::from_f32),
    ]
}

/// Points of numerals of one kind or mixed, the last ones repeated or combined from the others.
fn numeral_points() -> impl Strategy<Value = Vec<Point<Numeral>>> {
    let point = |c: BoxedStrategy<Numeral>| [c.clone(), c.clone(), c];
    let of_base = move |base| {
        let one = numeral().prop_filter("one base", move |n| n.unit_exponent().0 == base);
        prop::collection::vec(point(one.boxed()), 12).boxed()
    };
    let mixed = prop::collection::vec(point(numeral().boxed()), 12);
    (prop_oneof![of_base(Base::Two), of_base(Base::Ten), mixed.boxed()], any::<u16>()).prop_map(
        |(points, repeat)| {
            let mut points: Vec<Point<Numeral>> =
                points.into_iter().map(|[x, y, z]| Point::new(x, y, z)).collect();
            for i in 1..points.len() {
                if repeat >> i & 1 == 1 {
                    // On the vertical through the one before, or flat, or the same.
                    let (before, own) = (points[i - 1].clone(), points[i].clone());
                    points[i] = match repeat % 3 {
                        0 => Point::new(before.x, before.y, own.z),
                        1 => Point::new(own.x.clone(), own.x, before.z),
                        _ => before,
                    };
                }
            }
            points
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, ..ProptestConfig::default() })]

    #[test]
    fn signs_of_numerals_are_those_of_their_values(points in numeral_points()) {
        let values: Vec<Point<Q>> = points.iter().map(|p| p.map(Numeral::value)).collect();
        let plain = Plain(&values);
        for decider in [Decider::new(&points), Decider::over_boxes(&points)] {
            for_every_residual(&decider, |name, (sign, _), exact| assert_eq!(sign, exact(&plain), "{name}"));
            let at = std::array::from_fn(|i| VertexId(i as u32));
            let zero = |answer| answer == Answer::Zero;
            let (quick, slow) = (decider.decide_roots(ConcyclicNormals, at), plain.decide_roots(ConcyclicNormals, at));
            assert_eq!(zero(quick), zero(slow));
        }
    }

    #[test]
    fn what_is_certain_in_a_box_is_so_wherever_the_numbers_are(
        points in prop::collection::vec([-12i64..12, -12i64..12, -12i64..12], 12),
        digits in 0u32..3, shares in prop::collection::vec(prop::collection::vec(-4i64..=4, 36), 6),
    ) {
        let numerals: Vec<Point<Numeral>> = points.iter().map(|p| {
            // The last digit is a small one, so that boxes are wide.
            Point::new(p[0], p[1], p[2]).map(|c| format!("{}e-{digits}", c * 3i64.pow(digits)).parse().unwrap())
        }).collect();
        let decider = Decider::over_boxes(&numerals);
        let at = std::array::from_fn(|i| VertexId(i as u32));
        let apart = decider.decide_roots(ConcyclicNormals, at) == Answer::Nonzero;
        for share in shares {
            // ±4 of 4 are the corners of the box.
            let mut share = share.into_iter();
            let sample: Vec<Point<Q>> = numerals.iter().map(|p| p.map(|c| {
                c.value::<Q>() + c.half_unit::<Q>() * Q::from_ratio(share.next().unwrap(), 4)
            })).collect();
            let plain = Plain(&sample);
            for_every_residual(&decider, |name, (sign, certain), there| {
                if certain { assert_eq!(sign, there(&plain), "{name}"); }
            });
            if apart { assert_eq!(plain.decide_roots(ConcyclicNormals, at), Answer::Nonzero); }
        }
    }

    #[test]
    fn what_fails_in_a_box_fails_in_every_mesh_of_the_box(
        mesh in prop_oneof![any_mesh(small()), translational(), circular()], digits in 0u32..4, shift in fraction(),
    ) {
        // The numbers before printing are in the box of the printed ones.
        let points = mesh.points.iter().map(|p| p.map(|c| c + &shift / Q::from_i64(1000))).collect();
        let mesh = Mesh { points, ..mesh };
        let rounded = mesh.map(|x| printed(x, digits));
        let decider = Decider::over_boxes(&rounded.points);
        for property in Property::ALL {
            let (exact, rounded) = (fast(&mesh, property), Net::new(&mesh.topology, &decider).check(property));
            for failure in rounded.failures {
                let undefined = exact.undefined.iter().any(|(e, _)| *e == failure);
                // That no joint choice exists is a failure of the mesh; elsewhere in the box another
                // element may be the first to show it.
                let joint = property == Property::EdgeOffset
                    && !(exact.failures.is_empty() && exact.undefined.is_empty());
                let fails = undefined || joint || exact.failures.contains(&failure);
                prop_assert!(fails, "{} at {}", property.name(), failure);
            }
        }
    }
}

fn mesh(points: &[[i64; 3]], faces: &[&[u32]]) -> Mesh<Q> {
    let mut list = isogeo::mesh::FaceList::new();
    faces.iter().for_each(|f| list.push(f.iter().copied()));
    let points =
        points.iter().map(|p| Point::new(p[0], p[1], p[2]).map(|&c| Q::from_i64(c))).collect();
    Mesh::new(points, list).unwrap()
}

#[test]
fn a_crossed_cyclic_quad_is_circular() {
    // (13) as a sum of angles fails here, the determinant does not (theory, pitfall 4.4).
    let crossed = mesh(&[[5, 0, 0], [-5, 0, 0], [0, 5, 0], [0, -5, 0]], &[&[0, 1, 2, 3]]);
    assert_eq!(verdict(&crossed, Property::ICircular), Verdict::Proved);
}

#[test]
fn a_vertical_quad_has_no_i_circle_of_elliptic_type() {
    let wall = mesh(&[[0, 0, 0], [1, 1, 0], [1, 1, 2], [0, 0, 2]], &[&[0, 1, 2, 3]]);
    assert_eq!(verdict(&wall, Property::Planar), Verdict::Proved);
    assert_eq!(verdict(&wall, Property::ICircular), Verdict::Undecided);
    assert_eq!(verdict(&wall, Property::Circular), Verdict::Proved);
}

#[test]
fn triangles_have_nothing_to_check() {
    let fan = mesh(
        &[[0, 0, 1], [2, 0, 0], [-1, 2, 0], [-1, -2, 0]],
        &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1]],
    );
    for property in [
        Property::Planar,
        Property::ICircular,
        Property::IConical,
        Property::Circular,
        Property::Conical,
    ] {
        assert_eq!(verdict(&fan, property), Verdict::Vacuous, "{}", property.name());
    }
}

#[test]
fn a_pyramid_over_a_square_is_conical_in_both_geometries_and_over_a_kite_in_none() {
    let square = [[0, 0, 3], [2, 0, 0], [0, 2, 0], [-2, 0, 0], [0, -2, 0]];
    let faces: [&[u32]; 4] = [&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 1]];
    for property in [Property::IConical, Property::Conical] {
        assert_eq!(
            verdict(&mesh(&square, &faces), property),
            Verdict::Proved,
            "{}",
            property.name()
        );
        let mut kite = square;
        kite[1] = [3, 1, 0];
        assert_eq!(
            verdict(&mesh(&kite, &faces), property),
            Verdict::Refuted,
            "{}",
            property.name()
        );
    }
}

#[test]
fn a_right_circular_cone_of_irrational_slopes_is_conical() {
    // Tangent planes z = 1 − n·x' of one cone, with n from Pythagorean triples: |N| differ in class
    // from face to face after the planes are cut by z = 0, so roots have to cancel exactly.
    let n = [(3, 4, 5), (-4, 3, 5), (-5, -12, 13), (12, -5, 13)];
    let rim: Vec<[Q; 2]> = (0..4)
        .map(|i| {
            let (a, b) = (n[(i + 3) % 4], n[i]);
            let q = |p, d| Q::from_ratio(p, d);
            // The point of z = 0 on both planes: a·x/|a| = b·x/|b| = 1.
            let (a, b) = ([q(a.0, a.2), q(a.1, a.2)], [q(b.0, b.2), q(b.1, b.2)]);
            let det = (&a[0] * &b[1] - &a[1] * &b[0]).try_inv().unwrap();
            [(&b[1] - &a[1]) * &det, (&a[0] - &b[0]) * &det]
        })
        .collect();
    let zero = Q::zero;
    let mut points = vec![Point::new(zero(), zero(), Q::one())];
    points.extend(rim.into_iter().map(|[x, y]| Point::new(x, y, zero())));
    let mut list = isogeo::mesh::FaceList::new();
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]].into_iter().for_each(|f: [u32; 3]| list.push(f));
    let cone = Mesh::new(points, list).unwrap();
    assert_eq!(verdict(&cone, Property::Conical), Verdict::Proved);
    assert_eq!(verdict(&cone, Property::IConical), Verdict::Proved);
}

#[test]
fn the_lift_of_a_grid_is_inscribed_and_its_tangent_planes_circumscribed() {
    let lift = |x: i64, y: i64| {
        Point::new(Q::from_i64(x), Q::from_i64(y), Q::from_ratio(x * x + y * y, 2))
    };
    let points: Vec<_> = (0..3).flat_map(|x| (0..3).map(move |y| lift(x, y))).collect();
    let grid = Mesh::new(points.clone(), isogeo::construct::quad_patch(2, 2)).unwrap();
    assert_eq!(verdict(&grid, Property::Inscribed), Verdict::Proved);
    assert_eq!(verdict(&grid, Property::Delaunay), Verdict::Proved);
    assert_eq!(verdict(&grid, Property::Midscribed), Verdict::Refuted);
    // Koebe: vertex circles of radius 1/2 touch; lift at (|x|² − r²)/2.
    let koebe = points
        .iter()
        .map(|p| Point::new(p.x.clone(), p.y.clone(), &p.z - Q::from_ratio(1, 8)))
        .collect();
    let koebe = Mesh { points: koebe, ..grid.clone() };
    assert_eq!(verdict(&koebe, Property::Midscribed), Verdict::Proved);
    // The square (±1, ±1) at height 1 with apex below: faces touch Σ at (±1, 0), (0, ±1).
    let tangent = mesh(
        &[[0, 0, -1], [2, 2, 1], [-2, 2, 1], [-2, -2, 1], [2, -2, 1]],
        &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 1]],
    );
    let halves = tangent
        .points
        .iter()
        .map(|p| Point::new(&p.x / Q::from_i64(2), &p.y / Q::from_i64(2), &p.z / Q::from_i64(2)))
        .collect();
    let halves = Mesh { points: halves, ..tangent };
    assert_eq!(verdict(&halves, Property::Circumscribed), Verdict::Proved);
}

#[test]
fn delaunay_is_refuted_by_one_flipped_edge_and_local_at_a_reflex_boundary() {
    let points = [[0, 0, 0], [4, 0, 0], [5, 3, 0], [0, 3, 0]];
    let good = mesh(&points, &[&[0, 1, 3], &[1, 2, 3]]);
    let bad = mesh(&points, &[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!(verdict(&good, Property::Delaunay), Verdict::Proved);
    assert_eq!(verdict(&bad, Property::Delaunay), Verdict::Refuted);
    // An L-shape: all edges locally Delaunay, but the hull is not covered.
    let l = mesh(&[[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]], &[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!(verdict(&l, Property::Delaunay), Verdict::Undecided);
}

#[test]
fn the_witness_is_exact() {
    let bent = mesh(&[[0, 0, 0], [3, 0, 0], [3, 2, 0], [0, 2, 7]], &[&[0, 1, 2, 3]]);
    let worst = fast(&bent, Property::Planar).worst.unwrap();
    assert_eq!(worst.failure.residual, Some(Rational::from_i64(42)));
    assert_eq!(worst.failure.defect, 1.0);
}

/// The net z = x² + y² over the integers: planar, i-circular, i-conical.
fn integer_net(side: i64) -> Mesh<Numeral> {
    let point = |x: i64, y: i64| Point::new(x, y, x * x + y * y).map(|&c| Numeral::from_i64(c));
    let points = (0..=side).flat_map(|x| (0..=side).map(move |y| point(x, y))).collect();
    Mesh::new(points, isogeo::construct::quad_patch(side as usize, side as usize)).unwrap()
}

#[test]
fn reports_are_the_same_for_any_number_of_threads_that_ask_at_once() {
    // More chunks than threads and more threads than a thread has jobs of its own: what faces are
    // must not be found under a lock that a waiting thread comes back to.
    let mut net = integer_net(100);
    for moved in [2_500, 5_000, 10_100] {
        net.points[moved].z = Numeral::from_i64(-1);
    }
    let of_threads = |n: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
        pool.install(|| {
            let decider = Decider::new(&net.points);
            let net = Net::new(&net.topology, &decider);
            Property::ALL.par_iter().map(|&p| net.check(p)).collect::<Vec<_>>()
        })
    };
    let one = of_threads(1);
    let verdicts: Vec<_> = one.iter().map(|r| r.verdict()).collect();
    assert_eq!(verdicts[..3], [Verdict::Refuted; 3]);
    for n in [2, 16, 16, 16] {
        assert_eq!(of_threads(n), one, "{n} threads");
    }
}

#[test]
fn an_edge_of_length_zero_does_not_make_a_vertex_conical() {
    // Four planes through the origin with gradients (1, 0), (1, 1), (0, 1) and (0, -m); the first
    // and the last share an edge of length zero, hence a point but no line.
    let star = |m: i64| {
        let points = [
            [0, 0, 0],
            [0, 0, 0],
            [1, 0, 1],
            [0, 1, 1],
            [-1, 0, 0],
            [1, -1, 1],
            [1, 1, 2],
            [-1, 1, 1],
            [-1, -1, m],
        ];
        mesh(&points, &[&[0, 1, 5, 2], &[0, 2, 6, 3], &[0, 3, 7, 4], &[0, 4, 8, 1]])
    };
    for (m, concyclic) in [(0, true), (-1, true), (-3, false), (1, false)] {
        let expected = if concyclic { Verdict::Proved } else { Verdict::Refuted };
        assert_eq!(verdict(&star(m), Property::Planar), Verdict::Proved);
        assert_eq!(verdict(&star(m), Property::IConical), expected, "{m}");
    }
}

/// The point turned by the rotation of the quaternion (2, 1, -1, 3), times 15.
fn turned([x, y, z]: [i64; 3]) -> [i64; 3] {
    let row = |a: i64, b: i64, c: i64| a * x + b * y + c * z;
    [row(-5, -14, 2), row(10, -5, -10), row(10, -2, 11)]
}

#[test]
fn faces_that_double_back_or_cross_themselves_have_one_orientation_in_space() {
    // A pyramid over a square, cut into quads of which one has a spike, a repeated point or
    // a crossing; which corner is extreme depends on the coordinates, the vector area does not.
    let apex = [0, 0, 3];
    let [a, b, c, d] = [[2, 0, 0], [0, 2, 0], [-2, 0, 0], [0, -2, 0]];
    // In the plane of the apex, a and b: beyond a on the edge; twice a; across.
    for extra in [[4, 0, -3], a, [1, 1, 0], [2, 2, -3], [-1, 3, 0], [5, -1, -3]] {
        let points = [apex, a, b, c, d, extra];
        let faces: [&[u32]; 4] = [&[0, 1, 5, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 1]];
        for (turn, faces) in (0..4).map(|turn| {
            let mut first = faces[0].to_vec();
            first.rotate_left(turn);
            (turn, [first, faces[1].to_vec(), faces[2].to_vec(), faces[3].to_vec()])
        }) {
            let faces = faces.each_ref().map(|f| f.as_slice());
            let here = fast(&mesh(&points, &faces), Property::Conical);
            assert_eq!(here.verdict(), Verdict::Proved, "{extra:?} {turn}");
            let there = fast(&mesh(&points.map(turned), &faces), Property::Conical);
            assert_eq!(findings(&here), findings(&there), "{extra:?} {turn}");
        }
    }
    // The control: one face turned over by a fifth corner far out, which keeps its plane.
    let over = [apex, a, b, c, d, [-20, 0, 33], [0, -20, 33]];
    let faces: [&[u32]; 4] = [&[0, 1, 6, 5, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 1]];
    for move_to in [|p| p, turned] {
        let points = over.map(move_to);
        assert_eq!(verdict(&mesh(&points, &faces), Property::Planar), Verdict::Proved);
        assert_eq!(verdict(&mesh(&points, &faces), Property::Conical), Verdict::Refuted);
    }
    // Oriented area zero: a bow tie in the plane of the first face.
    let bow_tie = [apex, a, b, c, d, [2, 2, -3], [2, -2, 3]];
    for move_to in [|p| p, turned] {
        let points = bow_tie.map(move_to);
        let faces: [&[u32]; 4] = [&[0, 1, 5, 6, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 1]];
        let report = fast(&mesh(&points, &faces), Property::Conical);
        let expected = (Element::Vertex(VertexId(0)), Reason::NoOrientation(FaceId(0)));
        assert_eq!(report.undefined, [expected]);
    }
}

#[test]
fn a_flat_star_is_conical_for_any_valence() {
    // All normals and all gradients agree: that was looked at, so it is proved and not vacuous.
    let rim = [[3, 0], [2, 2], [0, 3], [-2, 2], [-3, 0], [-2, -2], [0, -3], [2, -2]];
    let stars: [&[usize]; 4] =
        [&[0, 2, 4, 6], &[0, 2, 4, 5, 6], &[0, 1, 2, 4, 5, 6], &[0, 1, 2, 3, 4, 5, 6, 7]];
    for star in stars {
        let k = star.len() as u32;
        let mut points = vec![[0, 0, 0]];
        points.extend(star.iter().map(|&i| [rim[i][0], rim[i][1], rim[i][0] - rim[i][1]]));
        let faces: Vec<_> = (0..k).map(|i| [0, 1 + i, 1 + (i + 1) % k]).collect();
        let faces: Vec<&[u32]> = faces.iter().map(|f| f.as_slice()).collect();
        for property in [Property::IConical, Property::Conical] {
            let found = verdict(&mesh(&points, &faces), property);
            assert_eq!(found, Verdict::Proved, "{} {k}", property.name());
        }
    }
}

#[test]
fn a_face_of_many_points_on_a_line_is_found_out_in_linear_time() {
    const N: u32 = 50_000;
    let point = |i: i64| Point::new(i % 977, i % 977, 2 * (i % 977)).map(|&c| Numeral::from_i64(c));
    let mut faces = isogeo::mesh::FaceList::new();
    faces.push(0..N);
    let line = Mesh::new((0..i64::from(N)).map(point).collect(), faces).unwrap();
    let decider = Decider::new(&line.points);
    let report = Net::new(&line.topology, &decider).check(Property::ICircular);
    let expected = (Element::Face(FaceId(0)), Reason::CollinearFace(FaceId(0)));
    assert_eq!(report.undefined, [expected]);
}

#[test]
fn the_zero_of_a_float_is_known_to_half_the_least_float() {
    let zero = Numeral::from_f32(0.0).unwrap();
    let least = Numeral::from_f32(f32::from_bits(1)).unwrap();
    assert_eq!(zero.unit_exponent(), (Base::Two, -149));
    assert_eq!(zero.half_unit::<Q>(), least.half_unit::<Q>());
    assert_eq!(Numeral::from_f32(-1.5).unwrap().unit_exponent(), (Base::Two, -23));
    assert_eq!(Numeral::from_f64(0.0).unwrap().unit_exponent(), (Base::Two, -1074));
}
