//! The gradients at the star of a vertex.

use crate::mesh::{Topology, VertexId, VertexKind};
use crate::scalar::Field;
use crate::space::{Gradient, Plane, Point};

/// The gradients of the triangles around an interior vertex for the heights of `points`;
/// `None` at other vertices, at larger faces and at vertical ones.
pub(super) fn gradients<T: Field>(
    topology: &Topology,
    v: VertexId,
    point: impl Fn(VertexId) -> Point<T>,
) -> Option<Vec<Gradient<T>>> {
    if topology.kind(v) != VertexKind::Interior {
        return None;
    }
    let gradient = |h| match *topology.face(topology.face_at(h)) {
        [a, b, c] => Plane::through(&point(a), &point(b), &point(c)).ok().map(|p| p.gradient),
        _ => None,
    };
    topology.star(v).map(gradient).collect()
}
