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
    /// The point of a vertex in rational numbers.
    pub fn point(&self, v: VertexId) -> Point<Rational> {
        match self {
            ExactPoints::Rationals(points) => points[v.index()].clone(),
            ExactPoints::Lattice(Lattice { points, unit }) => points[v.index()].map(|&c| {
                Rational::from_fraction(c.into(), (*unit).into()).unwrap_or_else(Rational::zero)
            }),
        }
    }
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
            let n = mantissa.checked_mul(*powers.get(shift as usize)?)?;
            (n.abs() < LIMIT).then_some(n)
        };
        Self::of(points, unit, integer)
    }

    /// Rational points, if a lattice of this size holds them all.
    pub fn of_rationals(points: &[Point<Rational>]) -> Option<Self> {
        let mut unit = 1i128;
        for c in points.iter().flat_map(|p| p.coordinates()) {
            let (_, q) = small(c)?;
            if unit % q != 0 {
                unit = unit.checked_mul(q / unit.gcd(&q)).filter(|&u| u < LIMIT)?;
            }
        }
        Self::of(points, unit, |c| {
            let (p, q) = small(c)?;
            p.checked_mul(unit / q).filter(|n| n.abs() < LIMIT)
        })
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
