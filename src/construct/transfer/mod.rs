//! The map τ from the isotropic model of Laguerre geometry to Euclidean space, and back (12), for
//! meshes (Remarks 1 and 2).
//!
//! | M in isotropic space | N in Euclidean space | by |
//! | --- | --- | --- |
//! | i-circular | conical, with rational unit normals | [`conical_image`], [`circular_image`] |
//! | i-isothermic, with radii of its vertex circles | edge-offset mesh, with its axes | [`edge_offset_image`], [`isothermic_image`] |
//!
//! A face of M becomes a vertex of N, an interior vertex of M a face of N.

mod euclidean;
mod isothermic;
mod isotropic;

use std::fmt;

use crate::mesh::{FaceId, NoPlane, TopologyError, VertexId};

pub use euclidean::{EuclideanImage, conical_image, edge_offset_image};
pub use isothermic::{isothermic_image, stored_axes};
pub use isotropic::{circular_image, observed_image, oriented_planes, stored_planes};

/// The names of the data on faces that hold the oriented planes `n₁x + n₂y + n₃z + h = 0`.
pub const PLANE_DATA: [&str; 4] = ["n1", "n2", "n3", "h"];

/// The names of the data on vertices that hold the axes s of their cones, the vertices of the Gauss
/// image, of an edge-offset mesh.
pub const AXIS_DATA: [&str; 3] = ["s1", "s2", "s3"];

/// Why a mesh has no image under τ or its inverse.
#[derive(Clone, Debug, PartialEq)]
pub enum NoTransfer<T> {
    /// A face of M without a plane, or with an isotropic one.
    Plane(NoPlane<T>),
    /// A face of M whose vertices do not lie on a circle of the top view, or whose vertex circles
    /// have no common orthogonal circle.
    NoCircle {
        /// The face.
        face: FaceId,
        /// How far the lift of a vertex lies above the plane of three others, exactly.
        residual: T,
    },
    /// Two neighbouring vertex circles that do not touch.
    NotTouching {
        /// The ends of the edge.
        edge: [VertexId; 2],
        /// `|x_i − x_j|² − (r_i + r_j)²` in the top view, exactly.
        residual: T,
    },
    /// Not one radius for every vertex.
    NoRadii,
    /// Not one axis for every vertex.
    NoAxes,
    /// A face of M whose circle is the image of a great circle: the planes envelop a cylinder, and
    /// the vertex lies at infinity.
    Cylinder(FaceId),
    /// A face of N of vector area 0, which has no oriented plane.
    NoNormal(FaceId),
    /// A face of N whose unit normal is no vector of fractions.
    Irrational {
        /// The face.
        face: FaceId,
        /// The squared length of a rational normal; it is no square.
        length2: T,
    },
    /// A stored normal of N that does not have length 1.
    NotAUnitNormal(FaceId),
    /// A vertex of N beside the plane of one of its faces.
    NotPlanar {
        /// The face.
        face: FaceId,
        /// The signed distance of the vertex, exactly.
        residual: T,
    },
    /// A face of N with the normal (0, 0, −1), which (12) sends to infinity.
    SouthPole(FaceId),
    /// A vertex of N whose unit normals lie on no circle.
    NotConical {
        /// The vertex.
        vertex: VertexId,
        /// Six times the volume that four of the unit normals span, exactly.
        residual: T,
    },
    /// A vertex of N whose cone has a plane with the normal (0, 0, −1).
    SouthCone(VertexId),
    /// A face of N around which the axes do not belong to one circle: the face of the Gauss image is not
    /// planar, or does not have the normal of N.
    NotEdgeOffset {
        /// The face.
        face: FaceId,
        /// What is left of the plane of the face or of its image at a vertex, exactly.
        residual: T,
    },
    /// A face of N whose vertex circle has a radius that is no fraction, or imaginary.
    IrrationalRadius {
        /// The face.
        face: FaceId,
        /// The squared radius.
        radius2: T,
    },
    /// The dual combinatorics form no mesh.
    Topology(TopologyError),
}

