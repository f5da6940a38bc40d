//! The weights of the edges at a vertex: the mixed measure as a Laplacian, as a stress, as a sum
//! over hinges.
//!
//! Two planes agree along their common line, so the gradients jump across an edge `e_j` by
//! `p_j − p_{j−1} = w_j J e_j'` with a weight `w_j`: jump over length, positive where the mesh is
//! convex. With the heights f of M and g of S, around an interior vertex:
//!
//! ```math
//! Σ w_j e_j' = 0,    2 D(v, s) = Σ w_j(f) (g_j − g_v) = Σ w_j(g) (f_j − f_v).
//! ```
//!
//! The first says that the weights are a stress in equilibrium, closing the dual face; the second
//! that the mixed measure is a weighted Laplacian. Where S lies on Σ and the faces are triangles,
//! `4 D(v, s) = Σ w_j |e_j'|²` as well: lengths times angles, the hinge form.

use super::{VParallel, VertexUndefined, Which};
use crate::mesh::{HalfEdge, VertexId};
use crate::scalar::Field;
use crate::space::Vector2;

/// An edge at an interior vertex with its weights in M and S.
#[derive(Clone, Debug, PartialEq)]
pub struct StarEdge<T> {
    /// The edge, leaving the vertex.
    pub half_edge: HalfEdge,
    /// Where it goes.
    pub target: VertexId,
    /// Its top view `e_j'`.
    pub edge: Vector2<T>,
    /// The rises `f_j − f_v` in M and `g_j − g_v` in S.
    pub rise: [T; 2],
    /// The weights `w_j` in M and in S.
    pub weight: [T; 2],
}

impl<T: Field> VParallel<'_, T> {
    /// The edges at a vertex, counter-clockwise, with their weights.
    ///
    /// # Errors
    /// Where the faces form no closed cycle, or an edge has length zero in the top view.
    pub fn star(&self, vertex: VertexId) -> Result<Vec<StarEdge<T>>, VertexUndefined> {
        self.interior(vertex)?;
        let topology = &self.mesh().topology;
        let star: Vec<HalfEdge> = topology.star(vertex).collect();
        let before = star.iter().cycle().skip(star.len().saturating_sub(1));
        let edges = star.iter().zip(before).map(|(&half_edge, &before)| {
            let target = topology.target(half_edge);
            let [e, image] = [self.mesh(), self.image()]
                .map(|m| &m.points[target.index()] - &m.points[vertex.index()]);
            let edge = e.top_view();
            let inverse = edge.length2().try_inv();
            let inverse = inverse.ok_or(VertexUndefined::ZeroLength(vertex, target))?;
            let faces = (topology.face_at(before), topology.face_at(half_edge));
            let weight = [Which::Mesh, Which::Image].map(|m| {
                let jump = self.gradient(m, faces.1) - self.gradient(m, faces.0);
                edge.det(&jump) * &inverse
            });
            Ok(StarEdge { half_edge, target, edge, rise: [e.z, image.z], weight })
        });
        edges.collect()
    }

    /// `Σ w_j(g) (f_j − f_v) = 2 D(v, s)`: the Laplacian of the heights of M with the weights of S.
    ///
    /// For the lift of a triangle mesh this is the cotangent Laplacian: see
    /// [`cotangent_weight`](super::cotangent_weight()).
    ///
    /// # Errors
    /// As for [`star`](Self::star).
    pub fn laplacian(&self, vertex: VertexId) -> Result<T, VertexUndefined> {
        let terms = self.star(vertex)?;
        Ok(terms.iter().fold(T::zero(), |sum, e| sum + &e.weight[1] * &e.rise[0]))
    }

    /// `Σ w_j(f) (g_j − g_v) = 2 D(v, s)`: the load that the stress of M carries on the shape S.
    ///
    /// # Errors
    /// As for [`star`](Self::star).
    pub fn load(&self, vertex: VertexId) -> Result<T, VertexUndefined> {
        let terms = self.star(vertex)?;
        Ok(terms.iter().fold(T::zero(), |sum, e| sum + &e.weight[0] * &e.rise[1]))
    }

    /// `Σ w_j(f) |e_j'|²`, lengths times i-angles of the hinges of M: `4 D(v, s)` where S has its
    /// vertices on Σ.
    ///
    /// # Errors
    /// As for [`star`](Self::star).
    pub fn hinge(&self, vertex: VertexId) -> Result<T, VertexUndefined> {
        let terms = self.star(vertex)?;
        Ok(terms.iter().fold(T::zero(), |sum, e| sum + &e.weight[0] * e.edge.length2()))
    }

    /// The derivatives of `D(v)` by the heights of a triangle mesh: `∂D(v)/∂f_j = w_j(f)` for the
    /// neighbours and `−Σ w_j(f)` for the vertex itself, which comes first.
    ///
    /// The Jacobian of prescribed curvature is the Laplacian with the stress of M itself.
    ///
    /// # Errors
    /// As for [`star`](Self::star).
    pub fn jacobian_row(&self, vertex: VertexId) -> Result<Vec<(VertexId, T)>, VertexUndefined> {
        let star = self.star(vertex)?;
        let total = star.iter().fold(T::zero(), |sum, e| sum + &e.weight[0]);
        let neighbours =
            star.into_iter().map(|StarEdge { target, weight: [w, _], .. }| (target, w));
        Ok(std::iter::once((vertex, -total)).chain(neighbours).collect())
    }
}
