//! Pairs of doubles: rounding within the proved bounds, and enclosures over them.

use isogeo::scalar::{Ball, BigRational, DoubleDouble, Numeral, Ordered, Ring};
use proptest::prelude::*;

use super::expression::{VARIABLES, polynomials};
use super::laws::{equal, holds, that};

fn exact(x: f64) -> BigRational {
    Numeral::from_f64(x).expect("finite").value()
}

/// What a pair stands for: its high part, and what is left without it.
fn value(pair: &DoubleDouble) -> BigRational {
    let low = *pair - DoubleDouble::from(pair.high());
    exact(pair.high()) + exact(low.high())
}

/// Sums of two doubles whose exponents differ by up to 110.
fn pairs() -> impl Strategy<Value = (f64, f64)> + Clone {
    let part = |low: i32, high: i32| {
        (-1.0..=1.0f64, low..high).prop_map(|(x, exponent)| x * 2f64.powi(exponent))
    };
    (part(-40, 40), part(-110, 40))
}

#[test]
fn a_sum_of_two_doubles_is_exact() -> Result<(), String> {
    holds(pairs(), |(a, b)| {
        let pair = DoubleDouble::sum(a, b);
        equal("a + b", value(&pair), exact(a) + exact(b))?;
        equal("the nearest double", pair.high(), a + b)?;
        that("not above", exact(pair.above()) >= value(&pair))
    })
}

#[test]
fn operations_round_as_was_proved() -> Result<(), String> {
    // 8 u² with u = 2^-53.
    let bound = |x: &BigRational| x.magnitude() * exact(2.0 * f64::EPSILON * f64::EPSILON);
    holds((pairs(), pairs()), |((a, b), (c, d))| {
        let (p, q) = (DoubleDouble::sum(a, b), DoubleDouble::sum(c, d));
        let (x, y) = (value(&p), value(&q));
        for (name, rounded, exact) in [
            ("p + q", p + q, &x + &y),
            ("p - q", p - q, &x - &y),
            ("p q", p * q, &x * &y),
            ("-p", -p, -&x),
        ] {
            that(name, (value(&rounded) - &exact).magnitude() <= bound(&exact))?;
        }
        equal("the order", p.partial_cmp(&q), x.partial_cmp(&y))?;
        equal("the sign", p.certain_sign(), x.certain_sign())
    })
}

#[test]
fn integers_are_themselves() -> Result<(), String> {
    holds(any::<i64>(), |n| equal("n", value(&DoubleDouble::from_i64(n)), BigRational::from_i64(n)))
}

#[test]
fn balls_over_pairs_enclose() -> Result<(), String> {
    let points = [pairs(), pairs(), pairs(), pairs()];
    holds((polynomials(3), points), |(formula, points): (_, [(f64, f64); VARIABLES])| {
        let pair = |(a, b)| DoubleDouble::sum(a, b);
        let sharp = |p| Ball::new(pair(p), DoubleDouble::from(0.0));
        let ball = formula.polynomial(&points.map(sharp));
        let exact = formula.polynomial(&points.map(|p| value(&pair(p))));
        let distance = (value(&ball.mid) - &exact).magnitude();
        that("it is in the ball", distance <= value(&ball.radius))?;
        that("it is below the bound", exact.magnitude() <= value(&ball.bound()))
    })
}

/// In doubles 1 + 2^-70 is 1, and the difference was 0.
#[test]
fn what_doubles_lose_is_kept() {
    let tiny = 2f64.powi(-70);
    let one = DoubleDouble::sum(1.0, tiny);
    let square = one * one - DoubleDouble::from(1.0);
    assert!((square.high() - 2.0 * tiny).abs() < tiny * tiny * 2.0);
    let ball = Ball::new(one, DoubleDouble::from(0.0));
    assert!((ball - Ball::one()).excludes_zero());
    assert!(!(Ball::new(1.0 + tiny, 0.0) - Ball::one()).excludes_zero());
}
