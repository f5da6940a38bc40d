//! A compromise between conditions and energies, in which the conditions count more and more.

use rayon::prelude::*;

use super::Mobility;
use super::cholesky::{Cholesky, NoFactor};
use super::projection::{moved, norm2};
use super::report::{Stage, Step};
use super::system::{Linearisation, System};
use crate::space::{Point, Vector3};

/// Minimises `h |c|² + |e|²` with the distances `c` to conditions that shall hold and the residuals `e` of
/// energies, by the method of Levenberg and Marquardt.
pub struct Compromise<'a> {
    hard: &'a System,
    soft: &'a System,
    mobility: &'a [Mobility],
    matrix: BlockMatrix,
    factor: Cholesky,
    damping: f64,
}

impl<'a> Compromise<'a> {
    /// Analyses which points meet in a condition or in an energy.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    pub fn new(
        hard: &'a System,
        soft: &'a System,
        mobility: &'a [Mobility],
    ) -> Result<Self, NoFactor> {
        let matrix = BlockMatrix::new([hard, soft], mobility.len());
        let factor = Cholesky::analyse(&matrix.starts, &matrix.rows, None)?;
        Ok(Compromise { hard, soft, mobility, matrix, factor, damping: f64::EPSILON })
    }

    /// The distances and the energy at some points.
    pub fn state(&self, points: &[Point<f64>], number: usize) -> Step {
        let at =
            [self.hard, self.soft].map(|system| system.linearise(points, self.mobility).residuals);
        let worst = self.hard.worst(&at[0]);
        let energy = Some(norm2(&at[1]));
        Step { stage: Stage::Compromise, number, energy, worst, damping: self.damping }
    }

    /// One step with conditions of the hardness `h`; whether it made the compromise better.
    pub fn step(&mut self, points: &mut Vec<Point<f64>>, hardness: f64) -> bool {
        let at = [self.hard, self.soft].map(|system| system.linearise(points, self.mobility));
        let weights = [hardness, 1.0];
        let cost = |residuals: [&[f64]; 2]| -> f64 {
            residuals.iter().zip(weights).map(|(r, weight)| weight * norm2(r)).sum()
        };
        let before = cost([&at[0].residuals, &at[1].residuals]);
        let mut slope = vec![0.0; 3 * points.len()];
        for ((system, at), weight) in [self.hard, self.soft].iter().zip(&at).zip(weights) {
            let part = system.transposed(at, &at.residuals, points.len());
            for (sum, part) in slope.chunks_exact_mut(3).zip(part) {
                sum[0] += weight * part.x;
                sum[1] += weight * part.y;
                sum[2] += weight * part.z;
            }
        }
        loop {
            self.matrix.fill([self.hard, self.soft], &at, weights, self.mobility, self.damping);
            let BlockMatrix { starts, rows, values, .. } = &self.matrix;
            if self.factor.factorise(starts, rows, values).is_ok() {
                let mut shift = slope.clone();
                self.factor.solve(&mut shift);
                let shift: Vec<Vector3<f64>> =
                    shift.chunks_exact(3).map(|s| Vector3::new(s[0], s[1], s[2])).collect();
                let next = moved(points, &shift, -1.0);
                let residuals = [(self.hard, &at[0]), (self.soft, &at[1])]
                    .map(|(s, at)| s.residuals(&next, &at.lengths));
                if cost([&residuals[0], &residuals[1]]) < before {
                    *points = next;
                    self.damping = (self.damping / 16.0).max(f64::EPSILON);
                    return true;
                }
            }
            if self.damping >= 1.0 {
                return false;
            }
            self.damping *= 256.0;
        }
    }
}

/// The lower triangle of `Σ w JᵀJ` by columns, three for each point.
struct BlockMatrix {
    starts: Vec<u32>,
    rows: Vec<u32>,
    values: Vec<f64>,
    /// For each system and point the rows that speak of it and where.
    incident: [Vec<Vec<(u32, u32)>>; 2],
    /// For each point the points of its block column, ascending, itself first.
    columns: Vec<Vec<u32>>,
}

impl BlockMatrix {
    fn new(systems: [&System; 2], points: usize) -> Self {
        let incident = systems.map(|system| {
            let mut incident = vec![Vec::new(); points];
            for row in 0..system.rows() {
                for place in system.range(row) {
                    incident[system.places()[place].index()].push((row as u32, place as u32));
                }
            }
            incident
        });
        let column = |v: usize| {
            let mut column = vec![v as u32];
            for (system, incident) in systems.iter().zip(&incident) {
                for &(row, _) in &incident[v] {
                    let others = system.range(row as usize).map(|i| system.places()[i].0);
                    column.extend(others.filter(|&u| u as usize > v));
                }
            }
            column.sort_unstable();
            column.dedup();
            column
        };
        let columns: Vec<Vec<u32>> = (0..points).into_par_iter().map(column).collect();
        let (mut starts, mut rows) = (vec![0], Vec::new());
        for column in &columns {
            for axis in 0..3 {
                // Of its own block a column has the part from the diagonal on.
                let all = column.iter().flat_map(|&u| [3 * u, 3 * u + 1, 3 * u + 2]);
                rows.extend(all.skip(axis));
                starts.push(rows.len() as u32);
            }
        }
        let values = vec![0.0; rows.len()];
        BlockMatrix { starts, rows, values, incident, columns }
    }

    fn fill(
        &mut self,
        systems: [&System; 2],
        at: &[Linearisation; 2],
        weights: [f64; 2],
        mobility: &[Mobility],
        damping: f64,
    ) {
        let (columns, incident, starts) = (&self.columns, &self.incident, &self.starts);
        let mut parts = Vec::with_capacity(columns.len());
        let mut rest = self.values.as_mut_slice();
        for v in 0..columns.len() {
            let (part, more) = rest.split_at_mut((starts[3 * v + 3] - starts[3 * v]) as usize);
            parts.push(part);
            rest = more;
        }
        parts.par_iter_mut().enumerate().for_each(|(v, part)| {
            part.fill(0.0);
            let height = 3 * columns[v].len();
            for s in 0..2 {
                for &(row, place) in &incident[s][v] {
                    let g = &at[s].gradients[place as usize];
                    let own = [weights[s] * g.x, weights[s] * g.y, weights[s] * g.z];
                    for i in systems[s].range(row as usize) {
                        let u = systems[s].places()[i].0;
                        if (u as usize) < v {
                            continue;
                        }
                        let Ok(block) = columns[v].binary_search(&u) else { continue };
                        let other = &at[s].gradients[i];
                        let other = [other.x, other.y, other.z];
                        let mut start = 0;
                        for (axis, own) in own.iter().enumerate() {
                            for (c, other) in other.iter().enumerate() {
                                if let Some(slot) = (3 * block + c).checked_sub(axis) {
                                    part[start + slot] += own * other;
                                }
                            }
                            start += height - axis;
                        }
                    }
                }
            }
            let mut start = 0;
            for axis in 0..3 {
                part[start] += damping * part[start];
                if part[start] <= 0.0 {
                    part[start] = 1.0;
                }
                // In directions that are not allowed there is no gradient: the unit matrix keeps them.
                let kept = mobility[v].kept(axis);
                let kept = [kept.x, kept.y, kept.z];
                for (slot, kept) in part[start..].iter_mut().zip(&kept[axis..]) {
                    *slot += kept;
                }
                start += height - axis;
            }
        });
    }
}
