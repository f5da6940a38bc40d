//! The prime field against integers of any size.

use isogeo::scalar::{BigInt, Field, Prime61, Ring};
use proptest::prelude::*;

use super::laws::{equal, holds, that};
use super::samples::{integers, primes};

fn p() -> BigInt {
    Prime61::MODULUS.into()
}

#[test]
fn operations_are_those_of_the_integers() -> Result<(), String> {
    let lift = |x: Prime61| BigInt::from(x.residue());
    holds((primes(), primes(), primes(), primes()), |(a, b, c, d)| {
        for x in [a + b, a - b, a * b, -a, Prime61::det2(&a, &b, &c, &d)] {
            that("a residue is below p", x.residue() < Prime61::MODULUS)?;
        }
        equal("+", a + b, Prime61::from_big(&(lift(a) + lift(b))))?;
        equal("-", a - b, Prime61::from_big(&(lift(a) - lift(b))))?;
        equal("*", a * b, Prime61::from_big(&(lift(a) * lift(b))))?;
        let det = lift(a) * lift(d) - lift(b) * lift(c);
        equal("det2", Prime61::det2(&a, &b, &c, &d), Prime61::from_big(&det))
    })?;
    holds((integers(), any::<i64>(), any::<u64>()), |(n, i, u)| {
        let remainder = ((&n % p()) + p()) % p();
        equal("from_big", BigInt::from(Prime61::from_big(&n).residue()), remainder)?;
        equal("from_i64", Prime61::from_i64(i), Prime61::from_big(&i.into()))?;
        equal("from_u64", Prime61::from_u64(u), Prime61::from_big(&u.into()))
    })
}

/// The largest products, as many as need several reductions on the way.
#[test]
fn a_long_sum_of_the_largest_products_does_not_overflow() {
    let (minus_one, n) = (-Prime61::one(), 200);
    let x = [&minus_one; 200];
    assert_eq!(Prime61::dot(x, x), Prime61::from_i64(n));
    assert_eq!(Prime61::dot([&minus_one; 33], [&minus_one; 33]), Prime61::from_i64(33));
    assert_eq!(Prime61::det2(&minus_one, &Prime61::zero(), &minus_one, &minus_one), Prime61::one());
}

#[test]
fn powers_obey_fermat_and_the_inverse_is_one() -> Result<(), String> {
    holds((primes(), 0u64..1000, any::<u64>()), |(x, m, n)| {
        equal("x^p = x", x.power(Prime61::MODULUS), x)?;
        equal("x^m x^n = x^(m+n)", x.power(m) * x.power(n / 2), x.power(m + n / 2))?;
        let inverse = (!x.is_zero()).then(|| x.power(Prime61::MODULUS - 2));
        equal("1/x = x^(p-2)", x.try_inv(), inverse)
    })?;
    assert_eq!(Prime61::zero().power(0), Prime61::one());
    Ok(())
}

#[test]
#[should_panic(expected = "division by zero")]
fn the_operator_of_division_refuses_zero() {
    let _ = Prime61::one() / Prime61::zero();
}

/// Which roots the field contains: `Quadratic` over it is a field for 3 but not for 2.
#[test]
fn two_is_a_square_and_three_is_not() {
    let euler = |n: i64| Prime61::from_i64(n).power((Prime61::MODULUS - 1) / 2);
    assert_eq!(euler(2), Prime61::one());
    assert_eq!(euler(3), -Prime61::one());
    assert_eq!(Prime61::from_u64(1 << 31).square(), Prime61::from_i64(2));
}
