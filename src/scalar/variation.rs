//! How far a formula can move while its arguments move within a box.

use super::ball::Ball;
use super::ring::ring_operators;
use super::{Midpoint, Numeral, Rational, Ring};

/// The value of a formula at the centre of a box, and a bound of its change within the box.
///
/// The change is bounded from the *exact* value at the centre, which `centre` only encloses: so
/// rounding in `f64` hardly widens `spread`, and together with the exact value at the centre the
/// enclosure is as tight for 17 printed digits as for 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation {
    /// Encloses the value at the centre of the box.
    pub centre: Ball<f64>,
    /// At most this far from it are the values in the box.
    pub spread: f64,
}

impl Variation {
    /// The box that a printed number stands for.
    pub fn of(numeral: &Numeral) -> Self {
        let centre = Ball::around(&numeral.value::<Rational>());
        Variation { centre, spread: numeral.half_unit_f64() }
    }

    /// The ball of all values in the box.
    pub fn enclosure(&self) -> Ball<f64> {
        Ball { mid: self.centre.mid, radius: up(self.centre.radius + self.spread) }
    }

    fn size(&self) -> f64 {
        self.centre.bound()
    }
}

fn up(x: f64) -> f64 {
    f64::outward(x, &0.0)
}

fn add(a: &Variation, b: &Variation) -> Variation {
    Variation { centre: a.centre + b.centre, spread: up(a.spread + b.spread) }
}

fn subtract(a: &Variation, b: &Variation) -> Variation {
    Variation { centre: a.centre - b.centre, spread: up(a.spread + b.spread) }
}

fn multiply(a: &Variation, b: &Variation) -> Variation {
    let spread = (a.size() + a.spread) * b.spread + b.size() * a.spread;
    Variation { centre: a.centre * b.centre, spread: up(spread) }
}

ring_operators!([] Variation, add, subtract, multiply, |a: &Variation| Variation {
    centre: -a.centre,
    spread: a.spread
});

impl Ring for Variation {
    const EXACT: bool = false;

    fn from_i64(n: i64) -> Self {
        Variation { centre: Ball::from_i64(n), spread: 0.0 }
    }
}
