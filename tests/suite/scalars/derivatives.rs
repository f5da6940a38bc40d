//! Dual numbers against derivatives found another way.

use isogeo::scalar::{
    BigInt, BigRational, Dual, Field, Magnitude, Numeral, Rational, RationalField, Ring,
};
use proptest::array::{uniform2, uniform4};
use proptest::collection::vec;

use super::expression::{VARIABLES, polynomials, quotients};
use super::laws::{equal, holds, that};
use super::samples::small_fractions;

fn horner<T: Ring>(coefficients: &[T], x: &T) -> T {
    coefficients.iter().rev().fold(T::zero(), |sum, c| sum * x + c)
}

#[test]
fn the_derivatives_of_a_polynomial_are_those_of_its_coefficients() -> Result<(), String> {
    type Twice = Dual<Dual<Rational, 1>, 1>;
    let numbers = small_fractions::<Rational>;
    holds((vec(numbers(), 0..8), numbers()), |(coefficients, at)| {
        let derived = |c: &[Rational]| -> Vec<Rational> {
            (1i64..).zip(c.iter().skip(1)).map(|(k, c)| Rational::from_i64(k) * c).collect()
        };
        let once = derived(&coefficients);
        let x = Twice::variable(Dual::variable(at.clone(), 0), 0);
        let constants: Vec<Twice> =
            coefficients.iter().map(|c| Dual::constant(Dual::constant(c.clone()))).collect();
        let y = horner(&constants, &x);
        equal("f", &y.value.value, &horner(&coefficients, &at))?;
        equal("f′", &y.partials[0].value, &horner(&once, &at))?;
        equal("f′ again", &y.value.partials[0], &horner(&once, &at))?;
        equal("f″", &y.partials[0].partials[0], &horner(&derived(&once), &at))
    })
}

/// For integers `x` and a polynomial with integer coefficients, `(f(x + h) − f(x)) / h` with
/// `h = 1/M` is `f′(x) + c₂/M + c₃/M² + …`, and rounds to `f′(x)` once `M > 4 Σ |cₖ|`.
#[test]
fn the_gradient_is_the_rounded_difference_quotient() -> Result<(), String> {
    holds((polynomials(4), uniform4(-9i64..10)), |(f, at)| {
        let gradient = f.polynomial(&Dual::variables(at.map(BigInt::from)));
        let value = f.polynomial(&at.map(BigRational::from_i64));
        equal("the value", gradient.value.clone(), value.numerator())?;
        // Σ |cₖ| is at most the sum of all |terms| at |x| + 1.
        let bound = f.polynomial(&at.map(|x| Magnitude(x.abs() as f64 + 1.0))).0;
        let bound: BigRational = Numeral::from_f64(bound).expect("far from overflow").value();
        // Twice what is needed makes up for the rounding of the bound.
        let h = (bound * BigRational::from_i64(8) + BigRational::one()).recip();
        for i in 0..VARIABLES {
            let mut moved = at.map(BigRational::from_i64);
            moved[i] += &h;
            let quotient = (f.polynomial(&moved) - &value) / &h;
            equal(
                "a partial derivative",
                quotient.round().numerator(),
                gradient.partials[i].clone(),
            )?;
        }
        Ok(())
    })
}

#[test]
fn quotients_differentiate_by_the_rules() -> Result<(), String> {
    holds((uniform2(small_fractions::<Rational>()), small_fractions::<Rational>()), |(at, c)| {
        let [x, y] = at.clone();
        let [u, v] = Dual::variables(at);
        let Some(quotient) = (u.square() + Dual::constant(c.clone())).try_div(&v) else {
            return equal("only a division by 0 fails", y, Rational::zero());
        };
        // f = (x² + c)/y: f_x = 2x/y, f_y = −(x² + c)/y².
        equal("f_x", &quotient.partials[0], &(Rational::from_i64(2) * &x / &y))?;
        equal("f_y", &quotient.partials[1], &-((x.square() + c) / y.square()))
    })
}

#[test]
fn hessians_are_symmetric() -> Result<(), String> {
    type Twice = Dual<Dual<Rational, VARIABLES>, VARIABLES>;
    holds((quotients(3), uniform4(small_fractions::<Rational>())), |(f, at)| {
        let value = f.rational(&at);
        let twice: [Twice; VARIABLES] = Dual::variables(Dual::variables(at.clone()));
        let Some(jet) = f.rational(&twice) else {
            return equal("only a division by 0 fails", value, None);
        };
        equal("the value", Some(&jet.value.value), value.as_ref())?;
        equal("the two gradients", Some(&jet.value), f.rational(&Dual::variables(at)).as_ref())?;
        for i in 0..VARIABLES {
            equal("the two gradients", &jet.partials[i].value, &jet.value.partials[i])?;
            for j in 0..i {
                that("f_ij = f_ji", jet.partials[i].partials[j] == jet.partials[j].partials[i])?;
            }
        }
        Ok(())
    })
}

#[test]
fn a_value_of_zero_has_no_inverse_though_it_is_not_zero() {
    let e = Dual::<BigRational, 1>::variable(BigRational::zero(), 0);
    assert!(!e.is_zero() && e.square().is_zero());
    assert_eq!((e.try_inv(), Dual::one().try_div(&e)), (None, None));
}