impl<T> NoTransfer<T> {
    /// The same with `f` applied to every number, to show them in another form.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> NoTransfer<S> {
        match self {
            NoTransfer::Plane(reason) => NoTransfer::Plane(reason.map(f)),
            NoTransfer::NoCircle { face, residual } => {
                NoTransfer::NoCircle { face: *face, residual: f(residual) }
            }
            NoTransfer::NotTouching { edge, residual } => {
                NoTransfer::NotTouching { edge: *edge, residual: f(residual) }
            }
            NoTransfer::NoRadii => NoTransfer::NoRadii,
            NoTransfer::NoAxes => NoTransfer::NoAxes,
            NoTransfer::Cylinder(face) => NoTransfer::Cylinder(*face),
            NoTransfer::NoNormal(face) => NoTransfer::NoNormal(*face),
            NoTransfer::Irrational { face, length2 } => {
                NoTransfer::Irrational { face: *face, length2: f(length2) }
            }
            NoTransfer::NotAUnitNormal(face) => NoTransfer::NotAUnitNormal(*face),
            NoTransfer::NotPlanar { face, residual } => {
                NoTransfer::NotPlanar { face: *face, residual: f(residual) }
            }
            NoTransfer::SouthPole(face) => NoTransfer::SouthPole(*face),
            NoTransfer::NotConical { vertex, residual } => {
                NoTransfer::NotConical { vertex: *vertex, residual: f(residual) }
            }
            NoTransfer::SouthCone(vertex) => NoTransfer::SouthCone(*vertex),
            NoTransfer::NotEdgeOffset { face, residual } => {
                NoTransfer::NotEdgeOffset { face: *face, residual: f(residual) }
            }
            NoTransfer::IrrationalRadius { face, radius2 } => {
                NoTransfer::IrrationalRadius { face: *face, radius2: f(radius2) }
            }
            NoTransfer::Topology(error) => NoTransfer::Topology(error.clone()),
        }
    }

    /// Whether something is undefined, as a vertex at infinity or a normal that is no fraction,
    /// rather than a residual that does not vanish.
    pub fn is_undefined(&self) -> bool {
        !matches!(
            self,
            NoTransfer::Plane(NoPlane::NotPlanar { .. })
                | NoTransfer::NoCircle { .. }
                | NoTransfer::NotTouching { .. }
                | NoTransfer::NotAUnitNormal(_)
                | NoTransfer::NotPlanar { .. }
                | NoTransfer::NotConical { .. }
                | NoTransfer::NotEdgeOffset { .. }
        )
    }
}

impl<T: fmt::Display> fmt::Display for NoTransfer<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoTransfer::Plane(reason) => reason.fmt(f),
            NoTransfer::NoCircle { face, residual } => write!(
                f,
                "face {} has no circle: the lift of a vertex lies {residual} above the plane of three others",
                face.0
            ),
            NoTransfer::NotTouching { edge: [v, w], residual } => {
                write!(
                    f,
                    "the circles of vertices {} and {} do not touch: residual {residual}",
                    v.0, w.0
                )
            }
            NoTransfer::NoRadii => write!(f, "there is not one radius for every vertex"),
            NoTransfer::NoAxes => write!(f, "there is not one axis for every vertex"),
            NoTransfer::Cylinder(face) => write!(
                f,
                "the circle of face {} stands for a great circle: its vertex is at infinity",
                face.0
            ),
            NoTransfer::NoNormal(face) => write!(f, "face {} has vector area 0", face.0),
            NoTransfer::Irrational { face, length2 } => write!(
                f,
                "the unit normal of face {} is irrational: its squared length {length2} is no square",
                face.0
            ),
            NoTransfer::NotAUnitNormal(face) => {
                write!(f, "the stored normal of face {} does not have length 1", face.0)
            }
            NoTransfer::NotPlanar { face, residual } => {
                write!(
                    f,
                    "face {} is not planar: a vertex lies {residual} beside its plane",
                    face.0
                )
            }
            NoTransfer::SouthPole(face) => {
                write!(f, "face {} has the normal (0, 0, −1): its image is at infinity", face.0)
            }
            NoTransfer::NotConical { vertex, residual } => write!(
                f,
                "vertex {} is not conical: four unit normals span six times the volume {residual}",
                vertex.0
            ),
            NoTransfer::SouthCone(vertex) => write!(
                f,
                "the cone at vertex {} has a plane with the normal (0, 0, −1): its image is at infinity",
                vertex.0
            ),
            NoTransfer::NotEdgeOffset { face, residual } => write!(
                f,
                "the axes at the vertices of face {} do not belong to one circle: residual {residual}",
                face.0
            ),
            NoTransfer::IrrationalRadius { face, radius2 } => write!(
                f,
                "the circle of face {} has the squared radius {radius2}, which is no square",
                face.0
            ),
            NoTransfer::Topology(error) => {
                write!(f, "the dual combinatorics form no mesh: {error}")
            }
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoTransfer<T> {}

impl<T> From<NoPlane<T>> for NoTransfer<T> {
    fn from(reason: NoPlane<T>) -> Self {
        NoTransfer::Plane(reason)
    }
}

impl<T> From<TopologyError> for NoTransfer<T> {
    fn from(error: TopologyError) -> Self {
        NoTransfer::Topology(error)
    }
}
