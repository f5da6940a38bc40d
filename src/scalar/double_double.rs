//! Pairs of doubles: some 106 bits, as fast as a dozen operations of the processor.

use super::ball::{Ball, Midpoint};
use super::ring::ring_operators;
use super::{Approx, Ordered, Ring, Sign};

/// The sum `high + low` of two doubles, where `high` is the sum rounded to the nearest double.
///
/// Sums and products are rounded with a relative error of at most `8 u²`, where `u` is half of
/// `f64::EPSILON`, as long as nothing overflows or underflows: Joldes, Muller and Popescu (Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic, ACM TOMS 44, 2017)
/// prove `3 u² / (1 − 4 u)` for the sum and `5 u²` for the product. So `Ball<DoubleDouble>` encloses to
/// some 31 digits.
///
/// ```
/// use isogeo::scalar::DoubleDouble;
/// let x = DoubleDouble::sum(1.0, f64::EPSILON * f64::EPSILON);
/// assert_eq!((x - DoubleDouble::from(1.0)).high(), f64::EPSILON * f64::EPSILON);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The sum of two doubles, exactly if it does not overflow.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        DoubleDouble { high, low: (a - (high - part)) + (b - part) }
    }

    /// The nearest double.
    #[inline]
    pub fn high(&self) -> f64 {
        self.high
    }

    /// The sum of two doubles, exactly, if the first is not the smaller one.
    #[inline]
    fn ordered_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        DoubleDouble { high, low: b - (high - a) }
    }

    /// The product of two doubles, exactly if it neither overflows nor underflows.
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        DoubleDouble { high, low: a.mul_add(b, -high) }
    }

    /// A double that is not below the number.
    pub fn above(&self) -> f64 {
        self.high.next_up()
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(x: f64) -> Self {
        DoubleDouble { high: x, low: 0.0 }
    }
}

/// Algorithm 6 of Joldes, Muller and Popescu.
#[inline]
fn add(a: &DoubleDouble, b: &DoubleDouble) -> DoubleDouble {
    let (s, t) = (DoubleDouble::sum(a.high, b.high), DoubleDouble::sum(a.low, b.low));
    let v = DoubleDouble::ordered_sum(s.high, s.low + t.high);
    DoubleDouble::ordered_sum(v.high, t.low + v.low)
}

#[inline]
fn negate(a: &DoubleDouble) -> DoubleDouble {
    DoubleDouble { high: -a.high, low: -a.low }
}

/// Algorithm 11 of Joldes, Muller and Popescu.
#[inline]
fn multiply(a: &DoubleDouble, b: &DoubleDouble) -> DoubleDouble {
    let c = DoubleDouble::product(a.high, b.high);
    let crossed = a.low.mul_add(b.high, a.high * b.low);
    DoubleDouble::ordered_sum(c.high, c.low + crossed)
}

ring_operators!([] DoubleDouble, add, |a: &DoubleDouble, b: &DoubleDouble| add(a, &negate(b)),
    multiply, negate);

impl Ring for DoubleDouble {
    const EXACT: bool = false;

    #[inline]
    fn from_i64(n: i64) -> Self {
        let high = n as f64;
        DoubleDouble { high, low: (i128::from(n) - high as i128) as f64 }
    }
}

impl Ordered for DoubleDouble {
    #[inline]
    fn certain_sign(&self) -> Option<Sign> {
        self.high.certain_sign()
    }
}

impl Approx for DoubleDouble {
    fn to_f64(&self) -> f64 {
        self.high
    }
}

impl Midpoint for DoubleDouble {
    /// The midpoint was rounded once, the radius in at most 8 operations; the last term covers
    /// underflow.
    #[inline]
    fn outward(radius: DoubleDouble, mid: &DoubleDouble) -> DoubleDouble {
        const ROUNDING: f64 = 2.0 * f64::EPSILON * f64::EPSILON;
        let sum = radius.high.next_up() + mid.high.abs().next_up() * ROUNDING;
        DoubleDouble::from(f64::outward(sum, &0.0))
    }
}

impl Ball<f64> {
    /// The ball about a pair of doubles.
    pub fn of_pair(pair: &DoubleDouble) -> Self {
        Ball { mid: pair.high, radius: f64::outward(pair.low.abs(), &0.0) }
    }
}
