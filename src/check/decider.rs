//! The decider of the program: exact and fast on the points of a mesh, and over rounding boxes.

use rayon::prelude::*;

use super::integers::Integer;
use super::local::Local;
use super::report::Failure;
use super::residual::{Answer, Decide, Residual, RootSum};
use super::roots::{sign, vanish};
use crate::mesh::{ExactPoints, VertexId};
use crate::scalar::{Ball, Numeral, Ordered, Rational, Ring, Sign, Variation};
use crate::space::Point;

/// Decides residuals exactly, whatever the size of the numbers, in integers as narrow as a bound
/// allows.
///
/// Where one common denominator of all coordinates fits, they are kept as integers over it;
/// otherwise denominators are cleared element by element.
#[derive(Clone, Debug)]
pub struct Decider<'a> {
    store: ExactPoints<'a>,
    /// Half the widths of the boxes about the coordinates, where there are boxes.
    boxes: Option<Vec<Point<f64>>>,
    tolerance: Option<f64>,
}

impl<'a> Decider<'a> {
    /// Decides on numbers taken exactly as they are printed.
    pub fn new(points: &'a [Point<Numeral>]) -> Self {
        Decider { store: points.into(), boxes: None, tolerance: None }
    }

    /// Decides on rational points.
    pub fn of_rationals(points: &'a [Point<Rational>]) -> Self {
        Decider { store: points.into(), boxes: None, tolerance: None }
    }

    /// Decides on the boxes that printed numbers stand for: half a unit of the last digit about
    /// each.
    pub fn over_boxes(points: &'a [Point<Numeral>]) -> Self {
        let boxes = points.par_iter().map(|p| p.map(Numeral::half_unit_f64)).collect();
        Decider { boxes: Some(boxes), ..Decider::new(points) }
    }

    /// Decides on these points followed by those of another decider, each in its own reading: for
    /// pairs of meshes. The tolerance is that of the first.
    ///
    /// ```
    /// use isogeo::check::{Answer, Decide, Decider};
    /// use isogeo::mesh::VertexId;
    /// use isogeo::net::planar::Difference;
    /// use isogeo::scalar::{Field, Numeral, Rational};
    /// use isogeo::space::Point;
    /// let third = [Point::new(1, 0, 0).map(|&n| Rational::from_ratio(n, 3))];
    /// let printed = [Point::new("0.33", "0", "0").map(|c| c.parse().unwrap_or(Numeral::from_i64(0)))];
    /// let both = Decider::of_rationals(&third).followed_by(Decider::over_boxes(&printed));
    /// assert_eq!(both.decide(Difference(0), [VertexId(0), VertexId(1)]), Answer::InBox);
    /// ```
    pub fn followed_by(self, other: Decider<'a>) -> Self {
        let counts = [self.store.len(), other.store.len()];
        let boxes = if self.boxes.is_none() && other.boxes.is_none() {
            None
        } else {
            let sharp = |n| vec![Point::new(0.0, 0.0, 0.0); n];
            let mut boxes = self.boxes.unwrap_or_else(|| sharp(counts[0]));
            boxes.extend(other.boxes.unwrap_or_else(|| sharp(counts[1])));
            Some(boxes)
        };
        Decider { store: self.store.followed_by(other.store), boxes, tolerance: self.tolerance }
    }

    /// Counts what is within `tolerance` of zero, in proportion to its scale, as near.
    pub fn within(mut self, tolerance: Option<f64>) -> Self {
        self.tolerance = tolerance;
        self
    }
}

/// Runs the same expression on either kind of integers.
macro_rules! either {
    ($local:expr, $cleared:ident => $value:expr) => {
        match $local {
            Local::Small($cleared) => $value,
            Local::Big($cleared) => $value,
        }
    };
}

impl Decider<'_> {
    /// The boxes, if some point of the element is not known exactly.
    fn boxes_at<const K: usize>(&self, places: &[[VertexId; K]]) -> Option<&[Point<f64>]> {
        let boxes = self.boxes.as_deref()?;
        let wide = |v: &VertexId| boxes[v.index()].coordinates().into_iter().any(|&h| h > 0.0);
        places.iter().flatten().any(wide).then_some(boxes)
    }

    /// Whether 0 lies outside of what the residual can be within the boxes.
    fn excluded<const K: usize, R: Residual<K>>(
        &self,
        boxes: &[Point<f64>],
        residual: R,
        places: &[[VertexId; K]],
        local: &Local<K>,
    ) -> bool {
        let block = R::TRANSLATES.then_some(R::BLOCK);
        let spread = |points: &[Point<Ball<f64>>; K], unit, at| {
            let (points, unit) = variations(boxes, at, points, unit, block);
            residual.eval(&points, &unit)
        };
        let sum = either!(local, c => {
            let unit = c.unit.ball();
            let balls = c.places().map(|place| place.each_ref().map(|p| p.map(Integer::ball)));
            let terms = balls.zip(places).map(|(points, at)| spread(&points, unit, at));
            terms.fold(Variation::zero(), |sum, term| sum + term)
        });
        let value = either!(local, c => c.value(residual));
        value.abs() * (1.0 - 8.0 * f64::EPSILON) > sum.spread
    }

    fn near(&self, failure: impl FnOnce() -> Failure<Rational>) -> Answer {
        match self.tolerance {
            Some(tolerance) if failure().defect <= tolerance => Answer::Near,
            _ => Answer::Nonzero,
        }
    }
}

