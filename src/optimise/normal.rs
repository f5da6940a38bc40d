//! The matrix `J Jᵀ` of a system: what couples two conditions is what their gradients share.

use rayon::prelude::*;

use super::cholesky::{Cholesky, NoFactor};
use super::dissection::dissect;
use super::system::{Linearisation, System};
use crate::space::Point;

/// The lower triangle of `J Jᵀ` by columns.
#[derive(Clone, Debug)]
pub struct NormalMatrix {
    /// Column `i` has the entries `starts[i]..starts[i + 1]`; the first is the diagonal.
    pub starts: Vec<u32>,
    /// The rows of the entries, ascending in each column.
    pub rows: Vec<u32>,
    /// The entries.
    pub values: Vec<f64>,
    /// For each vertex the places of rows that speak of it, with their rows, ascending.
    incident: Vec<(u32, u32)>,
    incident_starts: Vec<u32>,
}

const CHUNK: usize = 256;

/// From how many rows on two orders of elimination are tried.
const LARGE: usize = 50_000;

impl NormalMatrix {
    /// The pattern: two rows meet if they share a point. Linear in the number of pairs that do.
    pub fn new(system: &System, points: usize) -> Self {
        let mut incident_starts = vec![0u32; points + 1];
        system.places().iter().for_each(|v| incident_starts[v.index() + 1] += 1);
        (0..points).for_each(|v| incident_starts[v + 1] += incident_starts[v]);
        let mut next = incident_starts.clone();
        let mut incident = vec![(0, 0); system.places().len()];
        for row in 0..system.rows() {
            for place in system.range(row) {
                let slot = &mut next[system.places()[place].index()];
                incident[*slot as usize] = (row as u32, place as u32);
                *slot += 1;
            }
        }
        let column = |i: usize| {
            let mut rows: Vec<u32> = Vec::new();
            for place in system.range(i) {
                let v = system.places()[place].index();
                let at = &incident[incident_starts[v] as usize..incident_starts[v + 1] as usize];
                rows.extend(at.iter().map(|&(row, _)| row).filter(|&row| row as usize >= i));
            }
            rows.sort_unstable();
            rows.dedup();
            rows
        };
        let columns: Vec<Vec<u32>> =
            (0..system.rows()).into_par_iter().with_min_len(CHUNK).map(column).collect();
        let mut starts = Vec::with_capacity(columns.len() + 1);
        starts.push(0);
        let mut count = 0u32;
        for column in &columns {
            count += column.len() as u32;
            starts.push(count);
        }
        let rows = columns.concat();
        let values = vec![0.0; rows.len()];
        NormalMatrix { starts, rows, values, incident, incident_starts }
    }

    /// Finds an order of elimination and the pattern of the factor: that of least degrees, or, of large
    /// matrices, nested dissection where its factor has fewer entries.
    ///
    /// # Errors
    /// [`NoFactor::OutOfMemory`].
    pub fn analyse(&self, system: &System, points: &[Point<f64>]) -> Result<Cholesky, NoFactor> {
        if system.rows() < LARGE {
            return Cholesky::analyse(&self.starts, &self.rows, None);
        }
        let (dissected, least) = rayon::join(
            || Cholesky::analyse(&self.starts, &self.rows, Some(&dissect(system, points))),
            || Cholesky::analyse(&self.starts, &self.rows, None),
        );
        let (dissected, least) = (dissected?, least?);
        Ok(if dissected.entries() < least.entries() { dissected } else { least })
    }

    /// Computes the entries, with `damping` added to the diagonal. Rows without a gradient become
    /// rows of the unit matrix.
    pub fn fill(&mut self, system: &System, at: &Linearisation, damping: f64) {
        let (starts, rows) = (&self.starts, &self.rows);
        let (incident, incident_starts) = (&self.incident, &self.incident_starts);
        let mut columns: Vec<&mut [f64]> = Vec::with_capacity(system.rows());
        let mut rest = self.values.as_mut_slice();
        for i in 0..system.rows() {
            let (column, more) = rest.split_at_mut((starts[i + 1] - starts[i]) as usize);
            columns.push(column);
            rest = more;
        }
        columns.par_iter_mut().enumerate().with_min_len(CHUNK).for_each(|(i, column)| {
            let rows = &rows[starts[i] as usize..starts[i + 1] as usize];
            column.fill(0.0);
            for place in system.range(i) {
                let own = &at.gradients[place];
                let v = system.places()[place].index();
                let here = &incident[incident_starts[v] as usize..incident_starts[v + 1] as usize];
                let first = here.partition_point(|&(row, _)| (row as usize) < i);
                // Both lists ascend: one walk finds all.
                let mut slot = 0;
                for &(row, other) in &here[first..] {
                    while rows[slot] < row {
                        slot += 1;
                    }
                    let other = &at.gradients[other as usize];
                    column[slot] += own.x * other.x + own.y * other.y + own.z * other.z;
                }
            }
            column[0] += if at.free[i] { damping } else { 1.0 };
        });
    }
}
