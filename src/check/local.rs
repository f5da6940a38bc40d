//! The points of one element as integers.

use num_bigint::BigInt;
use num_integer::Integer as _;

use super::integers::Cleared;
use crate::mesh::{ExactPoints, Lattice, VertexId, common_multiple};
use crate::scalar::{Rational, RationalField, Ring};
use crate::space::Point;

impl ExactPoints<'_> {
    /// The points of an element at one place and more, every `block` moved to its first point.
    #[inline]
    pub(super) fn local<const K: usize>(
        &self,
        first: &[VertexId; K],
        more: &[[VertexId; K]],
        block: Option<usize>,
    ) -> Local<K> {
        let local = match self {
            ExactPoints::Lattice(Lattice { points, unit }) => {
                let place = |at: &[VertexId; K]| at.map(|v| points[v.index()]);
                let more = more.iter().map(place).collect();
                Local::Small(Cleared { points: place(first), more, unit: *unit })
            }
            ExactPoints::Rationals(points) => {
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
}

/// The points of one element, cleared.
pub(super) enum Local<const K: usize> {
    Small(Cleared<i128, K>),
    Big(Cleared<BigInt, K>),
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
        unit = common_multiple(unit, c.small_fraction()?.1.into())?;
    }
    let place = |points: &[&Point<Rational>; K]| {
        let mut cleared = [Point::new(0, 0, 0); K];
        for (to, from) in cleared.iter_mut().zip(points) {
            *to = point_over(from, unit)?;
        }
        Some(cleared)
    };
    let more = more.iter().map(place).collect::<Option<_>>()?;
    Some(Cleared { points: place(first)?, more, unit })
}

/// The coordinates times `unit`, a multiple of their denominators, if they stay below the limit.
fn point_over(point: &Point<Rational>, unit: i128) -> Option<Point<i128>> {
    let integer = |c: &Rational| {
        let (p, q) = c.small_fraction()?;
        Lattice::bounded(i128::from(p).checked_mul(unit / i128::from(q))?)
    };
    Some(Point::new(integer(&point.x)?, integer(&point.y)?, integer(&point.z)?))
}
