//! Gauss images (Theorems 1 and 2).

use isogeo::check::Residual;
use isogeo::construct::*;
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::net::i_conical::Balance;
use isogeo::pair::*;
use isogeo::scalar::{Rational, RationalField};
use isogeo::space::*;
use proptest::prelude::*;

use super::*;

laws! {
    polygons_on_a_circle_close_iff_their_number_of_sides_is_even
}

laws! {
    in 24 cases:
    inscribed_images_close_for_every_start
    starting_over_the_gradient_gives_a_point
    lifts_of_circular_nets_are_planar
    conical_meshes_have_a_circumscribed_image
    circumscribed_images_with_the_same_top_view_close_for_every_start
    duality_exchanges_inscribed_and_circumscribed
}

/// `thm-1-f`, `thm-1-converse`
fn inscribed_images_close_for_every_start<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let (vertex, start) = (VertexId(draw.index(9) as u32), draw.top_view());
    let pair = inscribed_f_parallel(&m, vertex, &start).unwrap();
    prop_assert!(pair.image().points.iter().all(|s| ParabolicSphere::unit().contains(s)));
    prop_assert_eq!(pair.image().points[vertex.index()].top_view(), start.clone());
    prop_assert!(pair.parallel().is_ok());
    // Not circular any more: some face is open, unless it became a point.
    let wrong = sheared(&m);
    match inscribed_f_parallel(&wrong, vertex, &start) {
        Err(NoGaussImage::FaceOpen { .. }) => {}
        Err(other) => prop_assert!(false, "{other}"),
        Ok(pair) => {
            let image = pair.image();
            let zero = wrong.topology.edges().any(|h| {
                let t = &wrong.topology;
                image.points[t.origin(h).index()] == image.points[t.target(h).index()]
            });
            prop_assert!(zero);
        }
    }
    Ok(())
}

/// `thm-1-f` for single faces. In the top view a step is the reflection at the line through the
/// gradient across the edge: an odd number of them is a reflection, and starts on its line close.
fn polygons_on_a_circle_close_iff_their_number_of_sides_is_even<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let (k, centre, plane) = (3 + draw.index(5), draw.top_view(), draw.plane());
    let parameters = [(-3, 1), (-1, 1), (-1, 3), (1, 5), (2, 3), (2, 1), (5, 1)];
    let corner = |(p, d): (i64, i64)| {
        let turn = Rotation::from_parameter(&q::<Q>(p, d)).unwrap();
        plane.point_at(&(&centre + &turn.turn(&Vector2::new(Q::from_i64(2), Q::zero()))))
    };
    let mut faces = FaceList::new();
    faces.push(0..k as u32);
    let mut m = Mesh::new(parameters.map(corner)[..k].to_vec(), faces).unwrap();
    let gradient = plane.gradient.dual();
    let start = &gradient + &Vector2::new(draw.non_zero(), draw.number());
    match inscribed_f_parallel(&m, VertexId(0), &start) {
        Ok(pair) => prop_assert!(k % 2 == 0 || pair.parallel().is_ok()),
        Err(NoGaussImage::FaceOpen { residual, .. }) => {
            prop_assert_eq!(k % 2, 1);
            let middle = &start + &residual.top_view().scaled(&q(1, 2));
            prop_assert!(inscribed_f_parallel(&m, VertexId(0), &middle).is_ok());
        }
        Err(other) => prop_assert!(false, "{other}"),
    }
    // A quad moved off its circle is open for all these starts.
    if k == 4 {
        let by = (&m.points[1] - &m.points[0]).top_view();
        m.points[0] = plane.point_at(&(&m.points[0].top_view() + &by.scaled(&q(-1, 2))));
        prop_assert!(inscribed_f_parallel(&m, VertexId(0), &start).is_err());
    }
    Ok(())
}

