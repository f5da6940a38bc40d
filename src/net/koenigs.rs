//! Koenigs nets: planar quad meshes that have Christoffel duals (Sec. 4, Fig. 7).
//!
//! Decided are, exactly: that faces are planar quads; and at every interior vertex that the product
//! of the ratios of diagonals around it is 1. That is what every simply connected part of the mesh
//! needs for a dual; around holes and handles only the construction of the dual looks
//! (`construct::christoffel_by_diagonals`). Undefined are faces that are no quads, vertical faces, and those with three corners on a
//! line in the top view, where a ratio is 0 or infinite.

use super::Judge;
use super::planar;
use super::star::{MOST, USUAL, no_proper_quad, padded, ring_of_quads, undefined_face};
use crate::check::{Decide, Element, Outcome, Reason, Residual};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::Ring;
use crate::space::Point;

/// `∏ det(y_j, x_{j+1}) − ∏ det(y_j, x_j)` in the top view, seen from a vertex of quads with the
/// neighbours `x_j` and the opposite corners `y_j` between `x_j` and `x_{j+1}`: zero iff the product of
/// the ratios of the diagonals `x_j x_{j+1}`, each cut by the line to `y_j`, is 1.
///
/// The points are the vertex, the `x_j` and the `y_j`; further ones are not looked at.
#[derive(Clone, Copy, Debug)]
pub struct DiagonalProduct {
    /// The number of quads around the vertex.
    pub valence: usize,
}

impl<const K: usize> Residual<K> for DiagonalProduct {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, points: &[Point<R>; K], _: &R) -> R {
        let n = self.valence;
        let from = |i: usize| (&points[i] - &points[0]).top_view();
        let (mut left, mut right) = (R::one(), R::one());
        for j in 0..n {
            let corner = from(1 + n + j);
            left = left * corner.det(&from(1 + (j + 1) % n));
            right = right * corner.det(&from(1 + j));
        }
        left - right
    }
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, element: Element) -> Outcome<D::Value> {
    match element {
        Element::Face(face) => face_outcome(judge, face),
        Element::Vertex(v) => vertex_outcome(judge, v),
        Element::Edge(..) => Outcome::Trivial,
    }
}

fn face_outcome<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    if let Some(outcome) = planar::no_graph(judge, face) {
        return outcome;
    }
    match no_proper_quad(judge, face) {
        Some(reason) => Outcome::Undefined(reason),
        None => Outcome::of(judge.net.shape(face).planar, || planar::failure(judge, face)),
    }
}

fn vertex_outcome<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let star: Vec<HalfEdge> = judge.topology().star(v).collect();
    if let Some(undefined) = undefined_face(judge, &star) {
        return undefined;
    }
    let (valence, around) = (star.len(), ring_of_quads(judge, &star));
    match valence {
        n if n <= USUAL => product::<D, { 1 + 2 * USUAL }>(judge, valence, padded(v, around)),
        n if n <= MOST => product::<D, { 1 + 2 * MOST }>(judge, valence, padded(v, around)),
        _ => Outcome::Undefined(Reason::HighValence),
    }
}

fn product<D: Decide, const K: usize>(
    judge: &Judge<'_, D>,
    valence: usize,
    at: [VertexId; K],
) -> Outcome<D::Value> {
    let residual = DiagonalProduct { valence };
    Outcome::of(judge.decide().decide(residual, at), || {
        judge.failure("product of the ratios of diagonals", residual, at)
    })
}
