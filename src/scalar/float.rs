//! `f64`: fast, and never more than an observation.

use super::{Approx, Field, Ordered, Ring, Sign};

impl Ring for f64 {
    const EXACT: bool = false;

    #[inline]
    fn from_i64(n: i64) -> f64 {
        n as f64
    }
}

impl Field for f64 {
    fn try_inv(&self) -> Option<f64> {
        (*self != 0.0).then(|| 1.0 / self)
    }

    fn try_div(&self, other: &f64) -> Option<f64> {
        (*other != 0.0).then(|| self / other)
    }
}

impl Ordered for f64 {
    fn certain_sign(&self) -> Option<Sign> {
        if *self > 0.0 {
            Some(Sign::Positive)
        } else if *self < 0.0 {
            Some(Sign::Negative)
        } else if *self == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }

    #[inline]
    fn magnitude(&self) -> f64 {
        self.abs()
    }
}

impl Approx for f64 {
    fn to_f64(&self) -> f64 {
        *self
    }
}
