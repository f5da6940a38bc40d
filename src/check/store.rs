//! The exact points of a mesh as integers over a common denominator, if it stays small.

use std::borrow::Cow;

use num_bigint::BigInt;
use num_integer::Integer as _;

use super::integers::Cleared;
use crate::mesh::VertexId;
use crate::scalar::{Base, Numeral, Rational, RationalField, Ring};
use crate::space::Point;

/// The points of a mesh, exactly, as they are best computed with.
#[derive(Clone, Debug)]
pub(super) enum Store<'a> {
    /// Integers over one common denominator `unit`; all have at most 126 bits.
    Lattice { points: Vec<Point<i128>>, unit: i128 },
    /// Anything else: denominators are cleared element by element.
    Rationals(Cow<'a, [Point<Rational>]>),
}

/// Coordinates and the common denominator stay below this, so that differences do not overflow.
const LATTICE_LIMIT: i128 = 1 << 125;

impl<'a> Store<'a> {
    pub fn of_numerals(points: &'a [Point<Numeral>]) -> Self {
        let rationals = || points.iter().map(|p| p.map(Numeral::value)).collect();
        lattice_of_numerals(points).unwrap_or_else(|| Store::Rationals(rationals()))
    }

    pub fn of_rationals(points: &'a [Point<Rational>]) -> Self {
        lattice_of_rationals(points).unwrap_or(Store::Rationals(points.into()))
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        match self {
            Store::Lattice { points, .. } => points.len(),
            Store::Rationals(points) => points.len(),
        }
    }

    /// These points and those of another store.
    pub fn followed_by(self, other: Store<'a>) -> Store<'a> {
        if let Some(joined) = self.on_one_lattice(&other) {
            return joined;
        }
        let rationals = |store: Store<'a>| match store {
            Store::Lattice { points, unit } => points.iter().map(|p| rational(p, unit)).collect(),
            Store::Rationals(points) => points.into_owned(),
        };
        let mut points = rationals(self);
        points.extend(rationals(other));
        Store::Rationals(points.into())
    }

    fn on_one_lattice(&self, other: &Store<'a>) -> Option<Store<'a>> {
        let (Store::Lattice { points, unit }, Store::Lattice { points: more, unit: own }) =
            (self, other)
        else {
            return None;
        };
        let common = common(*unit, *own)?;
        let refined = |points: &[Point<i128>], unit: i128| -> Option<Vec<Point<i128>>> {
            let scale = |c: &i128| c.checked_mul(common / unit).filter(|n| n.abs() < LATTICE_LIMIT);
            let point =
                |p: &Point<i128>| Some(Point::new(scale(&p.x)?, scale(&p.y)?, scale(&p.z)?));
            points.iter().map(point).collect()
        };
        let mut points = refined(points, *unit)?;
        points.extend(refined(more, *own)?);
        Some(Store::Lattice { points, unit: common })
    }

    /// The points of an element at one place and more, every `block` moved to its first point.
    #[inline]
    pub fn local<const K: usize>(
        &self,
        first: &[VertexId; K],
        more: &[[VertexId; K]],
        block: Option<usize>,
    ) -> Local<K> {
        let local = match self {
            Store::Lattice { points, unit } => {
                let place = |at: &[VertexId; K]| at.map(|v| points[v.index()]);
                let more = more.iter().map(place).collect();
                Local::Small(Cleared { points: place(first), more, unit: *unit })
            }
            Store::Rationals(points) => {
                let place = |at: &[VertexId; K]| at.map(|v| &points[v.index()]);
                clear(&place(first), &more.iter().map(place).collect::<Vec<_>>())
            }
        };
        match (local, block) {
            (Local::Small(cleared), Some(block)) => Local::Small(cleared.translated(block)),
            (Local::Big(cleared), Some(block)) => Local::Big(cleared.translated(block)),
            (local, None) => local,
        }
    }

    /// The points of the element as rational numbers.
    pub fn exact<const K: usize>(&self, at: &[VertexId; K]) -> [Point<Rational>; K] {
        at.map(|v| match self {
            Store::Lattice { points, unit } => rational(&points[v.index()], *unit),
            Store::Rationals(points) => points[v.index()].clone(),
        })
    }

    /// Whether two vertices have the same top view.
    pub fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        match self {
            Store::Lattice { points, .. } => {
                let (p, q) = (&points[a.index()], &points[b.index()]);
                p.x == q.x && p.y == q.y
            }
            Store::Rationals(points) => points[a.index()].is_parallel_to(&points[b.index()]),
        }
    }

    /// Whether two vertices are the same point.
    pub fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        match self {
            Store::Lattice { points, .. } => points[a.index()] == points[b.index()],
            Store::Rationals(points) => points[a.index()] == points[b.index()],
        }
    }
}

/// The points of one element, cleared.
pub(super) enum Local<const K: usize> {
    Small(Cleared<i128, K>),
    Big(Cleared<BigInt, K>),
}

/// A point of a lattice with its own denominator.
fn rational(point: &Point<i128>, unit: i128) -> Point<Rational> {
    point.map(|&c| Rational::from_fraction(c.into(), unit.into()).unwrap_or_else(Rational::zero))
}

/// Clears the denominators of the points of one element, at one place and more.
fn clear<const K: usize>(
    first: &[&Point<Rational>; K],
    more: &[[&Point<Rational>; K]],
) -> Local<K> {
    if let Some(cleared) = clear_small(first, more) {
        return Local::Small(cleared);
    }
    let all = first.iter().chain(more.iter().flatten()).flat_map(|p| p.coordinates());
    let unit = all.map(Rational::denominator).fold(BigInt::one(), |all, d| all.lcm(&d));
    let integer = |c: &Rational| c.numerator() * (&unit / c.denominator());
    let place = |points: &[&Point<Rational>; K]| points.map(|p| p.map(integer));
    let (points, more) = (place(first), more.iter().map(place).collect());
    Local::Big(Cleared { points, more, unit })
}

fn clear_small<const K: usize>(
    first: &[&Point<Rational>; K],
    more: &[[&Point<Rational>; K]],
) -> Option<Cleared<i128, K>> {
    let mut unit = 1i128;
    for c in first.iter().chain(more.iter().flatten()).flat_map(|p| p.coordinates()) {
        unit = common(unit, c.small_fraction()?.1.into())?;
    }
    let place = |points: &[&Point<Rational>; K]| {
        let mut cleared = [Point::new(0, 0, 0); K];
        for (to, from) in cleared.iter_mut().zip(points) {
            *to = over(from, unit)?;
        }
        Some(cleared)
    };
    let more = more.iter().map(place).collect::<Option<_>>()?;
    Some(Cleared { points: place(first)?, more, unit })
}

/// The least common multiple, if it stays below the limit.
fn common(unit: i128, d: i128) -> Option<i128> {
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
        unit = common(unit, c.small_fraction()?.1.into())?;
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
