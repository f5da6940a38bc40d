//! Directions of the plane as Gaussian integers of few bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use num_bigint::BigInt;

use crate::scalar::{Rational, RationalField, Ring};
use crate::space::Vector2;

/// The longest coordinate of a direction, so that products of four fit 128 bits.
const MOST: i64 = 1 << 30;

/// A complex number with whole coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Gaussian {
    pub re: i128,
    pub im: i128,
}

impl Gaussian {
    pub const ONE: Gaussian = Gaussian { re: 1, im: 0 };

    /// A direction of few bits within a tolerance of an angle, both modulo π. `None` if they are no
    /// numbers, or if it takes more than 30 bits.
    pub fn near(angle: f64, tolerance: f64) -> Option<Gaussian> {
        let angle = angle.rem_euclid(PI);
        // Turned and reflected to be between 0 and π/4.
        let turned = angle >= FRAC_PI_2;
        let angle = if turned { angle - FRAC_PI_2 } else { angle };
        let reflected = angle > FRAC_PI_4;
        let angle = if reflected { FRAC_PI_2 - angle } else { angle };
        let low = (angle - tolerance).max(-FRAC_PI_4).tan();
        let high = (angle + tolerance).min(FRAC_PI_4).tan();
        let (p, q) = if low <= 0.0 { (0, 1) } else { simplest(low, high)? };
        let (p, q) = (i128::from(p), i128::from(q));
        let (re, im) = if reflected { (p, q) } else { (q, p) };
        Some(if turned { Gaussian { re: -im, im: re } } else { Gaussian { re, im } })
    }

    pub fn angle(self) -> f64 {
        (self.im as f64).atan2(self.re as f64)
    }

    pub fn length(self) -> f64 {
        (self.re as f64).hypot(self.im as f64)
    }

    /// `|z|²`.
    pub fn norm(self) -> i128 {
        self.re * self.re + self.im * self.im
    }

    pub fn conjugate(self) -> Gaussian {
        Gaussian { re: self.re, im: -self.im }
    }

    pub fn times(self, other: Gaussian) -> Gaussian {
        Gaussian {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }

    pub fn vector(self) -> Vector2<Rational> {
        Vector2 { x: whole(self.re), y: whole(self.im) }
    }
}

/// The integer as a fraction.
pub(super) fn whole(n: i128) -> Rational {
    // 1 is not 0.
    Rational::from_fraction(n.into(), BigInt::from(1)).unwrap_or_else(Rational::zero)
}

/// The fraction with the least denominator between two positive numbers; by continued fractions.
fn simplest(mut low: f64, mut high: f64) -> Option<(i64, i64)> {
    // The last two convergents.
    let ([mut p, mut q], [mut r, mut s]) = ([1i64, 0i64], [0i64, 1i64]);
    loop {
        let floor = low.floor();
        if floor.is_nan() || floor >= MOST as f64 {
            return None;
        }
        let is_last = floor == low || floor + 1.0 <= high;
        let term = floor as i64 + i64::from(is_last && floor != low);
        ([p, q], [r, s]) = ([term.checked_mul(p)? + r, term.checked_mul(q)? + s], [p, q]);
        if p > MOST || q > MOST {
            return None;
        }
        if is_last {
            return Some((p, q));
        }
        (low, high) = (1.0 / (high - floor), 1.0 / (low - floor));
    }
}
