//! Gauss images: meshes that stand for the spherical image of a mesh, inscribed or circumscribed to
//! the unit i-sphere Σ (Sec. 3.1, 3.2, Theorems 1 and 2).
//!
//! | M is | S is | made by | unique |
//! | --- | --- | --- | --- |
//! | i-circular, any triangle mesh | inscribed, v-parallel | [`inscribed_v_parallel`](super::inscribed_v_parallel()) | yes |
//! | i-conical | circumscribed, f-parallel | [`circumscribed_f_parallel`](super::circumscribed_f_parallel()) | up to the boundary |
//! | i-circular | inscribed, f-parallel | [`inscribed_f_parallel`](super::inscribed_f_parallel()) | one for every start |
//! | i-conical | circumscribed, v-parallel | [`circumscribed_v_parallel`](super::circumscribed_v_parallel()) | one for every start |
//!
//! Each comes as a pair that was checked exactly.

use std::fmt;

use crate::mesh::{FaceId, Mesh, NoPlane, VertexId};
use crate::pair::{Misfit, Which};
use crate::space::{Vector2, Vector3};

/// Why a mesh has no Gauss image of the kind asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum NoGaussImage<T> {
    /// The vertex or face to start from does not exist.
    NoStart(u32),
    /// A face without a plane, or with an isotropic one.
    Plane(NoPlane<T>),
    /// A vertex that is not i-conical.
    NotConical {
        /// The vertex.
        vertex: VertexId,
        /// How far the common point of three touching planes lies above another, exactly.
        residual: T,
    },
    /// A vertex with at least three different gradients on a line: the touching planes are
    /// parallel to that of a vertical cylinder and have no common point.
    AtInfinity(VertexId),
    /// An edge with equal top views of its ends, which has no direction or no line there.
    VerticalEdge(VertexId, VertexId),
    /// A face around which the construction does not close.
    FaceOpen {
        /// The face.
        face: FaceId,
        /// From its first vertex to the point that is found after one turn.
        residual: Vector3<T>,
    },
    /// A vertex around which the construction does not close.
    VertexOpen {
        /// The vertex.
        vertex: VertexId,
        /// From the contact point of its first face to the one that is found after one turn.
        residual: Vector2<T>,
    },
    /// All faces close, but a cycle of vertices around a hole or a handle does not.
    VertexCycleOpen(Vec<VertexId>),
    /// All vertices close, but a cycle of faces around a hole or a handle does not.
    FaceCycleOpen(Vec<FaceId>),
    /// The image was made, but it is no pair with the mesh.
    Misfit(Misfit<T>),
}

impl<T> From<NoPlane<T>> for NoGaussImage<T> {
    fn from(reason: NoPlane<T>) -> Self {
        NoGaussImage::Plane(reason)
    }
}

impl<T> From<Misfit<T>> for NoGaussImage<T> {
    fn from(reason: Misfit<T>) -> Self {
        NoGaussImage::Misfit(reason)
    }
}

impl<T> NoGaussImage<T> {
    /// Checks that every vertex has a point and that the element to start from exists.
    pub(super) fn of_input(mesh: &Mesh<T>, start: u32, elements: usize) -> Result<(), Self> {
        if mesh.points.len() != mesh.topology.vertex_count() {
            return Err(Misfit::Points(Which::Mesh).into());
        }
        if start as usize >= elements { Err(NoGaussImage::NoStart(start)) } else { Ok(()) }
    }
}

impl<T> NoGaussImage<T> {
    /// The same with `f` applied to every number, to show them in another form.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> NoGaussImage<S> {
        match self {
            NoGaussImage::NoStart(i) => NoGaussImage::NoStart(*i),
            NoGaussImage::Plane(reason) => NoGaussImage::Plane(reason.map(f)),
            NoGaussImage::NotConical { vertex, residual } => {
                NoGaussImage::NotConical { vertex: *vertex, residual: f(residual) }
            }
            NoGaussImage::AtInfinity(v) => NoGaussImage::AtInfinity(*v),
            NoGaussImage::VerticalEdge(v, w) => NoGaussImage::VerticalEdge(*v, *w),
            NoGaussImage::FaceOpen { face, residual: Vector3 { x, y, z } } => {
                let residual = Vector3 { x: f(x), y: f(y), z: f(z) };
                NoGaussImage::FaceOpen { face: *face, residual }
            }
            NoGaussImage::VertexOpen { vertex, residual: Vector2 { x, y } } => {
                NoGaussImage::VertexOpen { vertex: *vertex, residual: Vector2 { x: f(x), y: f(y) } }
            }
            NoGaussImage::VertexCycleOpen(cycle) => NoGaussImage::VertexCycleOpen(cycle.clone()),
            NoGaussImage::FaceCycleOpen(cycle) => NoGaussImage::FaceCycleOpen(cycle.clone()),
            NoGaussImage::Misfit(reason) => NoGaussImage::Misfit(reason.map(f)),
        }
    }

    /// Whether the construction meets something undefined, as a vertical face or edge or a vertex
    /// at infinity, rather than a residual that does not vanish.
    pub fn is_undefined(&self) -> bool {
        matches!(
            self,
            NoGaussImage::Plane(NoPlane::NotAGraph(_))
                | NoGaussImage::AtInfinity(_)
                | NoGaussImage::VerticalEdge(..)
                | NoGaussImage::Misfit(Misfit::Plane(_, NoPlane::NotAGraph(_)))
        )
    }
}

impl<T: fmt::Display> fmt::Display for NoGaussImage<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fn list(ids: impl Iterator<Item = u32>) -> String {
            ids.map(|i| i.to_string()).collect::<Vec<_>>().join(", ")
        }
        match self {
            NoGaussImage::NoStart(i) => write!(f, "there is no element {i} to start from"),
            NoGaussImage::Plane(reason) => reason.fmt(f),
            NoGaussImage::NotConical { vertex, residual } => write!(
                f,
                "vertex {} is not i-conical: the point of three touching planes lies {residual} above another",
                vertex.0
            ),
            NoGaussImage::AtInfinity(v) => {
                write!(f, "the gradients at vertex {} lie on a line: its image is at infinity", v.0)
            }
            NoGaussImage::VerticalEdge(v, w) => {
                write!(
                    f,
                    "the edge between vertices {} and {} has length 0 in the top view",
                    v.0, w.0
                )
            }
            NoGaussImage::FaceOpen { face, residual: Vector3 { x, y, z } } => {
                write!(f, "face {} does not close: it misses by ({x}, {y}, {z})", face.0)
            }
            NoGaussImage::VertexOpen { vertex, residual: Vector2 { x, y } } => {
                write!(f, "vertex {} does not close: it misses by ({x}, {y})", vertex.0)
            }
            NoGaussImage::VertexCycleOpen(cycle) => {
                write!(
                    f,
                    "the cycle of vertices {} does not close",
                    list(cycle.iter().map(|v| v.0))
                )
            }
            NoGaussImage::FaceCycleOpen(cycle) => {
                write!(f, "the cycle of faces {} does not close", list(cycle.iter().map(|f| f.0)))
            }
            NoGaussImage::Misfit(reason) => reason.fmt(f),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoGaussImage<T> {}
