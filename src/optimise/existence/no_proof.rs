//! Why the existence of an exact mesh is not proved.

use std::fmt;

use crate::check::Element;
use crate::mesh::VertexId;

/// Why a proof of existence does not succeed. None of it says that there is no such mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum NoProof {
    /// The property asks for nothing, so that there is nothing to prove.
    Vacuous,
    /// A condition is no polynomial.
    NotPolynomial {
        /// What it asks for.
        name: &'static str,
    },
    /// A vertex is named that the mesh does not have.
    NoSuchVertex(VertexId),
    /// No movement that is allowed changes the value of a condition to first order.
    Rigid {
        /// What the condition asks for.
        name: &'static str,
        /// Its points.
        at: Vec<VertexId>,
    },
    /// The gradients of the conditions depend on each other, as far as doubles tell.
    Dependent {
        /// What the condition asks for that the dependence speaks of most.
        name: &'static str,
        /// Its points.
        at: Vec<VertexId>,
        /// What the smallest eigenvalue of their matrix of inner products seems to be.
        smallest: f64,
        /// How much of it rounding may have made.
        rounding: f64,
    },
    /// The points are too far from where the conditions hold.
    TooFar {
        /// The number that must be below 1: how much the derivative may differ from the one that is inverted.
        deviation: f64,
        /// The number that must not exceed 1/2, if the other allows to compute it.
        contraction: f64,
    },
    /// The exact mesh may be one for which the property is not defined, or not by these conditions.
    Degenerate(Element),
    /// There is not enough memory.
    OutOfMemory,
}

fn numbers(vertices: &[VertexId]) -> String {
    let numbers: Vec<String> = vertices.iter().map(|v| v.0.to_string()).collect();
    numbers.join(" ")
}

impl fmt::Display for NoProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoProof::Vacuous => write!(f, "the property asks for nothing on this mesh"),
            NoProof::NotPolynomial { name } => {
                write!(f, "the condition '{name}' is no polynomial, which the proof asks for")
            }
            NoProof::NoSuchVertex(v) => write!(f, "there is no vertex {}", v.0),
            NoProof::Rigid { name, at } => write!(
                f,
                "no movement that is allowed changes the condition '{name}' at vertices {}",
                numbers(at)
            ),
            NoProof::Dependent { name, at, smallest, rounding } => write!(
                f,
                "the conditions depend on each other as far as doubles tell, '{name}' at vertices {} most: the \
                 smallest eigenvalue seems to be {smallest:.1e}, and rounding may have made {rounding:.1e} of it",
                numbers(at)
            ),
            NoProof::TooFar { deviation, contraction } if *deviation < 1.0 => write!(
                f,
                "the points are too far from where the conditions hold: the Kantorovich number is \
                 {contraction:.1e} and must not exceed 1/2"
            ),
            NoProof::TooFar { deviation, .. } => write!(
                f,
                "the points are too far from where the conditions hold: the derivative changes by {deviation:.1e} \
                 times the smallest singular value, which must be below 1"
            ),
            NoProof::Degenerate(Element::Edge(a, b)) => write!(
                f,
                "the top view of edge {}-{} may have length zero on the exact mesh",
                a.0, b.0
            ),
            NoProof::Degenerate(Element::Vertex(v)) => write!(
                f,
                "faces at vertex {} may be vertical or have the same gradient on the exact mesh",
                v.0
            ),
            NoProof::Degenerate(element) => {
                write!(f, "{element} may be vertical or collinear on the exact mesh")
            }
            NoProof::OutOfMemory => write!(f, "there is not enough memory"),
        }
    }
}

impl std::error::Error for NoProof {}
