//! The fast ways agree with the plain ones: forms without divisions, in integers, in one pass.

use isogeo::construct::{inscribed_v_parallel, lift, quad_patch};
use isogeo::mesh::{ExactPoints, FaceId, FaceList, Mesh, VertexId};
use isogeo::pair::*;
use isogeo::scalar::{BigInt, Fraction, Prime61, Rational, RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

use super::vertices::wild;
use super::*;

laws! {
    forms_without_divisions_are_those_of_the_gradients
    one_pass_over_the_faces_gives_the_forms_of_the_lift
    everything_about_an_offset_follows_from_its_corners
    faces_by_points_are_faces_of_pairs
}

laws! {
    in 64 cases:
    integers_give_the_forms_of_vertices
    integers_give_the_forms_of_faces
}

const CENTRE: VertexId = VertexId(0);
const FACE: FaceId = FaceId(0);

fn forms_without_divisions_are_those_of_the_gradients<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = star(draw);
    let s = with_heights(draw, &m);
    let pair = VParallel::new(&m, &s).unwrap();
    let edges = pair.star(CENTRE).unwrap();
    let mut rays: Vec<_> =
        edges.iter().map(|e| Ray { edge: e.edge.clone(), rise: e.rise.clone() }).collect();
    let expected = pair.vertex_forms(CENTRE).unwrap().four;
    let (forms, scale) = star_forms(&rays).unwrap();
    prop_assert_eq!(&forms.map(|n| n.clone() / &scale), &expected);
    // A neighbour raised: D(v, s) changes by its weight in S.
    rays[0].rise[0] += &scale;
    let (raised, scale) = star_forms(&rays).unwrap();
    let change = (raised.mixed - forms.mixed) / scale.square();
    prop_assert_eq!(change, &edges[0].weight[1] * Q::from_i64(2));
    // Two rays on a line span no plane.
    rays[1].edge = rays[0].edge.clone();
    prop_assert_eq!(star_forms(&rays), None);
    Ok(())
}

fn one_pass_over_the_faces_gives_the_forms_of_the_lift<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let Some(mut m) = wild(draw) else { return Ok(()) };
    let plain = |m: &Mesh<Q>| inscribed_v_parallel(m).unwrap().vertex_forms(CENTRE).unwrap();
    let quick = |m: &Mesh<Q>| LiftedForms::new(m).unwrap().vertex_forms(CENTRE).unwrap();
    let before = quick(&m);
    prop_assert_eq!(&before, &plain(&m));
    prop_assert!(LiftedForms::new(&m).unwrap().vertex_forms(VertexId(1)).is_err());
    m.points[1].z += &Q::one();
    prop_assert_eq!(quick(&m), plain(&m));
    // The lift does not see heights; D(v, s) does.
    prop_assert_eq!(&quick(&m).four.second, &before.four.second);
    let weight = inscribed_v_parallel(&m).unwrap().star(CENTRE).unwrap();
    let weight = weight.iter().find(|e| e.target == VertexId(1)).unwrap().weight[1].clone();
    prop_assert_eq!(quick(&m).four.mixed - before.four.mixed, weight * Q::from_i64(2));
    Ok(())
}

fn everything_about_an_offset_follows_from_its_corners<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let polygon = |draw: &mut Draw<Q>, k| (0..k).map(|_| draw.top_view()).collect::<Vec<_>>();
    let k = 3 + draw.index(4);
    let (f, s, d) = (polygon(draw, k), polygon(draw, k), draw.number());
    let moved: Vec<_> = f.iter().zip(&s).map(|(v, w)| v + &w.position().scaled(&d)).collect();
    let degenerate = twice_area(&f).is_zero() || twice_area(&moved).is_zero();
    match OffsetResiduals::of(&f, &s, &d) {
        Some(residuals) => prop_assert!(!degenerate && residuals.vanish(), "{residuals:?}"),
        None => prop_assert!(degenerate),
    }
    Ok(())
}

