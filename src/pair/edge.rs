//! Curvatures of edges, and of the corners between them.
//!
//! In a pair with parallel edges the curvature of an edge is the ratio `κ` in `s_j − s_i =
//! κ (m_j − m_i)`. A corner between edges with curvatures κ, κ' has them as principal curvatures.
//! With the edges `e_j` of a face in cyclic order and the first k − 1 of them,
//!
//! ```math
//! 2 area(F) = Σ det(e_i, e_j),  2 area(F, S) = Σ ½(κ_i + κ_j) det(e_i, e_j),  2 area(S) = Σ κ_i κ_j det(e_i, e_j)
//! ```
//!
//! over `i < j`. For a quad this is two corners opposite each other, weighted by their triangles: H
//! and K of the face are weighted means of the H and K of these corners, whichever two are taken.

use std::fmt;

use super::{Curvatures, Parallel, VParallel, Which};
use crate::mesh::{HalfEdge, VertexId};
use crate::scalar::Field;

/// Why an edge has no curvature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeUndefined {
    /// Its ends agree (in the top view, for v-parallel pairs).
    ZeroLength(VertexId, VertexId),
    /// It belongs to one face only.
    Boundary(VertexId, VertexId),
    /// Its two faces in S lie in one plane.
    FlatImage(VertexId, VertexId),
}

impl fmt::Display for EdgeUndefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (edge, reason) = match self {
            EdgeUndefined::ZeroLength(v, w) => ((v, w), "it has length 0"),
            EdgeUndefined::Boundary(v, w) => ((v, w), "it belongs to one face only"),
            EdgeUndefined::FlatImage(v, w) => ((v, w), "the Gauss image is flat there"),
        };
        write!(f, "the edge between vertices {} and {}: {reason}", edge.0.0, edge.1.0)
    }
}

impl std::error::Error for EdgeUndefined {}

impl<T: Field> Parallel<'_, T> {
    /// The curvature of an edge: the edge of S divided by that of M; negative if they point in
    /// opposite directions.
    ///
    /// # Errors
    /// Where the edge of M has length zero.
    pub fn edge_curvature(&self, h: HalfEdge) -> Result<T, EdgeUndefined> {
        let topology = &self.mesh().topology;
        let (v, w) = (topology.origin(h), topology.target(h));
        let [e, image] =
            [self.mesh(), self.image()].map(|m| &m.points[w.index()] - &m.points[v.index()]);
        e.dot(&image).try_div(&e.length2()).ok_or(EdgeUndefined::ZeroLength(v, w))
    }

    /// H and K of the corner at the origin of a half-edge, in the face on its left: mean and
    /// product of the curvatures of its two edges.
    ///
    /// # Errors
    /// Where one of the edges has no curvature.
    pub fn corner_curvatures(&self, h: HalfEdge) -> Result<Curvatures<T>, EdgeUndefined> {
        let before = self.edge_curvature(self.mesh().topology.prev(h))?;
        let after = self.edge_curvature(h)?;
        let mean = (&before + &after) * T::from_ratio(1, 2);
        Ok(Curvatures { mean, gauss: before * after })
    }
}

impl<T: Field> VParallel<'_, T> {
    /// The curvature of an edge between two faces: the jump of the gradients of M across it,
    /// divided by that of S; dual to the curvature of an edge in a pair with parallel edges.
    ///
    /// # Errors
    /// At the boundary, at an edge of length zero in the top view, and where S is flat.
    pub fn edge_curvature(&self, h: HalfEdge) -> Result<T, EdgeUndefined> {
        let topology = &self.mesh().topology;
        let (v, w) = (topology.origin(h), topology.target(h));
        let twin = topology.twin(h).ok_or(EdgeUndefined::Boundary(v, w))?;
        let edge = &self.mesh().points[w.index()] - &self.mesh().points[v.index()];
        if edge.top_view().length2().is_zero() {
            return Err(EdgeUndefined::ZeroLength(v, w));
        }
        let faces = (topology.face_at(h), topology.face_at(twin));
        let [jump, image] = [Which::Mesh, Which::Image]
            .map(|m| self.gradient(m, faces.0) - self.gradient(m, faces.1));
        jump.dot(&image).try_div(&image.length2()).ok_or(EdgeUndefined::FlatImage(v, w))
    }
}
