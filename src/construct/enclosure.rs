//! Meshes whose exact coordinates are irrational, enclosed by rational ones.
//!
//! First integrals of rotational meshes lead to square roots `√(ŵ²/K + C)`. They are enclosed between
//! fractions, and every coordinate, which is linear in them, by the same arithmetic of balls. What is
//! written is the mesh of the middles: an exact mesh of its own, but not the one that was asked for,
//! which lies within the bounds. The bounds are data of the vertices, so that nobody takes the one for
//! the other.

use super::minimal::MeshPair;
use crate::pair::FParallel;
use crate::scalar::{Ball, RationalField};

/// The name of the data on vertices that bound how far each coordinate of the enclosed mesh is from
/// the written one.
pub const ENCLOSURE: &str = "enclosure";

/// A pair (M, S) with an enclosed M and an exact S.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed<Q> {
    /// The mesh of the middles, with the data [`ENCLOSURE`], and S.
    pub pair: MeshPair<Q>,
    /// The roots that were enclosed, from ring to ring.
    pub roots: Vec<Ball<Q>>,
}

impl<Q: RationalField> Enclosed<Q> {
    pub(super) fn new(mut pair: MeshPair<Q>, roots: Vec<Ball<Q>>, bounds: Vec<Q>) -> Self {
        pair.surface.data.vertex.insert(ENCLOSURE.to_owned(), bounds);
        Enclosed { pair, roots }
    }

    /// The largest of the bounds: no coordinate of the enclosed mesh is farther from the written one.
    pub fn radius(&self) -> Q {
        let bounds = self.pair.surface.data.vertex.get(ENCLOSURE).into_iter().flatten();
        bounds.fold(Q::zero(), |most, bound| if *bound > most { bound.clone() } else { most })
    }

    /// The least and the greatest i-curvature K of the faces of the written mesh; `None` where it is
    /// not defined at a face.
    pub fn written_gauss(&self) -> Option<[Q; 2]> {
        let pair = FParallel::new(&self.pair.surface, &self.pair.gauss).ok()?;
        let mut range: Option<[Q; 2]> = None;
        for face in self.pair.surface.topology.faces() {
            let value = pair.face_curvatures(face).ok()?.gauss;
            range = Some(match range {
                None => [value.clone(), value],
                Some([low, high]) if value < low => [value, high],
                Some([low, high]) if value > high => [low, value],
                Some(range) => range,
            });
        }
        range
    }
}

/// `√(ŵ²/K + C)`, not negative, enclosed to `2^−bits`; `None` for `K = 0` or where it is not real.
pub(super) fn first_integral<Q: RationalField>(
    image: &Q,
    gauss: &Q,
    integral: &Q,
    bits: u32,
) -> Option<Ball<Q>> {
    Ball::root(&(image.square().try_div(gauss)? + integral), bits)
}

/// The larger of the radii.
pub(super) fn bound<Q: RationalField>([a, b]: [&Ball<Q>; 2]) -> Q {
    if a.radius > b.radius { a.radius.clone() } else { b.radius.clone() }
}
