//! Fractions that are not reduced: a field in which no common factor is looked for.

use num_bigint::BigInt;

use super::rational::ratio_to_f64;
use super::ring::{field_operators, ring_operators};
use super::{Approx, Field, Ordered, RationalField, Ring, Sign};

/// `numerator / denominator` over an integral domain, with a denominator that is not zero.
///
/// Only what costs nothing is cancelled: equal denominators in a sum, equal terms in a product. So
/// the numbers grow, but a formula of a few steps over integers of a few words is done long before
/// one greatest common divisor is; [`reduced`](Fraction::reduced) looks for it once, at the end.
///
/// ```
/// use isogeo::scalar::{BigInt, Fraction, Rational, Ring, Field};
/// let half = Fraction::new(BigInt::from(3), BigInt::from(6));
/// assert_eq!(half, Fraction::from_ratio(1, 2)); // compared crosswise
/// assert_eq!((&half + &half).reduced::<Rational>(), Some(Rational::one()));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Fraction<R> {
    /// The numerator.
    pub numerator: R,
    /// The denominator; of either sign, not zero.
    pub denominator: R,
}

impl<R> Fraction<R> {
    /// The fraction; a denominator 0 is a mistake of the caller.
    pub const fn new(numerator: R, denominator: R) -> Self {
        Fraction { numerator, denominator }
    }
}

impl<R: Ring> Fraction<R> {
    /// The fraction `n / 1`.
    pub fn whole(n: R) -> Self {
        Fraction::new(n, R::one())
    }
}

impl Fraction<BigInt> {
    /// The number in lowest terms; `None` for a denominator 0.
    pub fn reduced<Q: RationalField>(&self) -> Option<Q> {
        let twos = |n: &BigInt| n.trailing_zeros().unwrap_or(u64::MAX);
        let common = twos(&self.numerator).min(twos(&self.denominator));
        if self.numerator.is_zero() || common == 0 {
            return Q::from_fraction(self.numerator.clone(), self.denominator.clone());
        }
        Q::from_fraction(&self.numerator >> common, &self.denominator >> common)
    }
}

#[inline]
fn sum<R: Ring>(a: &Fraction<R>, b: &Fraction<R>, join: impl Fn(&R, &R) -> R) -> Fraction<R> {
    if a.denominator == b.denominator {
        return Fraction::new(join(&a.numerator, &b.numerator), a.denominator.clone());
    }
    let left = &a.numerator * &b.denominator;
    let right = &b.numerator * &a.denominator;
    Fraction::new(join(&left, &right), &a.denominator * &b.denominator)
}

fn add<R: Ring>(a: &Fraction<R>, b: &Fraction<R>) -> Fraction<R> {
    sum(a, b, |x, y| x + y)
}

fn subtract<R: Ring>(a: &Fraction<R>, b: &Fraction<R>) -> Fraction<R> {
    sum(a, b, |x, y| x - y)
}

#[inline]
fn product<R: Ring>(a: [&R; 2], b: [&R; 2]) -> Fraction<R> {
    if a[0] == b[1] {
        Fraction::new(b[0].clone(), a[1].clone())
    } else if a[1] == b[0] {
        Fraction::new(a[0].clone(), b[1].clone())
    } else {
        Fraction::new(a[0] * b[0], a[1] * b[1])
    }
}

fn multiply<R: Ring>(a: &Fraction<R>, b: &Fraction<R>) -> Fraction<R> {
    product([&a.numerator, &a.denominator], [&b.numerator, &b.denominator])
}

/// The quotient by zero has a denominator 0: it equals nothing and `reduced` refuses it.
fn divide<R: Ring>(a: &Fraction<R>, b: &Fraction<R>) -> Fraction<R> {
    product([&a.numerator, &a.denominator], [&b.denominator, &b.numerator])
}

fn negate<R: Ring>(a: &Fraction<R>) -> Fraction<R> {
    Fraction::new(-&a.numerator, a.denominator.clone())
}

ring_operators!([R: Ring] Fraction<R>, add, subtract, multiply, negate);
field_operators!([R: Ring] Fraction<R>, divide);

/// Compared crosswise; a denominator 0 equals nothing.
impl<R: Ring> PartialEq for Fraction<R> {
    fn eq(&self, other: &Self) -> bool {
        let defined = !self.denominator.is_zero() && !other.denominator.is_zero();
        defined && (self - other).numerator.is_zero()
    }
}

impl<R: Ordered> PartialOrd for Fraction<R> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(match (self - other).certain_sign()? {
            Sign::Negative => std::cmp::Ordering::Less,
            Sign::Zero => std::cmp::Ordering::Equal,
            Sign::Positive => std::cmp::Ordering::Greater,
        })
    }
}

impl<R: Ring> Ring for Fraction<R> {
    const EXACT: bool = R::EXACT;

    fn from_i64(n: i64) -> Self {
        Fraction::whole(R::from_i64(n))
    }

    fn is_zero(&self) -> bool {
        self.numerator.is_zero() && !self.denominator.is_zero()
    }
}

impl<R: Ring> Field for Fraction<R> {
    fn try_inv(&self) -> Option<Self> {
        let inverse = Fraction::new(self.denominator.clone(), self.numerator.clone());
        (!self.numerator.is_zero()).then_some(inverse)
    }

    fn from_ratio(p: i64, q: i64) -> Self {
        Fraction::new(R::from_i64(p), R::from_i64(q))
    }
}

impl<R: Ordered> Ordered for Fraction<R> {
    fn certain_sign(&self) -> Option<Sign> {
        match (self.numerator.certain_sign()?, self.denominator.certain_sign()?) {
            (_, Sign::Zero) => None,
            (Sign::Zero, _) => Some(Sign::Zero),
            (a, b) if a == b => Some(Sign::Positive),
            _ => Some(Sign::Negative),
        }
    }
}

impl Approx for Fraction<BigInt> {
    /// Correctly rounded.
    fn to_f64(&self) -> f64 {
        if self.denominator.sign() == num_bigint::Sign::Minus {
            ratio_to_f64(&-&self.numerator, &-&self.denominator)
        } else {
            ratio_to_f64(&self.numerator, &self.denominator)
        }
    }
}
