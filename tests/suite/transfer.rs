//! Meshes under i-M-transformations, and in Euclidean space (Remarks 1 and 2).

use isogeo::check::{Plain, Verdict};
use isogeo::construct::transfer::*;
use isogeo::construct::{moebius_image, quad_patch};
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId};
use isogeo::net::{Net, Property};
use isogeo::pair::Parallel;
use isogeo::scalar::{Field, Rational, RationalField, Ring};
use isogeo::space::laguerre::{Cone, LaguerreTransformation, OrientedPlane};
use isogeo::space::{
    Circle, CylindricalSphere, Dual, ICircle, MoebiusSphere, MoebiusTransformation, Point, TopView,
    Vector3,
};
use proptest::prelude::*;

use crate::meshes::{Q, circular, translational};

fn verdict(mesh: &Mesh<Q>, property: Property) -> Verdict {
    Net::new(&mesh.topology, &Plain(&mesh.points)).check(property).verdict()
}

fn q(n: i64) -> Q {
    Q::from_i64(n)
}

/// An inversion off the middle of the meshes here.
fn inversion() -> MoebiusTransformation<Q> {
    let circle = Circle::new(TopView::new(Q::from_ratio(-7, 3), Q::from_ratio(13, 7)), q(5));
    let cylinder = CylindricalSphere::new(circle).expect("a radius");
    MoebiusTransformation::inversion_at_cylinder(&cylinder, &q(1))
}

/// The cones at the vertices of a Euclidean image.
fn cones(image: &EuclideanImage<Q>) -> impl Iterator<Item = Cone<Q>> {
    image.mesh.points.iter().zip(&image.gauss.points).map(|(vertex, axis)| Cone {
        vertex: vertex.clone(),
        axis: Vector3::new(axis.x.clone(), axis.y.clone(), axis.z.clone()),
    })
}

