//! Strategies for the numbers of every instance: small ones, so that coincidences occur, and large
//! ones, so that words overflow.

use isogeo::scalar::{
    BigInt, Bounded, Dual, Field, Fraction, Prime61, Quadratic, RationalField, Residue, Ring, Wide,
};
use proptest::array::uniform;
use proptest::prelude::*;

/// Integers of up to four words, small ones often.
pub fn integers() -> impl Strategy<Value = BigInt> + Clone {
    prop_oneof![
        (-6i64..=6).prop_map(BigInt::from),
        any::<i64>().prop_map(BigInt::from),
        (any::<i128>(), any::<i128>()).prop_map(|(a, b)| BigInt::from(a) * BigInt::from(b)),
    ]
}

/// Fractions of small and of large integers.
pub fn fractions<Q: RationalField>() -> impl Strategy<Value = Q> + Clone {
    let denominators = integers().prop_filter("a denominator is not 0", |q| !q.is_zero());
    (integers(), denominators)
        .prop_filter_map("a denominator is not 0", |(p, q)| Q::from_fraction(p, q))
}

/// Fractions of integers below 100.
pub fn small_fractions<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (-99i64..100, 1i64..100).prop_map(|(p, q)| Q::from_ratio(p, q))
}

pub fn residues<const W: usize>() -> impl Strategy<Value = Residue<W>> + Clone {
    prop_oneof![
        integers().prop_map(|n| Residue::from_big(&n)),
        uniform(any::<u64>()).prop_map(Residue),
    ]
}

pub fn primes() -> impl Strategy<Value = Prime61> + Clone {
    let p = Prime61::MODULUS;
    prop_oneof![0..3u64, p - 3..p + 3, any::<u64>()].prop_map(Prime61::from_u64)
}

pub fn duals<T: Ring, const N: usize>(
    parts: impl Strategy<Value = T> + Clone,
) -> impl Strategy<Value = Dual<T, N>> + Clone {
    (parts.clone(), uniform(parts)).prop_map(|(value, partials)| Dual { value, partials })
}

pub fn quadratics<T: Ring, const D: i64>(
    parts: impl Strategy<Value = T> + Clone,
) -> impl Strategy<Value = Quadratic<T, D>> + Clone {
    (parts.clone(), parts).prop_map(|(a, b)| Quadratic::new(a, b))
}

pub fn wides<const W: usize>() -> impl Strategy<Value = Wide<W>> + Clone {
    integers().prop_map(|n| n.to_wide())
}

/// Fractions with common factors, and with negative denominators.
pub fn unreduced() -> impl Strategy<Value = Fraction<BigInt>> + Clone {
    let factors = prop_oneof![Just(1i64), Just(-1), Just(6), Just(-35)];
    (integers(), integers(), factors)
        .prop_filter("a denominator is not 0", |(_, q, _)| !q.is_zero())
        .prop_map(|(p, q, factor)| Fraction::new(p * factor, q * factor))
}
