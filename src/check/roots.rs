//! Sums of square roots of rational numbers: whether they vanish, and their signs, exactly.

use num_bigint::BigInt;
use num_traits::Signed;

use crate::scalar::{RationalField, Ring, Sign};

/// Whether `Σ cᵢ √qᵢ = 0`, decided exactly; `None` if some `qᵢ` is negative.
///
/// Square roots of integers from different square classes are linearly independent over ℚ
/// (Besicovitch 1940). So the sum vanishes iff it does within each class, where the ratio of two
/// roots is rational: `√(q/r) = √(q r) / r`.
pub(super) fn vanish(terms: &[(BigInt, BigInt)]) -> Option<bool> {
    if terms.iter().any(|(_, q)| q.is_negative()) {
        return None;
    }
    let mut classes: Vec<(&BigInt, BigInt)> = Vec::new();
    'terms: for (c, q) in terms {
        if c.is_zero() || q.is_zero() {
            continue;
        }
        for (root, sum) in &mut classes {
            let product = q * *root;
            let ratio = product.sqrt();
            if &ratio * &ratio == product {
                // c √q = (c √(q r) / r) √r; sums are kept multiplied by r.
                *sum += c * ratio;
                continue 'terms;
            }
        }
        classes.push((q, c * q));
    }
    Some(classes.iter().all(|(_, sum)| sum.is_zero()))
}

/// The sign of `Σ cᵢ √qᵢ`, exactly; `None` if some `qᵢ` is negative.
pub(super) fn sign(terms: &[(BigInt, BigInt)]) -> Option<Sign> {
    if vanish(terms)? {
        return Some(Sign::Zero);
    }
    let (limit, mut bits) = (BigInt::from(terms.len()), 64u32);
    loop {
        // Every term times 2^bits is cut by less than 1; since the sum is not zero, this ends.
        let term = |(c, q): &(BigInt, BigInt)| {
            let size = ((c * c * q) << (2 * bits)).sqrt();
            if c.is_negative() { -size } else { size }
        };
        let sum: BigInt = terms.iter().map(term).sum();
        if sum.abs() > limit {
            return Some(if sum.is_negative() { Sign::Negative } else { Sign::Positive });
        }
        bits *= 2;
    }
}

/// Whether a sum with rational terms vanishes.
pub(super) fn vanish_over<Q: RationalField>(terms: &[(Q, Q)]) -> Option<bool> {
    vanish(&cleared(terms))
}

/// The sign of a sum with rational terms.
pub(super) fn sign_over<Q: RationalField>(terms: &[(Q, Q)]) -> Option<Sign> {
    sign(&cleared(terms))
}

/// The sum times a common denominator.
fn cleared<Q: RationalField>(terms: &[(Q, Q)]) -> Vec<(BigInt, BigInt)> {
    let cleared: Vec<_> = terms
        .iter()
        .map(|(c, q)| {
            // c √(p/d) = (c/d) √(p d), and the denominator of c/d is cleared next.
            let (p, d) = (q.numerator(), q.denominator());
            (c.numerator(), c.denominator() * &d, p * d)
        })
        .collect();
    let common =
        cleared.iter().fold(BigInt::one(), |all, (_, d, _)| num_integer::lcm(all, d.clone()));
    cleared.into_iter().map(|(c, d, q)| (c * (&common / d), q)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn terms(t: &[(i64, i64)]) -> Vec<(BigInt, BigInt)> {
        t.iter().map(|&(c, q)| (c.into(), q.into())).collect()
    }

    #[test]
    fn equal_square_classes_cancel_and_different_ones_do_not() {
        // 3√2 + √8 − 5√2 = 0.
        assert_eq!(vanish(&terms(&[(3, 2), (1, 8), (-5, 2)])), Some(true));
        assert_eq!(vanish(&terms(&[(3, 2), (1, 8), (-4, 2)])), Some(false));
        // √2 + √3 − √(5 + 2√6) would vanish, but √2 + √3 and √10 only nearly agree.
        assert_eq!(vanish(&terms(&[(1, 2), (1, 3), (-1, 10)])), Some(false));
        assert_eq!(vanish(&terms(&[(0, 7), (2, 0)])), Some(true));
        assert_eq!(vanish(&terms(&[(1, -1)])), None);
    }

    #[test]
    fn signs_are_found_at_any_precision() {
        assert_eq!(sign(&terms(&[(3, 2), (1, 8), (-5, 2)])), Some(Sign::Zero));
        assert_eq!(sign(&terms(&[(1, 2), (1, 3), (-1, 10)])), Some(Sign::Negative));
        assert_eq!(sign(&terms(&[(1, -1)])), None);
        // √(n² + 1) − n is about 1/(2n).
        let n: BigInt = BigInt::one() << 200;
        let near = [(BigInt::one(), &n * &n + 1u32), (-n, BigInt::one())];
        assert_eq!(sign(&near), Some(Sign::Positive));
    }

    #[test]
    fn rational_terms_are_cleared_first() {
        use crate::scalar::{BigRational, Field};
        let q = |p, d| BigRational::from_ratio(p, d);
        // ½ √(1/2) − ¼ √2 = 0.
        assert_eq!(vanish_over(&[(q(1, 2), q(1, 2)), (q(-1, 4), q(2, 1))]), Some(true));
        assert_eq!(vanish_over(&[(q(1, 2), q(1, 2)), (q(-1, 3), q(2, 1))]), Some(false));
        let negative = Some(Sign::Negative);
        assert_eq!(sign_over(&[(q(1, 2), q(1, 2)), (q(-1, 3), q(2, 1))]), negative);
    }
}