fn is_conical(image: &EuclideanImage<Q>) -> Result<(), TestCaseError> {
    let turned = image.turned_faces().len();
    if turned == 0 || turned == image.mesh.topology.face_count() {
        let verdict = verdict(&image.mesh, Property::Conical);
        // A face of area 0 has no orientation.
        prop_assert!(matches!(verdict, Verdict::Proved | Verdict::Vacuous | Verdict::Undecided));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// `remark-1`: i-circular stays i-circular; a damaged vertex shows.
    #[test]
    fn images_of_circular_meshes(mesh in prop_oneof![circular(), translational()]) {
        let Ok(mut image) = moebius_image(&mesh, &inversion()) else { return Ok(()) };
        let verdict_of = |m: &Mesh<Q>| verdict(m, Property::ICircular);
        let before = verdict_of(&image);
        prop_assert!(matches!(before, Verdict::Proved | Verdict::Undecided));
        prop_assert_eq!(moebius_image(&image, &inversion()).map(|m| m.points), Ok(mesh.points));
        image.points[0].z += &Q::one();
        prop_assert_ne!(verdict_of(&image), Verdict::Proved);
    }

    /// `remark-1`: the image is conical, its planes are those of the vertices, offsets are at constant
    /// distance, and the way back leads to the mesh inside.
    #[test]
    fn conical_images(mesh in prop_oneof![circular(), translational()], d in -9i64..=9) {
        let image = match conical_image(&mesh) {
            Ok(image) => image,
            Err(reason) => {
                let expected = matches!(reason, NoTransfer::Cylinder(_) | NoTransfer::Plane(_) | NoTransfer::Topology(_));
                prop_assert!(expected, "{}", reason);
                return Ok(());
            }
        };
        prop_assert_eq!(verdict(&image.mesh, Property::Planar) == Verdict::Refuted, false);
        is_conical(&image)?;
        let planes = stored_planes(&image.mesh).expect("planes").expect("unit normals");
        let offset = image.clone().offset(&q(d));
        is_conical(&offset)?;
        let interior: Vec<VertexId> = mesh.topology.interior_vertices().collect();
        prop_assert_eq!(planes.len(), interior.len());
        for (face, (plane, v)) in image.mesh.topology.faces().zip(planes.iter().zip(&interior)) {
            prop_assert_eq!(plane, &OrientedPlane::of_isotropic(&mesh.points[v.index()]));
            for corner in image.mesh.topology.face(face) {
                prop_assert!(plane.distance(&image.mesh.points[corner.index()]).is_zero());
                prop_assert_eq!(plane.distance(&offset.mesh.points[corner.index()]), q(d));
            }
        }
        prop_assert!(Parallel::new(&image.mesh, &image.gauss).is_ok() || interior.is_empty() || degenerate(&image.mesh));

        // An offset is an L-transformation, hence an i-M-transformation.
        let map = MoebiusTransformation::from(&LaguerreTransformation::offset(-q(d)));
        let moved = moebius_image(&mesh, &map).expect("no centre");
        prop_assert_eq!(conical_image(&moved), Ok(offset));

        let Ok(back) = circular_image(&image.mesh, &planes) else { return Ok(()) };
        let expected: Vec<_> = interior.iter().map(|v| mesh.points[v.index()].clone()).collect();
        prop_assert_eq!(&back.points, &expected);
        if let Ok(own) = oriented_planes(&image.mesh) {
            for (own, plane) in own.iter().zip(&planes) {
                prop_assert!(own == plane || *own == plane.turned());
            }
        }
        // One vertex moved out of its planes.
        if !interior.is_empty() {
            let mut wrong = image.mesh.clone();
            let corner = wrong.topology.face(FaceId(0))[0].index();
            wrong.points[corner] = &wrong.points[corner] + &Vector3::new(q(1), q(2), q(5));
            let refused = circular_image(&wrong, &planes);
            let parallel = planes[0].normal().dot(&Vector3::new(q(1), q(2), q(5))).is_zero();
            let is_not_planar = matches!(refused, Err(NoTransfer::NotPlanar { .. }));
            prop_assert!(is_not_planar || parallel);
        }
    }

    /// Under τ i-M-transformations are L-transformations.
    #[test]
    fn tau_takes_one_group_to_the_other(mesh in circular()) {
        let map = inversion().then(&MoebiusTransformation::inversion_at(&MoebiusSphere::new(q(1), q(2), q(0), q(3))));
        let (Ok(image), Ok(moved)) = (conical_image(&mesh), moebius_image(&mesh, &map)) else { return Ok(()) };
        let Ok(moved) = conical_image(&moved) else { return Ok(()) };
        let euclidean = LaguerreTransformation::from(&map);
        for (before, after) in cones(&image).zip(cones(&moved)) {
            prop_assert_eq!(euclidean.map_cone(&before), Ok(after.clone()));
            prop_assert_ne!(before, after);
        }
    }

    /// A vertex beside the circle of its face.
    #[test]
    fn no_circle_no_cone(mut mesh in circular()) {
        let corner = mesh.topology.face(FaceId(0))[2].index();
        let plane = mesh.face_plane(FaceId(0)).expect("a plane");
        mesh.points[corner].x += &Q::from_ratio(1, 1000);
        let at = mesh.points[corner].top_view();
        mesh.points[corner] = plane.point_at(&at);
        let refused = conical_image(&mesh);
        let expected = matches!(refused, Err(NoTransfer::NoCircle { face: FaceId(0), .. } | NoTransfer::Cylinder(_)));
        prop_assert!(expected, "{:?}", refused.err());
        mesh.points[corner].z += &Q::one();
        let refused = conical_image(&mesh);
        let expected = matches!(refused, Err(NoTransfer::Plane(_)));
        prop_assert!(expected);
    }
}

/// Whether an edge has length 0.
fn degenerate(mesh: &Mesh<Q>) -> bool {
    let points = |h| (mesh.topology.origin(h).index(), mesh.topology.target(h).index());
    mesh.topology.edges().map(points).any(|(a, b)| mesh.points[a] == mesh.points[b])
}

/// The i-isothermic Enneper mesh over a square grid with unit edges, beside its centre, with the radii of its vertex
/// circles (theory (b), h = 1).
pub fn enneper<Q: RationalField>(rows: usize, columns: usize) -> (Mesh<Q>, Vec<Q>) {
    let half = |k: i64| Q::from_ratio(2 * k + 1, 2);
    let (mut points, mut radii) = (Vec::new(), Vec::new());
    for i in 0..=rows as i64 {
        for j in 0..=columns as i64 {
            let (x, y) = (half(i + 1), half(j));
            let (x2, y2) = (x.square(), y.square());
            let twelfth = Q::from_ratio(1, 12);
            let third = Q::from_ratio(1, 3);
            points.push(Point::new(
                &x * (&y2 - &x2 * &third + &twelfth),
                &y * (&y2 * &third - &x2 - twelfth),
                (&y2 - &x2) * Q::from_ratio(1, 2),
            ));
            radii.push((x2 + y2 - Q::from_ratio(1, 4)) * Q::from_ratio(1, 2));
        }
    }
    (Mesh::new(points, quad_patch(rows, columns)).expect("a grid"), radii)
}

/// `remark-2-edge-offset`: planar faces, edges parallel to those of S, which touch the unit sphere.
#[test]
fn edge_offset_images() {
    let (mesh, mut radii) = enneper::<Q>(5, 4);
    assert_eq!(verdict(&mesh, Property::Planar), Verdict::Proved);
    assert_eq!(verdict(&mesh, Property::ICircular), Verdict::Refuted);
    let image = edge_offset_image(&mesh, &radii).expect("an edge-offset mesh");
    assert_eq!(image.mesh.topology.vertex_count(), 20);
    assert_eq!(verdict(&image.mesh, Property::Planar), Verdict::Proved);
    assert_eq!(verdict(&image.mesh, Property::Conical), Verdict::Refuted);
    assert!(Parallel::new(&image.mesh, &image.gauss).is_ok());
    let interior = mesh.topology.interior_vertices();
    for (face, v) in image.mesh.topology.faces().zip(interior) {
        let (at, r) = (&mesh.points[v.index()], &radii[v.index()]);
        let n = at.top_view().norm2() - r.square();
        let height = |p: &Point<Q>| {
            let along = &at.x * &p.x + &at.y * &p.y + &at.z;
            along * q(2) + (q(1) - &n) * &p.z
        };
        for corner in image.mesh.topology.face(face) {
            assert!(height(&image.mesh.points[corner.index()]).is_zero(), "the plane of a face");
        }
        assert!(!height(&Point::new(q(1), q(2), q(3))).is_zero());
    }
    let offset = image.clone().offset(&q(2)).mesh;
    let mut edges = 0;
    for edge in image.mesh.topology.edges() {
        let (a, b) = (image.mesh.topology.origin(edge), image.mesh.topology.target(edge));
        let ends = |mesh: &Mesh<Q>| [a, b].map(|v| mesh.points[v.index()].clone());
        let [s, t] = ends(&image.gauss);
        let origin = Point::new(q(0), q(0), q(0));
        let (s0, along) = (&s - &origin, &t - &s);
        assert_eq!(s0.cross(&along).length2(), along.length2(), "tangent to the sphere");
        // The distance of the edges is 2.
        let (m, d) = (ends(&image.mesh), ends(&offset));
        let along = &m[1] - &m[0];
        assert_eq!((&d[0] - &m[0]).cross(&along).length2(), along.length2() * q(4));
        edges += 1;
    }
    assert_eq!(edges, 31);
    radii[7] += &Q::from_ratio(1, 1000);
    assert!(matches!(edge_offset_image(&mesh, &radii), Err(NoTransfer::NotTouching { .. })));
    radii.pop();
    assert_eq!(edge_offset_image(&mesh, &radii), Err(NoTransfer::NoRadii));
}

/// `remark-4`: the inverted incircles have concurrent planes around vertices; τ of them is the
/// Laguerre image of the edge-offset mesh.
#[test]
fn incircles_move_as_cones() {
    let (mesh, radii) = enneper::<Q>(3, 3);
    let image = edge_offset_image(&mesh, &radii).expect("an edge-offset mesh");
    let map = LaguerreTransformation::from(&inversion());
    let moved = |cone: Cone<Q>| map.map_cone(&cone).expect("a finite vertex");
    let points = cones(&image).map(|cone| moved(cone).vertex).collect();
    let laguerre = Mesh { points, ..image.mesh.clone() };
    assert_eq!(verdict(&laguerre, Property::Planar), Verdict::Proved);
    let incircles: Vec<ICircle<Q>> =
        cones(&image).map(|c| c.to_isotropic().expect("no south pole")).collect();
    let inverted = incircles.iter().map(|c| inversion().map_circle(c).expect("no centre"));
    let planes: Vec<_> = inverted.map(|c| c.plane).collect();
    for v in mesh.topology.interior_vertices() {
        let around: Vec<_> =
            mesh.topology.star(v).map(|h| &planes[mesh.topology.face_at(h).index()]).collect();
        let poles = around.iter().map(|p| p.dual());
        let poles: Vec<Point<Q>> = poles.collect();
        let volume = Vector3::det(
            &(&poles[1] - &poles[0]),
            &(&poles[2] - &poles[0]),
            &(&poles[3] - &poles[0]),
        );
        assert!(volume.is_zero(), "the planes at vertex {} are concurrent", v.0);
    }
}

#[test]
fn great_circles_and_south_poles_are_refused() {
    // The top view is the unit circle, |c|² − ρ² = −1.
    let corners = [(1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| Point::new(q(x), q(y), q(x)));
    let mut faces = FaceList::new();
    faces.push([0, 1, 2, 3]);
    let mesh = Mesh::new(corners.to_vec(), faces.clone()).expect("a mesh");
    assert_eq!(conical_image(&mesh), Err(NoTransfer::Cylinder(FaceId(0))));

    let mut flat = mesh.clone();
    flat.points.iter_mut().for_each(|p| p.z = q(0));
    let planes = oriented_planes(&flat).expect("a horizontal plane");
    assert_eq!(planes[0].normal().z, q(1));
    let down = [planes[0].turned()];
    assert_eq!(circular_image(&flat, &down), Err(NoTransfer::SouthPole(FaceId(0))));
    let steep = oriented_planes(&mesh).map_err(|reason| reason.to_string());
    let text = "the unit normal of face 0 is irrational: its squared length 32 is no square";
    assert_eq!(steep, Err(text.into()));
    assert_eq!(Rational::from_ratio(32, 1).root(), None);
}

/// Four planes through one point: a cone of revolution iff their normals lie on a circle.
#[test]
fn four_planes_make_a_cone_or_not() {
    let half = |x: i64, y: i64, n: i64| Point::new(Q::from_ratio(x, n), Q::from_ratio(y, n), q(0));
    for (last, conical) in [(half(0, -1, 2), true), (half(0, -1, 3), false)] {
        let images = [half(1, 0, 2), half(0, 1, 2), half(-1, 0, 2), last];
        let planes = images.each_ref().map(OrientedPlane::of_isotropic);
        let origin = Point::new(q(0), q(0), q(0));
        let edge = |i: usize| &origin + &planes[(i + 3) % 4].normal().cross(planes[i].normal());
        let points = std::iter::once(origin.clone()).chain((0..4).map(edge)).collect();
        let mut faces = FaceList::new();
        (0..4).for_each(|i| faces.push([0, 1 + i, 1 + (i + 1) % 4]));
        let mesh = Mesh::new(points, faces).expect("a pyramid");
        assert_eq!(oriented_planes(&mesh).as_deref(), Ok(&planes[..]));
        assert_eq!(verdict(&mesh, Property::Conical) == Verdict::Proved, conical);
        match circular_image(&mesh, &planes) {
            Ok(image) => assert!(conical && image.points == images),
            Err(reason) => {
                assert!(!conical);
                assert!(matches!(reason, NoTransfer::NotConical { vertex: VertexId(0), .. }));
            }
        }
    }
}

/// Triangles in doubles: observed, not proved.
#[test]
fn a_star_in_doubles() {
    let ring = (0..5).map(|k| {
        let (s, c) = (f64::from(k) * 1.2566).sin_cos();
        Point::new(c, s, 0.3 * c * s)
    });
    let points: Vec<_> = std::iter::once(Point::new(0.1, 0.2, 0.7)).chain(ring).collect();
    let mut faces = FaceList::new();
    (0..5).for_each(|k| faces.push([0, 1 + k, 1 + (k + 1) % 5]));
    let mesh = Mesh::new(points, faces).expect("a star");
    let image = conical_image(&mesh).expect("triangles have circles");
    let plane = OrientedPlane::of_isotropic(&mesh.points[0]);
    assert_eq!(image.mesh.topology.face_count(), 1);
    assert!(image.mesh.points.iter().all(|p| plane.distance(p).abs() < 1e-12));
}

#[test]
fn a_mesh_without_faces_has_images_without_vertices() {
    // Found by the campaign of `tau-edge-offset`: values were carried from the first of no elements.
    let none = Mesh::<Q>::new(Vec::new(), FaceList::new()).expect("no faces are a mesh");
    assert_eq!(isothermic_image(&none, &[]).map(|image| image.points), Ok(Vec::new()));
    let dual = isogeo::construct::christoffel_by_radii(&none, &[]);
    assert_eq!(dual.map(|dual| dual.mesh.points), Ok(Vec::new()));
    let dual = isogeo::construct::christoffel_by_diagonals(&none);
    assert_eq!(dual.map(|dual| dual.mesh.points), Ok(Vec::new()));
}
