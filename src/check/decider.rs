//! The decider of the program: exact and fast on the points of a mesh, and over rounding boxes.

use num_bigint::BigInt;
use num_integer::Integer as _;

use super::integers::{Cleared, Integer};
use super::report::Failure;
use super::residual::{Answer, Decide, Residual, RootSum};
use super::roots::vanish;
use crate::mesh::VertexId;
use crate::scalar::{Ball, Base, Numeral, Ordered, Rational, RationalField, Ring, Sign, Variation};
use crate::space::Point;

/// Decides residuals exactly, whatever the size of the numbers, in integers as narrow as a bound
/// allows.
///
/// Where one common denominator of all coordinates fits, they are kept as integers over it;
/// otherwise denominators are cleared element by element.
#[derive(Clone, Debug)]
pub struct Decider<'a> {
    store: Store<'a>,
    boxes: Option<&'a [Point<Numeral>]>,
    tolerance: Option<f64>,
}

#[derive(Clone, Debug)]
enum Store<'a> {
    /// Integers over one common denominator `unit`; all have at most 126 bits.
    Lattice {
        points: Vec<Point<i128>>,
        unit: i128,
    },
    Rationals(std::borrow::Cow<'a, [Point<Rational>]>),
}

/// Coordinates and the common denominator stay below this, so that differences do not overflow.
const LATTICE_LIMIT: i128 = 1 << 125;

impl<'a> Decider<'a> {
    /// Decides on numbers taken exactly as they are printed.
    pub fn new(points: &'a [Point<Numeral>]) -> Self {
        let store = lattice_of_numerals(points).unwrap_or_else(|| {
            Store::Rationals(points.iter().map(|p| p.map(Numeral::value)).collect())
        });
        Decider { store, boxes: None, tolerance: None }
    }

    /// Decides on rational points.
    pub fn of_rationals(points: &'a [Point<Rational>]) -> Self {
        let store = lattice_of_rationals(points).unwrap_or(Store::Rationals(points.into()));
        Decider { store, boxes: None, tolerance: None }
    }

    /// Decides on the boxes that printed numbers stand for: half a unit of the last digit about
    /// each.
    pub fn over_boxes(points: &'a [Point<Numeral>]) -> Self {
        Decider { boxes: Some(points), ..Decider::new(points) }
    }

    /// Counts what is within `tolerance` of zero, in proportion to its scale, as near.
    pub fn within(mut self, tolerance: Option<f64>) -> Self {
        self.tolerance = tolerance;
        self
    }
}

/// The points of one element, cleared.
enum Local<const K: usize> {
    Small(Cleared<i128, K>),
    Big(Cleared<BigInt, K>),
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
    #[inline]
    fn local<const K: usize>(&self, at: [VertexId; K], translates: bool) -> Local<K> {
        let local = match &self.store {
            Store::Lattice { points, unit } => {
                Local::Small(Cleared { points: at.map(|v| points[v.index()]), unit: *unit })
            }
            Store::Rationals(points) => clear(at.map(|v| &points[v.index()])),
        };
        if !translates {
            return local;
        }
        match local {
            Local::Small(cleared) => Local::Small(cleared.translated()),
            Local::Big(cleared) => Local::Big(cleared.translated()),
        }
    }

    /// The points of the element as rational numbers.
    fn exact<const K: usize>(&self, at: [VertexId; K]) -> [Point<Rational>; K] {
        at.map(|v| match &self.store {
            Store::Lattice { points, unit } => points[v.index()].map(|&c| {
                Rational::from_fraction(c.into(), (*unit).into()).unwrap_or_else(Rational::zero)
            }),
            Store::Rationals(points) => points[v.index()].clone(),
        })
    }

    /// The boxes about the points of the element, in the integers of `local`.
    fn variations<const K: usize>(
        &self,
        boxes: &[Point<Numeral>],
        at: [VertexId; K],
        local: &Local<K>,
        translates: bool,
    ) -> ([Point<Variation>; K], Variation) {
        let exact = |centre| Variation { centre, spread: 0.0 };
        let (centres, unit) = either!(local, c => c.over(|i| exact(i.ball())));
        let half = at.map(|v| boxes[v.index()].map(Numeral::half_unit_f64));
        let length = unit.centre.bound() * (1.0 + 4.0 * f64::EPSILON);
        let points = std::array::from_fn(|i| {
            // The origin is exact, and every difference from it takes up both boxes.
            let spread = |own: f64, origin: f64| match (translates, i) {
                (true, 0) => 0.0,
                (true, _) => (own + origin) * length * (1.0 + 4.0 * f64::EPSILON),
                (false, _) => own * length * (1.0 + 4.0 * f64::EPSILON),
            };
            let (p, h, o) = (&centres[i], &half[i], &half[0]);
            let widened =
                |v: &Variation, own, origin| Variation { spread: spread(own, origin), ..*v };
            Point::new(widened(&p.x, h.x, o.x), widened(&p.y, h.y, o.y), widened(&p.z, h.z, o.z))
        });
        (points, unit)
    }

