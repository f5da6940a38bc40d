//! Curvatures at faces, corners and edges (17), and of offsets (18).

use isogeo::construct::inscribed_f_parallel;
use isogeo::mesh::{FaceId, FaceList, HalfEdge, Mesh, VertexId};
use isogeo::pair::*;
use isogeo::scalar::{Rational, RationalField, Ring};
use isogeo::space::{Plane, Point, Transform, Vector2};
use proptest::prelude::*;

use super::{Draw, Verdict, circular, laws, parallel_polygon, polygon, q};

laws! {
    parallel_convex_faces_have_principal_curvatures
    constructors_say_by_how_much_edges_and_planes_miss
    offsets_have_the_curvatures_of_the_formula
    offsets_with_constant_mean_curvature_come_in_pairs
    faces_are_means_of_corners
    offsets_of_nets_follow_the_formula_at_all_faces
    principal_curvatures_are_the_poles_of_offsets
    motions_keep_curvatures_of_faces
}

const FACE: FaceId = FaceId(0);

/// Moves one point in the plane of its face.
fn pushed<Q: RationalField>(mesh: &mut Mesh<Q>, plane: &Plane<Q>, at: usize, by: &Vector2<Q>) {
    let to = &mesh.points[at].top_view() + by;
    let height = &mesh.points[at].z + plane.gradient.along(by);
    mesh.points[at] = to.at_height(height);
}

fn is_convex<Q: RationalField>(mesh: &Mesh<Q>) -> bool {
    let p = |j: usize| &mesh.points[j % mesh.points.len()];
    (0..mesh.points.len()).all(|j| {
        let (a, b) = ((p(j + 1) - p(j)).top_view(), (p(j + 2) - p(j + 1)).top_view());
        a.det(&b) > Q::zero()
    })
}

/// `minkowski`: H² ≥ K, with equality iff one is a scaled copy of the other.
fn parallel_convex_faces_have_principal_curvatures<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = polygon(draw);
    let k = m.points.len();
    let other = parallel_polygon(draw, &m);
    // Near M itself, so that S is convex, too.
    let near = |m: &Q, s: &Q| m + s * q::<Q>(1, 400);
    let points = m.points.iter().zip(&other.points);
    let points =
        points.map(|(m, s)| Point::new(near(&m.x, &s.x), near(&m.y, &s.y), near(&m.z, &s.z)));
    let s = Mesh { points: points.collect(), ..m.clone() };
    if !(is_convex(&m) && is_convex(&s)) {
        return Ok(());
    }
    let pair = Parallel::new(&m, &s).unwrap();
    let edges = m.topology.half_edges(FACE).map(|h| pair.edge_curvature(h).unwrap());
    let edges: Vec<Q> = edges.collect();
    let scaled = (1..k).all(|j| edges[j] == edges[0]);
    let discriminant =
        FParallel::new(&m, &s).unwrap().face_curvatures(FACE).unwrap().discriminant();
    prop_assert!(discriminant >= Q::zero());
    prop_assert_eq!(discriminant.is_zero(), scaled);
    Ok(())
}

/// Without convexity it fails: a reflex corner is enough.
#[test]
fn a_reflex_face_may_have_no_principal_curvatures() {
    let mesh = |corners: [(i64, i64); 4]| {
        let mut faces = FaceList::new();
        faces.push(0..4);
        let points = corners.map(|(x, y)| Point::new(x, y, 0).map(|&n| Rational::from_i64(n)));
        Mesh::new(points.to_vec(), faces).unwrap()
    };
    let m = mesh([(0, 0), (4, 0), (1, 1), (0, 4)]);
    let s = mesh([(0, 0), (4, 0), (4, 0), (0, 12)]);
    assert!(Parallel::new(&m, &s).is_ok() && !is_convex(&m));
    let curvatures = FParallel::new(&m, &s).unwrap().face_curvatures(FACE).unwrap();
    assert_eq!(curvatures.mean, q::<Rational>(2, 1));
    assert_eq!(curvatures.gauss, q::<Rational>(6, 1));
    assert!(curvatures.discriminant() < Rational::zero());
}

fn constructors_say_by_how_much_edges_and_planes_miss<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    prop_assert!(Parallel::new(&m, &s).is_ok());
    let pair = FParallel::new(&m, &s).unwrap();
    prop_assert!(pair.parallel().is_ok());
    prop_assert_eq!(pair.gradient(FACE), &m.face_plane(FACE).unwrap().gradient);

    let step = draw.non_zero();
    let mut raised = s.clone();
    raised.points[1].z += &step;
    let misfit = Misfit::FacePlanes { face: FACE, vertex: VertexId(1), residual: step };
    prop_assert_eq!(FParallel::new(&m, &raised).map(|_| ()), Err(misfit));
    prop_assert!(Parallel::new(&m, &raised).is_err());

    // Moved within the plane: the faces stay parallel, an edge does not.
    let (plane, by) = (m.face_plane(FACE).unwrap(), draw.vector());
    let mut moved = s.clone();
    pushed(&mut moved, &plane, 1, &by);
    prop_assert!(FParallel::new(&m, &moved).is_ok());
    let along = |i: usize| (&m.points[i + 1] - &m.points[i]).top_view().det(&by).is_zero();
    prop_assert_eq!(Parallel::new(&m, &moved).is_ok(), along(0) && along(1));
    if let Err(Misfit::Edge { edge: (VertexId(0), VertexId(1)), residual }) =
        Parallel::new(&m, &moved)
    {
        prop_assert_eq!(residual.z, (&m.points[1] - &m.points[0]).top_view().det(&by));
    }
    Ok(())
}

