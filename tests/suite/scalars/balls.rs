//! Enclosures: nothing escapes a ball.

use isogeo::scalar::{Ball, BigInt, BigRational, Field, Numeral, Ordered, Ring, Sign};
use proptest::prelude::*;

use super::laws::{equal, holds, that};
use super::samples::small_fractions;

/// Whether a number lies in a ball, decided exactly; a ball that is "anything" contains all.
pub fn contains(ball: &Ball<f64>, x: &BigRational) -> bool {
    match (exact(ball.mid), exact(ball.radius)) {
        (Some(mid), Some(radius)) => (x - mid).magnitude() <= radius,
        _ => true,
    }
}

fn exact(x: f64) -> Option<BigRational> {
    Some(Numeral::from_f64(x)?.value())
}

/// Finite doubles of every size, subnormal ones among them.
fn doubles() -> impl Strategy<Value = f64> + Clone {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE, -1e3..1e3, Just(f64::MIN_POSITIVE)]
}

/// A ball and a point of it.
fn pointed_balls() -> impl Strategy<Value = (Ball<f64>, f64)> + Clone {
    (doubles(), doubles(), -1.0..=1.0f64).prop_filter_map("in the ball", |(mid, radius, t)| {
        let ball = Ball::new(mid, radius.abs());
        let point = mid + t * radius;
        (point.is_finite() && contains(&ball, &exact(point)?)).then_some((ball, point))
    })
}

#[test]
fn every_operation_encloses() -> Result<(), String> {
    holds((pointed_balls(), pointed_balls()), |((a, x), (b, y))| {
        let (x, y) = (Numeral::from_f64(x), Numeral::from_f64(y));
        let (Some(x), Some(y)) = (x, y) else { return Ok(()) };
        let (x, y): (BigRational, BigRational) = (x.value(), y.value());
        that("a + b", contains(&(a + b), &(&x + &y)))?;
        that("a - b", contains(&(a - b), &(&x - &y)))?;
        that("a b", contains(&(a * b), &(&x * &y)))?;
        that("-a", contains(&-&a, &-&x))?;
        that("a²", contains(&a.square(), &x.square()))?;
        that("|a|", contains(&a.magnitude(), &x.magnitude()))?;
        that("|a| <= bound", exact(a.bound()).is_none_or(|bound| x.magnitude() <= bound))?;
        let det = Ball::det2(&a, &b, &b, &a);
        that("det2", contains(&det, &BigRational::det2(&x, &y, &y, &x)))?;
        for (sign, true_sign) in [
            (a.certain_sign(), x.certain_sign()),
            ((a - b).certain_sign(), (&x - &y).certain_sign()),
            ((a * b).certain_sign(), (&x * &y).certain_sign()),
        ] {
            that("a certain sign is true", sign.is_none() || sign == true_sign)?;
        }
        let compared = a.partial_cmp(&b);
        that("the order is true", compared.is_none() || compared == x.partial_cmp(&y))
    })
}

#[test]
fn the_root_encloses() -> Result<(), String> {
    holds(pointed_balls(), |(a, x)| {
        let Some(root) = a.sqrt() else {
            return that("only negative balls have no root", a.mid + a.radius < 0.0);
        };
        let Some(x) = exact(x).filter(|x| *x >= BigRational::zero()) else { return Ok(()) };
        // low <= √x <= high, squared.
        let (Some(mid), Some(radius)) = (exact(root.mid), exact(root.radius)) else {
            return Ok(());
        };
        let (low, high) = (&mid - &radius, &mid + &radius);
        that("√x is not below", low.certain_sign() != Some(Sign::Positive) || low.square() <= x)?;
        that("√x is not above", high.square() >= x)
    })
}

#[test]
fn a_conversion_encloses() -> Result<(), String> {
    let tiny = (small_fractions::<BigRational>(), 900i32..1200)
        .prop_map(|(x, e)| (0..e).fold(x, |x, _| x * BigRational::from_ratio(1, 2)));
    holds(prop_oneof![small_fractions::<BigRational>(), tiny], |x| {
        that("the ball contains it", contains(&Ball::around(&x), &x))
    })
}

#[test]
fn integers_are_single_numbers() -> Result<(), String> {
    holds(any::<i64>(), |n| {
        let (ball, big) = (Ball::<f64>::from_i64(n), BigRational::from_i64(n));
        that("the ball contains it", contains(&ball, &big))?;
        equal("a radius of 0", ball.radius == 0.0, n.unsigned_abs() <= 1 << 53)?;
        equal("an integer ball", Ball::<BigInt>::from_i64(n), Ball::new(n.into(), BigInt::zero()))
    })
}

/// Found: the zero of `Ball<f64>` had a radius, so that it was not zero.
#[test]
fn the_zero_of_the_balls_is_zero() {
    assert!(Ball::<f64>::zero().is_zero());
    assert_eq!(Ball::<f64>::one().certain_sign(), Some(Sign::Positive));
    let two = Ball::<f64>::from_i64(2);
    assert_eq!(two.partial_cmp(&two.clone()), Some(std::cmp::Ordering::Equal));
}

/// Found: the magnitude of a ball that contains 0 was the ball itself, and lost its far end.
#[test]
fn the_magnitude_of_a_ball_about_minus_one_contains_three() {
    let ball = Ball::new(-1.0, 2.0); // −3 is in it
    assert_eq!(ball.magnitude(), Ball::new(1.0, 2.0));
    assert_eq!(Ball::new(BigInt::from(-1), BigInt::from(2)).magnitude().mid, BigInt::from(1));
}

/// Found: a ball that stands for "anything" was said to have no root.
#[test]
fn anything_has_any_root() {
    for ball in [
        Ball { mid: f64::NAN, radius: f64::NAN },
        Ball { mid: f64::NEG_INFINITY, radius: f64::INFINITY },
        Ball { mid: 0.0, radius: f64::INFINITY },
        Ball { mid: 1.0, radius: f64::NAN },
    ] {
        let root = ball.sqrt().expect("it may have one");
        assert!(contains(&root, &BigRational::from_i64(7)), "{ball:?} gave {root:?}");
        assert_eq!(root.certain_sign(), None);
    }
    assert_eq!(Ball::new(-2.0, 1.0).sqrt(), None);
}

/// An overflow is "anything", and stays so.
#[test]
fn an_overflow_is_never_certain() {
    let huge = Ball::new(1e300, 0.0);
    let overflow = huge * huge;
    for ball in [overflow, overflow - overflow, overflow * Ball::zero()] {
        assert_eq!(ball.certain_sign(), None, "{ball:?}");
    }
}
