//! The area forms of (21), (22) at the star of a vertex.

use crate::mesh::{Topology, VertexId, VertexKind};
use crate::scalar::{Field, Ring};
use crate::space::{Gradient, Plane, Point, Vector2};

/// `4 D(v)`, `4 D(v, s)` and `4 D(s)`.
pub(super) struct StarForms<T> {
    pub own: T,
    pub mixed: T,
    pub sigma: T,
}

/// The forms on two lists of gradients, those of the faces around a vertex in M and in S.
pub(super) fn forms<T: Ring>(m: &[Gradient<T>], s: &[Gradient<T>]) -> StarForms<T> {
    let mut sums = StarForms { own: T::zero(), mixed: T::zero(), sigma: T::zero() };
    let (Some(m0), Some(s0)) = (m.first(), s.first()) else {
        return sums;
    };
    let from = |p: &Gradient<T>, origin: &Gradient<T>| p - origin;
    let seen: Vec<[Vector2<T>; 2]> =
        m.iter().zip(s).map(|(p, q)| [from(p, m0), from(q, s0)]).collect();
    for pair in seen.windows(2) {
        let ([p, q], [next_p, next_q]) = (&pair[0], &pair[1]);
        let (own, sigma) = (p.det(next_p), q.det(next_q));
        sums.own = sums.own + &own + &own;
        sums.mixed = sums.mixed + p.det(next_q) + q.det(next_p);
        sums.sigma = sums.sigma + &sigma + &sigma;
    }
    sums
}

/// The gradients of the triangles around an interior vertex for the heights of `points`;
/// `None` at other vertices, at larger faces and at vertical ones.
pub(super) fn gradients<T: Field>(
    topology: &Topology,
    v: VertexId,
    point: impl Fn(VertexId) -> Point<T>,
) -> Option<Vec<Gradient<T>>> {
    if topology.kind(v) != VertexKind::Interior {
        return None;
    }
    let gradient = |h| match *topology.face(topology.face_at(h)) {
        [a, b, c] => Plane::through(&point(a), &point(b), &point(c)).ok().map(|p| p.gradient),
        _ => None,
    };
    topology.star(v).map(gradient).collect()
}
