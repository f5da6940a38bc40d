//! Bounds in doubles: each is rounded away from what it bounds. What is not a number stays so.

use crate::scalar::Midpoint;

/// Half a unit in the last place of 1: the relative error of one operation.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Not below the number that at most 8 operations on numbers that are not negative have rounded to `x`.
pub fn up(x: f64) -> f64 {
    f64::outward(x, &0.0)
}

/// Not above it.
pub fn down(x: f64) -> f64 {
    x - 2.0 * (up(x.abs()) - x.abs())
}

/// Not below `√(Σ x²)` for bounds `x`.
pub fn length(bounds: impl IntoIterator<Item = f64>) -> f64 {
    up(bounds.into_iter().fold(0.0, |sum, x| up(sum + x * x)).sqrt())
}

/// The largest of some bounds.
pub fn largest(bounds: impl IntoIterator<Item = f64>) -> f64 {
    // A comparison with what is not a number is false, so that it is kept.
    bounds.into_iter().fold(0.0, |most, x| if x <= most { most } else { x + 0.0 * most })
}

/// `γₙ = n u / (1 − n u)`: a sum of products in doubles, in which each product takes part in at most
/// `n` operations, is wrong by at most `γₙ` times the sum of the sizes, whatever the order of summation
/// and whether or not products are fused with sums (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2002,
/// Sec. 3.1).
pub fn gamma(n: usize) -> f64 {
    let part = up(n as f64 * UNIT);
    if part < 1.0 { up(part / down(1.0 - part)) } else { f64::INFINITY }
}
