//! Why a mesh has no Christoffel dual.

use std::fmt;

use crate::mesh::{FaceId, VertexId};
use crate::space::Vector3;

/// Why a mesh has no Christoffel dual: the first element or cycle that does not close, exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum NoChristoffelDual<T> {
    /// The numbers of points, radii and vertices differ.
    Counts,
    /// A face with an odd number of sides, around which signs do not alternate.
    OddFace(FaceId),
    /// An interior vertex of odd valence, around which signs do not alternate.
    OddVertex(VertexId),
    /// A cycle of faces around a hole or a handle along which signs do not alternate.
    FaceCycle(Vec<FaceId>),
    /// A vertex with radius 0.
    ZeroRadius(VertexId),
    /// A face that is no quad, in a mesh without radii.
    NoQuad(FaceId),
    /// A face that is not planar: a vertex lies so far above the plane of three others.
    NotPlanar {
        /// The face.
        face: FaceId,
        /// The height.
        residual: T,
    },
    /// A face with a corner on a diagonal in the top view: vertical, or three corners on a line.
    Degenerate(FaceId),
    /// An interior vertex around which the ratios of diagonals do not close.
    VertexOpen {
        /// The vertex.
        vertex: VertexId,
        /// Their product, which is not 1.
        product: T,
    },
    /// A cycle of vertices around a hole or a handle that does not close.
    VertexCycle(Vec<VertexId>),
    /// A face whose dual edges do not close.
    FaceOpen {
        /// The face.
        face: FaceId,
        /// The sum of the dual edges.
        residual: Vector3<T>,
    },
    /// A face whose dual closes, but is no Christoffel dual: four times the mixed area.
    MixedArea {
        /// The face.
        face: FaceId,
        /// Four times the mixed area.
        residual: T,
    },
}

impl<T> NoChristoffelDual<T> {
    /// The same with `f` applied to every number, to show them in another form.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> NoChristoffelDual<S> {
        use NoChristoffelDual::*;
        match self {
            Counts => Counts,
            OddFace(face) => OddFace(*face),
            OddVertex(vertex) => OddVertex(*vertex),
            FaceCycle(cycle) => FaceCycle(cycle.clone()),
            ZeroRadius(vertex) => ZeroRadius(*vertex),
            NoQuad(face) => NoQuad(*face),
            NotPlanar { face, residual } => NotPlanar { face: *face, residual: f(residual) },
            Degenerate(face) => Degenerate(*face),
            VertexOpen { vertex, product } => VertexOpen { vertex: *vertex, product: f(product) },
            VertexCycle(cycle) => VertexCycle(cycle.clone()),
            FaceOpen { face, residual: Vector3 { x, y, z } } => {
                FaceOpen { face: *face, residual: Vector3 { x: f(x), y: f(y), z: f(z) } }
            }
            MixedArea { face, residual } => MixedArea { face: *face, residual: f(residual) },
        }
    }

    /// Whether the rules do not apply, rather than a residual that does not vanish: faces without
    /// the right number of sides, without a plane that is a graph, or radii that are 0.
    pub fn is_undefined(&self) -> bool {
        use NoChristoffelDual::*;
        matches!(
            self,
            Counts
                | OddFace(_)
                | OddVertex(_)
                | FaceCycle(_)
                | ZeroRadius(_)
                | NoQuad(_)
                | Degenerate(_)
        )
    }

    /// The cycle of vertices or of faces that fails, if it is none around a vertex or a face.
    pub fn cycle(&self) -> Option<Vec<u32>> {
        match self {
            NoChristoffelDual::VertexCycle(cycle) => Some(cycle.iter().map(|v| v.0).collect()),
            NoChristoffelDual::FaceCycle(cycle) => Some(cycle.iter().map(|f| f.0).collect()),
            _ => None,
        }
    }
}

impl<T: fmt::Display> fmt::Display for NoChristoffelDual<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use NoChristoffelDual::*;
        let list = |f: &mut fmt::Formatter<'_>, what, end| {
            let ids: Vec<String> = self.cycle().iter().flatten().map(ToString::to_string).collect();
            write!(f, "the cycle of {what} {} {end}", ids.join(", "))
        };
        match self {
            Counts => f.write_str("the numbers of points, radii and vertices differ"),
            OddFace(face) => {
                write!(f, "face {} has an odd number of sides, so signs do not alternate", face.0)
            }
            OddVertex(v) => {
                write!(f, "vertex {} has an odd valence, so signs do not alternate", v.0)
            }
            FaceCycle(_) => list(f, "faces", "has an odd number of turns"),
            ZeroRadius(v) => write!(f, "vertex {} has radius 0", v.0),
            NoQuad(face) => write!(f, "face {} is no quad, and there are no radii", face.0),
            NotPlanar { face, residual } => write!(
                f,
                "face {} is not planar: a vertex lies {residual} above the plane of three others",
                face.0
            ),
            Degenerate(face) => {
                write!(f, "face {} has three corners on a line in the top view", face.0)
            }
            VertexOpen { vertex, product } => write!(
                f,
                "vertex {} does not close: the product of the ratios of diagonals is {product}",
                vertex.0
            ),
            VertexCycle(_) => list(f, "vertices", "does not close"),
            FaceOpen { face, residual: Vector3 { x, y, z } } => {
                write!(f, "face {} does not close: its dual misses by ({x}, {y}, {z})", face.0)
            }
            MixedArea { face, residual } => {
                write!(f, "face {} and its dual have the mixed area ({residual})/4", face.0)
            }
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for NoChristoffelDual<T> {}
