//! Sizes: a formula evaluated with every sign taken positive.

use super::Ring;
use super::ring::ring_operators;

/// An upper bound of a term in which nothing cancels: `−` counts as `+`.
///
/// Evaluated on absolute values, a residual gives the *scale* that its value is compared with:
/// `|residual| / scale` lies between 0 and 1 and does not change with the unit of any axis.
///
/// ```
/// use isogeo::scalar::{Magnitude, Ring};
/// let m = |x: f64| Magnitude(x);
/// assert_eq!(Magnitude::det2(&m(1.0), &m(2.0), &m(3.0), &m(4.0)), m(10.0)); // 1·4 + 2·3
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Magnitude(pub f64);

#[inline]
fn add(a: &Magnitude, b: &Magnitude) -> Magnitude {
    Magnitude(a.0 + b.0)
}

#[inline]
fn multiply(a: &Magnitude, b: &Magnitude) -> Magnitude {
    Magnitude(a.0 * b.0)
}

ring_operators!([] Magnitude, add, add, multiply, |a: &Magnitude| *a);

impl Ring for Magnitude {
    const EXACT: bool = false;

    fn from_i64(n: i64) -> Self {
        Magnitude(n.unsigned_abs() as f64)
    }
}
