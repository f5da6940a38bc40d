//! Subdivision: what it reproduces, what it commutes with, what stays.

use std::collections::BTreeSet;

use isogeo::check::{Plain, Verdict};
use isogeo::construct::subdivision::*;
use isogeo::construct::{quad_patch, translational_net};
use isogeo::mesh::{FaceId, FaceList, Mesh, Topology, TopologyError, VertexId, VertexKind};
use isogeo::net::{Net, Property};
use isogeo::scalar::{Approx, Field, Ring};
use isogeo::space::{Dual, Point};
use proptest::prelude::*;

use crate::meshes::{Q, any_mesh, combinatorics, fraction, small, translational};

fn q(p: i64, d: i64) -> Q {
    Q::from_ratio(p, d)
}

fn smooth(mesh: &Mesh<Q>) -> Mesh<Q> {
    catmull_clark(mesh, &Sharp::default()).expect("a mesh").0
}

/// A patch of `n × n` quads over the integers with these heights.
fn patch(n: usize, height: impl Fn(i64, i64) -> Q) -> Mesh<Q> {
    let side = 0..=n as i64;
    let points = side.clone().flat_map(|i| side.clone().map(move |j| (i, j)));
    let points = points.map(|(i, j)| Point::new(q(i, 1), q(j, 1), height(i, j))).collect();
    Mesh::new(points, quad_patch(n, n)).expect("a patch")
}

/// An edge list of pairs.
fn edges(pairs: &[(u32, u32)]) -> BTreeSet<[VertexId; 2]> {
    pairs.iter().map(|&(a, b)| [VertexId(a), VertexId(b)]).collect()
}

/// The points over a line of the top view, in its order.
fn over(mesh: &Mesh<Q>, on: impl Fn(&Point<Q>) -> bool) -> Vec<Point<Q>> {
    let mut points: Vec<_> = mesh.points.iter().filter(|p| on(p)).cloned().collect();
    points.sort_by(|a, b| (&a.x, &a.y).partial_cmp(&(&b.x, &b.y)).expect("an order"));
    points
}

/// The faces of a mesh with a property of all their vertices, as a mesh.
fn part(mesh: &Mesh<Q>, keep: impl Fn(VertexId) -> bool) -> Mesh<Q> {
    let mut faces = FaceList::new();
    for f in mesh.topology.faces() {
        let corners = mesh.topology.face(f);
        if corners.iter().all(|&v| keep(v)) {
            faces.push(corners.iter().map(|v| v.0));
        }
    }
    Mesh::new(mesh.points.clone(), faces).expect("a part of a mesh")
}

fn verdict(mesh: &Mesh<Q>, property: Property) -> Verdict {
    Net::new(&mesh.topology, &Plain(&mesh.points)).check(property).verdict()
}

#[test]
fn counts_and_orders() {
    for (vertices, faces) in combinatorics() {
        let topology = Topology::new(vertices, faces).expect("a mesh");
        let points = (0..vertices as i64).map(|i| Point::new(q(i, 1), q(i * i, 1), q(i % 3, 1)));
        let mesh = Mesh { topology, points: points.collect(), data: Default::default() };
        let (coarse, fine) = (&mesh.topology, smooth(&mesh));
        let [v, e, f] = [coarse.vertex_count(), coarse.edge_count(), coarse.face_count()];
        assert_eq!(fine.topology.vertex_count(), v + e + f);
        assert_eq!(fine.topology.face_count(), coarse.corner_count());
        assert_eq!(fine.topology.euler_characteristic(), coarse.euler_characteristic());
        assert_eq!(fine.topology.boundary_loops().len(), coarse.boundary_loops().len());
        for v in coarse.vertices() {
            assert_eq!(coarse.kind(v), fine.topology.kind(v));
        }
        for (i, h) in coarse.edges().enumerate() {
            let ends = [coarse.origin(h), coarse.target(h)];
            let middle = VertexId((v + i) as u32);
            assert!(ends.iter().all(|&end| fine.topology.edge(middle, end).is_some()));
        }
        let quads = coarse.faces().flat_map(|f| coarse.half_edges(f));
        for (h, quad) in quads.zip(fine.topology.faces()) {
            let [corner, _, centre, _] = *fine.topology.face(quad) else { panic!("no quad") };
            assert_eq!(
                (corner, centre.index()),
                (coarse.origin(h), v + e + coarse.face_at(h).index())
            );
        }
    }
}

