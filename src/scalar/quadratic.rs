//! Real quadratic fields: ℚ with one square root, where regular hexagons and octagons have
//! coordinates.

use std::cmp::Ordering;
use std::fmt;

use super::ring::{field_operators, ring_operators};
use super::{Approx, Field, Ordered, Ring, Sign};

/// A number `a + b √D` with `a`, `b` in `T`; `D` is a positive integer and no square.
///
/// ```
/// use isogeo::scalar::{BigRational, Field, Ordered, Quadratic, Ring, Sign};
/// type K = Quadratic<BigRational, 2>;
/// let x = K::from_i64(3) - K::from_i64(2) * K::sqrt_d();   // 3 − 2√2 > 0
/// assert_eq!(x.certain_sign(), Some(Sign::Positive));
/// assert_eq!(x.try_inv(), Some(x.conjugate()));            // its norm is 9 − 8 = 1
/// assert_eq!(x.to_string(), "3 - 2·√2");
/// ```
///
/// A `D` that is a square does not compile:
///
/// ```compile_fail
/// use isogeo::scalar::{BigRational, Quadratic, Ring};
/// let x = Quadratic::<BigRational, 4>::from_i64(1);
/// # let _ = x;
/// ```
///
/// It is a field where `√D` is not in `T` already. This holds for ℚ; it holds for
/// `Quadratic<Quadratic<Q, 2>, 3>`, which is ℚ(√2, √3), but not for `Quadratic<Quadratic<Q, 2>, 8>`.
/// There, and over [`Prime61`](super::Prime61) where `D` is a square modulo `p` (as 2 is; 3 is
/// not), it is a ring in which the elements of norm 0 have no inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Quadratic<T, const D: i64> {
    a: T,
    b: T,
}

impl<T: Ring, const D: i64> Quadratic<T, D> {
    /// `a + b √D`.
    #[inline]
    pub fn new(a: T, b: T) -> Self {
        const { assert!(D > 1 && D.isqrt() * D.isqrt() != D, "D must be positive and no square") };
        Quadratic { a, b }
    }

    /// The number `√D`.
    pub fn sqrt_d() -> Self {
        Self::new(T::zero(), T::one())
    }

    /// The parts `a` and `b` of `a + b √D`.
    #[inline]
    pub fn parts(&self) -> (&T, &T) {
        (&self.a, &self.b)
    }

    /// `a − b √D`: the image under the one automorphism that is not the identity.
    #[inline]
    pub fn conjugate(&self) -> Self {
        Quadratic { a: self.a.clone(), b: -&self.b }
    }

    /// `a² − D b²`, the product with the conjugate; multiplicative, and 0 for 0 alone.
    #[inline]
    pub fn norm(&self) -> T {
        T::det2(&self.a, &self.b, &(T::from_i64(D) * &self.b), &self.a)
    }
}

impl<T: Field, const D: i64> Quadratic<T, D> {
    /// `(cos 2π/n, sin 2π/n)`, where both lie in this field: the rotation of a regular `n`-gon.
    ///
    /// | `n` | field |
    /// | --- | --- |
    /// | 1, 2, 4 | every one (the numbers are 0 and ±1) |
    /// | 8 | ℚ(√2): `D` is twice a square |
    /// | 3, 6, 12 | ℚ(√3): `D` is three times a square |
    ///
    /// The table is complete: cosine and sine together generate the real part of the field of
    /// `m`-th roots of unity, `m = lcm(4, n)`, whose degree `φ(m)/2` is at most 2 for
    /// `m = 4, 8, 12` alone. The angles `π/n` are those of `2n`: so `π/3`, `π/6` and `π/4`, but
    /// neither `π/5` (`cos 2π/5` lies in ℚ(√5), its sine does not) nor `π/8`, nor `π/12`, whose
    /// cosine `(√6 + √2)/4` needs `Quadratic<Quadratic<Q, 2>, 3>`.
    ///
    /// ```
    /// use isogeo::scalar::{BigRational, Quadratic};
    /// let (cos, sin) = Quadratic::<BigRational, 3>::regular_polygon(6).unwrap();
    /// assert_eq!((cos.to_string(), sin.to_string()), ("1/2".into(), "1/2·√3".into()));
    /// assert!(Quadratic::<BigRational, 3>::regular_polygon(8).is_none());
    /// ```
    pub fn regular_polygon(n: u32) -> Option<(Self, Self)> {
        // √(D/k²) as an element, where D = `core` k².
        let root_of = |core: i64| {
            let k = (D / core).isqrt();
            (core * k * k == D).then(|| Self::new(T::zero(), T::from_ratio(1, k)))
        };
        let (zero, one) = (Self::zero(), Self::one());
        let half = Self::from_ratio(1, 2);
        Some(match n {
            1 => (one, zero),
            2 => (-one, zero),
            4 => (zero, one),
            3 => (-&half, root_of(3)? * half),
            6 => (half.clone(), root_of(3)? * half),
            12 => (root_of(3)? * &half, half),
            8 => {
                let diagonal = root_of(2)? * half;
                (diagonal.clone(), diagonal)
            }
            _ => return None,
        })
    }
}

