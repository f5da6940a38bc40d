//! Enclosures: a midpoint and a radius, rigorous in `f64` and in exact arithmetic alike.

use num_bigint::BigInt;

use super::rational::RationalField;
use super::ring::ring_operators;
use super::{Ordered, Ring, Sign};

/// The set of all numbers within `radius` of `mid`.
///
/// Every operation returns a ball that contains the result for all numbers of its operands; in
/// `f64` the radius also takes up the rounding of the midpoint. A NaN or infinite radius stands
/// for "anything".
///
/// `==` compares midpoints and radii; whether two unknown numbers are equal is asked by
/// [`certain_sign`](Ordered::certain_sign) of the difference. So `a == b` does not imply that
/// `partial_cmp` answers `Equal`: it does so only where both balls are single numbers.
///
/// ```
/// use isogeo::scalar::{Ball, Sign, Ordered};
/// let x = Ball::new(2.0, 0.5);
/// let y = Ball::new(3.0, 0.25);
/// assert_eq!((&y - &x).certain_sign(), Some(Sign::Positive)); // 1 ± 0.75
/// assert_eq!((&y - &x - Ball::new(1.0, 0.0)).certain_sign(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<T> {
    /// The midpoint.
    pub mid: T,
    /// The radius, not negative.
    pub radius: T,
}

/// The numbers that midpoints and radii can be.
pub trait Midpoint: Ordered {
    /// `radius` enlarged by all roundings that may have entered it and `mid` in one operation.
    fn outward(radius: Self, mid: &Self) -> Self;
}

impl Midpoint for f64 {
    /// The midpoint was rounded once (half an ulp), the radius in at most 8 operations; the last
    /// term covers underflow.
    #[inline]
    fn outward(radius: f64, mid: &f64) -> f64 {
        const HALF_ULP: f64 = f64::EPSILON / 2.0;
        (radius + mid.abs() * HALF_ULP) * (1.0 + 8.0 * f64::EPSILON) + f64::MIN_POSITIVE
    }
}

impl Midpoint for BigInt {
    fn outward(radius: BigInt, _: &BigInt) -> BigInt {
        radius
    }
}

impl<Q: RationalField> Midpoint for Q {
    fn outward(radius: Q, _: &Q) -> Q {
        radius
    }
}

impl<Q: RationalField> Ball<Q> {
    /// The square root that is not negative: the number itself where it is rational, else half a
    /// unit about the middle of the two multiples of `2^−bits` next to it, from integer square roots.
    /// A negative number has none.
    ///
    /// ```
    /// use isogeo::scalar::{Ball, Field, Rational, Ring};
    /// let root = Ball::root(&Rational::from_i64(2), 3);
    /// assert_eq!(root, Some(Ball::new(Rational::from_ratio(23, 16), Rational::from_ratio(1, 16))));
    /// ```
    pub fn root(number: &Q, bits: u32) -> Option<Self> {
        if let Some(root) = number.root() {
            return Some(Ball { mid: root, radius: Q::zero() });
        }
        if number.certain_sign() == Some(Sign::Negative) {
            return None;
        }
        let below = ((number.numerator() << (2 * u64::from(bits))) / number.denominator()).sqrt();
        let parts = BigInt::one() << (u64::from(bits) + 1);
        Some(Ball {
            mid: Q::from_fraction((below << 1) + BigInt::one(), parts.clone())?,
            radius: Q::from_fraction(BigInt::one(), parts)?,
        })
    }
}

impl<T: Midpoint> Ball<T> {
    /// The ball about `mid`; a negative radius is a mistake of the caller.
    #[inline]
    pub fn new(mid: T, radius: T) -> Self {
        debug_assert!(radius.certain_sign() != Some(Sign::Negative), "negative radius {radius:?}");
        Ball { mid, radius }
    }

    /// An upper bound of `|x|` over the ball.
    #[inline]
    pub fn bound(&self) -> T {
        let bound = self.mid.magnitude() + &self.radius;
        T::outward(T::zero(), &bound) + bound
    }