/// The counterexample that `thm-1-converse` excludes.
fn starting_over_the_gradient_gives_a_point<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = polygon(draw);
    let gradient = m.face_plane(FaceId(0)).unwrap().gradient;
    let pair = inscribed_f_parallel(&m, VertexId(0), &gradient.dual()).unwrap();
    prop_assert!(pair.image().points.iter().all(|p| *p == pair.image().points[0]));
    let mut start = gradient.dual();
    start.x += &Q::one();
    let moved = inscribed_f_parallel(&m, VertexId(0), &start);
    let constant = |p: &FParallel<'_, Q>| p.image().points.iter().all(|p| p.x == start.x);
    prop_assert!(!moved.is_ok_and(|p| constant(&p)));
    Ok(())
}

/// `thm-1-v`
fn lifts_of_circular_nets_are_planar<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 2, 2);
    if !graph_faces(&m) {
        return Ok(());
    }
    let pair = inscribed_v_parallel(&m).unwrap();
    prop_assert!(pair.image().points.iter().all(|s| ParabolicSphere::unit().contains(s)));
    let wrong = sheared(&m);
    let refused = inscribed_v_parallel(&wrong).map(|_| ());
    let rectangle = wrong.topology.faces().all(|f| lift(&wrong).face_plane(f).is_ok());
    prop_assert_eq!(refused.is_ok(), rectangle);
    let planar_quads_only = matches!(refused, Ok(()) | Err(Misfit::Plane(Which::Image, _)));
    prop_assert!(planar_quads_only);
    Ok(())
}

/// Whether all faces lie on planes that touch Σ.
fn circumscribed<Q: RationalField>(mesh: &Mesh<Q>) -> bool {
    let sigma = ParabolicSphere::unit();
    let touches = |f| mesh.face_plane(f).is_ok_and(|p| sigma.tangency(&p).is_zero());
    mesh.topology.faces().all(touches)
}

/// `thm-2-f`, `conical-cone`
fn conical_meshes_have_a_circumscribed_image<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let net = translational(draw, 3, 3);
    let dual = conical(draw);
    for m in std::iter::once(&net).chain(&dual) {
        let image = match circumscribed_f_parallel(m) {
            Ok(image) => image,
            // Parallel planes around a vertex.
            Err(NoGaussImage::AtInfinity(_)) => continue,
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        };
        prop_assert!(image.pair.parallel().is_ok());
        let s = image.pair.image();
        for f in m.topology.faces() {
            let plane = ParabolicSphere::unit().tangent_plane(&image.pair.gradient(f).dual());
            prop_assert!(m.topology.face(f).iter().all(|v| plane.contains(&s.points[v.index()])));
        }
    }
    let Some(mut m) = dual else { return Ok(()) };
    let free = circumscribed_f_parallel(&m).map(|c| c.free.len());
    prop_assert!(free.is_ok_and(|n| n <= 4));
    // A dual of a planar mesh that is not circular.
    let Ok(wrong) = metric_dual(&sheared(&circular(draw, 3, 3))) else { return Ok(()) };
    if graph_faces(&wrong) {
        let inner = wrong.topology.interior_vertices().next().unwrap();
        match circumscribed_f_parallel(&wrong) {
            Err(NoGaussImage::NotConical { vertex, residual }) => {
                prop_assert_eq!(vertex, inner);
                prop_assert!(!residual.is_zero());
            }
            other => prop_assert!(balance(&wrong, inner).is_zero(), "{:?}", other.map(|_| ())),
        }
    }
    m.points[0].z += &Q::one();
    prop_assert!(matches!(circumscribed_f_parallel(&m), Err(NoGaussImage::Plane(_))));
    Ok(())
}

fn balance<Q: RationalField>(m: &Mesh<Q>, v: VertexId) -> Q {
    let around: Vec<_> = m.topology.star(v).map(|h| m.topology.target(h)).collect();
    let at = |v: VertexId| m.points[v.index()].clone();
    Balance.eval(&[at(v), at(around[0]), at(around[1]), at(around[2]), at(around[3])], &Q::one())
}

