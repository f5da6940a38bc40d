//! i-isothermic meshes (Sec. 3.4, Theorem 3), of either type.
//!
//! With signed radii of vertex circles, the certificate that comes with the mesh, what is decided is
//! that it is v-parallel to a Koebe mesh: faces are planar, the poles of the circles at each face
//! are coplanar (so another circle is orthogonal to them, the incircle of the top view), and the
//! circles touch along every edge. Faces may have any number of sides. Four circles that touch in a
//! cycle do not suffice, as a rhombus shows. Another certificate may do where this one does not.
//!
//! Without radii it is the circular type: faces are i-circular quads, and the cross-ratios of their
//! top views factorise into one number for every row and one for every column, as far as interior
//! vertices tell. Undefined are faces that are no quads, vertical faces, edges of length 0 and
//! vertices of odd valence.

use super::i_conical::product;
use super::planar;
use super::star::{MOST, USUAL, no_proper_quad, padded, ring_of_quads, undefined_face};
use super::{Judge, i_circular};
use crate::check::{Answer, Decide, Element, Outcome, Reason, Residual};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::Ring;
use crate::space::{Point, Vector2, Vector3};

/// `|x₁' − x₀'|² − (r₀ + r₁)²` for two points and two radii, each the x-coordinate of a point: zero iff
/// the circles touch with their signs.
#[derive(Clone, Copy, Debug)]
pub struct TouchingCircles;

impl Residual<4> for TouchingCircles {
    const TRANSLATES: bool = false;

    fn eval<R: Ring>(self, [p, q, r, s]: &[Point<R>; 4], _: &R) -> R {
        p.i_distance2(q) - (&r.x + &s.x).square()
    }
}

/// The determinant of the poles of four circles over one plane: zero iff a circle (or a line) is
/// orthogonal to all of them. The points are the centres and then the radii, as x-coordinates.
#[derive(Clone, Copy, Debug)]
pub struct CoplanarPoles;

impl Residual<8> for CoplanarPoles {
    const TRANSLATES: bool = false;

    fn eval<R: Ring>(self, points: &[Point<R>; 8], _: &R) -> R {
        let [a, b, c] = [1, 2, 3].map(|i| {
            let e = (&points[i] - &points[0]).top_view();
            let height = lifted(&e, &points[4].x, &points[4 + i].x);
            Vector3 { x: e.x, y: e.y, z: height }
        });
        Vector3::det(&a, &b, &c)
    }
}

/// `|e|² − r² + r₀²`: twice the height of the pole of a circle over the plane that touches the pole
/// paraboloid of the first circle, seen from whose centre `e` is.
pub(super) fn lifted<R: Ring>(e: &Vector2<R>, first: &R, radius: &R) -> R {
    e.length2() - R::det2(radius, first, first, radius)
}

/// A part, real or imaginary, of `∏ (y_j − x_{j+1}) − ∏ (x_j − y_j)` in complex numbers of the top view,
/// for a vertex of an even number of quads with the neighbours `x_j` and the opposite corners `y_j`
/// between `x_j` and `x_{j+1}`.
///
/// Both vanish iff the product of the cross-ratios of the quads, all seen from the vertex, is 1.
#[derive(Clone, Copy, Debug)]
pub struct CrossRatioProduct {
    /// The number of quads around the vertex.
    pub valence: usize,
    /// Which part.
    pub real: bool,
}

impl<const K: usize> Residual<K> for CrossRatioProduct {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, points: &[Point<R>; K], _: &R) -> R {
        let n = self.valence;
        let step = |a: usize, b: usize| (&points[b] - &points[a]).top_view();
        let one = Vector2 { x: R::one(), y: R::zero() };
        let (mut left, mut right) = (one.clone(), one);
        for j in 0..n {
            left = product(&left, &step(1 + (j + 1) % n, 1 + n + j));
            right = product(&right, &step(1 + n + j, 1 + j));
        }
        if self.real { left.x - right.x } else { left.y - right.y }
    }
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, element: Element) -> Outcome<D::Value> {
    match element {
        Element::Face(face) if judge.net.radii.is_some() => tangential(judge, face),
        Element::Face(face) => circular(judge, face),
        Element::Edge(a, b) => touching(judge, a, b),
        Element::Vertex(v) => factorised(judge, v),
    }
}

fn tangential<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    if let Some(outcome) = planar::no_graph(judge, face) {
        return outcome;
    }
    if judge.topology().face(face).len() == 3 {
        return Outcome::Trivial;
    }
    let places = poles(judge, face);
    let answer = places.iter().map(|&at| judge.decide().decide(CoplanarPoles, at)).max();
    Outcome::of(answer.unwrap_or(Answer::Zero).max(judge.net.shape(face).planar), || {
        judge.worst("coplanar poles of the circles", CoplanarPoles, places.into_iter())
    })
}

/// The places of [`CoplanarPoles`] of a face, in a mesh with radii.
pub(super) fn poles<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Vec<[VertexId; 8]> {
    let corners = judge.topology().face(face);
    let with_radii = |at: [VertexId; 4]| {
        let radius = |i: usize| judge.radius(at[i]).unwrap_or(at[i]);
        std::array::from_fn(|i| if i < 4 { at[i] } else { radius(i - 4) })
    };
    planar::places(judge.decide(), corners).into_iter().flatten().map(with_radii).collect()
}

fn touching<D: Decide>(judge: &Judge<'_, D>, a: VertexId, b: VertexId) -> Outcome<D::Value> {
    let (Some(r), Some(s)) = (judge.radius(a), judge.radius(b)) else {
        return Outcome::Trivial;
    };
    if judge.decide().same_top_view(a, b) {
        return Outcome::Undefined(Reason::IsotropicEdge);
    }
    let at = [a, b, r, s];
    Outcome::of(judge.decide().decide(TouchingCircles, at), || {
        judge.failure("touching circles", TouchingCircles, at)
    })
}

fn circular<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    match (i_circular::outcome(judge, face), no_proper_quad(judge, face)) {
        (Outcome::Holds | Outcome::Trivial | Outcome::Consistent, Some(reason)) => {
            Outcome::Undefined(reason)
        }
        (outcome, _) => outcome,
    }
}

fn factorised<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let star: Vec<HalfEdge> = judge.topology().star(v).collect();
    if let Some(undefined) = undefined_face(judge, &star) {
        return undefined;
    }
    let (valence, around) = (star.len(), ring_of_quads(judge, &star));
    match valence {
        n if n % 2 == 1 => Outcome::Undefined(Reason::OddValence),
        n if n <= USUAL => cross_ratios::<D, { 1 + 2 * USUAL }>(judge, valence, padded(v, around)),
        n if n <= MOST => cross_ratios::<D, { 1 + 2 * MOST }>(judge, valence, padded(v, around)),
        _ => Outcome::Undefined(Reason::HighValence),
    }
}

fn cross_ratios<D: Decide, const K: usize>(
    judge: &Judge<'_, D>,
    valence: usize,
    at: [VertexId; K],
) -> Outcome<D::Value> {
    let part = |real| CrossRatioProduct { valence, real };
    let answer = |real| judge.decide().decide(part(real), at);
    Outcome::of(answer(true).max(answer(false)), || {
        let failure = |real| judge.failure("product of the cross-ratios", part(real), at);
        failure(true).worse(failure(false))
    })
}
