//! The way of a mesh to its conditions: Gauss-Newton steps of least length.

use super::Mobility;
use super::cholesky::{Cholesky, NoFactor};
use super::normal::NormalMatrix;
use super::report::{Ending, Step, Worst};
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
}

impl<'a> Projection<'a> {
    /// Analyses how the conditions are coupled.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    pub fn new(system: &'a System, mobility: &'a [Mobility]) -> Result<Self, NoFactor> {
        let matrix = NormalMatrix::new(system, mobility.len());
        let factor = Cholesky::analyse(&matrix.starts, &matrix.rows)?;
        Ok(Projection { system, mobility, matrix, factor, damping: f64::EPSILON })
    }

    /// Runs until the distances are those of rounding, or nothing gets better, or `go_on` says no.
    pub fn run(
        &mut self,
        points: &mut Vec<Point<f64>>,
        most_steps: usize,
        mut go_on: impl FnMut(&Step) -> bool,
    ) -> Ending {
        let floor = rounding(points);
        let mut at = self.system.linearise(points, self.mobility);
        for number in 0.. {
            let worst = self.worst(&at.residuals);
            let distance = worst.iter().map(|w| w.distance).fold(0.0, f64::max);
            let step = Step { number, worst, damping: self.damping };
            if !go_on(&step) {
                return Ending::Stopped;
            }
            if distance <= floor {
                return Ending::Converged;
            }
            if number == most_steps {
                return Ending::TooManySteps;
            }
            match self.step(points, &at) {
                Ok(Some((moved, next))) => (*points, at) = (moved, next),
                Ok(None) => return Ending::Stuck,
                Err(_) => return Ending::Stuck,
            }
        }
        Ending::TooManySteps
    }

    /// The next points and their linearisation; `None` if no step makes the conditions better.
    fn step(
        &mut self,
        points: &[Point<f64>],
        at: &Linearisation,
    ) -> Result<Option<(Vec<Point<f64>>, Linearisation)>, NoFactor> {
        let before = norm2(&at.residuals);
        loop {
            self.matrix.fill(self.system, at, self.damping);
            let NormalMatrix { starts, rows, values, .. } = &self.matrix;
            let factorised = self.factor.factorise(starts, rows, values);
            if factorised.is_ok() {
                let mut y = at.residuals.clone();
                self.factor.solve(&mut y);
                let shift = self.system.transposed(at, &y, points.len());
                // A shorter step where the whole one is too long for the linearisation.
                for part in [1.0, 0.5, 0.25, 0.125] {
                    let moved = moved(points, &shift, -part);
                    let after = norm2(&self.system.residuals(&moved, &at.lengths));
                    if after < before {
                        if part == 1.0 {
                            self.damping = (self.damping / 16.0).max(f64::EPSILON);
                        }
                        let next = self.system.linearise(&moved, self.mobility);
                        return Ok(Some((moved, next)));
                    }
                }
            }
            if self.damping >= 1.0 {
                return Ok(None);
            }
            self.damping *= 256.0;
        }
    }

    /// The worst condition of each kind.
    fn worst(&self, residuals: &[f64]) -> Vec<Worst> {
        let worst = |(kind, rows): (&dyn super::condition::Conditions, std::ops::Range<usize>)| {
            let sizes = residuals[rows].iter().map(|r| r.abs()).enumerate();
            let (condition, distance) =
                sizes.fold((0, 0.0), |worst, next| if next.1 > worst.1 { next } else { worst });
            Worst { name: kind.name(), at: kind.points(condition).to_vec(), distance }
        };
        self.system.kinds().map(worst).collect()
    }
}

/// What is left of a distance when coordinates are rounded.
fn rounding(points: &[Point<f64>]) -> f64 {
    let sizes = points.iter().flat_map(|p| p.coordinates().map(|c| c.abs()));
    4.0 * f64::EPSILON * sizes.fold(0.0, f64::max)
}

fn norm2(values: &[f64]) -> f64 {
    values.iter().map(|v| v * v).sum()
}

fn moved(points: &[Point<f64>], shift: &[Vector3<f64>], factor: f64) -> Vec<Point<f64>> {
    let one = |(p, s): (&Point<f64>, &Vector3<f64>)| {
        Point::new(p.x + factor * s.x, p.y + factor * s.y, p.z + factor * s.z)
    };
    points.iter().zip(shift).map(one).collect()
}
