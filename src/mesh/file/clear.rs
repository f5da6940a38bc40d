//! Integer coordinates: the same mesh in a finer unit, for programs that only know doubles.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Pow};

use super::fraction::MAX_DIGITS;
use crate::mesh::{Data, Mesh};
use crate::scalar::RationalField;

/// A mesh with integer coordinates, and what it was scaled by.
#[derive(Clone, Debug, PartialEq)]
pub struct Cleared<Q> {
    /// The scaled mesh. It has no data, since only their meaning says how they would scale.
    pub mesh: Mesh<Q>,
    /// `D`: what x and y were multiplied with.
    pub xy_scale: BigInt,
    /// `D²`: what z was multiplied with.
    pub z_scale: BigInt,
}

impl<Q> Cleared<Q> {
    /// The notes `xy_scale` and `z_scale` for the header of a file.
    pub fn notes(&self) -> BTreeMap<String, String> {
        [("xy_scale", &self.xy_scale), ("z_scale", &self.z_scale)]
            .map(|(key, scale)| (key.to_owned(), scale.to_string()))
            .into()
    }
}

/// Multiplies x and y by `D` and z by `D²`, such that all coordinates become integers.
///
/// This is an i-similarity; it turns the unit i-sphere `2z = x² + y²` into itself. `D`
/// always fits. It is the least such number unless several primes above 10,000 divide the
/// denominators of z to different powers: to be sure then, one would have to factor integers of
/// any size. `None` if `D` would have more than 10,000 digits.
pub fn clear_denominators<Q: RationalField>(mesh: &Mesh<Q>) -> Option<Cleared<Q>> {
    let common = |denominators: &mut dyn Iterator<Item = &Q>| {
        let mut lcm = BigInt::one();
        for x in denominators {
            let q = x.denominator();
            if !(&lcm % &q).eq(&BigInt::ZERO) {
                lcm = lcm.lcm(&q);
            }
            if lcm.bits() as usize > 4 * MAX_DIGITS {
                return None;
            }
        }
        Some(lcm)
    };
    let xy = common(&mut mesh.points.iter().flat_map(|p| [&p.x, &p.y]))?;
    let z = common(&mut mesh.points.iter().map(|p| &p.z))?;
    let square = &xy * &xy;
    let missing = &z / z.gcd(&square);
    let xy_scale = xy * half_root(missing);
    let z_scale = &xy_scale * &xy_scale;
    if xy_scale.to_string().len() > MAX_DIGITS {
        return None;
    }
    let [by_xy, by_z] = [&xy_scale, &z_scale].map(|d| Q::from_fraction(d.clone(), BigInt::one()));
    let (by_xy, by_z) = (by_xy?, by_z?);
    let mut scaled = Mesh {
        topology: mesh.topology.clone(),
        points: mesh.points.clone(),
        data: Data::default(),
    };
    for point in &mut scaled.points {
        point.x = &point.x * &by_xy;
        point.y = &point.y * &by_xy;
        point.z = &point.z * &by_z;
    }
    Some(Cleared { mesh: scaled, xy_scale, z_scale })
}

/// The least number found whose square is a multiple of `n`.
fn half_root(mut n: BigInt) -> BigInt {
    let mut root = BigInt::one();
    for prime in 2..10_000u32 {
        // Composite numbers never divide: their factors are gone.
        let mut power = 0u32;
        while (&n % prime) == BigInt::ZERO {
            n /= prime;
            power += 1;
        }
        root *= BigInt::from(prime).pow(power.div_ceil(2));
        if n.is_one() {
            return root;
        }
    }
    // What is left has only large factors; a power of one of them is found.
    let most = u32::try_from(n.bits() / 13).map_or(64, |most| most.min(64));
    let power = (2..=most).rev().find_map(|power| {
        let base = n.nth_root(power);
        (base.clone().pow(power) == n).then(|| base.pow(power.div_ceil(2)))
    });
    root * power.unwrap_or(n)
}
