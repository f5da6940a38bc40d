//! The metric dual of a mesh: the polarity with respect to Σ, face planes to vertices (Sec. 2.1, 3.1).

use std::fmt;

use crate::mesh::{Data, FaceId, Mesh, NoPlane, TopologyError};
use crate::scalar::Field;
use crate::space::{Dual, Plane};

/// Why a mesh has no metric dual.
#[derive(Clone, Debug, PartialEq)]
pub enum NoDual<T> {
    /// A face without a plane: the value of the plane through three of its points at another one.
    NotPlanar {
        /// The face.
        face: FaceId,
        /// How far the other point lies above the plane, exactly.
        residual: T,
    },
    /// A face in an isotropic plane, which has no pole, or with collinear points.
    NoPole(FaceId),
    /// The dual combinatorics form no mesh; faces are interior vertices of the mesh here.
    Topology(TopologyError),
}

impl<T: fmt::Display> fmt::Display for NoDual<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoDual::NotPlanar { face, residual } => write!(
                f,
                "face {} is not planar: a vertex lies {residual} above the plane of three others",
                face.0
            ),
            NoDual::NoPole(face) => {
                write!(f, "face {} is vertical or collinear, so its plane has no pole", face.0)
            }
            NoDual::Topology(error) => write!(f, "the dual combinatorics form no mesh: {error}"),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoDual<T> {}

impl<T> From<NoPlane<T>> for NoDual<T> {
    fn from(reason: NoPlane<T>) -> Self {
        match reason {
            NoPlane::NotPlanar { face, residual } => NoDual::NotPlanar { face, residual },
            NoPlane::NotAGraph(face) => NoDual::NoPole(face),
        }
    }
}

/// The metric dual: for every face the pole `(p₁, p₂, −t)` of its plane `z = p·x' + t`, for every
/// interior vertex a face.
///
/// Vertex `i` of the dual is face `i`; its faces follow the order of the interior vertices. A
/// planar mesh is i-circular iff its dual is i-conical, and conversely; the dual of an inscribed
/// mesh is circumscribed. Where K < 0 the top views of dual faces run clockwise. Data on elements
/// are not carried over, since duality changes their meaning.
///
/// # Errors
/// See [`NoDual`].
pub fn metric_dual<T: Field>(mesh: &Mesh<T>) -> Result<Mesh<T>, NoDual<T>> {
    let planes = mesh.topology.faces().map(|f| face_plane(mesh, f));
    let points = planes.map(|p| p.map(|plane| plane.dual())).collect::<Result<_, _>>()?;
    let topology = mesh.topology.dual().map_err(NoDual::Topology)?.topology;
    Ok(Mesh { topology, points, data: Data::default() })
}

/// The plane of a face: see [`Mesh::face_plane`].
///
/// # Errors
/// Where there is none, or it is isotropic.
pub fn face_plane<T: Field>(mesh: &Mesh<T>, face: FaceId) -> Result<Plane<T>, NoDual<T>> {
    Ok(mesh.face_plane(face)?)
}
