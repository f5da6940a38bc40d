//! Rational numbers.

use proptest::prelude::*;

use crate::scalar::Field;

/// Fractions with small numerators and denominators, among which coincidences are frequent.
pub fn small<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (-3i64..=3, 1i64..=3).prop_map(|(p, q)| Q::from_ratio(p, q))
}

/// Fractions among which coincidences are rare.
pub fn fraction<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (-9999i64..=9999, 1i64..=99).prop_map(|(p, q)| Q::from_ratio(p, q))
}

/// Numbers of the kind on which constructions break: mostly small, sometimes with many digits.
pub fn number<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (0u8..8, -9999i64..=9999, 1i64..=99).prop_map(|(kind, p, q)| match kind {
        0..=3 => Q::from_ratio(p % 5, 1),
        4..=5 => Q::from_ratio(p % 21, 1 + q % 9),
        _ => Q::from_ratio(p, q),
    })
}

/// Small fractions other than 0.
pub fn nonzero<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (1i64..=9, 1i64..=4, any::<bool>())
        .prop_map(|(p, q, negative)| Q::from_ratio(if negative { -p } else { p }, q))
}

/// Fractions between 0 and 1, without the ends.
pub fn proper<Q: Field>() -> impl Strategy<Value = Q> + Clone {
    (1i64..=9).prop_map(|p| Q::from_ratio(p, 10))
}