    /// Whether 0 lies outside of what the residual can be within the boxes.
    fn excluded<const K: usize, R: Residual<K>>(
        &self,
        boxes: &[Point<Numeral>],
        residual: R,
        at: [VertexId; K],
        local: &Local<K>,
    ) -> bool {
        let (points, unit) = self.variations(boxes, at, local, R::TRANSLATES);
        let spread = residual.eval(&points, &unit).spread;
        let value = either!(local, c => c.value(residual));
        value.abs() * (1.0 - 8.0 * f64::EPSILON) > spread
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

    fn decide<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> Answer {
        match self.sign(residual, at) {
            (Sign::Zero, _) => Answer::Zero,
            (_, false) => Answer::InBox,
            (_, true) if self.tolerance.is_none() => Answer::Nonzero,
            (_, true) => self.near(|| self.failure("", residual, at, false)),
        }
    }

    fn sign<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> (Sign, bool) {
        self.sign_of(residual, at)
    }

    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        self.sign_of_sum_of(residual, places)
    }

    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Answer {
        let local = self.local(at, true);
        let (balls, _) = either!(&local, c => c.over(Integer::ball));
        if !enclose(&sum.eval(&balls)).excludes_zero() {
            let (integers, _) = either!(&local, c => c.over(Integer::big));
            if vanish(&sum.eval(&integers)) == Some(true) {
                return Answer::Zero;
            }
        }
        if let Some(boxes) = self.boxes {
            let (points, _) = self.variations(boxes, at, &local, true);
            let widened = points.map(|p| p.map(Variation::enclosure));
            if !enclose(&sum.eval(&widened)).excludes_zero() {
                return Answer::InBox;
            }
        }
        self.near(|| self.root_failure("", sum, at))
    }

    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        match &self.store {
            Store::Lattice { points, .. } => {
                let (p, q) = (&points[a.index()], &points[b.index()]);
                p.x == q.x && p.y == q.y
            }
            Store::Rationals(points) => points[a.index()].is_parallel_to(&points[b.index()]),
        }
    }

    fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        match &self.store {
            Store::Lattice { points, .. } => points[a.index()] == points[b.index()],
            Store::Rationals(points) => points[a.index()] == points[b.index()],
        }
    }

    fn failure<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        at: [VertexId; K],
        exact: bool,
    ) -> Failure<Rational> {
        self.failure_of(condition, residual, at, exact)
    }

    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Failure<Rational> {
        let local = self.local(at, true);
        let defect = either!(&local, c => c.root_defect(sum));
        Failure { condition, defect, residual: None }
    }
}

impl Decider<'_> {
    #[inline]
    fn sign_of<const K: usize, R: Residual<K>>(
        &self,
        residual: R,
        at: [VertexId; K],
    ) -> (Sign, bool) {
        let local = self.local(at, R::TRANSLATES);
        let sign = either!(&local, c => c.sign(residual));
        let certain = self.boxes.is_none_or(|boxes| self.excluded(boxes, residual, at, &local));
        (sign, certain)
    }

    fn sign_of_sum_of<const K: usize, R: Residual<K>>(
        &self,
        residual: R,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        let signs: Vec<_> = places.iter().map(|&at| self.sign_of(residual, at)).collect();
        let has = |sign| signs.iter().any(|&(s, _)| s == sign);
        let sign = match (has(Sign::Positive), has(Sign::Negative)) {
            (false, false) => Sign::Zero,
            (true, false) => Sign::Positive,
            (false, true) => Sign::Negative,
            (true, true) => {
                let value = |&at| residual.eval(&self.exact(at), &Rational::one());
                let sum = places.iter().map(value).fold(Rational::zero(), |sum, v| sum + v);
                sum.certain_sign().unwrap_or(Sign::Zero)
            }
        };
        let certain = self.boxes.is_none_or(|boxes| {
            // Terms that keep one sign in the box have a sum that does; else they are added up.
            signs.iter().all(|&s| s == (sign, true)) || {
                let term = |at: &[VertexId; K]| {
                    let points = at.map(|v| boxes[v.index()].map(Variation::of));
                    residual.eval(&points, &Variation::one()).enclosure()
                };
                places.iter().map(term).fold(Ball::zero(), |sum, t| sum + t).excludes_zero()
            }
        });
        (sign, certain)
    }

    fn failure_of<const K: usize, R: Residual<K>>(
        &self,
        condition: &'static str,
        residual: R,
        at: [VertexId; K],
        exact: bool,
    ) -> Failure<Rational> {
        let local = self.local(at, R::TRANSLATES);
        let defect = either!(&local, c => c.defect(residual));
        let residual = exact.then(|| residual.eval(&self.exact(at), &Rational::one()));
        Failure { condition, defect, residual }
    }
}