/// `thm-2-v`
fn circumscribed_images_with_the_same_top_view_close_for_every_start<Q: RationalField>(
    draw: &mut Draw<Q>,
) -> Verdict {
    let net = translational(draw, 2, 2);
    let dual = conical(draw);
    for m in std::iter::once(&net).chain(&dual) {
        let (face, start) = (FaceId(draw.index(4) as u32), draw.top_view());
        let pair = circumscribed_v_parallel(m, face, &start).unwrap();
        prop_assert!(circumscribed(pair.image()));
        prop_assert_eq!(&pair.gradient(Which::Image, face).dual(), &start);
        let wrong = sheared(m);
        let v = wrong.topology.interior_vertices().next().unwrap();
        let outcome = circumscribed_v_parallel(&wrong, face, &start);
        let open = matches!(outcome, Err(NoGaussImage::VertexOpen { vertex, .. }) if vertex == v);
        // Rotated about the vertex, a point stays only if it lies over the vertex.
        let centre = wrong.points[v.index()].top_view();
        prop_assert_eq!(open, !balance(&wrong, v).is_zero() && centre != start);
    }
    Ok(())
}

/// `duality-f-v`: the dual of the lift of a circular net is the circumscribed image of its dual.
fn duality_exchanges_inscribed_and_circumscribed<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let m = circular(draw, 3, 3);
    let (Ok(dual), Ok(image)) = (metric_dual(&m), metric_dual(&lift(&m))) else { return Ok(()) };
    if !graph_faces(&dual) {
        return Ok(());
    }
    let inner = dual.topology.interior_vertices().next().unwrap();
    let canonical = circumscribed_f_parallel(&dual).unwrap();
    let found = &canonical.pair.image().points[inner.index()];
    prop_assert_eq!(found, &image.points[inner.index()]);
    prop_assert!(FParallel::new(&dual, &image).is_ok());
    let mut wrong = image.clone();
    wrong.points[inner.index()].z += &Q::one();
    prop_assert!(FParallel::new(&dual, &wrong).is_err());
    Ok(())
}

/// Three faces between a triangle and its image under an inversion: each is concyclic, but a start
/// off the mesh comes back as another point.
#[test]
fn an_odd_ring_of_faces_does_not_close() {
    let corner = |x: i64, y: i64, scale: i64| {
        // The inverse at the circle of squared radius 1800, which makes it larger.
        let factor: Rational = q(scale, 1);
        let inverse = if scale == 0 { q(1800, x * x + y * y) } else { factor };
        TopView::new(q::<Rational>(x, 1) * &inverse, q::<Rational>(y, 1) * &inverse)
    };
    let triangle = [(3, 1), (-2, 5), (-1, -4)];
    let inner = triangle.map(|(x, y)| corner(x, y, 1));
    let outer = triangle.map(|(x, y)| corner(x, y, 0));
    let sigma = ParabolicSphere::unit();
    let points = inner.iter().chain(&outer).map(|p| sigma.contact_at(p).point).collect();
    let mut faces = FaceList::new();
    (0..3).for_each(|i| faces.push([i, 3 + i, 3 + (i + 1) % 3, (i + 1) % 3]));
    let m = Mesh::new(points, faces).unwrap();
    let own = inscribed_f_parallel(&m, VertexId(0), &inner[0]).unwrap();
    assert_eq!(own.image().points, m.points);
    for f in m.topology.faces() {
        let c = own.face_curvatures(f).unwrap();
        assert_eq!((c.mean, c.gauss), (q(1, 1), q(1, 1)));
    }
    let start = TopView::new(q(1, 1), q(1, 1));
    let Err(NoGaussImage::VertexCycleOpen(cycle)) = inscribed_f_parallel(&m, VertexId(0), &start)
    else {
        panic!("an odd ring closed")
    };
    assert!(cycle.len() >= 3, "{cycle:?}");
    assert!(inscribed_v_parallel(&m).is_ok());
}
