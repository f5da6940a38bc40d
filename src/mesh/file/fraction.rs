//! Rational numbers as text: `p/q` or `p`.

use std::fmt;

use num_bigint::BigInt;

use crate::scalar::RationalField;

/// Why a text is no fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FractionError {
    /// Not of the form `[-] digits [/ digits]`.
    Syntax,
    /// The denominator is 0.
    ZeroDenominator,
    /// More than [`MAX_DIGITS`] digits above or below the bar.
    TooManyDigits,
}

/// The most digits that numerator and denominator may have, where nothing else is said.
pub const MAX_DIGITS: usize = 10_000;

impl fmt::Display for FractionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FractionError::Syntax => write!(f, "expected a fraction such as \"-1/3\" or \"2\""),
            FractionError::ZeroDenominator => write!(f, "the denominator is 0"),
            FractionError::TooManyDigits => write!(f, "more than {MAX_DIGITS} digits"),
        }
    }
}

impl std::error::Error for FractionError {}

/// The number that `p/q` or `p` says; it need not be in lowest terms.
///
/// ```
/// use isogeo::mesh::file::{FractionError, parse_fraction};
/// use isogeo::scalar::{BigRational, Field};
/// assert_eq!(parse_fraction("-2/6"), Ok(BigRational::from_ratio(-1, 3)));
/// assert_eq!(parse_fraction::<BigRational>("1/0"), Err(FractionError::ZeroDenominator));
/// assert_eq!(parse_fraction::<BigRational>("0.5"), Err(FractionError::Syntax));
/// ```
///
/// # Errors
/// See [`FractionError`]. Blanks, a plus sign and a signed denominator are refused.
pub fn parse_fraction<Q: RationalField>(text: &str) -> Result<Q, FractionError> {
    parse(text, MAX_DIGITS)
}

/// The same with another limit.
pub(super) fn parse<Q: RationalField>(text: &str, most_digits: usize) -> Result<Q, FractionError> {
    let (size, negative) = match text.strip_prefix('-') {
        Some(size) => (size, true),
        None => (text, false),
    };
    let (p, q) = size.split_once('/').unwrap_or((size, "1"));
    for digits in [p, q] {
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(FractionError::Syntax);
        }
        if digits.len() > most_digits {
            return Err(FractionError::TooManyDigits);
        }
    }
    let big = |digits: &str| digits.parse::<BigInt>().map_err(|_| FractionError::Syntax);
    let value = match (p.parse::<i64>(), q.parse::<i64>()) {
        (Ok(p), Ok(1)) => Q::from_i64(p),
        (Ok(p), Ok(q)) if q != 0 => Q::from_ratio(p, q),
        _ => Q::from_fraction(big(p)?, big(q)?).ok_or(FractionError::ZeroDenominator)?,
    };
    Ok(if negative { -value } else { value })
}
