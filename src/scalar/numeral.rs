//! Numbers as they stand in a file: exactly what was printed, and how far it can be trusted.

use std::fmt;

use num_bigint::BigInt;
use num_traits::Pow;

use super::rational::{RationalField, scale_by_power_of_two};

/// A number as a file gives it: `mantissa · base^exponent`, base 10 for text, 2 for binary data.
///
/// Trailing zeros are kept, since they say how many digits were meant: the *unit* of `0.50` is
/// 1/100, the number stands for the box `0.50 ± 1/200`.
///
/// ```
/// use isogeo::scalar::{BigRational, Numeral, RationalField, Field};
/// let n: Numeral = "-5.090e-001".parse().unwrap();
/// assert_eq!(n.value::<BigRational>(), BigRational::from_ratio(-509, 1000));
/// assert_eq!(n.half_unit::<BigRational>(), BigRational::from_ratio(1, 20_000));
/// assert!("1/3".parse::<Numeral>().is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numeral {
    mantissa: Mantissa,
    exponent: i32,
    base: Base,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Mantissa {
    Small(i64),
    Big(Box<BigInt>),
}

/// What the exponent of a [`Numeral`] counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// Powers of two: binary data, or text read as the nearest double.
    Two,
    /// Powers of ten: decimal text.
    Ten,
}

/// How the numbers of a file are understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ReadAs {
    /// The text is the number: `0.1` is 1/10.
    Decimal,
    /// The text stands for the box of half a unit of its last digit.
    Rounded,
    /// The text stands for the nearest double, taken exactly.
    Double,
}

/// The powers of ten that doubles hold exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

impl ReadAs {
    /// The name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            ReadAs::Decimal => "decimal",
            ReadAs::Rounded => "rounded",
            ReadAs::Double => "double",
        }
    }
}

/// Why a text is no numeral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumeralError {
    /// Not of the form `[sign] digits [. digits] [e [sign] digits]`.
    Syntax,
    /// More digits than this limit.
    TooManyDigits(usize),
    /// An exponent beyond plus or minus this limit.
    ExponentTooLarge(usize),
}

impl fmt::Display for NumeralError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NumeralError::Syntax => write!(f, "not a decimal number"),
            NumeralError::TooManyDigits(most) => write!(f, "a number of more than {most} digits"),
            NumeralError::ExponentTooLarge(most) => write!(f, "an exponent beyond ±{most}"),
        }
    }
}

impl std::error::Error for NumeralError {}

impl Numeral {
    /// The most digits of a numeral, and the largest size of its decimal exponent, where nothing else
    /// is said.
    pub const MAX_DIGITS: usize = 10_000;
    /// The most that [`parse`](Numeral::parse) can be told to take.
    pub const MOST_DIGITS: usize = 100_000_000;

    /// A finite double taken exactly; its unit is its unit in the last place. `None` for NaN and
    /// infinities.
    pub fn from_f64(x: f64) -> Option<Numeral> {
        const FRACTION: u64 = (1 << 52) - 1;
        let bits = x.to_bits();
        let biased = ((bits >> 52) & 0x7ff) as i32;
        let fraction = (bits & FRACTION) as i64;
        let (size, exponent) = match biased {
            0x7ff => return None,
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, biased - 1075),
        };
        let mantissa = Mantissa::Small(if x < 0.0 { -size } else { size });
        Some(Numeral { mantissa, exponent, base: Base::Two })
    }

    /// A finite float taken exactly; its unit is the unit in the last place of the *float*.
    pub fn from_f32(x: f32) -> Option<Numeral> {
        let mut numeral = Numeral::from_f64(x.into())?;
        if let Mantissa::Small(m) = &mut numeral.mantissa {
            // A float has 29 bits less than a double; below its normal range the unit is 2^-149.
            let drop = 29.max(-149 - numeral.exponent);
            *m >>= drop.min(62); // 0 where more is dropped
            numeral.exponent += drop;
        }
        Some(numeral)
    }

    /// The integer `n`, known to the unit.
    pub fn from_i64(n: i64) -> Numeral {
        Numeral { mantissa: Mantissa::Small(n), exponent: 0, base: Base::Ten }
    }

    /// The mantissa where it fits 64 bits, with its base and exponent.
    pub fn small_parts(&self) -> Option<(i64, Base, i32)> {
        match self.mantissa {
            Mantissa::Small(m) => Some((m, self.base, self.exponent)),
            Mantissa::Big(_) => None,
        }
    }

    /// The exponent: the unit of the last digit is `base^exponent`.
    pub fn unit_exponent(&self) -> (Base, i32) {
        (self.base, self.exponent)
    }

    /// The number exactly as it stands there.
    pub fn value<Q: RationalField>(&self) -> Q {
        let mantissa = match &self.mantissa {
            Mantissa::Small(m) => BigInt::from(*m),
            Mantissa::Big(m) => (**m).clone(),
        };
        self.scaled(mantissa)
    }

    /// Half a unit of the last digit.
    pub fn half_unit<Q: RationalField>(&self) -> Q {
        self.scaled::<Q>(1.into()) * Q::from_ratio(1, 2)
    }

    /// Half a unit of the last digit, rounded up.
    pub fn half_unit_f64(&self) -> f64 {
        match self.base {
            Base::Two => scale_by_power_of_two(0.5, self.exponent.into()).next_up(),
            Base::Ten => {
                format!("0.5e{}", self.exponent).parse::<f64>().map_or(f64::INFINITY, f64::next_up)
            }
        }
    }

    fn scaled<Q: RationalField>(&self, mantissa: BigInt) -> Q {
        let power = BigInt::from(match self.base {
            Base::Two => 2,
            Base::Ten => 10,
        })
        .pow(self.exponent.unsigned_abs());
        let fraction = if self.exponent >= 0 {
            Q::from_fraction(mantissa * power, 1.into())
        } else {
            Q::from_fraction(mantissa, power)
        };
        fraction.unwrap_or_else(Q::zero)
    }

    /// The nearest double (ties to even); infinite beyond the range of doubles.
    pub fn nearest_f64(&self) -> f64 {
        match (&self.mantissa, self.base) {
            (Mantissa::Small(m), Base::Two) if m.unsigned_abs() <= 1 << 53 => {
                scale_by_power_of_two(*m as f64, self.exponent.into())
            }
            // Two exact doubles and one operation: rounded once.
            (Mantissa::Small(m), Base::Ten)
                if m.unsigned_abs() <= 1 << 53 && self.exponent.unsigned_abs() <= 22 =>
            {
                let power = EXACT_POWERS[self.exponent.unsigned_abs() as usize];
                if self.exponent < 0 { *m as f64 / power } else { *m as f64 * power }
            }
            (Mantissa::Small(m), Base::Ten) => parse_f64(&format!("{m}e{}", self.exponent)),
            (Mantissa::Big(m), Base::Ten) => parse_f64(&format!("{m}e{}", self.exponent)),
            // Not made by any reader; exact and slow.
            _ => super::Approx::to_f64(&self.value::<super::BigRational>()),
        }
    }
}

