//! What an optimisation did.

use crate::mesh::VertexId;

/// The condition of one kind that is farthest from holding.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// What the condition asks for.
    pub name: &'static str,
    /// The points that it speaks of.
    pub at: Vec<VertexId>,
    /// How far they are from where it holds, to first order, in the unit of the mesh.
    pub distance: f64,
}

/// The state before a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its number, from 0 for the start.
    pub number: usize,
    /// The worst condition of each kind.
    pub worst: Vec<Worst>,
    /// How much the system is damped: the part of a unit row that is given away.
    pub damping: f64,
}

/// How an optimisation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// All conditions hold up to the rounding of coordinates.
    Converged,
    /// No step makes the conditions better.
    Stuck,
    /// The number of steps that was allowed is used up.
    TooManySteps,
    /// Whoever watches said so.
    Stopped,
}
