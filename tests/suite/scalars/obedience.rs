//! Every instance obeys the laws.

use isogeo::scalar::{BigInt, BigRational, Dual, Prime61, Quadratic, Rational, Ring};
use proptest::prelude::*;

use super::laws::{field, order, ring};
use super::samples::*;

fn not_zero<T: Ring>(x: &T) -> bool {
    !x.is_zero()
}

macro_rules! obeys {
    ($($name:ident: $($law:expr),+;)+) => {$(
        #[test]
        fn $name() -> Result<(), String> {
            $($law?;)+
            Ok(())
        }
    )+};
}

obeys! {
    rational: ring(fractions::<Rational>()), field(fractions::<Rational>(), not_zero),
        order(fractions::<Rational>());
    big_rational: ring(fractions::<BigRational>()), field(fractions::<BigRational>(), not_zero),
        order(fractions::<BigRational>());
    integer: ring(integers()), order(integers());
    residue_of_1_word: ring(residues::<1>());
    residue_of_2_words: ring(residues::<2>());
    residue_of_3_words: ring(residues::<3>());
    residue_of_4_words: ring(residues::<4>());
    wide_integers: ring(wides::<24>()), order(wides::<24>());
    unreduced_fractions: ring(unreduced()), field(unreduced(), not_zero), order(unreduced());
    prime_field: ring(primes()), field(primes(), not_zero);
    // Where doubles are exact: small integers for the ring, powers of two for the field.
    doubles: ring((-1000i32..1000).prop_map(f64::from)), order((-1000i32..1000).prop_map(f64::from)),
        field((-8i32..8, any::<bool>()).prop_map(|(e, s)| if s { -2f64.powi(e) } else { 2f64.powi(e) }),
            not_zero);
    dual_numbers: ring(duals::<_, 3>(small_fractions::<Rational>())),
        field(duals::<_, 2>(small_fractions::<Rational>()), |x| not_zero(&x.value));
    dual_numbers_nested: ring(hessians()), field(hessians(), |x| not_zero(&x.value.value));
    dual_numbers_over_integers: ring(duals::<_, 2>(integers()));
    quadratic_field: ring(quadratics::<_, 2>(small_fractions::<Rational>())),
        field(quadratics::<_, 3>(small_fractions::<Rational>()), not_zero),
        order(quadratics::<_, 5>(small_fractions::<Rational>()));
    quadratic_field_of_big_rationals:
        field(quadratics::<_, 2>(small_fractions::<BigRational>()), not_zero),
        order(quadratics::<_, 2>(fractions::<BigRational>()));
    quadratic_integers: ring(quadratics::<BigInt, 6>(integers())), order(quadratics::<BigInt, 7>(integers()));
    quadratic_tower: field(towers(), not_zero), order(towers());
    // 3 is no square modulo 2^61 - 1: a field of p^2 elements.
    quadratic_over_the_prime_field: ring(quadratics::<Prime61, 3>(primes())),
        field(quadratics::<Prime61, 3>(primes()), not_zero);
    dual_numbers_of_a_quadratic_field: ring(dual_quadratics()),
        field(dual_quadratics(), |x| not_zero(&x.value));
}

fn hessians() -> impl Strategy<Value = Dual<Dual<Prime61, 2>, 2>> + Clone {
    duals(duals(primes()))
}

/// The field of the square roots of 2 and 3.
fn towers() -> impl Strategy<Value = Quadratic<Quadratic<Rational, 2>, 3>> + Clone {
    quadratics(quadratics(small_fractions()))
}

fn dual_quadratics() -> impl Strategy<Value = Dual<Quadratic<Rational, 3>, 2>> + Clone {
    duals(quadratics(small_fractions()))
}