/// `eq-17-18`: from the formula, and from the vertices of the offset mesh.
fn offsets_have_the_curvatures_of_the_formula<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let (pair, d) = (FParallel::new(&m, &s).unwrap(), draw.number());
    let curvatures = pair.face_curvatures(FACE).unwrap();
    let mut offset = pair.offset(&d);
    let law = pair.face_forms(FACE).offset_law();
    prop_assert_eq!(law.at(&d), curvatures.offset(&d));
    // A critical offset may have no plane at all.
    let Ok(measured) = FParallel::new(&offset, &s).map(|p| p.face_curvatures(FACE)) else {
        prop_assert_eq!(law.at(&d), None);
        return Ok(());
    };
    prop_assert_eq!(measured.ok(), law.at(&d));
    prop_assert!(Parallel::new(&m, &offset).is_ok());

    // The coefficients are those of the values.
    if let Some(value) = law.at(&d) {
        let [a, b, c] = law.denominator();
        let [e, f] = law.mean_numerator();
        let denominator = a + &d * (b + &d * c);
        prop_assert_eq!(value.mean * &denominator, e + &d * f);
        prop_assert_eq!(value.gauss * denominator, law.gauss_numerator().clone());
    }
    let (plane, by) = (m.face_plane(FACE).unwrap(), draw.vector());
    let change = by.det(&(&offset.points[2] - &offset.points[0]).top_view());
    pushed(&mut offset, &plane, 1, &by);
    let forms = FParallel::new(&offset, &s).map(|p| p.face_forms(FACE).four.first);
    if let Ok(area) = forms {
        let [a, b, c] = law.denominator();
        prop_assert_eq!(area == a + &d * (b + &d * c), change.is_zero());
    }
    Ok(())
}

/// `cmc-offset`, `cgc-offset`
fn offsets_with_constant_mean_curvature_come_in_pairs<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let pair = FParallel::new(&m, &s).unwrap();
    let c = pair.face_curvatures(FACE).unwrap();
    let (opposite, constant) = (c.distance_to_opposite_mean(), c.distance_to_constant_gauss());
    prop_assert_eq!(opposite.is_none(), c.mean.is_zero());
    let (Some(opposite), Some(constant)) = (opposite, constant) else { return Ok(()) };
    let measure = |d: &Q| {
        let offset = pair.offset(d);
        FParallel::new(&offset, &s).ok().and_then(|p| p.face_curvatures(FACE).ok())
    };
    let (h, k) = (&c.mean, &c.gauss);
    prop_assert_eq!(measure(&opposite).map(|c| c.mean), (h.square() != *k).then(|| -h));
    let four = h.square() * Q::from_i64(4);
    prop_assert_eq!(measure(&constant).map(|c| c.gauss), (!k.is_zero()).then(|| four.clone()));
    let elsewhere = measure(&(constant + Q::one()));
    // K^d takes each value but 0 at two distances at most, symmetric to the vertex of a parabola.
    if let Some(elsewhere) = elsewhere.filter(|_| !k.is_zero()) {
        let other = q::<Q>(-1, 2) / h + Q::one();
        let same = (&other * Q::from_i64(2) * h + other.square() * k + Q::one()) * &four == *k;
        prop_assert_eq!(elsewhere.gauss == four, same);
    }
    Ok(())
}

