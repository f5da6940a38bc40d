//! The star of an interior vertex as places of a residual of fixed length.

use super::Judge;
use super::planar::ProjectedArea;
use crate::check::{Decide, Outcome, Reason};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::Sign;

/// The most faces around a vertex that star residuals look at.
pub(super) const MOST: usize = 16;
/// The valence up to which shorter lists do: that of regular meshes of quads.
pub(super) const USUAL: usize = 4;
/// The same for triangles.
pub(super) const TRIANGLES: usize = 6;

/// A vertex and the lists of vertices around it, one after the other; unused places repeat the
/// vertex, and the residual does not look at them.
pub(super) fn padded<const K: usize>(
    v: VertexId,
    around: impl IntoIterator<Item = VertexId>,
) -> [VertexId; K] {
    let mut at = [v; K];
    at.iter_mut().skip(1).zip(around).for_each(|(place, vertex)| *place = vertex);
    at
}

/// The neighbours `x_j` of a vertex of quads, then the corners `y_j` between `x_j` and `x_{j+1}`.
pub(super) fn ring_of_quads<D: Decide>(judge: &Judge<'_, D>, star: &[HalfEdge]) -> Vec<VertexId> {
    let topology = judge.topology();
    let neighbours = star.iter().map(|&h| topology.target(h));
    let opposite = star.iter().map(|&h| topology.target(topology.next(h)));
    neighbours.chain(opposite).collect()
}

/// A face that is no quad, or has three corners on a line in the top view.
pub(super) fn no_proper_quad<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Option<Reason> {
    let [a, b, c, d] = *judge.topology().face(face) else {
        return Some(Reason::NoQuad(face));
    };
    let straight = |at| judge.decide().sign(ProjectedArea::TopView, at).0 == Sign::Zero;
    let corners = [[a, b, c], [b, c, d], [c, d, a], [d, a, b]];
    corners.into_iter().any(straight).then_some(Reason::StraightCorner(face))
}

/// That a property is not defined at a vertex, because of a face around it.
pub(super) fn undefined_face<D: Decide>(
    judge: &Judge<'_, D>,
    star: &[HalfEdge],
) -> Option<Outcome<D::Value>> {
    let mut faces = star.iter().map(|&h| judge.topology().face_at(h));
    faces.find_map(|face| no_proper_quad(judge, face)).map(Outcome::Undefined)
}
