//! Edge-offset meshes of Euclidean space (Remark 2): the check, and the ways there and back.

use isogeo::check::{Decider, Element, Plain, Reason, Verdict};
use isogeo::construct::minimal::{MeshPair, bonnet, enneper, logarithmoid};
use isogeo::construct::transfer::{NoTransfer, edge_offset_image, isothermic_image, stored_axes};
use isogeo::mesh::{FaceId, FaceList, Mesh, VertexId, VertexKind};
use isogeo::net::{Net, Property, RADIUS};
use isogeo::scalar::{Field, Rational, Ring};
use isogeo::space::{Point, Rotation, TopView};

type Q = Rational;

fn q(p: i64, d: i64) -> Q {
    Q::from_ratio(p, d)
}

/// i-isothermic meshes with radii: two saddles and a surface with circles of both signs.
fn isothermic() -> Vec<Mesh<Q>> {
    let centre = TopView::new(q(-1, 2), q(-3, 2));
    let half = Rotation::new(q(4, 5), q(3, 5)).expect("an angle");
    let off = TopView::new(q(1, 3), q(2, 7));
    let pairs = [enneper(4, 4, &centre), logarithmoid(4, 4, &half), bonnet(3, 4, &half, &off)];
    pairs.map(|pair| pair.map(|MeshPair { surface, .. }| surface).expect("a surface")).into()
}

fn image(mesh: &Mesh<Q>) -> Mesh<Q> {
    edge_offset_image(mesh, &mesh.data.vertex[RADIUS]).expect("an edge-offset mesh").mesh
}

fn verdict(mesh: &Mesh<Q>) -> Verdict {
    let decider = Decider::of_rationals(&mesh.points);
    let fast = Net::new(&mesh.topology, &decider).check(Property::EdgeOffset);
    let plain = Plain(&mesh.points);
    let slow = Net::new(&mesh.topology, &plain).check(Property::EdgeOffset);
    assert_eq!((fast.verdict(), &fast.failures), (slow.verdict(), &slow.failures));
    fast.verdict()
}

/// `remark-2-edge-offset`: the images have the property, and none is conical by chance; with one
/// coordinate disturbed they do not.
#[test]
fn images_of_isothermic_meshes_are_edge_offset() {
    for mesh in isothermic() {
        let mut image = image(&mesh);
        assert_eq!(verdict(&image), Verdict::Proved);
        let inner = image.topology.interior_vertices().next().expect("an interior vertex");
        image.points[inner.index()].z += &q(1, 1 << 40);
        assert_eq!(verdict(&image), Verdict::Refuted);
    }
}

fn mesh(points: &[[i64; 3]], polygons: impl IntoIterator<Item = Vec<u32>>) -> Mesh<Q> {
    let point = |p: &[i64; 3]| Point::new(q(p[0], 1), q(p[1], 1), q(p[2], 1));
    let mut faces = FaceList::new();
    polygons.into_iter().for_each(|face| faces.push(face));
    Mesh::new(points.iter().map(point).collect(), faces).expect("a mesh")
}

fn star(points: &[[i64; 3]]) -> Mesh<Q> {
    let n = points.len() as u32 - 1;
    mesh(points, (0..n).map(|i| vec![0, 1 + i, 1 + (i + 1) % n]))
}

/// The prism over the polygon with these edges, with or without its top and bottom.
fn prism(edges: &[[i64; 2]], closed: bool) -> Mesh<Q> {
    let n = edges.len() as u32;
    let mut corner = [0, 0];
    let base: Vec<_> = edges
        .iter()
        .map(|[x, y]| {
            corner = [corner[0] + x, corner[1] + y];
            corner
        })
        .collect();
    let points: Vec<_> =
        [0, 1].iter().flat_map(|&z| base.iter().map(move |[x, y]| [*x, *y, z])).collect();
    let sides = (0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]);
    let ends = [(0..n).rev().collect(), (n..2 * n).collect()];
    mesh(&points, sides.chain(ends.into_iter().filter(|_| closed)))
}