/// The tensor product of `(1, 4, 6, 4, 1)/8`, the mask of cubic B-splines.
#[test]
fn a_regular_grid_gives_cubic_b_splines() {
    let fine = smooth(&patch(4, |i, j| q(i64::from((i, j) == (2, 2)), 1)));
    let mask = [0, 0, 1, 4, 6, 4, 1, 0, 0];
    let place = |c: &Q| (c * q(2, 1)).to_f64() as usize;
    let inside = |p: &&Point<Q>| [&p.x, &p.y].iter().all(|c| c.to_f64() > 0.5 && c.to_f64() < 3.5);
    let mut seen = 0;
    for p in fine.points.iter().filter(inside) {
        assert_eq!(p.z, q(mask[place(&p.x)] * mask[place(&p.y)], 64), "{p:?}");
        seen += 1;
    }
    assert_eq!(seen, 25);
}

#[test]
fn an_extraordinary_vertex() {
    let cube =
        combinatorics().into_iter().find(|(v, f)| (*v, f.len()) == (8, 6)).expect("a cube").1;
    let corner = |i: usize| [[-1, -1], [1, -1], [1, 1], [-1, 1]][i % 4].map(|c| q(c, 1));
    let points = (0..8).map(|i| {
        let [x, y] = corner(i);
        Point::new(x, y, q(if i < 4 { -1 } else { 1 }, 1))
    });
    let fine = smooth(&Mesh::new(points.collect(), cube).expect("a cube"));
    assert_eq!(fine.points[6], Point::new(q(5, 9), q(5, 9), q(5, 9)));
    assert_eq!(fine.points[8..20].iter().filter(|p| p.z.is_zero()).count(), 4);
}

#[test]
fn the_boundary_is_a_cubic_b_spline_of_the_boundary() {
    let height = |i: i64, j: i64| q(i * i * i - 4 * j + i * j, 7);
    let mesh = patch(4, height);
    let mut moved = mesh.clone();
    moved.points[12].z = q(100, 1);
    moved.points[6].x = q(7, 5);
    let side = |mesh: &Mesh<Q>| over(&smooth(mesh), |p| p.x.is_zero());
    let found = side(&mesh);
    assert_eq!(found, side(&moved));
    assert_eq!(found.len(), 7, "the corners are smoothed");
    // Linear on this side: knots and midpoints of the old polygon.
    for (i, p) in found.iter().enumerate() {
        assert_eq!(p.y, q(i as i64 + 1, 2));
        assert_eq!(p.z, &p.y * q(-4, 7));
    }
    let smoothed = smooth(&mesh).points[0].clone();
    assert_eq!(smoothed, Point::new(q(1, 8), q(1, 8), q(-3, 56)));
    let keep = Sharp { keep_corners: true, ..Sharp::default() };
    let (kept, next) = catmull_clark(&mesh, &keep).expect("a mesh");
    assert!([0, 4, 20, 24].iter().all(|&v| kept.points[v] == mesh.points[v]));
    assert_eq!(next, keep);
    // Negative control: a boundary vertex of two faces moves the boundary.
    moved.points[1].z = q(5, 1);
    assert_ne!(found, side(&moved));
}

#[test]
fn creases_are_curves_of_their_own() {
    let mesh = patch(4, |i, j| q(i * j * j - j, 3));
    let chain = edges(&[(10, 11), (12, 11), (12, 13), (14, 13)]);
    let sharp = Sharp { creases: chain, keep_corners: true };
    let twice = |mesh: &Mesh<Q>, sharp: &Sharp| {
        let (fine, sharp) = catmull_clark(mesh, sharp).expect("a mesh");
        catmull_clark(&fine, &sharp).expect("a mesh").0
    };
    let mut moved = mesh.clone();
    [6, 7, 17, 18].iter().for_each(|&v| moved.points[v].z = q(v as i64 * 10, 1));
    let middle = |mesh: &Mesh<Q>, sharp| over(&twice(mesh, sharp), |p| p.x == q(2, 1));
    let curve = middle(&mesh, &sharp);
    assert_eq!(curve.len(), 17);
    assert_eq!(curve, middle(&moved, &sharp));
    // Negative control: without the crease the two sides matter.
    assert_ne!(middle(&mesh, &Sharp::default()), middle(&moved, &Sharp::default()));
    // Along the curve the heights are those of the same curve on a boundary.
    let mut alone = patch(4, |_, _| q(0, 1));
    (0..5).for_each(|j| alone.points[j].z = mesh.points[10 + j].z.clone());
    let side =
        over(&twice(&alone, &Sharp { keep_corners: true, ..Sharp::default() }), |p| p.x.is_zero());
    let heights = |points: &[Point<Q>]| points.iter().map(|p| p.z.clone()).collect::<Vec<_>>();
    assert_eq!(heights(&side)[1..16], heights(&curve)[1..16]);
}

