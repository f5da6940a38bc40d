//! Numerals: what a text says, what a double says, and the limits.

use isogeo::scalar::{
    Approx, Base, BigRational, Field, Numeral, NumeralError, Ordered, Rational, RationalField, Ring,
};
use proptest::prelude::*;

use super::laws::{equal, holds, that};

/// Well-formed decimal texts, of every size that doubles have and beyond.
fn texts() -> impl Strategy<Value = String> {
    prop_oneof![
        "[+-]?[0-9]{1,25}(\\.[0-9]{0,25})?([eE][+-]?[0-3]?[0-9]{1,2})?",
        "[+-]?\\.[0-9]{1,20}([eE][+-]?[0-9]{1,2})?",
        // Near the least and the greatest double.
        "[0-9]{1,20}(\\.[0-9]{0,20})?e-3[0-3][0-9]",
        "[0-9](\\.[0-9]{0,20})?e30[5-9]",
        any::<f64>().prop_filter("finite", |x| x.is_finite()).prop_map(|x| x.to_string()),
        any::<f64>().prop_filter("finite", |x| x.is_finite()).prop_map(|x| format!("{x:e}")),
    ]
}

#[test]
fn a_text_gives_the_double_of_the_standard_library() -> Result<(), String> {
    holds(texts(), |text| {
        let double: f64 = text.parse().expect("the standard library reads it");
        let numeral: Numeral = text.parse().expect("a numeral");
        equal("nearest_f64", numeral.nearest_f64(), double)?;
        // Two more roads to the same number: correctly rounded quotients of integers.
        equal("through BigRational", numeral.value::<BigRational>().to_f64(), double)?;
        equal("through Rational", numeral.value::<Rational>().to_f64(), double)
    })
}

#[test]
fn the_unit_is_that_of_the_last_digit() -> Result<(), String> {
    holds((-999i64..1000, "[0-9]{0,12}", -30i32..30), |(whole, digits, e)| {
        let numeral: Numeral = format!("{whole}.{digits}e{e}").parse().expect("a numeral");
        equal("the unit", numeral.unit_exponent(), (Base::Ten, e - digits.len() as i32))?;
        let unit = numeral.half_unit::<Rational>() * Rational::from_i64(2);
        let mantissa = numeral.value::<Rational>() / unit;
        equal("the number is a multiple of it", mantissa.denominator(), 1.into())
    })
}

#[test]
fn half_a_unit_is_rounded_up_by_little() -> Result<(), String> {
    let numerals = prop_oneof![
        texts().prop_filter_map("a numeral", |text| text.parse::<Numeral>().ok()),
        any::<f64>().prop_filter_map("finite", Numeral::from_f64),
        any::<f32>().prop_filter_map("finite", Numeral::from_f32),
    ];
    holds(numerals, |numeral| {
        let (exact, bound) = (numeral.half_unit::<BigRational>(), numeral.half_unit_f64());
        let Some(bound) = Numeral::from_f64(bound) else {
            return that("only a huge unit has no bound", exact.to_f64() > 1e300);
        };
        let bound: BigRational = bound.value();
        that("an upper bound", exact <= bound)?;
        let slack = &exact * BigRational::from_ratio(1, 1 << 51)
            + Numeral::from_f64(f64::from_bits(2)).expect("finite").value::<BigRational>();
        that("within two units in the last place", bound <= exact + slack)
    })
}

#[test]
fn a_double_comes_back() -> Result<(), String> {
    holds(any::<f64>(), |x| {
        let Some(numeral) = Numeral::from_f64(x) else {
            return that("only NaN and infinities are refused", !x.is_finite());
        };
        equal("itself", numeral.nearest_f64(), x)?;
        equal("through BigRational", numeral.value::<BigRational>().to_f64(), x)?;
        equal("through Rational", numeral.value::<Rational>().to_f64(), x)?;
        let unit = numeral.half_unit::<BigRational>() * BigRational::from_i64(2);
        // The next double is one unit away (but at a power of two, downwards, half a unit).
        let away = x.abs().next_up();
        match Numeral::from_f64(away) {
            Some(next) => {
                let size = numeral.value::<BigRational>().magnitude();
                equal("the unit", next.value::<BigRational>() - size, unit)
            }
            None => Ok(()),
        }
    })
}

