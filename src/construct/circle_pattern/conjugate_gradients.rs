//! Conjugate gradients with a preconditioner.

use rayon::prelude::*;

use super::multigrid::Multigrid;
use super::sparse::Sparse;

/// An approximate solution and how many steps it took.
pub(super) struct Solution {
    pub x: Vec<f64>,
    pub steps: usize,
}

/// Solves `A x = b` until the residual is smaller than `tolerance` times b.
pub(super) fn solve(
    matrix: &Sparse<f64>,
    multigrid: &Multigrid,
    b: &[f64],
    tolerance: f64,
) -> Solution {
    const MOST: usize = 200;
    let mut x = vec![0.0; b.len()];
    let mut rest = b.to_vec();
    let bound = tolerance * dot(b, b).sqrt();
    let mut direction = multigrid.apply(&rest);
    let mut power = dot(&rest, &direction);
    for steps in 0..MOST {
        if dot(&rest, &rest).sqrt() <= bound {
            return Solution { x, steps };
        }
        let image = matrix.apply(&direction);
        let curvature = dot(&direction, &image);
        if curvature.is_nan() || curvature <= 0.0 {
            return Solution { x, steps };
        }
        let factor = power / curvature;
        add(&mut x, factor, &direction);
        add(&mut rest, -factor, &image);
        let next = multigrid.apply(&rest);
        let new_power = dot(&rest, &next);
        let turn = new_power / power;
        power = new_power;
        let pairs = direction.par_iter_mut().zip(&next).with_min_len(CHUNK);
        pairs.for_each(|(d, n)| *d = n + turn * *d);
    }
    Solution { x, steps: MOST }
}

const CHUNK: usize = 4096;

/// Added up in chunks of one size, so that the result does not depend on the number of threads.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let chunk = |(a, b): (&[f64], &[f64])| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let sums: Vec<f64> = a.par_chunks(CHUNK).zip(b.par_chunks(CHUNK)).map(chunk).collect();
    sums.iter().sum()
}

fn add(x: &mut [f64], factor: f64, y: &[f64]) {
    x.par_iter_mut().zip(y).with_min_len(CHUNK).for_each(|(x, y)| *x += factor * y);
}
