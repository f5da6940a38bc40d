//! Doubles rounded to dyadic fractions, as the rational numbers that they are.

use crate::scalar::{Numeral, Rational, Ring};
use crate::space::Point;

/// The double as a fraction; `None` if it is not finite.
pub(super) fn exact(x: f64) -> Option<Rational> {
    Some(Numeral::from_f64(x)?.value())
}

/// The double as a fraction; 0 if it is not finite.
pub(super) fn finite(x: f64) -> Rational {
    exact(x).unwrap_or_else(Rational::zero)
}

/// The multiple of `2^−bits` nearest to `x`; `None` if it is not finite.
pub(super) fn rounded(x: f64, bits: i32) -> Option<Rational> {
    let scale = 2f64.powi(bits);
    exact((x * scale).round() / scale)
}

/// The largest e with `2^e ≤ |x|`, within the range of doubles.
pub(super) fn exponent(x: f64) -> i32 {
    x.abs().log2().floor().clamp(-1000.0, 1000.0) as i32
}

/// The point with each coordinate rounded.
pub(super) fn rounded_point(p: &Point<f64>, bits: i32) -> Option<Point<Rational>> {
    Some(Point { x: rounded(p.x, bits)?, y: rounded(p.y, bits)?, z: rounded(p.z, bits)? })
}
