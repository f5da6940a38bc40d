//! Named values: curvatures of discrete surfaces known in closed form.

use isogeo::construct::minimal::{MeshPair, bonnet, enneper, logarithmoid};
use isogeo::construct::{face_circle, inscribed_v_parallel, metric_dual, vertex_circles};
use isogeo::mesh::{FaceId, Mesh, VertexId};
use isogeo::net::RADIUS;
use isogeo::pair::*;
use isogeo::scalar::{Rational, Ring};
use isogeo::space::{OrientedCircle, Point, Rotation, TopView};

use super::{fan, q, sampled};

type R = Rational;

fn r(p: i64, d: i64) -> R {
    q(p, d)
}

const CENTRE: VertexId = VertexId(0);

fn at_centre(mesh: &Mesh<R>) -> (R, R) {
    let c = inscribed_v_parallel(mesh).unwrap().vertex_curvatures(CENTRE).unwrap();
    (c.mean, c.gauss)
}

const SIX: [(i64, i64); 6] = [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];
const SIX_OTHER: [(i64, i64); 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
const EIGHT: [(i64, i64); 8] =
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
const FOUR: [(i64, i64); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];

#[test]
fn union_jack_sees_the_mixed_derivative_twice_or_not_at_all() {
    let xy = |x: &R, y: &R| x * y;
    assert_eq!(at_centre(&sampled(&SIX, xy)), (r(0, 1), r(-1, 1)));
    assert_eq!(at_centre(&sampled(&EIGHT, xy)), (r(0, 1), r(-2, 1)));
    assert_eq!(at_centre(&sampled(&FOUR, xy)), (r(0, 1), r(0, 1)));
    let f = |x: &R, y: &R| x * x * x * y + x * x * y * y + x * x;
    assert_eq!(at_centre(&sampled(&SIX, f)), (r(1, 1), r(-4, 1)));
    assert_eq!(at_centre(&sampled(&SIX_OTHER, f)), (r(1, 1), r(0, 1)));
    assert_eq!(at_centre(&sampled(&EIGHT, f)), (r(1, 1), r(-4, 1)));
    assert_eq!(at_centre(&sampled(&FOUR, f)), (r(1, 1), r(0, 1)));
}

#[test]
fn the_six_star_converges_with_the_known_error() {
    // f = x⁴/12 + y²/2 + xy³/6 at (1, 1): H = 3/2, K = 7/4.
    let f = |x: &R, y: &R| {
        let (x2, y2) = (x * x, y * y);
        x2.square() * r(1, 12) + &y2 * r(1, 2) + x * y * y2 * r(1, 6)
    };
    let table = [
        (2, (73, 48), (995, 576)),
        (4, (289, 192), (16079, 9216)),
        (8, (1153, 768), (257_855, 147_456)),
        (16, (4609, 3072), (4_127_999, 2_359_296)),
    ];
    for (n, h, k) in table {
        let at = |i: i64, j: i64| {
            let (x, y) = (r(n + i, n), r(n + j, n));
            let z = f(&x, &y);
            Point::new(x, y, z)
        };
        let mesh = fan(at(0, 0), SIX.iter().map(|&(i, j)| at(i, j)).collect());
        assert_eq!(at_centre(&mesh), (r(h.0, h.1), r(k.0, k.1)), "h = 1/{n}");
        assert_eq!(r(h.0, h.1) - r(3, 2), r(1, 12 * n * n), "h = 1/{n}");
    }
}

#[test]
fn the_error_of_the_six_star_is_the_taylor_polynomial() {
    // K = (4 a02 a20 − a11²) + h² [...] + O(h⁴), so the h² term is a limit of differences.
    let a = |i: i64, j: i64| r((3 * i + 5 * j + i * j) % 7 - 3, 1);
    let exponents = || (0..=4i64).flat_map(|n| (0..=n).map(move |i| (i, n - i)));
    let power = |x: &R, n: i64| (0..n).fold(R::one(), |p, _| p * x);
    let value = |h: &R| {
        let f = |x: &R, y: &R| {
            let (x, y) = (x * h, y * h);
            exponents().fold(R::zero(), |sum, (i, j)| sum + a(i, j) * power(&x, i) * power(&y, j))
        };
        // Sampled with h = 1 and scaled: K grows by h⁻⁴.
        at_centre(&sampled(&SIX, f)).1 / power(h, 4)
    };
    let exact = r(4, 1) * a(0, 2) * a(2, 0) - a(1, 1).square();
    let second = r(4, 1) * (a(0, 2) * a(4, 0) + a(0, 4) * a(2, 0))
        - r(2, 1) * a(1, 1) * (a(1, 3) + a(2, 2) + a(3, 1))
        - a(1, 2).square()
        - r(2, 1) * a(1, 2) * a(2, 1)
        - a(2, 1).square();
    // K is a polynomial in h² of degree 2: three values give its coefficients.
    let [k1, k2, k3] = [1, 2, 3].map(|h| value(&r(h, 1)) - &exact);
    let (u1, u2) = (k1, k2 / r(4, 1));
    let fourth = (&u2 - &u1) / r(3, 1);
    assert_eq!(u1 - &fourth, second);
    assert_eq!(k3, r(9, 1) * second + r(81, 1) * fourth);
}

#[test]
fn five_point_laplacians() {
    let laplacian = |f: &dyn Fn(&R, &R) -> R, mesh: &dyn Fn(i64, i64) -> (R, R)| {
        let at = |i: i64, j: i64| {
            let (x, y) = mesh(i, j);
            let z = f(&x, &y);
            Point::new(x, y, z)
        };
        let m = fan(at(0, 0), FOUR.iter().map(|&(i, j)| at(i, j)).collect());
        at_centre(&m).0 * r(2, 1)
    };
    let grid = |i: i64, j: i64| (r(2 + i, 3), r(5 + j, 3)); // h = 1/3 at (2/3, 5/3)
    let quartic = |x: &R, y: &R| {
        let (x, y) = (x.square(), y.square());
        x.square() - r(6, 1) * &x * &y + y.square()
    };
    assert_eq!(laplacian(&quartic, &grid), r(4, 9));
    let cubic = |x: &R, y: &R| x * (x * x - r(3, 1) * y * y);
    assert_eq!(laplacian(&cubic, &grid), r(0, 1));
    let quintic = |x: &R, y: &R| {
        let (x2, y2) = (x.square(), y.square());
        x * (x2.square() - r(10, 1) * &x2 * &y2 + r(5, 1) * y2.square())
    };
    assert_eq!(laplacian(&quintic, &grid), r(20, 9) * r(2, 3));
}

#[test]
fn the_pyramid_measures_twice_the_square_of_its_height() {
    let t = r(3, 5);
    let ring = [(1, 1), (-1, 1), (-1, -1), (1, -1)];
    let height = |x: &R, _: &R| if x.is_zero() { -&t } else { R::zero() };
    let m = sampled(&ring, height);
    let pair = inscribed_v_parallel(&m).unwrap();
    let forms = pair.vertex_forms(CENTRE).unwrap();
    assert_eq!(forms.measure(), r(2, 1) * t.square());
    assert_eq!(forms.image_measure(), r(2, 1));
    let c = forms.curvatures().unwrap();
    assert_eq!((c.mean.clone(), c.gauss.clone()), (t.clone(), t.square()));
    assert_eq!(c.principal(), Roots::Exact(vec![t.clone(), t]));
}

#[test]
fn an_embedded_star_may_have_negative_area() {
    let ring = [(3, -2), (0, 1), (-7, 1), (-1, 0)];
    let m = sampled(&ring, |x: &R, _| x * x);
    let pair = inscribed_v_parallel(&m).unwrap();
    let forms = pair.vertex_forms(CENTRE).unwrap();
    assert_eq!(forms.image_measure(), r(-99, 4));
    assert!(forms.image_is_reversed());
    let cotangents = pair.star(CENTRE).unwrap().into_iter().map(|e| {
        let weight = cotangent_weight(&m, e.half_edge).unwrap();
        assert_eq!(weight, e.weight[1]);
        weight * &e.rise[0]
    });
    let laplacian = cotangents.fold(R::zero(), |a, b: R| a + b);
    assert_eq!(laplacian, forms.curvatures().unwrap().mean * r(2, 1) * r(-99, 4));
}

#[test]
fn a_delaunay_star_that_does_not_converge() {
    let ring = [(2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2)];
    for scale in [1, 10, 1000] {
        let f = |x: &R, _: &R| x * x;
        let m = sampled(&ring, f).map(|c| c / r(scale, 1));
        // Scaled points, heights x² again.
        let points = m.points.iter().map(|p| Point::new(p.x.clone(), p.y.clone(), p.x.square()));
        let m = Mesh { points: points.collect(), ..m.clone() };
        assert_eq!(at_centre(&m), (r(34, 31), r(412, 775)), "scale 1/{scale}");
    }
}

#[test]
fn cmc_three_sevenths_has_an_offset_of_constant_curvature() {
    let c = Curvatures { mean: r(3, 7), gauss: r(-5, 2) };
    let d = c.distance_to_constant_gauss().unwrap();
    assert_eq!(d, r(-7, 6));
    assert_eq!(c.offset(&d).unwrap().gauss, r(36, 49));
    let d = c.distance_to_opposite_mean().unwrap();
    assert_eq!(c.offset(&d).unwrap().mean, r(-3, 7));
    let saddle = Curvatures { mean: r(0, 1), gauss: r(-1, 1) };
    let offset = Curvatures { mean: r(-2, 3), gauss: r(-4, 3) };
    assert_eq!(saddle.offset(&r(1, 2)), Some(offset));
    assert_eq!(saddle.v_offset(&r(1, 2)), Curvatures { mean: r(1, 2), gauss: r(-3, 4) });
    assert_eq!(saddle.offset(&r(1, 1)), None);
}

#[test]
fn the_discrete_enneper_surface() {
    // Seen from the centre of the inversion, the corner (0, 0) is (−1/2, −1/2).
    let half = TopView::new(r(1, 2), r(1, 2));
    let MeshPair { surface: m, gauss: s } = enneper(4, 3, &half).unwrap();
    let face = |i: u32, j: u32| FaceId(3 * i + j);
    assert_eq!(m.points[5], Point::new(r(1, 8), r(-1, 8), r(0, 1)));
    assert_eq!(m.points[10], Point::new(r(19, 8), r(-19, 8), r(0, 1)));
    let x = r(6, 17) + r(1, 2);
    assert_eq!(s.points[10].top_view(), TopView::new(x.clone(), x));
    assert!(Parallel::new(&m, &s).is_ok());
    let pair = FParallel::new(&m, &s).unwrap();
    let values = [
        ((0, 0), (-1, 16), (16, 1), (-256, 1)),
        ((1, 0), (15, 16), (-80, 27), (-256, 81)),
        ((1, 1), (63, 16), (-112, 153), (-256, 1377)),
        ((2, 1), (399, 16), (-2128, 42075), (-256, 126_225)),
        ((2, 2), (1023, 16), (-496, 27489), (-256, 907_137)),
        ((3, 1), (1599, 16), (-8528, 768_075), (-256, 2_304_225)),
    ];
    for ((i, j), area, image, k) in values {
        let forms = pair.face_forms(face(i, j));
        let [area, image, k] = [area, image, k].map(|(p, d)| r(p, d));
        assert_eq!((forms.area(), forms.image_area()), (area, image), "face ({i}, {j})");
        let c = forms.curvatures().unwrap();
        assert_eq!((c.mean, c.gauss), (R::zero(), k), "face ({i}, {j})");
    }
    for f in m.topology.faces() {
        assert_eq!(pair.face_forms(f).mixed_area(), R::zero());
    }
    let mut wrong = m.clone();
    wrong.points[5].x += &r(1, 1000);
    assert!(FParallel::new(&wrong, &s).is_err());
}

/// `K(v) = −1/∏ N_d` over the middles d of the faces around a vertex of the Enneper surface. In general
/// `K(v) = −λ²/∏ ρ` with the signed radii ρ of the incircles of M, where `λ = r R` for the radii r of M
/// and R of S at any vertex; for `λ = 1` it is minus the product of the radii of the incircles of S.
#[test]
fn the_curvature_at_vertices_is_a_product_of_radii() {
    let centre = TopView::new(r(1, 2), r(1, 2));
    let half = Rotation::new(r(4, 5), r(3, 5)).unwrap();
    let off = TopView::new(r(1, 3), r(2, 7));
    let products = |MeshPair { surface: m, gauss: s }: &MeshPair<R>| {
        let scale = &m.data.vertex[RADIUS][0] * &s.data.vertex[RADIUS][0];
        let circles = vertex_circles(m).unwrap();
        let points = circles.iter().map(OrientedCircle::pole).collect();
        let koebe = Mesh { points, ..m.clone() };
        let pair = VParallel::new(m, &koebe).unwrap();
        let around = |v: VertexId| {
            let faces = m.topology.star(v).map(|h| m.topology.face_at(h));
            faces.map(|f| face_circle(&koebe, f).unwrap().unwrap().radius).collect::<Vec<_>>()
        };
        let mut found = Vec::new();
        for v in m.topology.interior_vertices() {
            let product = around(v).into_iter().fold(R::one(), |product, r| product * r);
            let c = pair.vertex_curvatures(v).unwrap();
            assert_eq!((c.mean, &c.gauss), (R::zero(), &-(scale.square() / product)), "{}", v.0);
            found.push((v, c.gauss));
        }
        found
    };
    for (v, k) in products(&enneper(4, 3, &centre).unwrap()) {
        let (i, j) = (i64::from(v.0 / 4), i64::from(v.0 % 4));
        let power = |a: i64, b: i64| r(a * a + b * b, 1) - r(1, 4);
        let around = [(i, j), (i - 1, j), (i, j - 1), (i - 1, j - 1)];
        let product = around.into_iter().fold(R::one(), |p, (a, b)| p * power(a, b));
        assert_eq!(k, -(R::one() / product), "vertex ({i}, {j})");
    }
    // At (1, 1) the faces have the middles (0, 0), (1, 0), (0, 1), (1, 1).
    assert_eq!(products(&enneper(2, 2, &centre).unwrap())[0].1, r(256, 63));
    assert_eq!(products(&logarithmoid(3, 3, &half).unwrap()).len(), 4);
    assert_eq!(products(&bonnet(3, 3, &half, &off).unwrap()).len(), 4);
}

/// Fig. 9: the vertices of the dual M* of the Enneper surface are `(d/N_d, Re d²/6)`, its face planes along
/// a row y pass through `(0, 1/(2y), −y²/3 − 1/24)`, along a column x through `(1/(2x), 0, x²/3 + 1/24)`, all
/// moved by the centre of the inversion in the top view.
#[test]
fn planes_of_the_dual_of_enneper_meet_in_points() {
    let centre = TopView::new(r(-1, 2), r(-3, 2));
    let m = enneper(4, 5, &centre).unwrap().surface;
    let dual = metric_dual(&m).unwrap();
    assert_eq!(dual.points.len(), 20);
    for (index, point) in dual.points.iter().enumerate() {
        let (x, y) = (r(index as i64 / 5 + 1, 1), r(index as i64 % 5 + 2, 1));
        let power = x.square() + y.square() - r(1, 4);
        let at = TopView::new(&x / &power + &centre.x, &y / &power + &centre.y);
        assert_eq!(*point, at.at_height((x.square() - y.square()) * r(1, 6)));
    }
    let shift = r(1, 24);
    for (face, v) in dual.topology.faces().zip(m.topology.interior_vertices()) {
        let (i, j) = (i64::from(v.0 / 6), i64::from(v.0 % 6));
        let (x, y) = (r(2 * i + 1, 2), r(2 * j + 3, 2));
        let plane = dual.face_plane(face).unwrap();
        let over = |a: R, b: R| plane.point_at(&TopView::new(a + &centre.x, b + &centre.y)).z;
        let row = |y: &R| -(y.square() * r(1, 3)) - &shift;
        let column = |x: &R| x.square() * r(1, 3) + &shift;
        assert_eq!(over(R::zero(), r(1, 2) / &y), row(&y), "row {j}");
        assert_eq!(over(r(1, 2) / &x, R::zero()), column(&x), "column {i}");
        // The control: the point of the next row.
        let next = &y + R::one();
        assert_ne!(over(R::zero(), r(1, 2) / &next), row(&next));
    }
    // The point of row y = 5/2.
    let row = m.topology.interior_vertices().position(|v| v.0 == 7).unwrap() as u32;
    let plane = dual.face_plane(FaceId(row)).unwrap();
    assert_eq!(plane.point_at(&TopView::new(r(-1, 2), r(-13, 10))).z, r(-17, 8));
}

#[test]
fn the_discrete_logarithmoid() {
    // σ = 3/5, q = 4, sectors turned by (7/25, 24/25).
    let power = |k: i64| if k < 0 { r(1, 4i64.pow(-k as u32)) } else { r(4i64.pow(k as u32), 1) };
    let half = Rotation::new(r(4, 5), r(3, 5)).unwrap();
    let MeshPair { surface: m, gauss: s } = logarithmoid(3, 3, &half).unwrap();
    for (k, row) in m.points.chunks(4).enumerate() {
        assert!(row.iter().all(|p| p.z == r(6 * k as i64, 5)));
        assert_eq!(row[0].x, -power(-(k as i64)));
    }
    assert!(Parallel::new(&m, &s).is_ok());
    let pair = FParallel::new(&m, &s).unwrap();
    for f in m.topology.faces() {
        let c = pair.face_curvatures(f).unwrap();
        let k = i64::from(f.0 / 3);
        assert_eq!((c.mean, c.gauss), (R::zero(), -power(4 * k + 2)), "face {}", f.0);
    }
}

#[test]
fn the_wheel_of_maxwell() {
    let at = |x: i64, y: i64, z: i64| Point::new(r(x, 1), r(y, 1), r(z, 1));
    let m = fan(at(1, 1, -1), vec![at(0, 0, 0), at(4, 0, 0), at(0, 4, 0)]);
    let pair = inscribed_v_parallel(&m).unwrap();
    let star = pair.star(CENTRE).unwrap();
    let spokes: Vec<(u32, R)> = star.iter().map(|e| (e.target.0, e.weight[0].clone())).collect();
    assert!(spokes.contains(&(1, r(1, 1))) && spokes.contains(&(2, r(1, 2))));
    assert!(spokes.contains(&(3, r(1, 2))));
    let load = star.iter().fold(R::zero(), |sum, e| sum + &e.weight[0] * e.edge.length2());
    // Spokes alone; with the rim −4 − 4 − 4 the sum is 0.
    assert_eq!(load, r(12, 1));
    let gradients: Vec<(R, R)> = m
        .topology
        .faces()
        .map(|f| pair.gradient(Which::Mesh, f))
        .map(|p| (p.x.clone(), p.y.clone()))
        .collect();
    assert_eq!(gradients, [(r(0, 1), r(-1, 1)), (r(1, 2), r(1, 2)), (r(-1, 1), r(0, 1))]);
}

#[test]
fn principal_curvatures_are_rounded_where_they_are_irrational() {
    let c = Curvatures { mean: r(1, 1), gauss: r(-1, 1) };
    let root = f64::sqrt(2.0);
    // 1 − √2 cancels; K divided by the other root does not.
    assert_eq!(c.principal(), Roots::Rounded([-1.0 / (1.0 + root), 1.0 + root]));
    let none = Curvatures { mean: r(1, 1), gauss: r(2, 1) };
    assert_eq!(none.principal(), Roots::Complex(r(-1, 1)));
}