#[test]
fn what_has_more_than_two_sharp_edges_stays() {
    let mesh = patch(4, |i, j| q(i * i * (j + 1) + j * j * j, 1));
    let at = |pairs: &[(u32, u32)]| {
        let sharp = Sharp { creases: edges(pairs), keep_corners: false };
        catmull_clark(&mesh, &sharp).expect("a mesh").0.points
    };
    let (plain, old) = (at(&[]), &mesh.points);
    assert_ne!(plain[12], old[12]);
    assert_eq!(at(&[(12, 13), (7, 12), (12, 11)])[12], old[12]);
    assert_eq!(at(&[(12, 13)])[12], plain[12], "a crease ends");
    assert_eq!(at(&[(10, 11)])[10], old[10], "a crease meets the boundary");
    assert_ne!(plain[10], old[10]);
    // An edge of the boundary is sharp as it is.
    assert_eq!(at(&[(0, 1)]), plain);
}

#[test]
fn pinched_and_isolated_vertices_stay() {
    let (vertices, faces) = combinatorics().pop().expect("the pinched one");
    let points = (0..vertices as i64).map(|i| Point::new(q(i, 1), q(i * i, 2), q(1, i + 1)));
    let mesh = Mesh::new(points.collect(), faces).expect("a mesh");
    let fine = smooth(&mesh);
    for v in mesh.topology.vertices() {
        let stays = matches!(mesh.topology.kind(v), VertexKind::Pinched | VertexKind::Isolated);
        assert_eq!(fine.points[v.index()] == mesh.points[v.index()], stays, "{v:?}");
    }
}

#[test]
fn a_crease_is_an_edge() {
    let sharp = Sharp { creases: edges(&[(0, 1), (7, 11)]), keep_corners: false };
    let error = catmull_clark(&patch(4, |_, _| q(0, 1)), &sharp).expect_err("a diagonal");
    assert_eq!(error, NoSubdivision::NoSuchEdge([VertexId(7), VertexId(11)]));
    assert_eq!(error.to_string(), "there is no edge between vertices 7 and 11");
}

#[test]
fn counts_and_orders_of_planes() {
    let mesh = patch(4, |i, j| q(i * i + 3 * j * j + i, 2));
    let fine = subdivide_planes(&mesh, true).expect("a mesh");
    let topology = &fine.topology;
    assert_eq!((topology.vertex_count(), topology.face_count()), (64, 49));
    assert_eq!(topology.boundary_loops().len(), 1);
    for f in mesh.topology.faces() {
        let corners: Vec<u32> = mesh.topology.half_edges(f).map(|h| h.0).collect();
        assert_eq!(topology.face(f).iter().map(|v| v.0).collect::<Vec<_>>(), corners);
    }
    assert_eq!(fine.points[0], mesh.points[0]);
    let smoothed = subdivide_planes(&mesh, false).expect("a mesh");
    assert_eq!(smoothed.points[0].x, q(1, 8));
    // The corner at vertex 5, in the first face, lies on the side to vertex 0.
    assert_eq!((&fine.points[1].x, &fine.points[1].y), (&q(3, 4), &q(0, 1)));
}

/// New planes are those of Catmull and Clark on the poles, and new vertices lie in them.
#[test]
fn translational_nets_stay_translational_inside() {
    let values = |k: i64| (0..6).map(move |i| (q(i * i + 7 * i, 3), q(k * i * i * i - i, 5)));
    let net = translational_net(&values(1).collect::<Vec<_>>(), &values(-2).collect::<Vec<_>>());
    let net = net.expect("a grid");
    let fine = subdivide_planes(&net, false).expect("K is not 0");
    let old = &net.topology;
    let origins: Vec<VertexId> = old.faces().flat_map(|f| old.face(f).to_vec()).collect();
    let inside = |v: VertexId| old.kind(origins[v.index()]) == VertexKind::Interior;
    let mut core = part(&fine, inside);
    assert_eq!(core.topology.face_count(), 7 * 7);
    for property in [Property::Planar, Property::IConical, Property::ICircular] {
        assert_eq!(verdict(&core, property), Verdict::Proved, "{property:?}");
    }
    let dual = isogeo::construct::metric_dual(&net).expect("planar");
    let (poles, _) = catmull_clark(&dual, &Sharp::default()).expect("a mesh");
    // Face 12 of the grid has no vertex at the boundary.
    let plane = poles.points[12].dual();
    assert!(fine.topology.face(FaceId(12)).iter().all(|v| plane.contains(&fine.points[v.index()])));
    core.points[4 * 12].z += &q(1, 1000);
    assert_eq!(verdict(&core, Property::Planar), Verdict::Refuted);
}

