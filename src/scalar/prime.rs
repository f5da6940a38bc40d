//! The field of `2^61 − 1` elements: exact arithmetic at the price of a few machine instructions.

use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::rational::RationalField;
use super::ring::{field_operators, ring_operators};
use super::{Field, Ring};

/// An integer modulo the Mersenne prime `p = 2^61 − 1`.
///
/// It is the scalar of fast identity tests. A polynomial of degree `d` with coefficients in this
/// field that is *not the zero polynomial* vanishes at a point drawn uniformly from the field, one
/// coordinate independently of the other, with probability at most `d / p` (Schwartz, Zippel); `k`
/// independent points fail together with probability at most `(d/p)^k`.
///
/// The condition is on the polynomial *modulo p*. One with integer coefficients may be non-zero
/// and yet zero modulo `p`, where `p` divides all its coefficients; then every test passes. This
/// is impossible where one coefficient is not 0 and smaller than `p` in size. Without such a bound
/// a test in this field is evidence only. A test that fails, on the other hand, always refutes.
///
/// There is no order, and `a / 0` panics as it does for integers; see
/// [`try_inv`](Field::try_inv).
///
/// ```
/// use isogeo::scalar::{BigRational, Field, Prime61};
/// let half = Prime61::from_ratio(1, 2);
/// assert_eq!(half.residue(), 1 << 60);
/// assert_eq!(Prime61::reduce(&BigRational::from_ratio(3, 6)), Some(half));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Prime61(u64);

const P: u64 = Prime61::MODULUS;

impl Prime61 {
    /// The prime `2^61 − 1`.
    pub const MODULUS: u64 = (1 << 61) - 1;

    /// The class of an unsigned integer.
    #[inline]
    pub const fn from_u64(n: u64) -> Self {
        // n = low + 2^61 high, and 2^61 = 1.
        Prime61(once((n & P) + (n >> 61)))
    }

    /// The class of an integer of any size.
    pub fn from_big(n: &BigInt) -> Self {
        n.mod_floor(&P.into()).to_u64().map_or(Prime61(0), Prime61::from_u64)
    }

    /// The class of a fraction; `None` where `p` divides its denominator.
    pub fn reduce<Q: RationalField>(q: &Q) -> Option<Self> {
        if let Some((n, d)) = q.small_fraction() {
            return Self::from_i64(n).try_div(&Self::from_i64(d));
        }
        Self::from_big(&q.numerator()).try_div(&Self::from_big(&q.denominator()))
    }

    /// The representative in `0..p`.
    #[inline]
    pub const fn residue(self) -> u64 {
        self.0
    }

    /// `self^exponent`; `0^0 = 1`.
    pub fn power(self, mut exponent: u64) -> Self {
        let (mut square, mut power) = (self, Prime61(1));
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = multiply(&power, &square);
            }
            square = multiply(&square, &square);
            exponent >>= 1;
        }
        power
    }

    /// `self^(2^k)`.
    #[inline]
    fn squared_times(self, k: u32) -> Self {
        (0..k).fold(self, |x, _| multiply(&x, &x))
    }
}

/// Subtracts `p` where a number below `2p` reaches it.
#[inline]
const fn once(n: u64) -> u64 {
    if n >= P { n - P } else { n }
}

/// Any 128 bits modulo `p`: digits to base `2^61` are added.
#[inline]
const fn fold(n: u128) -> Prime61 {
    let low = n as u64 & P;
    let middle = (n >> 61) as u64 & P;
    let high = (n >> 122) as u64;
    Prime61::from_u64(low + middle + high)
}

#[inline]
fn add(a: &Prime61, b: &Prime61) -> Prime61 {
    Prime61(once(a.0 + b.0))
}

#[inline]
fn subtract(a: &Prime61, b: &Prime61) -> Prime61 {
    Prime61(once(a.0 + (P - b.0)))
}

#[inline]
fn multiply(a: &Prime61, b: &Prime61) -> Prime61 {
    let n = a.0 as u128 * b.0 as u128;
    Prime61(once((n as u64 & P) + (n >> 61) as u64))
}

#[inline]
fn negate(a: &Prime61) -> Prime61 {
    Prime61(once(P - a.0))
}

fn divide(a: &Prime61, b: &Prime61) -> Prime61 {
    match a.try_div(b) {
        Some(quotient) => quotient,
        // The contract of the operator `/`, as for integers and exact rationals.
        None => panic!("division by zero modulo 2^61 - 1"),
    }
}

ring_operators!([] Prime61, add, subtract, multiply, negate);
field_operators!([] Prime61, divide);

impl Ring for Prime61 {
    const EXACT: bool = true;

    #[inline]
    fn from_i64(n: i64) -> Self {
        let size = Prime61::from_u64(n.unsigned_abs());
        if n < 0 { negate(&size) } else { size }
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.0 == 0
    }

    #[inline]
    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        fold(a.0 as u128 * d.0 as u128 + (P - b.0) as u128 * c.0 as u128)
    }

    /// One reduction for up to 32 products, of less than 2^122 each.
    #[inline]
    fn dot<const N: usize>(a: [&Self; N], b: [&Self; N]) -> Self {
        let mut sum = 0;
        for i in 0..N {
            sum += a[i].0 as u128 * b[i].0 as u128;
            if i % 32 == 31 {
                sum = fold(sum).0.into();
            }
        }
        fold(sum)
    }
}

impl Field for Prime61 {
    /// Fermat: `x^(p−2)`, where `p − 2 = 4 (2^59 − 1) + 1`.
    fn try_inv(&self) -> Option<Self> {
        if self.0 == 0 {
            return None;
        }
        // x_k stands for x^(2^k − 1); x_(j+k) = x_j^(2^k) · x_k.
        let join = |high: Prime61, k, low: Prime61| high.squared_times(k) * low;
        let x1 = *self;
        let x3 = join(join(x1, 1, x1), 1, x1);
        let x7 = join(join(x3, 3, x3), 1, x1);
        let x14 = join(x7, 7, x7);
        let x29 = join(join(x14, 14, x14), 1, x1);
        let x59 = join(join(x29, 29, x29), 1, x1);
        Some(join(x59, 2, x1))
    }
}

impl fmt::Debug for Prime61 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} mod 2^61-1", self.0)
    }
}

impl fmt::Display for Prime61 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
