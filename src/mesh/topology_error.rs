//! Why lists of vertices are no oriented mesh.

use std::fmt;

use super::{FaceId, VertexId};

/// Why lists of vertices are no oriented mesh. Indices count from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TopologyError {
    /// A face with fewer than three corners.
    FaceTooSmall {
        /// The face.
        face: FaceId,
        /// How many corners it has.
        corners: usize,
    },
    /// A corner that names a vertex that does not exist.
    NoSuchVertex {
        /// The face.
        face: FaceId,
        /// The index it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: u32,
    },
    /// A face that goes through a vertex twice.
    RepeatedVertex {
        /// The face.
        face: FaceId,
        /// The vertex.
        vertex: VertexId,
    },
    /// Two faces that run through their common edge in the same direction.
    WrongOrientation {
        /// The edge, in the direction of both.
        edge: (VertexId, VertexId),
        /// The two faces.
        faces: (FaceId, FaceId),
    },
    /// An edge of more than two faces.
    NonManifoldEdge {
        /// The edge.
        edge: (VertexId, VertexId),
        /// Three of its faces.
        faces: (FaceId, FaceId, FaceId),
    },
    /// More corners than 32 bits can count.
    TooLarge,
}

impl TopologyError {
    /// The face that the message is about: the last of those named.
    pub fn face(&self) -> Option<FaceId> {
        match *self {
            TopologyError::FaceTooSmall { face, .. }
            | TopologyError::NoSuchVertex { face, .. }
            | TopologyError::RepeatedVertex { face, .. } => Some(face),
            TopologyError::WrongOrientation { faces: (a, b), .. } => Some(a.max(b)),
            TopologyError::NonManifoldEdge { faces: (a, b, c), .. } => Some(a.max(b).max(c)),
            TopologyError::TooLarge => None,
        }
    }
}

impl fmt::Display for TopologyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TopologyError::FaceTooSmall { face, corners } => {
                write!(f, "face {} has {corners} corners; a face needs at least 3", face.0)
            }
            TopologyError::NoSuchVertex { face, vertex, vertices } => {
                write!(f, "face {} names vertex {vertex}, but there are only {vertices}", face.0)
            }
            TopologyError::RepeatedVertex { face, vertex } => {
                write!(f, "face {} goes through vertex {} twice", face.0, vertex.0)
            }
            TopologyError::WrongOrientation { edge, faces } => write!(
                f,
                "faces {} and {} run through the edge from vertex {} to vertex {} in the same direction",
                faces.0.0, faces.1.0, edge.0.0, edge.1.0
            ),
            TopologyError::NonManifoldEdge { edge, faces } => write!(
                f,
                "the edge between vertices {} and {} belongs to more than two faces: {}, {} and {}",
                edge.0.0, edge.1.0, faces.0.0, faces.1.0, faces.2.0
            ),
            TopologyError::TooLarge => write!(f, "more than {} corners or vertices", u32::MAX - 1),
        }
    }
}

impl std::error::Error for TopologyError {}
