//! Curvatures at vertices of v-parallel pairs (21), (22).

use std::fmt;

use super::{Curvatures, Forms, VParallel, Which};
use crate::mesh::{FaceId, VertexId, VertexKind};
use crate::scalar::{Field, Ordered, Sign};
use crate::space::Gradient;

/// The measures `D(v)`, `D(v, s)`, `D(s)` of a vertex with any valence: the *integrated* curvatures.
///
/// They are the area forms on the polygons of the gradients of the faces around the vertex, in
/// counter-clockwise order. They are polynomials where H and K are quotients, they add up, and they
/// are there where `D(s) = 0`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexForms<T> {
    /// The vertex.
    pub vertex: VertexId,
    /// `4 D(v)`, `4 D(v, s)`, `4 D(s)`.
    pub four: Forms<T>,
}

/// Why a vertex has no curvature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexUndefined {
    /// Its faces form no closed cycle.
    NotInterior(VertexId, VertexKind),
    /// `D(s) = 0`: the faces of the Gauss image around it have no area under duality.
    ZeroMeasure(VertexId),
    /// A face at it is vertical or collinear, so that it has no gradient.
    NotAGraph(VertexId, FaceId),
    /// An edge of the star has length zero in the top view, so it has no weight.
    ZeroLength(VertexId, VertexId),
}

impl fmt::Display for VertexUndefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VertexUndefined::NotInterior(v, kind) => {
                let reason = match kind {
                    VertexKind::Isolated => "it is in no face",
                    VertexKind::Boundary => "it lies on the boundary",
                    VertexKind::Pinched => "the mesh is pinched there",
                    VertexKind::Interior => "its faces do not close",
                };
                write!(f, "vertex {} has no curvature: {reason}", v.0)
            }
            VertexUndefined::ZeroMeasure(v) => {
                write!(f, "vertex {} has no curvature: the measure of its image is 0", v.0)
            }
            VertexUndefined::NotAGraph(v, face) => {
                write!(f, "vertex {} has no curvature: face {} is vertical", v.0, face.0)
            }
            VertexUndefined::ZeroLength(v, w) => {
                write!(f, "the edge from vertex {} to {} has length 0 in the top view", v.0, w.0)
            }
        }
    }
}

impl std::error::Error for VertexUndefined {}

impl<T: Field> VertexForms<T> {
    /// `D(v)` (21): the isotropic measure of the planes through the vertex, the area of the
    /// polygon of gradients; positive at a convex or concave vertex.
    pub fn measure(&self) -> T {
        &self.four.first * T::from_ratio(1, 4)
    }

    /// `D(v, s)`, the mixed measure; positive at a convex vertex over a convex image.
    pub fn mixed_measure(&self) -> T {
        &self.four.mixed * T::from_ratio(1, 4)
    }

    /// `D(s)`; for the lift of a triangle mesh the signed area of the polygon of circumcentres.
    pub fn image_measure(&self) -> T {
        &self.four.second * T::from_ratio(1, 4)
    }

    /// (22): the *pointwise* curvatures `K = D(v) / D(s)` and `H = D(v, s) / D(s)`.
    ///
    /// # Errors
    /// Where `D(s) = 0`.
    pub fn curvatures(&self) -> Result<Curvatures<T>, VertexUndefined> {
        self.four.at_vertex().ok_or(VertexUndefined::ZeroMeasure(self.vertex))
    }
}

impl<T: Ordered> VertexForms<T> {
    /// Whether `D(s) < 0`, in a mesh whose faces run counter-clockwise in the top view: then H and K exist but the Gauss image is turned over, and they say
    /// nothing about the shape. For lifts of triangle meshes this cannot happen at a vertex whose
    /// edges are all Delaunay.
    pub fn image_is_reversed(&self) -> bool {
        self.four.second.certain_sign() == Some(Sign::Negative)
    }
}

impl<T: Field> VParallel<'_, T> {
    /// The measures of a vertex and its image (21).
    ///
    /// # Errors
    /// Where the faces around the vertex form no closed cycle.
    pub fn vertex_forms(&self, vertex: VertexId) -> Result<VertexForms<T>, VertexUndefined> {
        self.interior(vertex)?;
        let topology = &self.mesh().topology;
        let [p, q] = [Which::Mesh, Which::Image].map(|which| -> Vec<Gradient<T>> {
            topology
                .star(vertex)
                .map(|h| self.gradient(which, topology.face_at(h)).clone())
                .collect()
        });
        Ok(VertexForms { vertex, four: Forms::of(&p, &q) })
    }

    /// H and K at a vertex (22).
    ///
    /// # Errors
    /// Where the faces around the vertex form no closed cycle, or `D(s) = 0`.
    ///
    /// ```
    /// use isogeo::mesh::{FaceList, Mesh, VertexId};
    /// use isogeo::pair::VParallel;
    /// use isogeo::space::Point;
    /// // A pyramid of height 3 over the square (±1, ±1), and one of height 1 in Σ.
    /// let pyramid = |height: f64| {
    ///     let mut faces = FaceList::new();
    ///     (0..4).for_each(|i| faces.push([0, 1 + i, 1 + (i + 1) % 4]));
    ///     let at = |x, y, z| Point::new(x, y, z);
    ///     let ring = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    ///     let ring = ring.map(|(x, y)| at(x, y, height));
    ///     Mesh::new([&[at(0.0, 0.0, 0.0)], ring.as_slice()].concat(), faces)
    /// };
    /// let (m, s) = (pyramid(3.0)?, pyramid(1.0)?);
    /// let curvatures = VParallel::new(&m, &s).ok().and_then(|p| p.vertex_curvatures(VertexId(0)).ok());
    /// assert_eq!(curvatures.map(|c| (c.mean, c.gauss)), Some((3.0, 9.0)));
    /// # Ok::<(), isogeo::mesh::TopologyError>(())
    /// ```
    pub fn vertex_curvatures(&self, vertex: VertexId) -> Result<Curvatures<T>, VertexUndefined> {
        self.vertex_forms(vertex)?.curvatures()
    }

    pub(super) fn interior(&self, vertex: VertexId) -> Result<(), VertexUndefined> {
        match self.mesh().topology.kind(vertex) {
            VertexKind::Interior => Ok(()),
            kind => Err(VertexUndefined::NotInterior(vertex, kind)),
        }
    }
}
