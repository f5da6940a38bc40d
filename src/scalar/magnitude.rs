//! Sizes: a formula evaluated with every sign taken positive.

use super::ring::ring_operators;
use super::{Ordered, Ring};

/// An upper bound of a term in which nothing cancels: `−` counts as `+`.
///
/// Evaluated on absolute values, a residual gives the *scale* that its value is compared with:
/// `|residual| / scale` lies between 0 and 1 and does not change with the unit of any axis.
///
/// ```
/// use isogeo::scalar::{Magnitude, Ring};
/// let m = |x: f64| Magnitude::of(&x);
/// assert_eq!(Magnitude::det2(&m(1.0), &m(-2.0), &m(3.0), &m(4.0)), m(10.0)); // 1·4 + 2·3
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnitude<T>(pub T);

impl<T: Ordered> Magnitude<T> {
    /// The size of a number.
    pub fn of(x: &T) -> Self {
        Magnitude(x.magnitude())
    }
}

#[inline]
fn add<T: Ring>(a: &Magnitude<T>, b: &Magnitude<T>) -> Magnitude<T> {
    Magnitude(&a.0 + &b.0)
}

#[inline]
fn multiply<T: Ring>(a: &Magnitude<T>, b: &Magnitude<T>) -> Magnitude<T> {
    Magnitude(&a.0 * &b.0)
}

ring_operators!([T: Ring] Magnitude<T>, add, add, multiply, |a: &Magnitude<T>| a.clone());

impl<T: Ring> Ring for Magnitude<T> {
    const EXACT: bool = T::EXACT;

    fn from_i64(n: i64) -> Self {
        Magnitude(T::from_i64(n.saturating_abs()))
    }
}
