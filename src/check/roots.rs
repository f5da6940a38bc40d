//! Sums of square roots of rational numbers: whether they vanish, exactly.

use num_bigint::BigInt;
use num_traits::Signed;

use crate::scalar::{RationalField, Ring};

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

/// The same for rational terms: a common denominator is cleared, which does not change the answer.
pub(super) fn vanish_over<Q: RationalField>(terms: &[(Q, Q)]) -> Option<bool> {
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
    let terms: Vec<_> = cleared.into_iter().map(|(c, d, q)| (c * (&common / d), q)).collect();
    vanish(&terms)
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
    fn rational_terms_are_cleared_first() {
        use crate::scalar::{BigRational, Field};
        let q = |p, d| BigRational::from_ratio(p, d);
        // ½ √(1/2) − ¼ √2 = 0.
        assert_eq!(vanish_over(&[(q(1, 2), q(1, 2)), (q(-1, 4), q(2, 1))]), Some(true));
        assert_eq!(vanish_over(&[(q(1, 2), q(1, 2)), (q(-1, 3), q(2, 1))]), Some(false));
    }
}
