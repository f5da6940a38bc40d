//! The points of a mesh in exact numbers, as integers where one common denominator fits.

use std::borrow::Cow;

use num_integer::Integer as _;

use crate::mesh::VertexId;
use crate::scalar::{Base, BigInt, Numeral, Rational, RationalField, Ring};
use crate::space::Point;

/// The points of a mesh, exactly.
#[derive(Clone, Debug)]
pub enum ExactPoints<'a> {
    /// Integers over one common denominator.
    Lattice(Lattice),
    /// Fractions whose common denominator is too large.
    Rationals(Cow<'a, [Point<Rational>]>),
}

/// Points as integers over one common denominator.
///
/// All numbers have at most 126 bits, so that differences do not overflow.
#[derive(Clone, Debug)]
pub struct Lattice {
    /// The coordinates times `unit`.
    pub points: Vec<Point<i128>>,
    /// The common denominator, positive.
    pub unit: i128,
}

const LIMIT: i128 = 1 << 125;

impl<'a> From<&'a [Point<Rational>]> for ExactPoints<'a> {
    fn from(points: &'a [Point<Rational>]) -> Self {
        let lattice = Lattice::of_rationals(points).map(ExactPoints::Lattice);
        lattice.unwrap_or(ExactPoints::Rationals(points.into()))
    }
}

/// The numbers are taken as they are printed.
impl From<&[Point<Numeral>]> for ExactPoints<'_> {
    fn from(points: &[Point<Numeral>]) -> Self {
        let lattice = Lattice::of_numerals(points).map(ExactPoints::Lattice);
        lattice.unwrap_or_else(|| {
            ExactPoints::Rationals(points.iter().map(|p| p.map(Numeral::value)).collect())
        })
    }
}

impl ExactPoints<'_> {
    /// The number of points.
    pub fn len(&self) -> usize {
        match self {
            ExactPoints::Lattice(lattice) => lattice.points.len(),
            ExactPoints::Rationals(points) => points.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether two vertices have the same top view.
    pub fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        match self {
            ExactPoints::Lattice(Lattice { points, .. }) => {
                let (p, q) = (&points[a.index()], &points[b.index()]);
                p.x == q.x && p.y == q.y
            }
            ExactPoints::Rationals(points) => points[a.index()].is_parallel_to(&points[b.index()]),
        }
    }

    /// Whether two vertices are the same point.
    pub fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        match self {
            ExactPoints::Lattice(Lattice { points, .. }) => points[a.index()] == points[b.index()],
            ExactPoints::Rationals(points) => points[a.index()] == points[b.index()],
        }
    }

    /// The point of a vertex in rational numbers.
    pub fn point(&self, v: VertexId) -> Point<Rational> {
        match self {
            ExactPoints::Rationals(points) => points[v.index()].clone(),
            ExactPoints::Lattice(Lattice { points, unit }) => rational(&points[v.index()], *unit),
        }
    }
}

impl<'a> ExactPoints<'a> {
    /// These points and those of another mesh.
    pub fn followed_by(self, other: ExactPoints<'a>) -> ExactPoints<'a> {
        if let (ExactPoints::Lattice(own), ExactPoints::Lattice(more)) = (&self, &other)
            && let Some(joined) = own.followed_by(more)
        {
            return ExactPoints::Lattice(joined);
        }
        let rationals = |points: ExactPoints<'a>| match points {
            ExactPoints::Lattice(Lattice { points, unit }) => {
                points.iter().map(|p| rational(p, unit)).collect()
            }
            ExactPoints::Rationals(points) => points.into_owned(),
        };
        let mut points = rationals(self);
        points.extend(rationals(other));
        ExactPoints::Rationals(points.into())
    }
}

/// A point of a lattice with its own denominator.
fn rational(point: &Point<i128>, unit: i128) -> Point<Rational> {
    point.map(|&c| Rational::from_fraction(c.into(), unit.into()).unwrap_or_else(Rational::zero))
}

impl Lattice {
    /// The points as they are printed, if a lattice of this size holds them all.
    pub fn of_numerals(points: &[Point<Numeral>]) -> Option<Self> {
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
        let power = |e: i32| base.checked_pow(e as u32).filter(|&p| p < LIMIT);
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
            Self::bounded(mantissa.checked_mul(*powers.get(shift as usize)?)?)
        };
        Self::of(points, unit, integer)
    }

    /// Rational points, if a lattice of this size holds them all.
    pub fn of_rationals(points: &[Point<Rational>]) -> Option<Self> {
        let mut unit = 1i128;
        for c in points.iter().flat_map(|p| p.coordinates()) {
            unit = common_multiple(unit, small(c)?.1)?;
        }
        Self::of(points, unit, |c| {
            let (p, q) = small(c)?;
            Self::bounded(p.checked_mul(unit / q)?)
        })
    }

    /// These points and those of another lattice, on one that holds both.
    fn followed_by(&self, other: &Lattice) -> Option<Lattice> {
        let unit = common_multiple(self.unit, other.unit)?;
        let refined = |lattice: &Lattice| {
            let factor = unit / lattice.unit;
            Self::of(&lattice.points, unit, |c| Self::bounded(c.checked_mul(factor)?))
        };
        let (mut joined, more) = (refined(self)?, refined(other)?);
        joined.points.extend(more.points);
        Some(joined)
    }

    /// A coordinate, if it is not too large.
    pub(crate) fn bounded(n: i128) -> Option<i128> {
        (n.abs() < LIMIT).then_some(n)
    }

    fn of<Q>(
        points: &[Point<Q>],
        unit: i128,
        integer: impl Fn(&Q) -> Option<i128>,
    ) -> Option<Self> {
        let point = |p: &Point<Q>| Some(Point::new(integer(&p.x)?, integer(&p.y)?, integer(&p.z)?));
        let points = points.iter().map(point).collect::<Option<_>>()?;
        Some(Lattice { points, unit })
    }
}

/// Numerator and denominator where both fit 128 bits.
fn small(c: &Rational) -> Option<(i128, i128)> {
    if let Some((p, q)) = c.small_fraction() {
        return Some((p.into(), q.into()));
    }
    let fits = |n: BigInt| i128::try_from(n).ok();
    Some((fits(c.numerator())?, fits(c.denominator())?))
}

/// The least common multiple of two denominators, if it is not too large.
pub(crate) fn common_multiple(a: i128, b: i128) -> Option<i128> {
    if a % b == 0 {
        return Some(a);
    }
    Lattice::bounded(a.checked_mul(b / a.gcd(&b))?)
}
