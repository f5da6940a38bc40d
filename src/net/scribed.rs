//! Meshes that approximate the unit i-sphere Σ: `2 z = x² + y²` (5): inscribed, circumscribed and
//! midscribed (Definition 1, Sec. 3.4).

use super::planar::{self, Position, ProjectedArea};
use super::{Judge, i_conical};
use crate::check::{Answer, Decide, Outcome, Reason, Residual};
use crate::mesh::{FaceId, VertexId};
use crate::scalar::Ring;
use crate::space::Point;

/// `2 z − x² − y²`: zero iff the point lies on Σ, positive above it (inside).
#[derive(Clone, Copy, Debug)]
pub struct OnSigma;

impl Residual<1> for OnSigma {
    const TRANSLATES: bool = false;

    fn eval<R: Ring>(self, [p]: &[Point<R>; 1], unit: &R) -> R {
        let z = &p.z * unit;
        &z + &z - p.top_view().norm2()
    }
}

/// `N₁² + N₂² + 2 N₃ h` for the plane `N·x = h` through three points: zero iff it touches Σ.
///
/// With gradient p and height t that is `t = −|p|²/2`.
#[derive(Clone, Copy, Debug)]
pub struct TouchesSigma;

impl Residual<3> for TouchesSigma {
    const TRANSLATES: bool = false;

    fn eval<R: Ring>(self, [a, b, c]: &[Point<R>; 3], unit: &R) -> R {
        let n = i_conical::normal(a, b, c);
        let h = R::dot([&n.x, &n.y, &n.z], a.coordinates()) * &n.z;
        &h + &h + n.top_view().length2() * unit
    }
}

/// `(p'·d − (q₃ − p₃))² − |d|² (|p'|² − 2 p₃)` with `d = q' − p'`: a quarter of the discriminant of
/// the line pq and Σ, zero iff the line touches Σ, positive if it meets Σ twice.
#[derive(Clone, Copy, Debug)]
pub struct EdgeTouchesSigma;

impl Residual<2> for EdgeTouchesSigma {
    const TRANSLATES: bool = false;

    fn eval<R: Ring>(self, [p, q]: &[Point<R>; 2], unit: &R) -> R {
        let v = q - p;
        let d = v.top_view();
        let slope = R::dot([&p.x, &p.y], [&d.x, &d.y]) - v.z * unit;
        let z = &p.z * unit;
        let power = p.top_view().norm2() - &z - &z;
        slope.square() - d.length2() * power
    }
}

pub(super) fn inscribed<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let answer = judge.decide().decide(OnSigma, [v]);
    Outcome::of(answer, || judge.failure("on the unit i-sphere", OnSigma, [v]))
}

pub(super) fn circumscribed<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    let shape = judge.net.shape(face);
    let corners = judge.topology().face(face);
    let triangle = match shape.position {
        _ if shape.planar == Answer::Nonzero => {
            return Outcome::Fails(planar::failure(judge, face));
        }
        Position::Collinear => return Outcome::Undefined(Reason::CollinearFace(face)),
        Position::Vertical => None,
        Position::Graph => planar::triangle(judge.decide(), ProjectedArea::TopView, corners),
    };
    let Some(triangle) = triangle else {
        return Outcome::Undefined(Reason::VerticalFace(face));
    };
    let answer = judge.decide().decide(TouchesSigma, triangle).max(shape.planar);
    Outcome::of(answer, || judge.failure("touches the unit i-sphere", TouchesSigma, triangle))
}

pub(super) fn midscribed<D: Decide>(
    judge: &Judge<'_, D>,
    a: VertexId,
    b: VertexId,
) -> Outcome<D::Value> {
    if judge.decide().same_top_view(a, b) {
        return Outcome::Undefined(Reason::IsotropicEdge);
    }
    let answer = judge.decide().decide(EdgeTouchesSigma, [a, b]);
    Outcome::of(answer, || {
        judge.failure("edge touches the unit i-sphere", EdgeTouchesSigma, [a, b])
    })
}
