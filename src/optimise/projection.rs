//! The way of a mesh to its conditions: Gauss-Newton steps of least length.

use super::Mobility;
use super::cholesky::{Cholesky, NoFactor};
use super::normal::NormalMatrix;
use super::report::{Ending, Stage, Step};
use super::system::{Linearisation, System};
use crate::space::{Point, Vector3};

/// Moves points to where a system of conditions holds, along steps `−Jᵀ (J Jᵀ)⁻¹ r`: of all steps to where
/// the linearised conditions hold they are the shortest.
///
/// `J` and `r` are divided row by row by the lengths of the gradients, so that nothing depends on the
/// unit of length or on how a condition is written. Where conditions depend on each other or
/// contradict each other, a damping grows until a step makes them better.
pub struct Projection<'a> {
    system: &'a System,
    mobility: &'a [Mobility],
    matrix: NormalMatrix,
    factor: Cholesky,
    damping: f64,
    /// Whether `factor` is that of some earlier matrix.
    is_factorised: bool,
}

impl<'a> Projection<'a> {
    /// Analyses how the conditions are coupled.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    pub fn new(
        system: &'a System,
        mobility: &'a [Mobility],
        points: &[Point<f64>],
    ) -> Result<Self, NoFactor> {
        let matrix = NormalMatrix::new(system, mobility.len());
        let factor = matrix.analyse(system, points)?;
        Ok(Projection {
            system,
            mobility,
            matrix,
            factor,
            damping: f64::EPSILON,
            is_factorised: false,
        })
    }

    /// Runs until the distances are those of rounding, or nothing gets better, or `go_on` says no.
    pub fn run(
        &mut self,
        points: &mut Vec<Point<f64>>,
        most_steps: usize,
        stage: Stage,
        mut go_on: impl FnMut(&Step) -> bool,
    ) -> Ending {
        let floor = rounding(points);
        let mut at = self.system.linearise(points, self.mobility);
        let mut last = f64::INFINITY;
        for number in 0.. {
            let worst = self.system.worst(&at.residuals);
            let step = Step { stage, number, energy: None, worst, damping: self.damping };
            if !go_on(&step) {
                return Ending::Stopped;
            }
            if step.distance() <= floor {
                return Ending::Converged;
            }
            if number == most_steps {
                return Ending::TooManySteps;
            }
            let size = norm2(&at.residuals).sqrt();
            let gain = size / last;
            if gain > 0.5 && self.system.is_rounding(points, &at, floor) {
                return Ending::Converged;
            }
            last = size;
            let Some((moved, next)) = self.step(points, &at, gain) else {
                let is_rounding = self.system.is_rounding(points, &at, floor);
                return if is_rounding { Ending::Converged } else { Ending::Stuck };
            };
            (*points, at) = (moved, next);
        }
        Ending::TooManySteps
    }

    /// The next points and their linearisation; `None` if no step makes the conditions better.
    fn step(
        &mut self,
        points: &[Point<f64>],
        at: &Linearisation,
        gain: f64,
    ) -> Option<(Vec<Point<f64>>, Linearisation)> {
        let before = norm2(&at.residuals);
        // After a step that gained much the matrix has changed little, and the last factor may do again.
        if self.is_factorised && gain < SMALL_GAIN {
            let mut y = at.residuals.clone();
            self.factor.solve(&mut y);
            let bound = ENOUGH * ENOUGH * before;
            if let Some(next) = self.shift(points, at, &y, &[1.0], bound) {
                return Some(next);
            }
        }
        loop {
            self.matrix.fill(self.system, at, self.damping);
            let NormalMatrix { starts, rows, values, .. } = &self.matrix;
            self.is_factorised = self.factor.factorise(starts, rows, values).is_ok();
            if self.is_factorised {
                let mut y = at.residuals.clone();
                self.factor.solve(&mut y);
                // A shorter step where the whole one is too long for the linearisation.
                if let Some(next) = self.shift(points, at, &y, &[1.0, 0.5, 0.25, 0.125], before) {
                    return Some(next);
                }
            }
            if self.damping >= 1.0 {
                return None;
            }
            self.damping *= 256.0;
        }
    }

    /// Moves along the first of some parts of `−Jᵀ y` that brings the squares of the distances below a bound.
    fn shift(
        &mut self,
        points: &[Point<f64>],
        at: &Linearisation,
        y: &[f64],
        parts: &[f64],
        bound: f64,
    ) -> Option<(Vec<Point<f64>>, Linearisation)> {
        let shift = self.system.transposed(at, y, points.len());
        for &part in parts {
            let moved = moved(points, &shift, -part);
            let after = norm2(&self.system.residuals(&moved, &at.lengths));
            if after < bound {
                if part == 1.0 {
                    self.damping = (self.damping / 16.0).max(f64::EPSILON);
                }
                let next = self.system.linearise(&moved, self.mobility);
                return Some((moved, next));
            }
        }
        None
    }
}

/// What a step has to leave of the distances for the last factor to be tried again: after others the matrix
/// has changed too much where it is nearly singular.
const SMALL_GAIN: f64 = 1.0 / 4096.0;

/// What a step with the last factor has to leave to be taken: solving is so much cheaper than a new factor.
const ENOUGH: f64 = 1.0 / 8.0;

/// What is left of a distance when coordinates are rounded.
fn rounding(points: &[Point<f64>]) -> f64 {
    let sizes = points.iter().flat_map(|p| p.coordinates().map(|c| c.abs()));
    4.0 * f64::EPSILON * sizes.fold(0.0, f64::max)
}

pub(super) fn norm2(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum()
}

pub(super) fn moved(points: &[Point<f64>], shift: &[Vector3<f64>], factor: f64) -> Vec<Point<f64>> {
    points.iter().zip(shift).map(|(p, s)| p + &s.scaled(&factor)).collect()
}