impl Decide for Decider<'_> {
    type Value = Rational;

    #[inline]
    fn decide_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> Answer {
        match self.sign_of_sum(residual, places) {
            (Sign::Zero, _) => Answer::Zero,
            (_, false) => Answer::InBox,
            (_, true) if self.tolerance.is_none() => Answer::Nonzero,
            (_, true) => self.near(|| self.failure_of_sum("", residual, places, false)),
        }
    }

    #[inline]
    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        self.sign_of(residual, places)
    }

    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Answer {
        let [answer] = self.decide_each_roots([sum], at);
        answer
    }

    /// Denominators are cleared once.
    fn decide_each_roots<const K: usize, const TERMS: usize, const N: usize>(
        &self,
        sums: [impl RootSum<K, TERMS>; N],
        at: [VertexId; K],
    ) -> [Answer; N] {
        let local = self.store.local(&at, &[], Some(K));
        let balls = either!(&local, c => c.scaled());
        sums.map(|sum| {
            if !enclose(&sum.eval(&balls)).excludes_zero() {
                let (integers, _) = either!(&local, c => c.over(Integer::big));
                if vanish(&sum.eval(&integers)) == Some(true) {
                    return Answer::Zero;
                }
            }
            if self.roots_in_box(sum, &at, &local).is_some_and(|ball| !ball.excludes_zero()) {
                return Answer::InBox;
            }
            self.near(|| self.root_failure("", sum, at))
        })
    }

    fn sign_of_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> (Sign, bool) {
        let local = self.store.local(&at, &[], Some(K));
        let balls = either!(&local, c => c.scaled());
        let found = enclose(&sum.eval(&balls)).certain_sign().or_else(|| {
            let (integers, _) = either!(&local, c => c.over(Integer::big));
            sign(&sum.eval(&integers))
        });
        let within = self.roots_in_box(sum, &at, &local);
        let certain = within.is_none_or(|ball| ball.excludes_zero());
        (found.unwrap_or(Sign::Zero), certain && found.is_some())
    }

    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        self.store.same_top_view(a, b)
    }

    fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        self.store.same_point(a, b)
    }

    fn failure_of_sum<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
        exact: bool,
    ) -> Failure<Rational> {
        self.failure_of(condition, residual, places, exact)
    }

    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Failure<Rational> {
        let local = self.store.local(&at, &[], Some(K));
        let defect = either!(&local, c => c.root_defect(sum));
        Failure { condition, defect, residual: None }
    }
}

impl Decider<'_> {
    /// What the sum of roots can be within the boxes, if there are boxes.
    fn roots_in_box<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: &[VertexId; K],
        local: &Local<K>,
    ) -> Option<Ball<f64>> {
        let boxes = self.boxes_at(&[*at])?;
        let (centres, unit) = either!(local, c => c.over(Integer::ball));
        let (points, _) = variations(boxes, at, &centres, unit, Some(K));
        Some(enclose(&sum.eval(&points.map(|p| p.map(Variation::enclosure)))))
    }

    #[inline]
    fn sign_of<const K: usize, R: Residual<K>>(
        &self,
        residual: R,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        let Some((first, more)) = places.split_first() else {
            return (Sign::Zero, true);
        };
        let local = self.store.local(first, more, R::TRANSLATES.then_some(R::BLOCK));
        let sign = either!(&local, c => c.sign(residual));
        let boxes = self.boxes_at(places);
        let certain = boxes.is_none_or(|boxes| self.excluded(boxes, residual, places, &local));
        (sign, certain)
    }

    fn failure_of<const K: usize, R: Residual<K>>(
        &self,
        condition: &'static str,
        residual: R,
        places: &[[VertexId; K]],
        exact: bool,
    ) -> Failure<Rational> {
        let value =
            |at: &[VertexId; K]| residual.eval(&at.map(|v| self.store.point(v)), &Rational::one());
        let sum = || places.iter().map(value).fold(Rational::zero(), |sum, value| sum + value);
        let defect = places.split_first().map_or(0.0, |(first, more)| {
            let local = self.store.local(first, more, R::TRANSLATES.then_some(R::BLOCK));
            either!(&local, c => c.defect(residual))
        });
        Failure { condition, defect, residual: exact.then(sum) }
    }
}

/// The boxes about the points of an element at one place, over the common denominator `unit`.
fn variations<const K: usize>(
    boxes: &[Point<f64>],
    at: &[VertexId; K],
    centres: &[Point<Ball<f64>>; K],
    unit: Ball<f64>,
    block: Option<usize>,
) -> ([Point<Variation>; K], Variation) {
    let half = at.map(|v| &boxes[v.index()]);
    let length = unit.bound() * (1.0 + 4.0 * f64::EPSILON);
    let points = std::array::from_fn(|i| {
        let first = block.map(|block| i - i % block);
        // The first of a block is exact, and every difference from it takes up both boxes.
        let spread = |own: f64, origin: f64| match first {
            Some(first) if first == i => 0.0,
            Some(_) => (own + origin) * length * (1.0 + 4.0 * f64::EPSILON),
            None => own * length * (1.0 + 4.0 * f64::EPSILON),
        };
        let (p, h, o) = (&centres[i], half[i], half[first.unwrap_or(0)]);
        let widened =
            |&centre: &Ball<f64>, own, origin| Variation { centre, spread: spread(own, origin) };
        Point::new(widened(&p.x, h.x, o.x), widened(&p.y, h.y, o.y), widened(&p.z, h.z, o.z))
    });
    (points, Variation { centre: unit, spread: 0.0 })
}

/// The enclosure of `Σ cᵢ √qᵢ`; everything, if a `qᵢ` is certainly negative.
fn enclose(terms: &[(Ball<f64>, Ball<f64>)]) -> Ball<f64> {
    let anything = Ball { mid: 0.0, radius: f64::INFINITY };
    let term = |(c, q): &(Ball<f64>, Ball<f64>)| q.sqrt().map_or(anything, |root| *c * root);
    terms.iter().map(term).fold(Ball::zero(), |sum, t| sum + t)
}
