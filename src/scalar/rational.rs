//! The rational numbers ℚ, the exact scalars of the program.

use std::fmt::Display;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Signed;

use super::{Approx, Field, Ordered, Ring, Sign};

/// The exact scalar of the program: malachite's `Rational`, or [`BigRational`] where the feature
/// `malachite` is off.
#[cfg(feature = "malachite")]
pub type Rational = malachite::rational::Rational;
/// The exact scalar of the program: [`BigRational`], since the feature `malachite` is off.
#[cfg(not(feature = "malachite"))]
pub type Rational = BigRational;

/// A type that is a field isomorphic to ℚ: ordered, exact, printed as `p/q` or `p`.
pub trait RationalField: Field + Ordered + Approx + Display {
    /// `p / q` in lowest terms; `None` if `q` is 0.
    fn from_fraction(p: BigInt, q: BigInt) -> Option<Self>;

    /// The numerator in lowest terms; it carries the sign.
    fn numerator(&self) -> BigInt;

    /// The positive denominator in lowest terms.
    fn denominator(&self) -> BigInt;

    /// The same number in another rational type.
    fn convert<Q: RationalField>(&self) -> Q {
        Q::from_fraction(self.numerator(), self.denominator()).unwrap_or_else(Q::zero)
    }

    /// The square root that is not negative, if it is rational.
    ///
    /// ```
    /// use isogeo::scalar::{Field, Rational, RationalField};
    /// assert_eq!(Rational::from_ratio(4, 9).root(), Some(Rational::from_ratio(2, 3)));
    /// assert_eq!(Rational::from_ratio(-4, 9).root().or(Rational::from_ratio(2, 1).root()), None);
    /// ```
    fn root(&self) -> Option<Self> {
        let (p, q) = (self.numerator(), self.denominator());
        if p.is_negative() {
            return None;
        }
        let root = Self::from_fraction(p.sqrt(), q.sqrt())?;
        (root.square() == *self).then_some(root)
    }

    /// Numerator and denominator where both fit 64 bits.
    fn small_fraction(&self) -> Option<(i64, i64)>;
}

impl Ring for BigRational {
    const EXACT: bool = true;

    fn from_i64(n: i64) -> Self {
        BigRational::from_integer(n.into())
    }

    fn is_zero(&self) -> bool {
        self.numer().sign() == num_bigint::Sign::NoSign
    }

    /// The square of a fraction in lowest terms is in lowest terms.
    fn square(&self) -> Self {
        BigRational::new_raw(self.numer() * self.numer(), self.denom() * self.denom())
    }

    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        let sum = unreduced_sum([(a, d, false), (b, c, true)]);
        reduced(sum.0, sum.1)
    }

    fn dot<const N: usize>(a: [&Self; N], b: [&Self; N]) -> Self {
        let sum = unreduced_sum(a.into_iter().zip(b).map(|(a, b)| (a, b, false)));
        reduced(sum.0, sum.1)
    }
}

/// `Σ ± aᵢ bᵢ` as a fraction that is not reduced: one common factor is looked for at the end
/// instead of three in every product.
fn unreduced_sum<'a>(
    terms: impl IntoIterator<Item = (&'a BigRational, &'a BigRational, bool)>,
) -> (BigInt, BigInt) {
    let (mut p, mut q) = (BigInt::zero(), BigInt::one());
    for (a, b, negative) in terms {
        let mut num = a.numer() * b.numer();
        if num.is_zero() {
            continue;
        }
        let den = a.denom() * b.denom();
        if negative {
            num = -num;
        }
        if den == q {
            p += num;
        } else {
            p = p * &den + num * &q;
            q *= den;
        }
    }
    (p, q)
}

/// `p / q` in lowest terms. A remainder first makes the sizes equal: the binary gcd of
/// `num-bigint` takes one step for every bit of the difference.
fn reduced(mut p: BigInt, mut q: BigInt) -> BigRational {
    let mut gcd = q.clone();
    let mut rest = p.mod_floor(&q);
    while !rest.is_zero() && gcd.bits() > rest.bits() + 32 {
        let next = gcd.mod_floor(&rest);
        gcd = std::mem::replace(&mut rest, next);
    }
    if !rest.is_zero() {
        gcd = gcd.gcd(&rest);
    }
    if gcd != BigInt::one() {
        p /= &gcd;
        q /= &gcd;
    }
    BigRational::new_raw(p, q)
}

impl Field for BigRational {
    fn try_inv(&self) -> Option<Self> {
        (!Ring::is_zero(self)).then(|| self.recip())
    }
}

impl Ordered for BigRational {
    fn certain_sign(&self) -> Option<Sign> {
        Some(sign_of(self.numer()))
    }
}

impl Approx for BigRational {
    fn to_f64(&self) -> f64 {
        ratio_to_f64(self.numer(), self.denom())
    }
}

impl RationalField for BigRational {
    fn from_fraction(p: BigInt, q: BigInt) -> Option<Self> {
        (!q.is_zero()).then(|| BigRational::new(p, q))
    }

    fn numerator(&self) -> BigInt {
        self.numer().clone()
    }

    fn denominator(&self) -> BigInt {
        self.denom().clone()
    }

    fn small_fraction(&self) -> Option<(i64, i64)> {
        Some((self.numer().try_into().ok()?, self.denom().try_into().ok()?))
    }
}

pub(super) fn sign_of(n: &BigInt) -> Sign {
    match n.sign() {
        num_bigint::Sign::Minus => Sign::Negative,
        num_bigint::Sign::NoSign => Sign::Zero,
        num_bigint::Sign::Plus => Sign::Positive,
    }
}

/// The `f64` nearest to `p / q` (ties to even), for any sizes; overflow gives an infinity.
pub(crate) fn ratio_to_f64(p: &BigInt, q: &BigInt) -> f64 {
    if p.is_zero() {
        return 0.0;
    }
    // A quotient of 65 or 66 bits; its last bit also stands for the remainder.
    let shift = 65 - (p.bits() as i64 - q.bits() as i64);
    let (quotient, rest) = if shift >= 0 {
        (p.abs() << shift as u64).div_rem(q)
    } else {
        p.abs().div_rem(&(q << (-shift) as u64))
    };
    let digits = quotient.to_u64_digits().1;
    let quotient = digits.iter().rev().fold(0u128, |n, d| n << 64 | u128::from(*d))
        | u128::from(!rest.is_zero());
    // The unit of the result is 2^exponent: 53 bits, or the smallest double.
    let bits = i64::from(u128::BITS - quotient.leading_zeros());
    let exponent = (bits - shift - 53).max(-1074);
    let dropped = (exponent + shift).min(70) as u32;
    let (mantissa, tail, half) =
        (quotient >> dropped, quotient & ((1 << dropped) - 1), 1 << (dropped - 1));
    let up = tail > half || (tail == half && mantissa & 1 == 1);
    let value = scale_by_power_of_two((mantissa + u128::from(up)) as f64, exponent);
    if p.is_negative() { -value } else { value }
}

/// `x · 2^e`, in steps that neither overflow nor underflow before the result does.
pub(crate) fn scale_by_power_of_two(mut x: f64, mut e: i64) -> f64 {
    while e != 0 && x != 0.0 && x.is_finite() {
        let step = e.clamp(-1000, 1000);
        // The bits of 2^step.
        x *= f64::from_bits(((1023 + step) as u64) << 52);
        e -= step;
    }
    x
}
