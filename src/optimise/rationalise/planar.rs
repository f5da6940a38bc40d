//! Planar meshes of any faces.

use super::heights::heights;
use super::incidence::{Incidence, Lead, Placement};
use super::offsets::offsets;
use super::placing::Placing;
use super::{BITS, Inside, NoExactMesh, Obstacle, Options, Rationalised, bits};
use crate::mesh::{Mesh, Topology};
use crate::scalar::Rational;
use crate::space::Point;

/// An exact planar mesh near a mesh with faces of any size.
///
/// ```
/// use isogeo::check::{Decider, Verdict};
/// use isogeo::construct::quad_patch;
/// use isogeo::mesh::Mesh;
/// use isogeo::net::{Net, Property};
/// use isogeo::optimise::rationalise::{Options, planar};
/// use isogeo::space::Point;
/// let points = (0..9).map(|i| [f64::from(i / 3), f64::from(i % 3)].map(|c| 0.1 + c / 7.0));
/// let points = points.map(|[x, y]| Point::new(x, y, x * x - 0.3 * y * y)).collect();
/// let mesh = Mesh::new(points, quad_patch(2, 2))?; // planar but for rounding
/// let found = planar(&mesh, &Options::of(&mesh.points))?;
/// let decider = Decider::of_rationals(&found.mesh.points);
/// let report = Net::new(&mesh.topology, &decider).check(Property::Planar);
/// assert_eq!(report.verdict(), Verdict::Proved);
/// assert!(found.movement.largest < 1e-6 && found.bits < 80);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Incidences of points and planes form a planar graph if the mesh has genus 0; then there is an order
/// in which each has at most three with those before it. Orders are compared by the bits that they lead to,
/// among each other and with linear systems for the heights over a rounded top view or for the offsets of
/// planes with rounded normals. Vertical faces are allowed. Excluded are meshes with fewer degrees of
/// freedom than that: in a torus of quads every vertex and every face has four incidences.
///
/// # Errors
/// A coordinate that is no number; support points of a face that are collinear; no order, as on a
/// torus; numbers that become too long, as in flat closed meshes of many faces; not enough memory.
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
        placing.place(placement).ok_or(at(Obstacle::Degenerate))?;
        if placing.at(placement.node).is_some_and(|point| bits(point) > options.most_bits) {
            return Err(at(Obstacle::TooManyBits));
        }
    }
    Ok(placing.into_points())
}
