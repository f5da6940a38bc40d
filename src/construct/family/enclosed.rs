//! Members whose coordinates are irrational: their profiles, and why there are none.

use super::member::{no, ratio};
use super::{Member, NoMember, Values};
use crate::construct::hexagonal::HexagonalRings;
use crate::construct::rotational::{enclosed_curvature_rings, enclosed_rotational_pair};
use crate::scalar::{Ball, Ordered, Rational, RationalField, Ring, Sign};
use crate::space::Rotation;

type Q = Rational;

/// Rings of S with simple radii: for `K > 0` from `√(−CK)`, or 0, in equal steps outwards; for
/// `K < 0` from near `√(−CK)` inwards, at the sines of simple rotations.
pub(super) fn enclosed_rotational(
    [m, n]: [usize; 2],
    values: &Values,
    sector: &Rotation<Q>,
) -> Result<Member, NoMember> {
    let (gauss, integral) = (values.non_zero("curvature")?, values.non_zero("integral")?);
    let rim2 = -(&integral * &gauss);
    let rim = if rim2.certain_sign() == Some(Sign::Positive) {
        near_root(&rim2)
    } else {
        Ball::new(Q::zero(), Q::zero())
    };
    let images: Vec<Q> = if gauss.certain_sign() == Some(Sign::Negative) {
        let inner = &rim.mid - &rim.radius;
        let turn = |k: usize| Rotation::from_parameter(&ratio(m + 1 - k, m + 2)).ok();
        (0..=m).filter_map(turn).map(|turn| &inner * turn.sin()).collect()
    } else {
        let unit = near_root(&gauss);
        let (start, step) = (&rim.mid + &rim.radius, (&unit.mid + &unit.radius) * ratio(1, 12));
        (0..=m).map(|k| &start + &step * ratio(k + 1, 1)).collect()
    };
    let radii = enclosed_curvature_rings(&images, &gauss, &integral, values.bits("bits")?);
    let radii = radii.ok_or_else(|| not_real("integral", values))?;
    let pair = enclosed_rotational_pair(radii, &images, sector, n).map_err(no)?;
    Ok(Member::enclosed(pair, gauss))
}

/// Hexagons with an S that is circumscribed exactly.
pub(super) fn enclosed_hexagonal(
    hexagons: usize,
    values: &Values,
    rings: &HexagonalRings<Q>,
) -> Result<Member, NoMember> {
    let (gauss, integral) = (values.non_zero("curvature")?, values.non_zero("integral")?);
    let image = rings.circumscribed();
    let steps = rings.enclosed_constant_gauss(&image, &gauss, &integral, values.bits("bits")?);
    let steps = steps.ok_or_else(|| not_real("integral", values))?;
    let pair = rings.enclosed_pair(steps, &image, hexagons).map_err(no)?;
    Ok(Member::enclosed(pair, gauss))
}

fn not_real(name: &'static str, values: &Values) -> NoMember {
    let text = values.text(name);
    no(format!("a square root is not real with the curvature and the integral {text}"))
}

/// The root of a positive number, enclosed to a few significant bits.
fn near_root(number: &Q) -> Ball<Q> {
    let (above, below) = (number.numerator().bits(), number.denominator().bits());
    let bits = 5 + below.saturating_sub(above).div_ceil(2);
    let bits = u32::try_from(bits).unwrap_or(u32::MAX);
    Ball::root(number, bits).unwrap_or(Ball::new(Q::one(), Q::zero()))
}
