//! Centres of circle patterns and Voronoi diagrams (Theorem 2).

use isogeo::check::{Decider, Verdict as Answer};
use isogeo::construct::*;
use isogeo::mesh::{FaceId, Mesh, VertexId};
use isogeo::net::{Net, Property};
use isogeo::scalar::{Rational, RationalField};
use isogeo::space::*;
use proptest::prelude::*;

use super::*;

laws! { in 24 cases: conical_meshes_have_circle_centres }

/// `thm-2-voronoi`: vertices are centres of circles through the sites around them, edges bisect
/// sites, and sites lie on the radical axes of the circles at the ends of an edge.
fn conical_meshes_have_circle_centres<Q: RationalField>(draw: &mut Draw<Q>) -> Verdict {
    let net = translational(draw, 2, 2);
    let dual = conical(draw);
    for m in std::iter::once(&net).chain(&dual) {
        let (face, start) = (FaceId(draw.index(4) as u32), draw.top_view());
        let pair = circumscribed_v_parallel(m, face, &start).unwrap();
        let pattern = CircleCentres::new(pair.image()).unwrap();
        prop_assert_eq!(&pattern.sites[face.index()], &start);
        for face in m.topology.faces() {
            for v in m.topology.face(face) {
                let circle = &pattern.circles[v.index()];
                prop_assert_eq!(&circle.centre, &m.points[v.index()].top_view());
                prop_assert!(circle.power(&pattern.sites[face.index()]).is_zero());
            }
        }
        let intruder = pattern.intruder();
        let inside = |v: &usize| {
            let circle = &pattern.circles[*v];
            pattern.sites.iter().any(|x| circle.power(x) < Q::zero())
        };
        let first = (0..m.points.len()).find(inside);
        prop_assert_eq!(intruder.as_ref().map(|i| i.vertex.index()), first);
        if let Some(found) = intruder {
            // The plane of that face lies above the vertex.
            let plane = pair.image().face_plane(found.face).unwrap();
            let point = &pair.image().points[found.vertex.index()];
            let height = &point.z - plane.point_at(&point.top_view()).z;
            prop_assert_eq!(height * q::<Q>(2, 1), found.power);
        }
        let mut wrong = pair.image().clone();
        let moved = draw.index(m.points.len());
        wrong.points[moved].z += &q::<Q>(1, 1000);
        prop_assert!(CircleCentres::new(&wrong).is_err());
    }
    Ok(())
}

fn r(p: i64, d: i64) -> Rational {
    q(p, d)
}

/// The unit squares: a Voronoi diagram if sites lie in their own squares, none if they lie beside.
#[test]
fn squares_are_cells_of_sites_inside() {
    let profile: Vec<_> = (0..5).map(|i| (r(i, 1), r(i * i, 1))).collect();
    let m = translational_net(&profile, &profile).unwrap();
    let pattern = |x, y| {
        let pair = circumscribed_v_parallel(&m, FaceId(0), &TopView::new(x, y)).unwrap();
        let image: Mesh<Rational> = pair.image().clone();
        (CircleCentres::new(&image).unwrap(), image)
    };
    for (x, y) in [(r(1, 2), r(1, 2)), (r(1, 5), r(2, 3)), (r(0, 1), r(1, 1))] {
        assert_eq!(pattern(x.clone(), y.clone()).0.intruder(), None, "({x}, {y})");
    }
    // Seen from the lift of the sites: a Delaunay mesh with convex boundary, the dual of the cells.
    let (inside, image) = pattern(r(1, 5), r(2, 3));
    let dual = metric_dual(&image).unwrap();
    assert_eq!(dual.points.iter().map(Point::top_view).collect::<Vec<_>>(), inside.sites);
    let decider = Decider::of_rationals(&dual.points);
    let report = Net::new(&dual.topology, &decider).check(Property::Delaunay);
    assert!(matches!(report.verdict(), Answer::Proved | Answer::Undecided));
    // The site of face (0, 0) at (3/2, 1/2), in the next square: S₁ is not convex.
    let (beside, _) = pattern(r(3, 2), r(1, 2));
    let found = beside.intruder().unwrap();
    // About (0, 0) through (3/2, 1/2), of radius √(5/2); the site of face (1, 0) is its mirror image (1/2, 1/2).
    assert_eq!((found.vertex, &beside.circles[0].radius2), (VertexId(0), &r(5, 2)));
    assert_eq!(beside.sites[found.face.index()], TopView::new(r(1, 2), r(1, 2)));
    assert_eq!(found.power, r(-2, 1));
}

#[test]
fn a_mesh_that_is_not_circumscribed_has_no_sites() {
    let profile: Vec<_> = (0..3).map(|i| (r(i, 1), r(i * i, 1))).collect();
    let m = translational_net(&profile, &profile).unwrap();
    let refused = CircleCentres::new(&m);
    // Face 0: the plane z = x + y, |p|² + 2t = 2.
    let expected = NotCircumscribed::Face { face: FaceId(0), residual: r(2, 1) };
    assert_eq!(refused, Err(expected));
}
