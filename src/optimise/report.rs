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

/// What a step belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// A compromise with energies.
    Compromise,
    /// The top view alone.
    TopView,
    /// Heights over a given top view.
    Heights,
    /// The last way to the conditions.
    Projection,
}

impl Stage {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Stage::Compromise => "compromise",
            Stage::TopView => "top view",
            Stage::Heights => "heights",
            Stage::Projection => "projection",
        }
    }
}

/// The state before a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it belongs to.
    pub stage: Stage,
    /// Its number in the stage, from 0 for the start.
    pub number: usize,
    /// The energy, in the square of the unit of the mesh, where there is one.
    pub energy: Option<f64>,
    /// The worst condition of each kind.
    pub worst: Vec<Worst>,
    /// How much the system is damped: the part of a unit row that is given away.
    pub damping: f64,
}

impl Step {
    /// The same in a smaller unit of length.
    pub(super) fn times(&self, unit: f64) -> Step {
        let worst = |w: &Worst| Worst { distance: w.distance * unit, ..w.clone() };
        Step {
            energy: self.energy.map(|e| e * unit * unit),
            worst: self.worst.iter().map(worst).collect(),
            ..self.clone()
        }
    }

    /// The largest distance.
    pub fn distance(&self) -> f64 {
        self.worst.iter().map(|w| w.distance).fold(0.0, f64::max)
    }
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

impl Ending {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Ending::Converged => "converged",
            Ending::Stuck => "stuck",
            Ending::TooManySteps => "too many steps",
            Ending::Stopped => "stopped",
        }
    }
}
