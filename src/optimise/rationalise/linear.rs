//! Exact solutions of sparse linear systems near given numbers.

use std::collections::BTreeMap;

use super::super::cholesky::{Cholesky, NoFactor};
use super::dyadic::{finite, rounded};
use crate::scalar::{Approx, LinearSystem, Rational, Ring};

/// The rows of a homogeneous system, each by its unknowns and their coefficients.
pub(super) type Rows = Vec<Vec<(usize, Rational)>>;

/// The bits of the unknowns that may be chosen, at first and at most. The others may be very sensitive to
/// them, because pivots are chosen for short computations.
const BITS: [i32; 2] = [64, 512];

/// How far the others may come out from where they should, `2^−48`.
const NEAR: i32 = 48;

/// A solution of a homogeneous system near given numbers of size about 1.
///
/// They are moved to the solution that is nearest in the sense of least squares, by steps in doubles
/// against residuals that are exact; then those that may be chosen are kept, and the others solved for.
///
/// # Errors
/// Where the memory does not suffice.
pub(super) fn solution_near(target: &[f64], rows: &Rows) -> Result<Vec<Rational>, NoFactor> {
    let mut projector = Projector::new(target.len(), rows)?;
    let mut system = LinearSystem::new(target.len());
    for row in rows {
        // The unknowns are those of the system.
        let _ = system.push(row.iter().cloned());
    }
    let echelon = system.eliminate();
    let mut near: Vec<Rational> = target.iter().map(|&x| finite(x)).collect();
    let mut bits = BITS[0];
    loop {
        let is_solved = projector.project(&mut near, bits);
        let mut x = vec![Rational::zero(); near.len()];
        echelon.free_unknowns().iter().for_each(|&i| x[i] = near[i].clone());
        let right: Vec<Rational> = residuals(rows, &x).into_iter().map(|r| -r).collect();
        if let Ok(Some(solved)) = echelon.solve(&right) {
            x.iter_mut().zip(&solved).for_each(|(x, solved)| *x += solved);
        }
        let apart = |(x, near): (&Rational, &Rational)| (x - near).to_f64().abs();
        let apart = x.iter().zip(&near).map(apart).fold(0.0, f64::max);
        if apart <= 2f64.powi(-NEAR) || bits >= BITS[1] || !is_solved {
            return Ok(x);
        }
        bits *= 2;
    }
}

fn residuals(rows: &Rows, x: &[Rational]) -> Vec<Rational> {
    let value = |row: &Vec<(usize, Rational)>| {
        row.iter().fold(Rational::zero(), |sum, (i, a)| sum + a * &x[*i])
    };
    rows.iter().map(value).collect()
}

/// The factor of `A Aᵀ` for rows of length 1, in doubles.
struct Projector<'a> {
    exact: &'a Rows,
    rows: Vec<Vec<(usize, f64)>>,
    lengths: Vec<f64>,
    factor: Cholesky,
}

impl<'a> Projector<'a> {
    fn new(unknowns: usize, exact: &'a Rows) -> Result<Self, NoFactor> {
        let mut rows: Vec<Vec<(usize, f64)>> =
            exact.iter().map(|row| row.iter().map(|(i, a)| (*i, a.to_f64())).collect()).collect();
        let mut lengths = Vec::with_capacity(rows.len());
        for row in &mut rows {
            let length = row.iter().map(|(_, a)| a * a).sum::<f64>().sqrt();
            let length = if length > 0.0 { length } else { 1.0 };
            row.iter_mut().for_each(|(_, a)| *a /= length);
            lengths.push(length);
        }
        let mut columns = vec![Vec::new(); unknowns];
        for (r, row) in rows.iter().enumerate() {
            row.iter().for_each(|&(i, a)| columns[i].push((r as u32, a)));
        }
        // The lower triangle by columns. Rows may depend on each other.
        let mut entries: BTreeMap<(u32, u32), f64> =
            (0..rows.len() as u32).map(|r| ((r, r), 64.0 * f64::EPSILON)).collect();
        for column in &columns {
            for (k, &(r, a)) in column.iter().enumerate() {
                for &(s, b) in &column[k..] {
                    *entries.entry((r, s)).or_insert(0.0) += a * b;
                }
            }
        }
        let (mut starts, mut places, mut values) = (vec![0u32], Vec::new(), Vec::new());
        for (&(column, row), &value) in &entries {
            if starts.len() <= column as usize {
                starts.push(places.len() as u32);
            }
            places.push(row);
            values.push(value);
        }
        starts.push(places.len() as u32);
        let mut factor = Cholesky::analyse(&starts, &places, None)?;
        factor.factorise(&starts, &places, &values)?;
        Ok(Projector { exact, rows, lengths, factor })
    }

    /// Moves to the nearest solution, but for residuals of `2^−bits`; `false` where the steps do not come
    /// so far.
    fn project(&mut self, x: &mut [Rational], bits: i32) -> bool {
        let mut last = f64::INFINITY;
        loop {
            let residuals = residuals(self.exact, x);
            let scaled = residuals.iter().zip(&self.lengths).map(|(r, length)| r.to_f64() / length);
            // x ← x − Aᵀ (A Aᵀ)⁻¹ r
            let mut y: Vec<f64> = scaled.collect();
            let size = y.iter().fold(0.0, |size: f64, r| size.max(r.abs()));
            if size <= 2f64.powi(-bits) || size >= last / 2.0 {
                return size <= 2f64.powi(-bits);
            }
            last = size;
            self.factor.solve(&mut y);
            let mut shift = vec![0.0; x.len()];
            for (row, y) in self.rows.iter().zip(y) {
                row.iter().for_each(|&(i, a)| shift[i] += a * y);
            }
            for (x, shift) in x.iter_mut().zip(shift) {
                *x -= &rounded(shift, bits + 8).unwrap_or_else(Rational::zero);
            }
        }
    }
}
