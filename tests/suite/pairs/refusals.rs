//! What constructors refuse and what is undefined, with the words for it.

use isogeo::construct::*;
use isogeo::mesh::{FaceId, FaceList, HalfEdge, Mesh, VertexId, VertexKind};
use isogeo::pair::*;
use isogeo::scalar::{Rational, Ring};
use isogeo::space::{Point, TopView};

use super::{fan, q, sampled};

type R = Rational;

fn at(x: i64, y: i64, z: i64) -> Point<R> {
    Point::new(q(x, 1), q(y, 1), q(z, 1))
}

fn one_face(points: Vec<Point<R>>) -> Mesh<R> {
    let mut faces = FaceList::new();
    faces.push(0..points.len() as u32);
    Mesh::new(points, faces).unwrap()
}

#[test]
fn other_combinatorics() {
    let square = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)]);
    let triangle = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0)]);
    let misfit = Parallel::new(&square, &triangle).unwrap_err();
    assert_eq!(misfit.to_string(), "the combinatorics differ: 4 and 3 vertices, 1 and 1 faces");
    let mut faces = FaceList::new();
    faces.push([1, 2, 3, 0]);
    let turned = Mesh::new(square.points.clone(), faces).unwrap();
    assert_eq!(VParallel::new(&square, &turned).unwrap_err(), Misfit::Face(FaceId(0)));
    let mut short = square.clone();
    short.points.pop();
    assert_eq!(FParallel::new(&square, &short).unwrap_err(), Misfit::Points(Which::Image));
    assert!(matches!(circumscribed_f_parallel(&short), Err(NoGaussImage::Misfit(_))));
}

#[test]
fn the_words_for_a_misfit() {
    let square = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)]);
    let mut bent = square.clone();
    bent.points[2].z += &q::<R>(1, 3);
    let words = |m: Misfit<R>| m.to_string();
    assert_eq!(
        words(FParallel::new(&square, &bent).unwrap_err()),
        "the planes of face 0 are not parallel: vertex 2 of the Gauss image lies 1/3 above the parallel plane"
    );
    assert_eq!(
        words(VParallel::new(&square, &bent).unwrap_err()),
        "in the Gauss image, face 0 is not planar: a vertex lies -1/3 above the plane of three others"
    );
    assert_eq!(
        words(Parallel::new(&square, &bent).unwrap_err()),
        "the edges between vertices 1 and 2 are not parallel: their cross product is (1/3, 0, 0)"
    );
    bent.points[2] = at(2, 1, 0);
    assert_eq!(
        words(VParallel::new(&square, &bent).unwrap_err()),
        "vertex 2 has different top views: they differ by (1, 0)"
    );
}

#[test]
fn zero_edges_are_parallel_to_everything() {
    let square = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)]);
    let point = one_face(vec![at(5, 5, 5); 4]);
    let pair = Parallel::new(&square, &point).unwrap();
    assert_eq!(pair.edge_curvature(HalfEdge(0)), Ok(R::zero()));
    let back = Parallel::new(&point, &square).unwrap();
    let undefined = EdgeUndefined::ZeroLength(VertexId(0), VertexId(1));
    assert_eq!(back.edge_curvature(HalfEdge(0)), Err(undefined));
    let c = FParallel::new(&square, &point).unwrap().face_curvatures(FaceId(0)).unwrap();
    assert_eq!((c.mean, c.gauss), (R::zero(), R::zero()));
    assert!(matches!(FParallel::new(&point, &square), Err(Misfit::Plane(Which::Mesh, _))));
}

#[test]
fn a_bow_tie_has_no_curvature() {
    let tie = one_face(vec![at(0, 0, 0), at(1, 1, 0), at(1, 0, 0), at(0, 1, 0)]);
    let pair = FParallel::new(&tie, &tie).unwrap();
    assert_eq!(pair.face_curvatures(FaceId(0)), Err(ZeroArea(FaceId(0))));
    assert_eq!(
        ZeroArea(FaceId(0)).to_string(),
        "face 0 has no curvature: its area in the top view is 0"
    );
    assert_eq!(pair.face_forms(FaceId(0)).offset_law().critical(), Roots::Every);
}

#[test]
fn boundary_pinched_and_isolated_vertices_have_no_curvature() {
    let mut faces = FaceList::new();
    faces.push([0, 1, 2]);
    faces.push([2, 3, 4]);
    let points = vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(2, 1, 0), at(2, 2, 1), at(9, 9, 9)];
    let m = Mesh::new(points, faces).unwrap();
    let pair = inscribed_v_parallel(&m).unwrap();
    for (v, kind) in
        [(0, VertexKind::Boundary), (2, VertexKind::Pinched), (5, VertexKind::Isolated)]
    {
        let undefined = VertexUndefined::NotInterior(VertexId(v), kind);
        assert_eq!(pair.vertex_forms(VertexId(v)), Err(undefined));
        assert_eq!(pair.star(VertexId(v)), Err(undefined));
    }
    assert_eq!(pair.total_forms().interior, Forms::zero());
}

#[test]
fn flat_images_have_no_curvature() {
    let m = sampled(&[(1, 0), (0, 1), (-1, 0), (0, -1)], |x: &R, y: &R| x * x + y * y);
    let flat = sampled(&[(1, 0), (0, 1), (-1, 0), (0, -1)], |_, _| R::zero());
    let pair = VParallel::new(&m, &flat).unwrap();
    let undefined = VertexUndefined::ZeroMeasure(VertexId(0));
    assert_eq!(pair.vertex_curvatures(VertexId(0)), Err(undefined));
    assert_eq!(pair.vertex_forms(VertexId(0)).unwrap().measure(), q::<R>(4, 1));
    let vertical = fan(at(0, 0, 0), vec![at(1, 0, 0), at(2, 0, 0), at(0, 1, 0)]);
    assert!(matches!(inscribed_v_parallel(&vertical), Err(Misfit::Plane(Which::Mesh, _))));
}

#[test]
fn images_need_a_start_and_edges_with_a_direction() {
    let square = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)]);
    let start = TopView::new(q(1, 2), q(1, 3));
    let outcome = inscribed_f_parallel(&square, VertexId(7), &start).map(|_| ());
    assert_eq!(outcome, Err(NoGaussImage::NoStart(7)));
    let outcome = circumscribed_v_parallel(&square, FaceId(1), &start).map(|_| ());
    assert_eq!(outcome, Err(NoGaussImage::NoStart(1)));
    let wall = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(1, 0, 1)]);
    let outcome = inscribed_f_parallel(&wall, VertexId(0), &start).map(|_| ());
    assert_eq!(outcome, Err(NoGaussImage::VerticalEdge(VertexId(1), VertexId(2))));
    let triangle = one_face(vec![at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)]);
    let outcome = inscribed_f_parallel(&triangle, VertexId(0), &start).map(|_| ());
    assert!(matches!(outcome, Err(NoGaussImage::FaceOpen { .. })), "an odd face");
}