/// Theory of edges: `2 area(F) = Σ det(e_i, e_j)` with weights κ; for quads two corners each way.
fn faces_are_means_of_corners<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let pair = Parallel::new(&m, &s).unwrap();
    let k = m.points.len();
    let kappa: Vec<Q> = (0..k).map(|j| pair.edge_curvature(HalfEdge(j as u32)).unwrap()).collect();
    let edge = |m: &Mesh<Q>, j: usize| (&m.points[(j + 1) % k] - &m.points[j]).top_view();
    for (j, kappa) in kappa.iter().enumerate() {
        prop_assert_eq!(edge(&s, j), edge(&m, j).scaled(kappa));
        prop_assert_ne!(edge(&s, j), edge(&m, j).scaled(&(kappa + Q::one())));
    }
    let mut sums = Forms::zero();
    for j in 0..k - 1 {
        for i in 0..j {
            let det = edge(&m, i).det(&edge(&m, j)) * Q::from_i64(2);
            sums = sums.plus(&Forms {
                mixed: (&kappa[i] + &kappa[j]) * &det * q::<Q>(1, 2),
                second: &kappa[i] * &kappa[j] * &det,
                first: det,
            });
        }
    }
    let forms = FParallel::new(&m, &s).unwrap().face_forms(FACE);
    prop_assert_eq!(&sums, &forms.four);
    if k == 4 {
        let c = forms.curvatures().unwrap();
        for start in [0, 1] {
            // Corners 1 and 3, or 2 and 0, with the triangles cut off there.
            let weighted = |corner: usize| {
                let weight = edge(&m, (corner + 3) % 4).det(&edge(&m, corner)) * Q::from_i64(2);
                (pair.corner_curvatures(HalfEdge(corner as u32)).unwrap(), weight)
            };
            let ((a, u), (b, v)) = (weighted((start + 1) % 4), weighted((start + 3) % 4));
            prop_assert_eq!(&u + &v, forms.four.first.clone());
            prop_assert_eq!(&c.mean * &forms.four.first, &a.mean * &u + &b.mean * &v);
            prop_assert_eq!(&c.gauss * &forms.four.first, a.gauss * u + b.gauss * v);
        }
    }
    Ok(())
}

fn offsets_of_nets_follow_the_formula_at_all_faces<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let m = circular(draw, 2, 1);
    let Ok(pair) = inscribed_f_parallel(&m, VertexId(0), &draw.top_view()) else { return Ok(()) };
    let d = draw.number();
    let offset = pair.offset(&d);
    let Ok(moved) = FParallel::new(&offset, pair.image()) else { return Ok(()) };
    for face in m.topology.faces() {
        let law = pair.face_forms(face).offset_law();
        prop_assert_eq!(moved.face_curvatures(face).ok(), law.at(&d));
        let wrong = law.at(&(&d + Q::one()));
        let flat = law.gauss_numerator().is_zero() && law.mean_numerator()[0].is_zero();
        prop_assert!(
            flat || moved.face_curvatures(face).ok() != wrong
                || wrong.is_none()
                || law.at(&d) == wrong
        );
    }
    Ok(())
}

fn principal_curvatures_are_the_poles_of_offsets<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let (a, b) = (draw.number(), draw.number());
    let c = Curvatures { mean: (&a + &b) * q::<Q>(1, 2), gauss: &a * &b };
    let (low, high) = if a < b { (&a, &b) } else { (&b, &a) };
    prop_assert_eq!(c.principal(), Roots::Exact(vec![low.clone(), high.clone()]));
    prop_assert_eq!(c.discriminant(), ((&a - &b) * q::<Q>(1, 2)).square());
    prop_assert_eq!(c.principal().rounded(), Some([low.to_f64(), high.to_f64()]));

    // On a face: every critical distance annihilates the area, and no other does.
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let forms = FParallel::new(&m, &s).unwrap().face_forms(FACE);
    let law = forms.offset_law();
    if let Roots::Exact(critical) = law.critical() {
        let rational = forms.curvatures().unwrap().principal();
        let poles: Vec<Q> = rational.exact().into_iter().flatten().filter_map(Q::try_inv).collect();
        prop_assert_eq!(critical.len(), poles.len());
        for d in critical {
            prop_assert_eq!(law.at(&d), None);
            prop_assert!(poles.contains(&-&d));
            let near = &d + q::<Q>(1, 1000);
            prop_assert!(law.at(&near).is_some() || poles.contains(&-near));
        }
    }
    // Multiplied by 1 + ε the square is no square.
    let k = &c.gauss - q::<Q>(2, 1) * (Q::one() + c.discriminant());
    let irrational = Curvatures { gauss: k, ..c }.principal();
    if let Roots::Rounded([low, high]) = irrational {
        prop_assert!(low < high);
    }
    Ok(())
}

fn motions_keep_curvatures_of_faces<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let s = parallel_polygon(draw, &m);
    let (motion, scaling) = (draw.motion(), draw.scaling());
    let before = FParallel::new(&m, &s).unwrap().face_forms(FACE);
    let (moved, image) = (motion.apply(&m), motion.apply(&s));
    let after = FParallel::new(&moved, &image).unwrap().face_forms(FACE);
    prop_assert_eq!(&after, &before);
    let grown = scaling.apply(&m);
    let factor = scaling.horizontal();
    let scaled = scaling.apply(&s);
    let after = FParallel::new(&grown, &scaled).unwrap().face_forms(FACE);
    prop_assert_eq!(after.curvatures(), before.curvatures());
    prop_assert_eq!(after.area(), before.area() * factor.square());
    let doubled = m.map(|c| c * q::<Q>(2, 1));
    let after = FParallel::new(&doubled, &s).unwrap().face_curvatures(FACE).unwrap();
    prop_assert_eq!(after.mean, before.curvatures().unwrap().mean * q::<Q>(1, 2));
    Ok(())
}