#[inline]
fn add<T: Ring, const D: i64>(x: &Quadratic<T, D>, y: &Quadratic<T, D>) -> Quadratic<T, D> {
    Quadratic { a: &x.a + &y.a, b: &x.b + &y.b }
}

#[inline]
fn subtract<T: Ring, const D: i64>(x: &Quadratic<T, D>, y: &Quadratic<T, D>) -> Quadratic<T, D> {
    Quadratic { a: &x.a - &y.a, b: &x.b - &y.b }
}

#[inline]
fn multiply<T: Ring, const D: i64>(x: &Quadratic<T, D>, y: &Quadratic<T, D>) -> Quadratic<T, D> {
    let a = T::dot([&x.a, &(T::from_i64(D) * &x.b)], [&y.a, &y.b]);
    Quadratic { a, b: T::dot([&x.a, &x.b], [&y.b, &y.a]) }
}

#[inline]
fn negate<T: Ring, const D: i64>(x: &Quadratic<T, D>) -> Quadratic<T, D> {
    Quadratic { a: -&x.a, b: -&x.b }
}

fn divide<T: Field, const D: i64>(x: &Quadratic<T, D>, y: &Quadratic<T, D>) -> Quadratic<T, D> {
    let (product, norm) = (multiply(x, &y.conjugate()), y.norm());
    Quadratic { a: product.a / &norm, b: product.b / &norm }
}

ring_operators!([T: Ring, const D: i64] Quadratic<T, D>, add, subtract, multiply, negate);
field_operators!([T: Field, const D: i64] Quadratic<T, D>, divide);

impl<T: Ring, const D: i64> Ring for Quadratic<T, D> {
    const EXACT: bool = T::EXACT;

    #[inline]
    fn from_i64(n: i64) -> Self {
        Self::new(T::from_i64(n), T::zero())
    }

    fn is_zero(&self) -> bool {
        self.a.is_zero() && self.b.is_zero()
    }
}

impl<T: Field, const D: i64> Field for Quadratic<T, D> {
    /// The conjugate over the norm; `None` where the norm has no inverse.
    fn try_inv(&self) -> Option<Self> {
        let inverse = self.norm().try_inv()?;
        Some(Quadratic { a: &self.a * &inverse, b: -(&self.b * &inverse) })
    }
}

impl<T: Ordered, const D: i64> Ordered for Quadratic<T, D> {
    /// The sign of `a + b √D` with `√D > 0`. Where the two terms disagree, `a²` is compared with
    /// `D b²`: no approximation enters.
    fn certain_sign(&self) -> Option<Sign> {
        let (a, b) = (self.a.certain_sign()?, self.b.certain_sign()?);
        match (a, b) {
            (sign, Sign::Zero) | (Sign::Zero, sign) => Some(sign),
            _ if a == b => Some(a),
            _ => Some(match self.norm().certain_sign()? {
                Sign::Positive => a,
                Sign::Zero => Sign::Zero,
                Sign::Negative => b,
            }),
        }
    }
}

impl<T: Ordered, const D: i64> PartialOrd for Quadratic<T, D> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(match subtract(self, other).certain_sign()? {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        })
    }
}

impl<T: Approx, const D: i64> Approx for Quadratic<T, D> {
    /// Within four units in the last place for `T = ℚ`, cancellation or not: where the two terms
    /// disagree in sign, the norm is divided by the conjugate, in which they agree. Excluded are
    /// parts beyond 10^±150, whose squares leave the range of `f64`.
    fn to_f64(&self) -> f64 {
        let (x, y) = (self.a.to_f64(), self.b.to_f64() * (D as f64).sqrt());
        if x == 0.0 || y == 0.0 || (x > 0.0) == (y > 0.0) {
            x + y
        } else {
            self.norm().to_f64() / (x - y)
        }
    }
}

impl<T: Ordered + fmt::Display, const D: i64> fmt::Display for Quadratic<T, D> {
    /// `a + b·√D` without the terms that are 0.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.b.is_zero() {
            return write!(f, "{}", self.a);
        }
        let negative = self.b.certain_sign() == Some(Sign::Negative);
        if self.a.is_zero() {
            f.write_str(if negative { "-" } else { "" })?;
        } else {
            write!(f, "{} {} ", self.a, if negative { '-' } else { '+' })?;
        }
        let size = self.b.magnitude();
        if size == T::one() {
            return write!(f, "√{D}");
        }
        let factor = size.to_string();
        // A nested factor is a sum itself.
        if factor.contains(' ') {
            write!(f, "({factor})·√{D}")
        } else {
            write!(f, "{factor}·√{D}")
        }
    }
}
