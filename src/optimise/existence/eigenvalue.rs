//! A verified lower bound of the smallest eigenvalue of `A = J̃ J̃ᵀ`.
//!
//! If `A − s I` is computed and a triangular matrix `L` is found such that `|A − s I − L Lᵀ| ≤ d` in the 2-norm,
//! the smallest eigenvalue is at least `s − d`, since that of `L Lᵀ` is not negative. S. M. Rump
//! (Verification of positive definiteness, BIT 46, 2006) bounds `d` beforehand by an analysis of the
//! rounding errors of Cholesky's method; here it is bounded afterwards from `L` itself, so that
//! nothing is assumed of the program that has computed `L`.

use super::NoProof;
use super::bounds::most_repeated;
use super::factor::misfit;
use super::problem::Problem;
use super::rounding::{down, largest, up};
use crate::optimise::cholesky::Cholesky;
use crate::optimise::normal::NormalMatrix;

/// The smallest eigenvalue of the matrix that was factorised last, by inverse iteration: what one would guess;
/// and the row that its eigenvector speaks of most.
pub fn guess(factor: &mut Cholesky, size: usize) -> (f64, usize) {
    // Any vector will do that is not orthogonal to what is looked for; this one is like no eigenvector.
    let mut x: Vec<f64> = (0..size).map(|i| (i as f64).sqrt().fract() - 0.25).collect();
    let mut value = f64::INFINITY;
    loop {
        let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        x.iter_mut().for_each(|x| *x /= length);
        factor.solve(&mut x);
        let next = 1.0 / x.iter().map(|x| x * x).sum::<f64>().sqrt();
        if next < 0.9 * value {
            value = next;
        } else {
            let row = (0..size).max_by(|&i, &j| x[i].abs().total_cmp(&x[j].abs()));
            return (next.min(value), row.unwrap_or(0));
        }
    }
}

/// A number that is certainly not above the smallest eigenvalue, and positive.
pub fn bound(
    problem: &Problem<'_>,
    matrix: &mut NormalMatrix,
    factor: &mut Cholesky,
    (guess, row): (f64, usize),
) -> Result<f64, NoProof> {
    let (products, sizes) = products(problem);
    let mut shift = guess / 2.0;
    let mut rounding = f64::EPSILON * sizes;
    while shift > rounding {
        matrix.fill(&problem.system, &problem.at, -shift);
        let NormalMatrix { starts, rows, values, .. } = &*matrix;
        if factor.factorise(starts, rows, values).is_ok() {
            let found = misfit(matrix, factor, products, up(sizes + shift));
            rounding = found.unwrap_or(f64::INFINITY);
            let bound = down(shift - rounding);
            if bound > 0.0 {
                return Ok(bound);
            }
        }
        shift /= 4.0;
    }
    Err(problem.dependent(row, guess, rounding))
}

/// The largest number of products in an entry of `J̃ J̃ᵀ`, and not below the 2-norm of `|J̃| |J̃|ᵀ`.
fn products(problem: &Problem<'_>) -> (usize, f64) {
    let all = || 0..problem.system.rows();
    let longest = all().map(|row| problem.places(row).len()).max().unwrap_or(0);
    let repeated = all().map(|row| most_repeated(problem.places(row))).max().unwrap_or(0);
    let mut columns = vec![[0.0; 3]; problem.mobility.len()];
    let mut most = 0.0;
    for row in all() {
        let mut sum = 0.0;
        let gradients = &problem.at.gradients[problem.system.range(row)];
        for (v, g) in problem.places(row).iter().zip(gradients) {
            for (column, g) in columns[v.index()].iter_mut().zip([g.x, g.y, g.z]) {
                (*column, sum) = (up(*column + g.abs()), up(sum + g.abs()));
            }
        }
        most = largest([most, sum]);
    }
    (3 * longest * repeated, up(most * largest(columns.into_iter().flatten())))
}