/// The enclosure of `Σ cᵢ √qᵢ`; everything, if a `qᵢ` is certainly negative.
fn enclose(terms: &[(Ball<f64>, Ball<f64>)]) -> Ball<f64> {
    let anything = Ball { mid: 0.0, radius: f64::INFINITY };
    let term = |(c, q): &(Ball<f64>, Ball<f64>)| q.sqrt().map_or(anything, |root| *c * root);
    terms.iter().map(term).fold(Ball::zero(), |sum, t| sum + t)
}

/// Clears the denominators of the points of one element.
fn clear<const K: usize>(points: [&Point<Rational>; K]) -> Local<K> {
    if let Some(cleared) = clear_small(points) {
        return Local::Small(cleared);
    }
    let denominators = points.iter().flat_map(|p| p.coordinates()).map(Rational::denominator);
    let unit = denominators.fold(BigInt::one(), |all, d| all.lcm(&d));
    let integer = |c: &Rational| c.numerator() * (&unit / c.denominator());
    Local::Big(Cleared { points: points.map(|p| p.map(integer)), unit })
}

fn clear_small<const K: usize>(points: [&Point<Rational>; K]) -> Option<Cleared<i128, K>> {
    let mut unit = 1i128;
    for c in points.iter().flat_map(|p| p.coordinates()) {
        unit = common(unit, c.small_fraction()?.1)?;
    }
    let mut cleared = [Point::new(0, 0, 0); K];
    for (to, from) in cleared.iter_mut().zip(points) {
        *to = over(from, unit)?;
    }
    Some(Cleared { points: cleared, unit })
}

/// The least common multiple, if it stays below the limit.
fn common(unit: i128, denominator: i64) -> Option<i128> {
    let d = i128::from(denominator);
    if unit % d == 0 {
        return Some(unit);
    }
    unit.checked_mul(d / unit.gcd(&d)).filter(|&u| u < LATTICE_LIMIT)
}

/// The coordinates times `unit`, a multiple of their denominators, if they stay below the limit.
fn over(point: &Point<Rational>, unit: i128) -> Option<Point<i128>> {
    let integer = |c: &Rational| {
        let (p, q) = c.small_fraction()?;
        let n = i128::from(p).checked_mul(unit / i128::from(q))?;
        (n.abs() < LATTICE_LIMIT).then_some(n)
    };
    Some(Point::new(integer(&point.x)?, integer(&point.y)?, integer(&point.z)?))
}

fn lattice_of_rationals<'a>(points: &[Point<Rational>]) -> Option<Store<'a>> {
    let mut unit = 1i128;
    for c in points.iter().flat_map(|p| p.coordinates()) {
        unit = common(unit, c.small_fraction()?.1)?;
    }
    let points = points.iter().map(|p| over(p, unit)).collect::<Option<_>>()?;
    Some(Store::Lattice { points, unit })
}

fn lattice_of_numerals<'a>(points: &[Point<Numeral>]) -> Option<Store<'a>> {
    let mut lowest = 0;
    let mut base = None;
    for c in points.iter().flat_map(|p| p.coordinates()) {
        let (mantissa, b, exponent) = c.small_parts()?;
        if *base.get_or_insert(b) != b {
            return None;
        }
        lowest = lowest.min(match b {
            _ if mantissa == 0 => 0,
            Base::Two => exponent + mantissa.trailing_zeros() as i32,
            Base::Ten => exponent,
        });
    }
    let base: i128 = match base? {
        Base::Two => 2,
        Base::Ten => 10,
    };
    let power = |e: i32| base.checked_pow(e as u32).filter(|&p| p < LATTICE_LIMIT);
    let powers: Vec<i128> = (0..126).map_while(power).collect();
    let unit = *powers.get(lowest.unsigned_abs() as usize)?;
    let integer = |c: &Numeral| {
        let (mantissa, _, exponent) = c.small_parts()?;
        let (mantissa, shift) = (i128::from(mantissa), exponent - lowest);
        if mantissa == 0 {
            return Some(0);
        }
        if shift < 0 {
            // Only zeros are cut off: `lowest` did not count the trailing ones.
            return Some(mantissa >> -shift);
        }
        let n = mantissa.checked_mul(*powers.get(shift as usize)?)?;
        (n.abs() < LATTICE_LIMIT).then_some(n)
    };
    let point =
        |p: &Point<Numeral>| Some(Point::new(integer(&p.x)?, integer(&p.y)?, integer(&p.z)?));
    let points = points.iter().map(point).collect::<Option<_>>()?;
    Some(Store::Lattice { points, unit })
}