/// The control: in arithmetic that rounds, the residuals are not all 0.
#[test]
fn residuals_of_offsets_see_a_wrong_arithmetic() {
    let at = |x, y| TopView::new(x, y);
    let (f, s) =
        ([at(0.1, 0.2), at(0.7, 0.3), at(0.4, 0.9)], [at(0.3, 0.1), at(0.6, 0.6), at(0.1, 0.7)]);
    let residuals = OffsetResiduals::of(&f, &s, &(1.0 / 3.0)).unwrap();
    assert!(!residuals.vanish() && residuals.area.abs() < 1e-12);
}

fn faces_by_points_are_faces_of_pairs<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let pair = FParallel::new(&m, &s).unwrap();
    let all = face_curvatures(&m.topology, &m.points, &s.points).unwrap();
    prop_assert_eq!(all, vec![pair.face_curvatures(FACE)]);
    let short = face_curvatures(&m.topology, &m.points, &s.points[1..]);
    prop_assert_eq!(short, Err(Misfit::Points(Which::Image)));
    Ok(())
}

fn rational<Q: RationalField>(mesh: &Mesh<Q>) -> Mesh<Rational> {
    mesh.map(RationalField::convert)
}

/// The mesh over a lattice, over a lattice of huge numbers, and without a common denominator.
fn stretched(mesh: &Mesh<Rational>) -> Vec<Mesh<Rational>> {
    let fraction = |p: BigInt, q: BigInt| Rational::from_fraction(p, q).unwrap();
    let power = |e: u32| fraction(BigInt::from(1) << e, 1.into());
    let large =
        [7919i64, 104_729, 1_299_709, 15_485_863, 179_424_673, 2_038_074_743, 22_801_763_489];
    // Top views are scaled linearly, so that faces stay planar.
    let linear = large.map(|p| fraction(1.into(), p.into()) + Rational::from_i64(3));
    let each = |f: &dyn Fn(&Point<Rational>) -> Point<Rational>| {
        let points = mesh.points.iter().map(f).collect();
        Mesh { points, ..mesh.clone() }
    };
    vec![
        mesh.clone(),
        each(&|p| p.map(|c| c * power(100))),
        each(&|p| p.map(|c| c * power(300))),
        each(&|p| {
            let [a, b, c, d, e, f, g] = &linear;
            Point::new(&p.x * a + &p.y * b, &p.x * c - &p.y * d, &p.z * e + &p.x * f + &p.y * g)
        }),
    ]
}

fn reduced(forms: &Forms<Fraction<BigInt>>) -> Forms<Rational> {
    forms.try_map(|n| n.reduced()).unwrap()
}

fn points(mesh: &Mesh<Rational>) -> ExactPoints<'_> {
    mesh.points.as_slice().into()
}

fn integers_give_the_forms_of_vertices<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = rational(&star(draw));
    for m in stretched(&m) {
        let s = rational(&with_heights(draw, &m.map(RationalField::convert::<Q>)));
        let pair = VParallel::new(&m, &s).unwrap();
        let expected = pair.vertex_forms(CENTRE).unwrap().four;
        let exact = ExactPair::new(&m.topology, points(&m), points(&s));
        prop_assert_eq!(&reduced(&exact.vertex_forms(CENTRE).unwrap().four), &expected);
        let lifted = inscribed_v_parallel(&m).unwrap();
        let exact = ExactPair::lifted(&m.topology, points(&m));
        let forms = exact.vertex_forms(CENTRE).unwrap();
        prop_assert_eq!(&reduced(&forms.four), &lifted.vertex_forms(CENTRE).unwrap().four);
        let curvatures = exact.vertex_curvatures(CENTRE).map(|c| c.reduced().unwrap());
        prop_assert_eq!(curvatures, lifted.vertex_curvatures(CENTRE));
        prop_assert!(exact.vertex_forms(VertexId(1)).is_err());
    }
    Ok(())
}

