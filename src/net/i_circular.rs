//! i-circular meshes: every face has an isotropic circumcircle (Sec. 3.2, Theorem 1).
//!
//! A face is i-circular iff it is planar and its top view lies on a circle. Triangles are so by
//! themselves. A vertical face has no i-circle of elliptic type and is *undefined*.

use super::Judge;
use super::planar;
use crate::check::{Answer, Decide, Outcome, Residual};
use crate::mesh::{FaceId, VertexId};
use crate::scalar::{Ring, det3};
use crate::space::Point;

/// The in-circle determinant of four top views, of degree 4 in x and y.
///
/// Zero iff the points lie on a circle or a line (or two coincide); positive if the fourth lies
/// inside the counter-clockwise circle through the first three. Opposite angles of an embedded
/// convex quad then sum to π (13).
#[derive(Clone, Copy, Debug)]
pub struct Concyclic;

impl Residual<4> for Concyclic {
    const TRANSLATES: bool = true;

    #[inline]
    fn eval<R: Ring>(self, [p, a, b, c]: &[Point<R>; 4], _: &R) -> R {
        let [a, b, c] = [a, b, c].map(|q| (q - p).top_view());
        let [na, nb, nc] = [a.length2(), b.length2(), c.length2()];
        det3([&a.x, &a.y, &na], [&c.x, &c.y, &nc], [&b.x, &b.y, &nb])
    }
}

/// The quadruples to test: a quad itself, or three different top views with each other point.
/// Three different points on a circle determine it, so nothing is lost.
pub(super) fn places<D: Decide>(decide: &D, face: &[VertexId]) -> Vec<[VertexId; 4]> {
    let base = match *face {
        [a, b, c, _] => [a, b, c],
        _ => match distinct(face, |a, b| decide.same_top_view(a, b)) {
            Some(base) => base,
            None => return Vec::new(),
        },
    };
    let [a, b, c] = base;
    face.iter().filter(|v| !base.contains(v)).map(|&v| [a, b, c, v]).collect()
}

/// Three elements that are pairwise different, the first in order.
pub(super) fn distinct<T: Copy>(list: &[T], same: impl Fn(T, T) -> bool) -> Option<[T; 3]> {
    let a = *list.first()?;
    let b = *list.iter().find(|&&x| !same(a, x))?;
    let c = *list.iter().find(|&&x| !same(a, x) && !same(b, x))?;
    Some([a, b, c])
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    if let Some(outcome) = planar::no_graph(judge, face) {
        return outcome;
    }
    let corners = judge.topology().face(face);
    if corners.len() == 3 {
        return Outcome::Trivial;
    }
    let places = places(judge.decide(), corners);
    let circular = places.iter().map(|&at| judge.decide().decide(Concyclic, at)).max();
    let answer = circular.unwrap_or(Answer::Zero).max(judge.net.shape(face).planar);
    Outcome::of(answer, || judge.worst("concyclic", Concyclic, places.into_iter()))
}
