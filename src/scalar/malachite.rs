//! malachite's `Rational`: about as fast as GMP without C, licence LGPL-3.0-only (feature `malachite`).

use malachite::base::num::arithmetic::traits::{Reciprocal, Sign as _, UnsignedAbs};
use malachite::base::num::basic::traits::{One as _, Zero as _};
use malachite::rational::Rational;
use malachite::{Integer, Natural};
use num_bigint::{BigInt, BigUint};

use super::rational::ratio_to_f64;
use super::{Approx, Field, Ordered, RationalField, Ring, Sign};

impl Ring for Rational {
    const EXACT: bool = true;

    fn from_i64(n: i64) -> Self {
        Rational::from(n)
    }

    fn is_zero(&self) -> bool {
        *self == 0u32
    }

    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        fused_sum([(a, d, false), (b, c, true)])
    }

    fn dot<const N: usize>(a: [&Self; N], b: [&Self; N]) -> Self {
        fused_sum(a.into_iter().zip(b).map(|(a, b)| (a, b, false)))
    }
}

/// `Σ ± aᵢ bᵢ` with one reduction at the end.
fn fused_sum<'a>(terms: impl IntoIterator<Item = (&'a Rational, &'a Rational, bool)>) -> Rational {
    let (mut p, mut q) = (Integer::ZERO, Natural::ONE);
    for (a, b, negative) in terms {
        if *a == 0u32 || *b == 0u32 {
            continue;
        }
        let positive = (*a > 0u32) == (*b > 0u32);
        let num =
            Integer::from_sign_and_abs(positive != negative, a.numerator_ref() * b.numerator_ref());
        let den = a.denominator_ref() * b.denominator_ref();
        if den == q {
            p += num;
        } else {
            p = p * Integer::from(&den) + num * Integer::from(&q);
            q *= den;
        }
    }
    let positive = p >= 0;
    Rational::from_sign_and_naturals(positive, p.unsigned_abs(), q)
}

impl Field for Rational {
    fn try_inv(&self) -> Option<Self> {
        (*self != 0u32).then(|| self.reciprocal())
    }
}

impl Ordered for Rational {
    fn certain_sign(&self) -> Option<Sign> {
        Some(match self.sign() {
            std::cmp::Ordering::Less => Sign::Negative,
            std::cmp::Ordering::Equal => Sign::Zero,
            std::cmp::Ordering::Greater => Sign::Positive,
        })
    }
}

impl Approx for Rational {
    fn to_f64(&self) -> f64 {
        match self.small_fraction() {
            // Both are exact in f64, so one division rounds once.
            Some((p, q)) if p.unsigned_abs() <= 1 << 53 && q <= 1 << 53 => p as f64 / q as f64,
            _ => ratio_to_f64(&self.numerator(), &self.denominator()),
        }
    }
}

impl RationalField for Rational {
    fn from_fraction(p: BigInt, q: BigInt) -> Option<Self> {
        let positive = p.sign() == q.sign();
        let (p, q) = (natural(p.magnitude()), natural(q.magnitude()));
        (q != 0u32).then(|| Rational::from_sign_and_naturals(positive, p, q))
    }

    fn numerator(&self) -> BigInt {
        let n = big(self.numerator_ref());
        if *self < 0u32 { -n } else { n }
    }

    fn denominator(&self) -> BigInt {
        big(self.denominator_ref())
    }

    fn small_fraction(&self) -> Option<(i64, i64)> {
        let p = i128::from(u64::try_from(self.numerator_ref()).ok()?);
        let q = i64::try_from(self.denominator_ref()).ok()?;
        Some((i64::try_from(if *self < 0u32 { -p } else { p }).ok()?, q))
    }
}

fn natural(n: &BigUint) -> Natural {
    Natural::from_owned_limbs_asc(n.to_u64_digits())
}

fn big(n: &Natural) -> BigInt {
    let words = n.to_limbs_asc().into_iter().flat_map(|limb| [limb as u32, (limb >> 32) as u32]);
    BigUint::new(words.collect()).into()
}