#[test]
fn why_planes_are_not_subdivided() {
    let cylinder = patch(3, |i, _| q(i * i, 1));
    let error = subdivide_planes(&cylinder, true).expect_err("K = 0");
    let (vertex, face) = (VertexId(5), FaceId(0));
    assert_eq!(error, NoPlaneSubdivision::NoPoint { vertex, face });
    let mut vertical = patch(3, |i, j| q(i * i + j * j, 1));
    [0, 1, 4, 5].iter().for_each(|&v| vertical.points[v].y = vertical.points[v].x.clone());
    let error = subdivide_planes(&vertical, true).expect_err("a vertical face");
    assert_eq!(error, NoPlaneSubdivision::Vertical(FaceId(0)));
    // Two faces with two common edges.
    let mut faces = FaceList::new();
    [[0, 1, 2, 4], [0, 4, 2, 3]].into_iter().for_each(|f: [u32; 4]| faces.push(f));
    let points = [(0, 0), (2, -1), (3, 0), (2, 2), (1, 0)];
    let points = points.map(|(x, y)| Point::new(q(x, 1), q(y, 1), q(0, 1))).to_vec();
    let error = subdivide_planes(&Mesh::new(points, faces).expect("a mesh"), true);
    let small = TopologyError::FaceTooSmall { face: FaceId(0), corners: 2 };
    assert_eq!(error, Err(NoPlaneSubdivision::Dual(small)));
}

/// `x' ↦ L x' + a`, `z ↦ c·x' + s z + d`: keeps vertical lines.
fn map(p: &Point<Q>, m: &[Q]) -> Point<Q> {
    let row = |r: &[Q]| &r[0] * &p.x + &r[1] * &p.y + &r[2];
    Point::new(row(&m[0..3]), row(&m[3..6]), row(&m[6..9]) + &m[9] * &p.z)
}

fn mapped(mesh: &Mesh<Q>, m: &[Q]) -> Mesh<Q> {
    let points = mesh.points.iter().map(|p| map(p, m)).collect();
    Mesh { points, ..mesh.clone() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Subdivision commutes with affine maps; a shear that is not affine shows.
    #[test]
    fn points_commute_with_affine_maps(
        mesh in any_mesh(fraction()),
        m in prop::collection::vec(small(), 10),
        keep_corners: bool,
    ) {
        let first: Vec<_> = mesh.topology.edges().step_by(3).map(|h| {
            [mesh.topology.target(h), mesh.topology.origin(h)]
        }).collect();
        let sharp = Sharp { creases: first.into_iter().collect(), keep_corners };
        let (fine, next) = catmull_clark(&mesh, &sharp).expect("a mesh");
        let (image, same) = catmull_clark(&mapped(&mesh, &m), &sharp).expect("a mesh");
        prop_assert_eq!(next, same);
        prop_assert_eq!(image, mapped(&fine, &m));
        let square = |p: &Point<Q>| Point { z: p.z.square(), ..p.clone() };
        let bent = Mesh { points: mesh.points.iter().map(square).collect(), ..mesh.clone() };
        let bent = catmull_clark(&bent, &sharp).expect("a mesh").0.points;
        prop_assert_ne!(bent, fine.points.iter().map(square).collect::<Vec<_>>());
    }

    /// In planes: with affine maps that keep the vertical direction; doubles come near.
    #[test]
    fn planes_commute_with_affine_maps(
        mesh in prop_oneof![any_mesh(fraction()), translational()],
        m in prop::collection::vec(small(), 10),
        keep_corners: bool,
    ) {
        let det = Q::det2(&m[0], &m[1], &m[3], &m[4]);
        prop_assume!(!det.is_zero() && !m[9].is_zero());
        let fine = subdivide_planes(&mesh, keep_corners);
        let image = subdivide_planes(&mapped(&mesh, &m), keep_corners);
        prop_assert_eq!(image, fine.clone().map(|fine| mapped(&fine, &m)));
        if let (Ok(fine), Ok(doubles)) = (fine, subdivide_planes(&mesh.map(|c| c.to_f64()), keep_corners)) {
            prop_assert_eq!(fine.topology, doubles.topology);
        }
    }
}

/// The refined mesh is planar nowhere, and can be refined again all the same.
#[test]
fn planes_are_fitted_where_there_are_none() {
    let values = |k: i64| (0..4).map(move |i| (q(i * i + 5 * i, 3), q(k * i * i * i, 5)));
    let net = translational_net(&values(1).collect::<Vec<_>>(), &values(-2).collect::<Vec<_>>());
    let fine = subdivide_planes(&net.expect("a grid"), true).expect("K is not 0");
    assert_eq!(verdict(&fine, Property::Planar), Verdict::Refuted);
    let again = subdivide_planes(&fine, true).expect("K is not 0");
    assert_eq!(again.topology.face_count(), 9 * 9);
    assert_eq!(again.topology.euler_characteristic(), 1);
    assert_eq!(again.topology.boundary_loops().len(), 1);
}
