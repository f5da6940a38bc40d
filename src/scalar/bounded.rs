//! Integers of bounded size that know when they have overflown.

use num_bigint::BigInt;

use super::ring::ring_operators;
use super::{Ring, Wide};

/// Integers that stand for themselves until one becomes too large.
///
/// A computation runs over a small type first and over a larger one where
/// [`is_overflown`](Bounded::is_overflown) says so; no bound has to be known beforehand.
pub trait Bounded: Ring + From<i128> {
    /// Whether this, or something that it was made from, did not fit; then it is no integer.
    fn is_overflown(&self) -> bool;

    /// The integer, `None` if it has overflown.
    fn to_big(&self) -> Option<BigInt>;

    /// The integer in another size.
    fn to_wide<const W: usize>(&self) -> Wide<W>;
}

/// An integer of at most 128 bits, or the knowledge that one was larger.
///
/// ```
/// use isogeo::scalar::{Bounded, Narrow};
/// let n = Narrow::from(1 << 100);
/// assert!((&n * &n).is_overflown());
/// assert_eq!((&n - Narrow::from(1)).to_big(), Some(((1i128 << 100) - 1).into()));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Narrow {
    value: i128,
    overflown: bool,
}

impl From<i128> for Narrow {
    #[inline]
    fn from(value: i128) -> Self {
        Narrow { value, overflown: false }
    }
}

#[inline]
fn with(a: &Narrow, b: &Narrow, (value, overflown): (i128, bool)) -> Narrow {
    Narrow { value, overflown: overflown | a.overflown | b.overflown }
}

#[inline]
fn add(a: &Narrow, b: &Narrow) -> Narrow {
    with(a, b, a.value.overflowing_add(b.value))
}

#[inline]
fn subtract(a: &Narrow, b: &Narrow) -> Narrow {
    with(a, b, a.value.overflowing_sub(b.value))
}

#[inline]
fn multiply(a: &Narrow, b: &Narrow) -> Narrow {
    // Two numbers of 64 bits are multiplied at once.
    with(
        a,
        b,
        match (i64::try_from(a.value), i64::try_from(b.value)) {
            (Ok(a), Ok(b)) => (i128::from(a) * i128::from(b), false),
            _ => a.value.overflowing_mul(b.value),
        },
    )
}

#[inline]
fn negate(a: &Narrow) -> Narrow {
    with(a, a, a.value.overflowing_neg())
}

ring_operators!([] Narrow, add, subtract, multiply, negate);

/// What has overflown equals nothing, not even itself.
impl PartialEq for Narrow {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        !(self.overflown | other.overflown) && self.value == other.value
    }
}

impl Ring for Narrow {
    const EXACT: bool = true;

    #[inline]
    fn from_i64(n: i64) -> Self {
        i128::from(n).into()
    }
}

impl Bounded for Narrow {
    fn is_overflown(&self) -> bool {
        self.overflown
    }

    fn to_big(&self) -> Option<BigInt> {
        (!self.overflown).then(|| self.value.into())
    }

    fn to_wide<const W: usize>(&self) -> Wide<W> {
        Wide::from(self.value).or_overflown(self.overflown)
    }
}

/// Never too large.
impl Bounded for BigInt {
    fn is_overflown(&self) -> bool {
        false
    }

    fn to_big(&self) -> Option<BigInt> {
        Some(self.clone())
    }

    fn to_wide<const W: usize>(&self) -> Wide<W> {
        let (sign, words) = self.to_u64_digits();
        Wide::from_words(sign == num_bigint::Sign::Minus, &words)
    }
}
