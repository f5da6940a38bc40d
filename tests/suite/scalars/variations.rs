//! Boxes: no point of a box escapes the spread of a formula, measured from its exact centre.

use isogeo::scalar::{Ball, BigRational, Field, Ordered, Ring, Variation};
use proptest::prelude::*;

use super::balls::contains;
use super::expression::{VARIABLES, polynomials};
use super::laws::{holds, that};

/// A box with integer centre and dyadic half-width, and a point of it.
fn boxes() -> impl Strategy<Value = [(i64, u32, i64); VARIABLES]> + Clone {
    let side = (-999i64..=999, 0u32..40, -64i64..=64);
    [side.clone(), side.clone(), side.clone(), side]
}

#[test]
fn every_point_of_a_box_stays_within_the_spread() -> Result<(), String> {
    holds((polynomials(4), boxes()), |(formula, sides)| {
        let exact = |(centre, width, t): (i64, u32, i64)| {
            let half = BigRational::from_ratio(1, 1 << width);
            let centre = BigRational::from_i64(centre);
            (centre.clone(), centre + half * BigRational::from_ratio(t, 64))
        };
        let centre = sides.map(|side| exact(side).0);
        let point = sides.map(|side| exact(side).1);
        let variation = formula.polynomial(&sides.map(|(centre, width, _)| Variation {
            spread: 2f64.powi(-(width as i32)),
            ..Variation::from_i64(centre)
        }));
        let (centre, point) = (formula.polynomial(&centre), formula.polynomial(&point));
        that("the centre", contains(&variation.centre, &centre))?;
        that("the box", contains(&variation.enclosure(), &point))?;
        let spread = Ball { mid: 0.0, radius: variation.spread };
        that("the spread", contains(&spread, &(&point - &centre).magnitude()))
    })
}

#[test]
fn a_spread_that_forgets_the_second_order_is_caught() {
    // (1 ± 1)² reaches 4, three above its centre; the first order alone would say two.
    let x = Variation { spread: 1.0, ..Variation::from_i64(1) };
    let square = x * x;
    assert!(square.spread >= 3.0 && square.spread < 3.0 + 1e-9);
}