    /// Whether 0 lies outside.
    #[inline]
    pub fn excludes_zero(&self) -> bool {
        self.mid.magnitude() > self.radius
    }
}

impl Ball<f64> {
    /// A ball about a rational number.
    pub fn around<Q: RationalField>(q: &Q) -> Self {
        let mid = q.to_f64();
        // `to_f64` rounds once.
        let radius = if q.is_zero() { 0.0 } else { f64::outward(0.0, &mid) };
        Ball { mid, radius }
    }

    /// The square roots; a ball that reaches below 0 is cut there, one that lies below has none.
    /// "Anything" (a NaN or infinite ball) has any root.
    pub fn sqrt(&self) -> Option<Self> {
        let (low, high) = (self.mid - self.radius, self.mid + self.radius);
        if high < 0.0 {
            return None;
        }
        if !low.is_finite() || !high.is_finite() {
            return Some(Ball { mid: 0.0, radius: f64::INFINITY });
        }
        let (low, high) = (low.next_down().max(0.0).sqrt(), high.next_up().sqrt());
        let mid = 0.5 * (low + high);
        Some(Ball { mid, radius: f64::outward(0.5 * (high - low), &(2.0 * high)) })
    }
}

#[inline]
fn add<T: Midpoint>(a: &Ball<T>, b: &Ball<T>) -> Ball<T> {
    let mid = &a.mid + &b.mid;
    let radius = T::outward(&a.radius + &b.radius, &mid);
    Ball { mid, radius }
}

#[inline]
fn subtract<T: Midpoint>(a: &Ball<T>, b: &Ball<T>) -> Ball<T> {
    let mid = &a.mid - &b.mid;
    let radius = T::outward(&a.radius + &b.radius, &mid);
    Ball { mid, radius }
}

#[inline]
fn multiply<T: Midpoint>(a: &Ball<T>, b: &Ball<T>) -> Ball<T> {
    let mid = &a.mid * &b.mid;
    let spread = (a.mid.magnitude() + &a.radius) * &b.radius + b.mid.magnitude() * &a.radius;
    let radius = T::outward(spread, &mid);
    Ball { mid, radius }
}

#[inline]
fn negate<T: Midpoint>(a: &Ball<T>) -> Ball<T> {
    Ball { mid: -&a.mid, radius: a.radius.clone() }
}

ring_operators!([T: Midpoint] Ball<T>, add, subtract, multiply, negate);

impl<T: Midpoint> Ring for Ball<T> {
    const EXACT: bool = false;

    fn from_i64(n: i64) -> Self {
        let mid = T::from_i64(n);
        // Integers of 53 bits are exact in `f64` too, so 0 and 1 are what a ring asks of them.
        let exact = n.unsigned_abs() <= 1 << 53;
        let radius = if exact { T::zero() } else { T::outward(T::zero(), &mid) };
        Ball { mid, radius }
    }

    /// Whether the ball is the single number 0; an enclosure of 0 is not.
    fn is_zero(&self) -> bool {
        self.mid.is_zero() && self.radius.is_zero()
    }
}

impl<T: Midpoint> PartialOrd for Ball<T> {
    /// The order where all numbers of one ball are below all of the other, else `None`.
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        if self.radius.is_zero() && other.radius.is_zero() {
            return self.mid.partial_cmp(&other.mid);
        }
        match (self - other).certain_sign()? {
            Sign::Negative => Some(std::cmp::Ordering::Less),
            Sign::Zero => Some(std::cmp::Ordering::Equal),
            Sign::Positive => Some(std::cmp::Ordering::Greater),
        }
    }
}

impl<T: Midpoint> Ordered for Ball<T> {
    /// All `|x|`: they are within the same radius of `|mid|`, also where the ball contains 0.
    fn magnitude(&self) -> Self {
        Ball { mid: self.mid.magnitude(), radius: self.radius.clone() }
    }

    fn certain_sign(&self) -> Option<Sign> {
        if self.is_zero() {
            Some(Sign::Zero)
        } else if self.excludes_zero() {
            self.mid.certain_sign()
        } else {
            None
        }
    }
}
