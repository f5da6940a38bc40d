//! Order and approximate value: traits apart from [`Field`](crate::scalar::Field), since primes,
//! jets and symbols have neither.

use super::Ring;

/// The sign of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Zero.
    Zero,
    /// Greater than zero.
    Positive,
}

/// A ring with an order that addition and multiplication respect.
pub trait Ordered: Ring + PartialOrd {
    /// The sign, or `None` where the type cannot tell (NaN, an enclosure of 0).
    fn certain_sign(&self) -> Option<Sign>;

    /// `|self|`.
    fn magnitude(&self) -> Self {
        if self.certain_sign() == Some(Sign::Negative) { -self } else { self.clone() }
    }
}

/// A number with an approximate value for display, for starting values and for scales.
pub trait Approx: Ring {
    /// The nearest `f64`: correctly rounded for integers and rationals, within the error that
    /// the type states for others; infinite beyond the range of `f64`.
    fn to_f64(&self) -> f64;
}
