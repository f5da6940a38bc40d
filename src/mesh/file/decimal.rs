//! Rational numbers as decimals: exactly, to some digits, or as the shortest double.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Pow, Signed, Zero};

use crate::scalar::RationalField;

/// The most digits, zeros included, of a decimal that is written in full.
const LONGEST: usize = 40;

/// Appends the number itself; `false`, and nothing, if it is no decimal of at most 40 digits.
pub(super) fn push_exact<Q: RationalField>(out: &mut String, x: &Q) -> bool {
    if let Some((p, 1)) = x.small_fraction() {
        out.push_str(&p.to_string());
        return true;
    }
    let (p, mut q) = (x.numerator(), x.denominator());
    // 10^40 has 133 bits.
    if q.bits() > 133 || p.bits() > 266 {
        return false;
    }
    let twos = q.trailing_zeros().unwrap_or(0) as usize;
    q >>= twos;
    let mut fives = 0;
    while q > BigInt::from(1) {
        let (quotient, rest) = q.div_rem(&5.into());
        if !rest.is_zero() {
            return false;
        }
        q = quotient;
        fives += 1;
    }
    let places = twos.max(fives);
    let scaled = p * BigInt::from(2).pow(places - twos) * BigInt::from(5).pow(places - fives);
    let digits = scaled.abs().to_string();
    let fits = digits.len().max(places + 1) <= LONGEST;
    if fits {
        push_positional(out, scaled.is_negative(), &digits, places);
    }
    fits
}

/// Appends the number rounded to some digits, ties to even; returns whether it is that number.
pub(super) fn push_rounded<Q: RationalField>(out: &mut String, x: &Q, digits: usize) -> bool {
    let digits = digits.max(1);
    let (p, q) = (x.numerator(), x.denominator());
    if p.is_zero() {
        push_positional(out, false, "0", digits);
        return true;
    }
    let bits = p.bits() as f64 - 1.0 - q.bits() as f64;
    // The power of ten of the first digit, to be corrected below.
    let mut first = (bits * std::f64::consts::LOG10_2).floor() as i64;
    let (text, exact) = loop {
        let (scaled, exact) = scaled(&p.abs(), &q, digits as i64 - 1 - first);
        let text = scaled.to_string();
        match text.len().cmp(&digits) {
            std::cmp::Ordering::Less => first -= 1,
            std::cmp::Ordering::Equal => break (text, exact),
            std::cmp::Ordering::Greater => first += 1,
        }
    };
    let places = digits as i64 - 1 - first;
    if places >= 0 && first >= -7 {
        push_positional(out, p.is_negative(), &text, places as usize);
    } else {
        push_positional(out, p.is_negative(), &text, digits - 1);
        out.push_str(&format!("e{first}"));
    }
    exact
}

/// `p / q · 10^power` to the nearest integer, ties to even, and whether nothing was rounded.
fn scaled(p: &BigInt, q: &BigInt, power: i64) -> (BigInt, bool) {
    let ten = BigInt::from(10).pow(power.unsigned_abs());
    let (p, q) = if power >= 0 { (p * ten, q.clone()) } else { (p.clone(), q * ten) };
    let (quotient, rest) = p.div_rem(&q);
    let up = match (&rest + &rest).cmp(&q) {
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal => quotient.is_odd(),
        std::cmp::Ordering::Greater => true,
    };
    (if up { quotient + 1 } else { quotient }, rest.is_zero())
}

fn push_positional(out: &mut String, negative: bool, digits: &str, places: usize) {
    if negative {
        out.push('-');
    }
    let zeros = (places + 1).saturating_sub(digits.len());
    let digits = "0".repeat(zeros) + digits;
    let (whole, fraction) = digits.split_at(digits.len() - places);
    out.push_str(whole);
    if places > 0 {
        out.push('.');
        out.push_str(fraction);
    }
}

/// Appends the shortest decimal that reads back as this finite double.
pub(super) fn push_shortest(out: &mut String, x: f64) {
    // `{:?}` changes to an exponent where the zeros would be many, and ends in `.0` elsewhere.
    let text = format!("{x:?}");
    out.push_str(text.strip_suffix(".0").unwrap_or(&text));
}
