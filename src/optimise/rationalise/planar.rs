//! Planar meshes.

use super::heights::heights;
use super::incidence::{Incidence, Lead, Placement};
use super::offsets::offsets;
use super::placing::Placing;
use super::{BITS, Inside, NoExactMesh, Obstacle, Options, Rationalised, bits};
use crate::mesh::{Mesh, Topology};
use crate::scalar::Rational;
use crate::space::Point;

/// An exact planar mesh near a mesh.
///
/// # Errors
/// See [`NoExactMesh`].
pub fn planar(mesh: &Mesh<f64>, options: &Options) -> Result<Rationalised, NoExactMesh> {
    let inside = Inside::of(&mesh.points)?;
    let incidence = Incidence::new(&mesh.topology);
    let mut best: Option<Rationalised> = None;
    let mut obstacle = None;
    for way in ways(&incidence)? {
        let found = super::nearest(mesh, options, |rounding| {
            let points = match &way {
                Way::InOrder(order) => {
                    in_order(&mesh.topology, &inside, &incidence, order, rounding, options)
                }
                Way::Heights => heights(&mesh.topology, &inside.points, rounding),
                Way::Offsets => offsets(&mesh.topology, &incidence, &inside.points, rounding),
            };
            Ok(points?.iter().map(|p| inside.back(p)).collect())
        });
        match found {
            Ok(found) => {
                let is_last = matches!(way, Way::InOrder(_));
                let distance = found.movement.largest;
                if best.as_ref().is_none_or(|best| distance < best.movement.largest) {
                    best = Some(found);
                }
                if is_last || distance <= options.within {
                    break;
                }
            }
            Err(reason) => obstacle = Some(reason),
        }
    }
    match (best, obstacle) {
        (Some(found), _) => Ok(found),
        (None, Some(obstacle)) => Err(obstacle),
        // A mesh without conditions has an order.
        (None, None) => super::nearest(mesh, options, |_| Ok(Vec::new())),
    }
}

/// How the conditions are met.
enum Way {
    /// One point or plane after the other.
    InOrder(Vec<Placement>),
    /// The top view is rounded, the heights solve a linear system.
    Heights,
    /// The normals are rounded, the offsets of the planes solve a linear system.
    Offsets,
}

/// The ways that there are; the one with the fewest bits is tried first.
fn ways(incidence: &Incidence) -> Result<Vec<Way>, NoExactMesh> {
    let orders = [Lead::Points, Lead::Planes].map(|lead| incidence.order(lead));
    let stuck = orders[0].as_ref().err().copied();
    let bits = BITS[2] as u64;
    let mut ways: Vec<(u64, Way)> = Vec::new();
    for order in orders.into_iter().flatten() {
        ways.push((incidence.bits(&order, bits), Way::InOrder(order)));
    }
    for (lead, way) in [(Lead::Points, Way::Heights), (Lead::Planes, Way::Offsets)] {
        let (unknowns, conditions) = incidence.linear(lead);
        // Affine functions solve every system.
        if unknowns > conditions + 3 {
            // Measured, where the bound of Hadamard is twice the bits of a parameter.
            ways.push((bits * conditions as u64, way));
        }
    }
    ways.sort_by_key(|(bits, _)| *bits);
    match stuck {
        Some(stuck) if ways.is_empty() => Err(stuck),
        _ => Ok(ways.into_iter().map(|(_, way)| way).collect()),
    }
}

fn in_order(
    topology: &Topology,
    inside: &Inside,
    incidence: &Incidence,
    order: &[Placement],
    rounding: i32,
    options: &Options,
) -> Result<Vec<Point<Rational>>, NoExactMesh> {
    let mut placing = Placing::new(topology, &inside.points, rounding);
    for placement in order {
        // What is placed on one other is determined by what that was placed on.
        let at = |obstacle| match placement.on[..] {
            [one] => incidence.at(one, obstacle),
            _ => incidence.at(placement.node, obstacle),
        };
        let placed = placing.place(placement).ok_or(at(Obstacle::Degenerate))?;
        if placed.is_some_and(|point| bits(point) > options.most_bits) {
            return Err(at(Obstacle::TooManyBits));
        }
    }
    Ok(placing.into_points())
}