fn integers_give_the_forms_of_faces<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let d = draw.number().convert::<Rational>();
    let (m, s) = (rational(&m), rational(&s));
    for m in stretched(&m) {
        for s in stretched(&s) {
            let expected = Forms::of(&top_views(&m), &top_views(&s));
            let exact = ExactPair::new(&m.topology, points(&m), points(&s));
            let forms = exact.face_forms(FACE);
            prop_assert_eq!(&reduced(&forms.four), &expected);
            let curvatures = exact.face_curvatures(FACE).ok().and_then(|c| c.reduced());
            prop_assert_eq!(curvatures, expected.at_face());
            let residuals = OffsetResiduals::of(&top_views(&m), &top_views(&s), &d);
            prop_assert_eq!(exact.offset_residuals(FACE, &d), residuals);
        }
    }
    Ok(())
}

fn top_views<Q: RationalField>(m: &Mesh<Q>) -> Vec<TopView<Q>> {
    m.points.iter().map(Point::top_view).collect()
}

/// Faces of any size, and one that runs straight through the vertex.
#[test]
fn a_straight_corner_takes_its_gradient_from_elsewhere() {
    let mut faces = FaceList::new();
    [&[0u32, 1, 3, 2] as &[_], &[0, 2, 4], &[0, 4, 5], &[0, 5, 1]]
        .into_iter()
        .for_each(|f| faces.push(f.iter().copied()));
    let at = |x, y, z| Point::new(x, y, z).map(|&n| Rational::from_i64(n));
    // The upper face lies in z = 2y, though 2, 0, 1 are collinear.
    let heights =
        [at(0, 0, 0), at(1, 0, 0), at(-1, 0, 0), at(0, 1, 2), at(-1, -2, 3), at(1, -3, 5)];
    let m = Mesh::new(heights.to_vec(), faces).unwrap();
    let mut s = m.clone();
    let others = [1, 2, 0, 4, 7, -2];
    for (point, z) in s.points.iter_mut().zip(others) {
        point.z = Rational::from_i64(z);
    }
    s.points[3].z = Rational::from_i64(9);
    s.points[1].z = Rational::from_i64(2);
    let pair = VParallel::new(&m, &s).unwrap();
    let exact = ExactPair::new(&m.topology, points(&m), points(&s));
    let forms = exact.vertex_forms(CENTRE).unwrap();
    let expected = pair.vertex_forms(CENTRE).unwrap();
    assert_eq!(reduced(&forms.four), expected.four);
    assert!(!expected.four.first.is_zero());
    // A vertical face has no gradient at all.
    let mut vertical = m.clone();
    vertical.points[3] = at(3, 0, 5);
    let exact = ExactPair::new(&m.topology, points(&vertical), points(&s));
    assert_eq!(exact.vertex_forms(CENTRE), Err(VertexUndefined::NotAGraph(CENTRE, FACE)));
}

/// Corners span the planes, whatever the numbers are kept in: over a lattice and without one.
#[test]
fn faces_that_are_not_planar_count_with_their_corners() {
    let at = |x, y, z| Point::new(x, y, z).map(|&n| Rational::from_i64(n));
    let heights = [1, 5, 2, 0, 3, 7, 4, 1, 9];
    let grid = (0..9).map(|i| at(i / 3, i % 3 + i * i % 2, heights[i as usize]));
    let m = Mesh::new(grid.collect(), quad_patch(2, 2)).unwrap();
    let centre = VertexId(4);
    let scaled = |f: &Rational| {
        let points = m.points.iter().map(|p| Point::new(&p.x * f, &p.y * f, &p.z * f.square()));
        Mesh { points: points.collect(), ..m.clone() }
    };
    // The same star over a denominator that no lattice holds: (22) does not change.
    let tiny = (0..300).fold(Rational::from_i64(1), |f, _| f * q::<Rational>(1, 3));
    let curvatures = [m.clone(), scaled(&tiny)].map(|m| {
        let is_lattice = matches!(points(&m), ExactPoints::Lattice(_));
        let curvatures = ExactPair::lifted(&m.topology, points(&m)).vertex_curvatures(centre);
        (is_lattice, curvatures.ok().and_then(|c| c.reduced::<Rational>()))
    });
    assert_eq!((curvatures[0].0, curvatures[1].0), (true, false));
    assert!(curvatures[0].1.is_some() && curvatures[0].1 == curvatures[1].1);
    // The control: the planes through other corners are others.
    assert!(VParallel::new(&m, &lift(&m)).is_err());
}

