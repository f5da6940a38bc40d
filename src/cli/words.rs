//! Counts and numbers in sentences for people.

#[cfg(feature = "optimise")]
use crate::scalar::Numeral;
use crate::scalar::{Approx, Rational, Ring};

/// A count with its noun: "1 face", "2 faces".
pub fn count(n: usize, noun: &str) -> String {
    match n {
        1 => format!("1 {noun}"),
        _ => format!("{n} {noun}s"),
    }
}

/// "1 vertex", "2 vertices".
pub fn vertices(n: usize) -> String {
    match n {
        1 => "1 vertex".into(),
        _ => format!("{n} vertices"),
    }
}

/// An exact number if it is short, else its size and where to find all of it.
pub fn exact(number: &Rational) -> String {
    const MOST: usize = 48;
    let text = number.to_string();
    if text.len() <= MOST {
        return text;
    }
    let how = format!("{} characters, see --format json", text.len());
    match number.to_f64() {
        x if x.is_normal() => format!("≈ {x:.6e} (exact: {how})"),
        _ => format!("{}... ({how})", &text[..MOST / 2]),
    }
}

/// A coordinate as a double, or as it is where doubles end.
pub fn coordinate(number: &Rational) -> String {
    match number.to_f64() {
        x if x.is_normal() || number.is_zero() => x.to_string(),
        _ => exact(number),
    }
}

/// An exact number in two decimal digits if they are all it has, else as it is.
#[cfg(feature = "optimise")]
pub fn radius(number: &Rational) -> String {
    let short = format!("{:.1e}", number.to_f64());
    let value = short.parse::<Numeral>().map(|short| short.value::<Rational>());
    if value.is_ok_and(|value| value == *number) { short } else { exact(number) }
}

/// A size relative to its scale.
pub fn defect(size: f64) -> String {
    if size < 0.01 { format!("{size:.1e}") } else { format!("{size:.2}") }
}