#[test]
fn a_float_comes_back_with_its_own_unit() -> Result<(), String> {
    holds(any::<f32>(), |x| {
        let Some(numeral) = Numeral::from_f32(x) else {
            return that("only NaN and infinities are refused", !x.is_finite());
        };
        equal("itself", numeral.nearest_f64(), f64::from(x))?;
        let unit = numeral.half_unit::<BigRational>() * BigRational::from_i64(2);
        match Numeral::from_f32(x.abs().next_up()) {
            Some(next) => {
                let size = numeral.value::<BigRational>().magnitude();
                equal("the unit", next.value::<BigRational>() - size, unit)
            }
            None => Ok(()),
        }
    })
}

/// Found: the float 0 was given the unit `2^-1012` of no format at all.
#[test]
fn the_unit_of_the_float_zero_is_the_least_float() {
    let zero = Numeral::from_f32(0.0).expect("finite");
    assert_eq!(zero.unit_exponent(), (Base::Two, -149));
    assert_eq!(zero.nearest_f64(), 0.0);
    assert_eq!(Numeral::from_f64(-0.0).expect("finite").unit_exponent(), (Base::Two, -1074));
}

#[test]
fn texts_that_are_no_numbers_are_refused() {
    for text in [
        "", "+", "-", ".", "e5", ".e5", "+-1", "1e", "1e+", "1e5.0", "1.2.3", "1_000", "0x10",
        " 1", "1 ", "1/3", "nan", "inf", "-inf", "infinity", "1,5", "１", "1f", "--1", "1e--1",
        "1e1e1",
    ] {
        assert_eq!(text.parse::<Numeral>(), Err(NumeralError::Syntax), "{text:?}");
    }
}

#[test]
fn limits_are_where_they_are_stated() {
    use NumeralError::{ExponentTooLarge, TooManyDigits};
    let parse = |text: &str| text.parse::<Numeral>();
    let digits = |n: usize| "9".repeat(n);
    assert!(parse(&digits(Numeral::MAX_DIGITS)).is_ok());
    assert_eq!(parse(&digits(Numeral::MAX_DIGITS + 1)), Err(TooManyDigits(10_000)));
    assert_eq!(parse(&format!("0.{}", digits(Numeral::MAX_DIGITS))), Err(TooManyDigits(10_000)));
    for sign in ["", "+", "-"] {
        assert!(parse(&format!("1e{sign}10000")).is_ok());
        assert_eq!(parse(&format!("1e{sign}10001")), Err(ExponentTooLarge(10_000)));
        assert_eq!(parse(&format!("1e{sign}{}", digits(10_000))), Err(ExponentTooLarge(10_000)));
        assert_eq!(
            parse(&format!("1e{sign}{}1", "0".repeat(10_000))),
            parse(&format!("1e{sign}1"))
        );
    }
    // The extremes are still numbers.
    let least = parse(&format!(".{}e-10000", digits(Numeral::MAX_DIGITS))).expect("a numeral");
    assert_eq!(least.unit_exponent(), (Base::Ten, -20_000));
    assert_eq!(least.nearest_f64(), 0.0);
    assert!(least.half_unit_f64() > 0.0);
    let greatest = parse(&format!("{}e10000", digits(Numeral::MAX_DIGITS))).expect("a numeral");
    assert_eq!(greatest.nearest_f64(), f64::INFINITY);
    assert_eq!(greatest.half_unit_f64(), f64::INFINITY);
    assert_eq!(greatest.value::<BigRational>().to_f64(), f64::INFINITY);
}

#[test]
fn mantissas_around_64_bits_are_exact() {
    for text in [
        "9223372036854775807",
        "9223372036854775808",
        "-9223372036854775808",
        "-9223372036854775809",
    ] {
        let numeral: Numeral = text.parse().expect("a numeral");
        assert_eq!(numeral.value::<Rational>().to_string(), text);
        assert_eq!(numeral.nearest_f64(), text.parse::<f64>().expect("a double"));
    }
    let zeros: Numeral = "-0000000000000000000000000.00000".parse().expect("a numeral");
    assert_eq!(zeros.small_parts(), Some((0, Base::Ten, -5)));
    assert_eq!(zeros.value::<Rational>(), Rational::from_i64(0));
}
