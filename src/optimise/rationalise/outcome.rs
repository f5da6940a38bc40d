//! What comes of it: an exact mesh with how far it is, or the element that stops it.

use std::fmt;

use super::super::Movement;
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::scalar::Rational;

/// An exact mesh near a mesh of doubles.
#[derive(Clone, Debug)]
pub struct Rationalised {
    /// The mesh: the topology of the other one, without its data.
    pub mesh: Mesh<Rational>,
    /// How far its vertices are from those of the other one.
    pub movement: Movement,
    /// The bits of the longest numerator or denominator of a coordinate.
    pub bits: u64,
}

/// Why there is no exact mesh: the element that stopped it, and what is wrong there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoExactMesh {
    /// Where.
    pub at: Element,
    /// What.
    pub why: Obstacle,
}

/// A vertex or a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A vertex.
    Vertex(VertexId),
    /// A face.
    Face(FaceId),
}

/// What stands in the way of an exact mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A coordinate is no finite number.
    NotFinite,
    /// Points, planes or circles that should determine the element do not.
    Degenerate,
    /// The element, and all that is left with it, depends on too many others at once.
    Stuck,
    /// Numbers of more bits than were allowed.
    TooManyBits,
    /// The face is no quad.
    NoQuad,
    /// The interior vertex has not four faces.
    NotRegular,
    /// Another interior vertex has two faces in common with it that are no neighbours there: the dual
    /// is no mesh.
    NoDual,
    /// More than three face planes meet at the vertex, which is at the boundary, and nothing makes
    /// them meet exactly.
    TooManyPlanes,
    /// There is not enough memory.
    OutOfMemory,
}

impl Obstacle {
    pub(super) fn at_vertex(self, v: VertexId) -> NoExactMesh {
        NoExactMesh { at: Element::Vertex(v), why: self }
    }

    pub(super) fn at_face(self, f: FaceId) -> NoExactMesh {
        NoExactMesh { at: Element::Face(f), why: self }
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Element::Vertex(v) => write!(f, "vertex {}", v.0),
            Element::Face(face) => write!(f, "face {}", face.0),
        }
    }
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Obstacle::NotFinite => "a coordinate is no finite number",
            Obstacle::Degenerate => "what it should be determined by is degenerate",
            Obstacle::Stuck => "no order of the vertices lets it depend on few enough of them",
            Obstacle::TooManyBits => "its numbers become too long",
            Obstacle::NoQuad => "it is no quad",
            Obstacle::NotRegular => "it has not four faces",
            Obstacle::NoDual => "two of its faces meet at another vertex, too: there is no dual",
            Obstacle::TooManyPlanes => {
                "more than three face planes meet there at the boundary, and not exactly"
            }
            Obstacle::OutOfMemory => "there is not enough memory",
        })
    }
}

impl fmt::Display for NoExactMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.at, self.why)
    }
}

impl std::error::Error for NoExactMesh {}