/// Edges on a cone as lines: turned over they stay, and a cone of irrational lengths is one.
#[test]
fn cones_are_cones_of_lines() {
    // Slopes 1: |e|² is 2, 50, 50, 1250, 338.
    let ends = [[1, 0, 1], [3, 4, 5], [-3, 4, 5], [-7, -24, 25], [5, -12, 13]];
    let cone = |turned: [bool; 5], last: i64| {
        let end = |j: usize| ends[j].map(|c| if turned[j] { -c } else { c });
        let mut points = vec![[0, 0, 0]];
        points.extend((0..5).map(end));
        points[5][2] += last;
        star(&points)
    };
    for bits in 0..32 {
        let turned = [0, 1, 2, 3, 4].map(|j| bits >> j & 1 == 1);
        for (last, found) in [(0, None), (1, Some(VertexId(0)))] {
            let mesh = cone(turned, last);
            let decider = Decider::of_rationals(&mesh.points);
            let report = Net::new(&mesh.topology, &decider).check(Property::EdgeOffset);
            let centre = Element::Vertex(VertexId(0));
            assert_eq!(report.failures.contains(&centre), found.is_some(), "{turned:?} {last}");
        }
    }
}

/// Cones at all vertices are not enough: three edges always lie on one. A cube is parallel to the one
/// that touches the sphere, a sheared prism over a triangle to none.
#[test]
fn three_edges_at_a_vertex_do_not_suffice() {
    let mut sheared = prism(&[[3, 0], [-3, 4], [0, -4]], true);
    sheared.points[3..].iter_mut().for_each(|p| p.x += &Q::one());
    assert_eq!(verdict(&sheared), Verdict::Refuted);
    let mut cube = prism(&[[1, 0], [0, 1], [-1, 0], [0, -1]], true);
    assert_eq!(verdict(&cube), Verdict::Proved);
    cube.points[7].x += &Q::one();
    assert_eq!(verdict(&cube), Verdict::Refuted);
}

/// Edges that enclose angles of 45° as lines. Around the polygon the points of contact change from the
/// inside to the outside at every turn by 135°, or else at every one by 45°; an octagon has none of the
/// former, and the hexagon an odd number of both.
#[test]
fn cones_that_fit_edge_by_edge_may_not_fit_together() {
    let octagon = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
    let hexagon = [[4, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-3, -3]];
    for closed in [false, true] {
        assert_eq!(verdict(&prism(&octagon, closed)), Verdict::Proved);
        let mesh = prism(&hexagon, closed);
        assert_eq!(verdict(&mesh), Verdict::Refuted);
        let decider = Decider::of_rationals(&mesh.points);
        let report = Net::new(&mesh.topology, &decider).check(Property::EdgeOffset);
        assert!(matches!(report.failures[..], [Element::Vertex(_)]));
        let worst = report.worst.expect("a failure");
        assert_eq!(worst.failure.condition, "cones that fit together");
    }
}

/// A ring of faces of an image: what holds on a disc holds on a part of it.
#[test]
fn an_annulus_of_an_image_is_edge_offset() {
    let centre = TopView::new(q(-1, 2), q(-3, 2));
    let enneper = enneper(5, 5, &centre).expect("a surface").surface;
    let whole = image(&enneper);
    let topology = &whole.topology;
    let inner = |v: &VertexId| topology.kind(*v) == VertexKind::Interior;
    let outside = topology.faces().map(|f| topology.face(f)).filter(|f| !f.iter().all(inner));
    let mut faces = FaceList::new();
    outside.for_each(|f| faces.push(f.iter().map(|v| v.0)));
    let mut ring = Mesh::new(whole.points.clone(), faces).expect("a ring");
    assert_eq!(ring.topology.boundary_loops().len(), 2);
    assert_eq!(verdict(&ring), Verdict::Proved);
    let v = ring.topology.face(FaceId(0))[0];
    ring.points[v.index()].x += &q(1, 1 << 40);
    assert_eq!(verdict(&ring), Verdict::Refuted);
}

/// Two squares with one corner in common: its four edges are to lie on a cone.
#[test]
fn pinched_vertices_count() {
    let squares = |last: [i64; 3]| {
        let far = [last[0], last[1], last[2] + 5];
        let points = [[0; 3], [5, 0, 0], [5, 5, 0], [0, 5, 0], [0, 0, 5], far, last];
        mesh(&points, [vec![0, 1, 2, 3], vec![0, 4, 5, 6]])
    };
    assert_eq!(verdict(&squares([0, -5, 0])), Verdict::Proved);
    assert_eq!(verdict(&squares([0, -3, 4])), Verdict::Refuted);
}

