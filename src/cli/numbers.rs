//! Numbers in options, exactly.

use super::failure::Failure;
use crate::mesh::file::parse_fraction;
use crate::scalar::{Numeral, Rational};

/// As many numbers as there are places: integers, decimals or fractions.
pub fn numbers<const N: usize>(option: &str, text: &str) -> Result<[Rational; N], Failure> {
    let number = |part: &str| {
        let decimal = part.parse::<Numeral>().ok().map(|n| n.value());
        decimal.or_else(|| parse_fraction(part).ok())
    };
    let numbers: Option<Vec<Rational>> = text.split(',').map(|p| number(p.trim())).collect();
    numbers.and_then(|n| n.try_into().ok()).ok_or_else(|| {
        let asked = match N {
            1 => "one number".to_owned(),
            _ => format!("{N} numbers separated by commas"),
        };
        Failure::with_help(
            format!("{option} takes {asked}, not '{text}'"),
            "a number is an integer, a decimal or a fraction such as -3/5",
        )
    })
}
