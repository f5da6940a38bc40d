//! The integers ℤ of any size: where fractions have been cleared and fixed width does not suffice.

use num_bigint::BigInt;
use num_traits::Signed;

use super::rational::{ratio_to_f64, sign_of};
use super::{Approx, Ordered, Ring, Sign};

impl Ring for BigInt {
    const EXACT: bool = true;

    fn from_i64(n: i64) -> Self {
        n.into()
    }

    fn is_zero(&self) -> bool {
        self.sign() == num_bigint::Sign::NoSign
    }
}

impl Ordered for BigInt {
    fn certain_sign(&self) -> Option<Sign> {
        Some(sign_of(self))
    }

    fn magnitude(&self) -> Self {
        self.abs()
    }
}

impl Approx for BigInt {
    fn to_f64(&self) -> f64 {
        ratio_to_f64(self, &1.into())
    }
}