fn reason(mesh: &Mesh<Q>) -> Reason {
    let decider = Decider::of_rationals(&mesh.points);
    let report = Net::new(&mesh.topology, &decider).check(Property::EdgeOffset);
    assert_eq!(report.verdict(), Verdict::Undecided);
    report.undefined[0].1
}

#[test]
fn flat_stars_and_points_are_undefined() {
    let flat = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]];
    assert_eq!(reason(&star(&flat)), Reason::FlatVertex(VertexId(0)));
    let mut point = flat;
    point[3] = [0, 0, 0];
    assert_eq!(reason(&star(&point)), Reason::PointEdge(VertexId(0)));
}

/// A hexagon between two quads, which share only edges along z with it.
#[test]
fn vertices_with_two_edges_may_separate_others() {
    let rows = [[0, 2], [0, 0], [2, 0], [4, 4]];
    let ends = rows.iter().flat_map(|&[x, y]| [[x, y, 0], [x, y, 1]]);
    let mut points: Vec<_> = ends.chain([[1, 0, -1], [1, 0, 2]]).collect();
    let faces = [vec![0, 2, 3, 1], vec![2, 8, 4, 5, 9, 3], vec![4, 6, 7, 5]];
    assert_eq!(reason(&mesh(&points, faces.clone())), Reason::LooseFace(FaceId(1)));
    [points[8], points[9]] = [[1, 0, 0], [1, 0, 1]];
    assert_eq!(reason(&mesh(&points, faces)), Reason::StraightVertex(VertexId(8)));
}

/// `remark-2-edge-offset`: the way back leads to the interior of the mesh, with its radii up to a sign;
/// also from an offset, to the i-isothermic mesh with other heights.
#[test]
fn the_way_back_is_the_inverse() {
    for mesh in isothermic() {
        let there = edge_offset_image(&mesh, &mesh.data.vertex[RADIUS]).expect("an image");
        let axes = stored_axes(&there.mesh).expect("axes");
        let back = isothermic_image(&there.mesh, &axes).expect("the way back");
        let inner: Vec<_> = mesh.topology.interior_vertices().collect();
        let own: Vec<_> = inner.iter().map(|v| mesh.points[v.index()].clone()).collect();
        assert_eq!(back.points, own);
        let own: Vec<_> =
            inner.iter().map(|v| mesh.data.vertex[RADIUS][v.index()].clone()).collect();
        let turned: Vec<Q> = own.iter().map(|r| -r).collect();
        assert!(back.data.vertex[RADIUS] == own || back.data.vertex[RADIUS] == turned);
        let again = edge_offset_image(&back, &back.data.vertex[RADIUS]).expect("an image");
        assert!(again.mesh.points.iter().all(|p| there.mesh.points.contains(p)));

        // h ↦ h − d adds −d (1 + n)/2 to the heights.
        let offset = there.clone().offset(&q(3, 1)).mesh;
        let lower = isothermic_image(&offset, &axes).expect("the way back");
        for (v, (a, b)) in back.points.iter().zip(&lower.points).enumerate() {
            let n = a.top_view().norm2() - lower.data.vertex[RADIUS][v].square();
            assert_eq!(&a.z - &b.z, (n + q(1, 1)) * q(3, 2));
        }
    }
}

#[test]
fn axes_that_do_not_fit_are_refused() {
    let mesh = &isothermic()[0];
    let image = image(mesh);
    let axes = stored_axes(&image).expect("axes");
    let inner = image.topology.interior_vertices().next().expect("an interior vertex").index();
    let mut wrong = axes.clone();
    wrong[inner].x += &q(1, 1000);
    let refused = isothermic_image(&image, &wrong).map_err(|e| e.is_undefined());
    assert_eq!(refused.err(), Some(false));
    let mut bent = image.clone();
    bent.points[inner].z += &q(1, 1000);
    let refused = isothermic_image(&bent, &axes);
    assert!(matches!(refused, Err(NoTransfer::NotEdgeOffset { .. })));
    let mut south = axes.clone();
    south[inner].z = q(-1, 1);
    let refused = isothermic_image(&image, &south);
    assert_eq!(refused, Err(NoTransfer::SouthCone(VertexId(inner as u32))));
    assert_eq!(isothermic_image(&image, &axes[1..]), Err(NoTransfer::NoAxes));
    let mut bare = image.clone();
    bare.data.vertex.remove("s2");
    assert_eq!(stored_axes(&bare), None);
}
