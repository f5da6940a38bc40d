//! The places to triangulate: sorted, so that nothing depends on the order of the input.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::NoTriangulation;
use crate::check::{Decide, Decider, Residual};
use crate::mesh::VertexId;
use crate::scalar::{Approx, Ball, BigInt, Midpoint, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::Point;

/// Top views in lexicographic order; their numbers in that order are their *ranks*.
pub(super) struct Sites {
    /// The index in the input by rank.
    pub order: Vec<u32>,
    /// The top views by rank, at height 0.
    exact: Vec<Point<Rational>>,
    /// The same, moved and scaled into the unit square by a similarity, and rounded once.
    near: Vec<[f64; 2]>,
}

impl Sites {
    /// Sorts the top views of the points.
    pub fn new(points: &[Point<Rational>]) -> Result<Sites, NoTriangulation> {
        if u32::try_from(points.len()).is_err() {
            return Err(NoTriangulation::TooMany);
        }
        let found = points.len();
        let ranges = (range(points, |p| &p.x), range(points, |p| &p.y));
        let (Some((left, right)), Some((bottom, top))) = ranges else {
            return Err(NoTriangulation::TooFew { found });
        };
        let scale = scale_below_one(&(right - &left), &(top - &bottom));
        let round = |c: &Rational, low: &Rational| ((c - low) * &scale).to_f64();
        let all: Vec<[f64; 2]> =
            points.par_iter().map(|p| [round(&p.x, &left), round(&p.y, &bottom)]).collect();
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        // Rounding is monotone, so exact numbers are compared only where rounded ones are equal.
        let compare = |a: u32, b: u32| -> Ordering {
            let (p, q) = (&points[a as usize], &points[b as usize]);
            let (near_p, near_q) = (&all[a as usize], &all[b as usize]);
            let by = |i: usize, u: &Rational, v: &Rational| {
                let rounded = near_p[i].total_cmp(&near_q[i]);
                rounded.then_with(|| u.partial_cmp(v).unwrap_or(Ordering::Equal))
            };
            by(0, &p.x, &q.x).then_with(|| by(1, &p.y, &q.y))
        };
        order.par_sort_unstable_by(|&a, &b| compare(a, b));
        if let Some(pair) = order.windows(2).find(|w| compare(w[0], w[1]).is_eq()) {
            let (a, b) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
            return Err(NoTriangulation::SameTopView(VertexId(a), VertexId(b)));
        }
        if found < 3 {
            return Err(NoTriangulation::TooFew { found });
        }
        let flat = |&i: &u32| {
            let p = &points[i as usize];
            Point::new(p.x.clone(), p.y.clone(), Rational::zero())
        };
        let exact = order.par_iter().map(flat).collect();
        let near = order.iter().map(|&i| all[i as usize]).collect();
        Ok(Sites { order, exact, near })
    }

    /// The rounded places by rank, between 0 and 1.
    pub fn near(&self) -> &[[f64; 2]] {
        &self.near
    }

    /// The signs of polynomials at the places.
    pub fn signs(&self) -> Signs<'_> {
        Signs { near: &self.near, decider: Decider::of_rationals(&self.exact) }
    }
}

/// Exact signs: from the rounded places where these suffice, which is nearly always, else from the
/// decider of the crate.
pub(super) struct Signs<'a> {
    near: &'a [[f64; 2]],
    decider: Decider<'a>,
}

impl Signs<'_> {
    /// The sign of a residual in the top view that no similarity changes.
    #[inline]
    pub fn sign<const K: usize>(&self, residual: impl Residual<K>, at: [u32; K]) -> Sign {
        let ball = |mid: f64| Ball { mid, radius: f64::outward(0.0, &mid) };
        let points = at.map(|v| {
            let [x, y] = self.near[v as usize];
            Point::new(ball(x), ball(y), Ball::zero())
        });
        let rounded = residual.eval(&points, &Ball::one()).certain_sign();
        rounded.unwrap_or_else(|| self.decider.sign(residual, at.map(VertexId)).0)
    }
}

/// The least and the greatest value of a coordinate.
fn range(
    points: &[Point<Rational>],
    coordinate: impl Fn(&Point<Rational>) -> &Rational + Sync,
) -> Option<(Rational, Rational)> {
    let mut values = points.iter().map(coordinate);
    let first = values.next()?;
    let (low, high) = values.fold((first, first), |(low, high), c| {
        (if c < low { c } else { low }, if c > high { c } else { high })
    });
    Some((low.clone(), high.clone()))
}

/// A power of two that brings both sizes below 1, and not far below.
fn scale_below_one(width: &Rational, height: &Rational) -> Rational {
    let size = if width > height { width } else { height };
    let (p, q) = (size.numerator().bits(), size.denominator().bits());
    // 2^(p − 1) ≤ numerator < 2^p, and the same for the denominator.
    let scale = Rational::from_fraction(BigInt::one() << q, BigInt::one() << (p + 1));
    scale.unwrap_or_else(Rational::one)
}