fn parse_f64(text: &str) -> f64 {
    // Always a well-formed literal, which `f64` parses with one correct rounding.
    text.parse().unwrap_or(f64::NAN)
}

impl std::str::FromStr for Numeral {
    type Err = NumeralError;

    fn from_str(text: &str) -> Result<Numeral, NumeralError> {
        Numeral::parse(text, Numeral::MAX_DIGITS)
    }
}

impl Numeral {
    /// The numeral that a text is, with at most so many digits, and an exponent of at most that size.
    ///
    /// ```
    /// use isogeo::scalar::{Numeral, NumeralError};
    /// assert_eq!(Numeral::parse("-1.25e3", 3), "-1.25e3".parse());
    /// assert_eq!(Numeral::parse("0.125", 3), Err(NumeralError::TooManyDigits(3)));
    /// assert_eq!(Numeral::parse("1e-4", 3), Err(NumeralError::ExponentTooLarge(3)));
    /// ```
    ///
    /// # Errors
    /// See [`NumeralError`]. A limit above [`MOST_DIGITS`](Numeral::MOST_DIGITS) counts as that.
    pub fn parse(text: &str, most_digits: usize) -> Result<Numeral, NumeralError> {
        let most = most_digits.min(Numeral::MOST_DIGITS);
        let bytes = text.as_bytes();
        let (negative, mut rest) = match bytes {
            [b'-', rest @ ..] => (true, rest),
            [b'+', rest @ ..] => (false, rest),
            _ => (false, bytes),
        };
        let mut small = 0i64;
        let mut fits = true;
        let mut digits = 0usize;
        let mut point: Option<usize> = None;
        let body = rest;
        while let [byte, tail @ ..] = rest {
            match byte {
                b'0'..=b'9' => {
                    digits += 1;
                    match small.checked_mul(10).and_then(|m| m.checked_add((byte - b'0').into())) {
                        Some(m) if fits => small = m,
                        _ => fits = false,
                    }
                }
                b'.' if point.is_none() => point = Some(digits),
                _ => break,
            }
            rest = tail;
        }
        let body = &body[..body.len() - rest.len()];
        if digits == 0 {
            return Err(NumeralError::Syntax);
        }
        if digits > most {
            return Err(NumeralError::TooManyDigits(most));
        }
        let mut exponent = match rest {
            [] => 0,
            [b'e' | b'E', power @ ..] => parse_exponent(power, most)?,
            _ => return Err(NumeralError::Syntax),
        };
        exponent -= (digits - point.unwrap_or(digits)) as i32;
        let mantissa = if fits {
            Mantissa::Small(if negative { -small } else { small })
        } else {
            let digits: Vec<u8> = body.iter().filter(|b| **b != b'.').copied().collect();
            let size = BigInt::parse_bytes(&digits, 10).ok_or(NumeralError::Syntax)?;
            Mantissa::Big(Box::new(if negative { -size } else { size }))
        };
        Ok(Numeral { mantissa, exponent, base: Base::Ten })
    }
}

fn parse_exponent(text: &[u8], most: usize) -> Result<i32, NumeralError> {
    let (negative, digits) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    };
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return Err(NumeralError::Syntax);
    }
    let size = digits.iter().try_fold(0i32, |n, d| {
        // Both fit: at most `MOST_DIGITS` so far.
        let n = n * 10 + i32::from(d - b'0');
        (n as usize <= most).then_some(n).ok_or(NumeralError::ExponentTooLarge(most))
    })?;
    Ok(if negative { -size } else { size })
}
