//! What (22) does to samples of known surfaces: the values of the theory, exactness, orders.

use isogeo::construct::accuracy::{
    Accuracy, Class, Errors, Row, Trend, accuracy, vertex_curvatures,
};
use isogeo::construct::delaunay;
use isogeo::mesh::{FaceList, Mesh, VertexId};
use isogeo::scalar::{Approx, Field, Rational};
use isogeo::space::{Expression, Point, TopView};
use proptest::prelude::*;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::from_ratio(p, q)
}

fn surface(text: &str) -> Expression {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

/// The graph over a star: vertex 0 at `centre`, the others around it in steps of `h`.
fn star(f: &str, centre: (i64, i64), h: &Rational, ring: &[(i64, i64)]) -> Mesh<Rational> {
    let f = surface(f);
    let place = |&(i, j): &(i64, i64)| {
        let step = |c: i64, d: i64| ratio(c, 1) + ratio(d, 1) * h;
        let at = TopView::new(step(centre.0, i), step(centre.1, j));
        at.at_height(f.height_at(&at).expect("defined"))
    };
    let points: Vec<Point<Rational>> = [(0, 0)].iter().chain(ring).map(place).collect();
    let mut faces = FaceList::new();
    let n = ring.len() as u32;
    for i in 0..n {
        faces.push([0, 1 + i, 1 + (i + 1) % n]);
    }
    Mesh::new(points, faces).expect("a star")
}

fn h_and_k(mesh: &Mesh<Rational>) -> [String; 2] {
    vertex_curvatures(mesh, VertexId(0)).expect("interior").map(|c| c.to_string())
}

const SIX: [(i64, i64); 6] = [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];
const OTHER_SIX: [(i64, i64); 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
const EIGHT: [(i64, i64); 8] =
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
const FOUR: [(i64, i64); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

#[test]
fn union_jack_values() {
    let one = ratio(1, 1);
    for (f, h, ks) in [
        ("x*y", "0", ["-1", "-1", "-2", "0"]),
        ("x^3*y + x^2*y^2 + x^2", "1", ["-4", "0", "-4", "0"]),
    ] {
        let stars = [&SIX[..], &OTHER_SIX, &EIGHT, &FOUR];
        for (ring, k) in stars.into_iter().zip(ks) {
            assert_eq!(h_and_k(&star(f, (0, 0), &one, ring)), [h, k], "{f} on {ring:?}");
        }
    }
}

#[test]
fn quartic_on_the_six_star() {
    for (n, k, h) in [
        (2, "995/576", "73/48"),
        (4, "16079/9216", "289/192"),
        (8, "257855/147456", "1153/768"),
        (16, "4127999/2359296", "4609/3072"),
    ] {
        let mesh = star("x^4/12 + y^2/2 + x*y^3/6", (1, 1), &ratio(1, n), &SIX);
        assert_eq!(h_and_k(&mesh), [h, k], "h = 1/{n}");
    }
}

#[test]
fn the_star_that_never_converges() {
    // z = x² has 2H = 2 and K = 0.
    let ring = [(2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2)];
    for n in [1, 10, 1_000_000] {
        let mesh = star("x^2", (0, 0), &ratio(1, n), &ring);
        assert_eq!(h_and_k(&mesh), ["34/31", "412/775"], "2H = 68/31 at h = 1/{n}");
        // It is the star of a Delaunay mesh.
        let own = delaunay(mesh.points.clone()).expect("not collinear");
        assert_eq!(vertex_curvatures(&own, VertexId(0)), vertex_curvatures(&mesh, VertexId(0)));
        assert_eq!(own.topology.star(VertexId(0)).count(), 5);
    }
}

fn measure(f: &str, class: Class, sizes: &[u32]) -> Accuracy {
    accuracy(&surface(f), class, sizes, 1).expect("a triangulation")
}

fn h(row: &Row) -> &Errors {
    &row.mean_curvature
}

fn k(row: &Row) -> &Errors {
    &row.curvature
}

#[test]
fn which_classes_are_exact_for_quadratics() {
    for (class, exact) in [
        (Class::Lattice, [true, true]),
        (Class::RightAngled, [true, true]),
        (Class::Mapped, [false, false]),
        (Class::UnionJack, [true, false]),
        (Class::Delaunay, [false, false]),
    ] {
        let found = measure("x", class, &[8]);
        assert_eq!(found.exact_for_quadratics, exact, "{}", class.name());
        // Planes and i-spheres are exact on all.
        for f in ["x - 2*y + 3", "(x^2 + y^2)/2 - x"] {
            let found = measure(f, class, &[8]);
            assert_eq!((found.trend(h), found.trend(k)), (Trend::Exact, Trend::Exact), "{f}");
        }
    }
}

#[test]
fn orders_are_those_of_the_theory() {
    let f = "x^4/12 + y^2/2 + x*y^3/6";
    let is_second = |trend| matches!(trend, Trend::Order(p) if (p - 2.0).abs() < 0.3);
    for class in [Class::Lattice, Class::RightAngled, Class::Mapped] {
        let found = measure(f, class, &[8, 16]);
        assert!(is_second(found.trend(h)) && is_second(found.trend(k)), "{found:?}");
    }
    let jack = measure("x*y", Class::UnionJack, &[8, 16]);
    assert_eq!((jack.trend(h), jack.trend(k)), (Trend::Exact, Trend::NoConvergence));
    // Off by f_xy² = 1 exactly, and nearly right in the mean.
    assert!(jack.rows.iter().all(|row| k(row).largest == ratio(1, 1)));
    assert!(k(&jack.rows[1]).mean.abs() < 0.02);
    let random = measure("x^2", Class::Delaunay, &[8, 16, 24]);
    assert_eq!((random.trend(h), random.trend(k)), (Trend::NoConvergence, Trend::NoConvergence));
    assert!(random.rows.iter().all(|row| row.undefined == 0), "D(s) > 0 on Delaunay meshes");
}

#[test]
fn functions_are_sampled_in_doubles() {
    let found = measure("sin(x)*cos(y) + exp(x)/4", Class::RightAngled, &[8, 16]);
    let Trend::Order(order) = found.trend(h) else { panic!("{found:?}") };
    assert!((order - 2.0).abs() < 0.1);
    // Not defined on half of the square.
    let half = measure("sqrt(x - 1/2)", Class::RightAngled, &[8]);
    assert!(half.rows[0].undefined > 0 && half.rows[0].vertices > 0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn lattices_are_exact_for_quadratics(
        a in -9i64..9, b in -9i64..9, c in -9i64..9, q in 1i64..9, oblique in any::<bool>(),
    ) {
        let f = format!("({a}*x^2 + {b}*x*y + {c}*y^2)/{q} + x - y");
        let class = if oblique { Class::Lattice } else { Class::RightAngled };
        let found = measure(&f, class, &[4]);
        prop_assert_eq!((found.trend(h), found.trend(k)), (Trend::Exact, Trend::Exact));
        // The control: a cubic is not.
        let cubic = measure(&format!("{f} + x^4"), class, &[4]);
        prop_assert!(h(&cubic.rows[0]).largest.to_f64() > 0.0);
    }
}