/// Quads of an i-circular net have the gradients of their corners.
#[test]
fn vertices_of_quads_are_those_of_their_lift() {
    let at = |x: i64| (Rational::from_i64(x), Rational::from_i64(x * x * x));
    let profile = [at(0), at(1), at(3), at(4)];
    let m = translational_net(&profile, &profile).unwrap();
    let (pair, exact) =
        (inscribed_v_parallel(&m).unwrap(), ExactPair::lifted(&m.topology, points(&m)));
    for v in m.topology.interior_vertices() {
        let forms = exact.vertex_forms(v).unwrap();
        assert_eq!(reduced(&forms.four), pair.vertex_forms(v).unwrap().four);
    }
    assert_eq!(LiftedForms::new(&m).map(|_| ()), Err(NoTriangle(FACE)));
}

/// A graph over a square grid of triangles, in order or shuffled, modulo a prime.
fn large(side: u32, shuffled: bool) -> Mesh<Prime61> {
    let place = |i: u32| if shuffled { (i as u64 * 7919 % (side * side) as u64) as u32 } else { i };
    let mut points =
        vec![Point::new(Prime61::zero(), Prime61::zero(), Prime61::zero()); (side * side) as usize];
    for i in 0..side * side {
        let (x, y) = (i64::from(i / side), i64::from(i % side));
        let f = |n: i64| Prime61::from_i64(n);
        points[place(i) as usize] = Point::new(
            f(100 * x + y * y % 7),
            f(100 * y + x * x % 11),
            f(x * x * y + y * y + x % 5),
        );
    }
    let mut faces = FaceList::new();
    let at = |i: u32, j: u32| place(i * side + j);
    for i in 0..side - 1 {
        for j in 0..side - 1 {
            faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    Mesh::new(points, faces).unwrap()
}

#[test]
fn large_meshes_are_added_up_by_several_threads() {
    for shuffled in [false, true] {
        let m = large(170, shuffled);
        let (quick, plain) = (LiftedForms::new(&m).unwrap(), inscribed_v_parallel(&m).unwrap());
        for v in m.topology.vertices() {
            assert_eq!(quick.vertex_forms(v), plain.vertex_forms(v), "vertex {}", v.0);
        }
    }
}

#[test]
fn a_vertical_face_leaves_its_vertices_undefined() {
    let mut m = large(4, false);
    m.points[5] = m.points[0];
    let quick = LiftedForms::new(&m).unwrap();
    assert_eq!(
        quick.vertex_forms(VertexId(5)),
        Err(VertexUndefined::NotAGraph(VertexId(5), FaceId(1)))
    );
    assert!(quick.vertex_forms(VertexId(10)).is_ok());
}

#[test]
fn a_face_without_area_has_no_curvature_in_the_list() {
    let grid = quad_patch(1, 2);
    let at = |x, y| Point::new(x, y, 0.0);
    let flat =
        [at(0.0, 0.0), at(0.0, 1.0), at(-3.0, 1.0), at(1.0, 0.0), at(1.0, 1.0), at(-1.0, 1.0)];
    let m = Mesh::new(flat.to_vec(), grid).unwrap();
    let all = face_curvatures(&m.topology, &m.points, &m.points).unwrap();
    assert_eq!(all[0].as_ref().map(|c| (c.mean, c.gauss)), Ok((1.0, 1.0)));
    assert_eq!(all[1], Err(ZeroArea(FaceId(1))));
}

/// The lift as an image of its own, and the lift that is not stored.
#[test]
fn a_stored_lift_is_the_lift() {
    let m =
        stretched(&sampled(&[(2, 0), (1, 1), (-1, 1), (-2, -1), (1, -2)], |x, y| x * x + y * x));
    for m in m {
        let s = lift(&m);
        let stored = ExactPair::new(&m.topology, points(&m), points(&s));
        let lifted = ExactPair::lifted(&m.topology, points(&m));
        let forms = [stored, lifted].map(|p| p.vertex_forms(CENTRE).map(|f| reduced(&f.four)));
        assert_eq!(forms[0], forms[1]);
    }
}
