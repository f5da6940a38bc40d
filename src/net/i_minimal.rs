//! i-minimal meshes in the sense of vertices: `H = 0` in (22), with the lift to Σ as Gauss image.
//!
//! With signed radii of vertex circles the lift is that of the circles, the v-parallel Koebe mesh with
//! the heights `(|x'|² − r²)/2`; without, the radii are 0 and the lift lies on Σ. At an interior
//! vertex the mixed measure `D(v, s)` must vanish; `D(s)`, which may be 0, is not divided by.
//!
//! Undefined are vertices at faces that are vertical, whose lift is not planar, or that are straight
//! at the vertex in the top view; and more than 16 faces around one.

use super::Judge;
use super::i_circular::{self, Concyclic};
use super::i_conical::planes_around;
use super::i_isothermic::{CoplanarPoles, lifted, poles};
use super::planar::ProjectedArea;
use super::star::{MOST, TRIANGLES, USUAL, padded};
use crate::check::{Answer, Decide, Outcome, Reason, Residual};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::{Ring, Sign};
use crate::space::{Point, Vector2};

/// `2 D(v, s) ∏ d_j` with `d_j = det(e_j, e_{j+1})` of the edges around a vertex in the top view, for the
/// lift of circles (`RADII`) or of points: `Σ g_j V_j ∏ d_i` over `i ≠ j − 1, j`, with twice the heights
/// g of the lift and the volumes `V_j = det(e_{j−1}, e_j, e_{j+1})` of the edges in space.
///
/// The points are the vertex and its neighbours, and in the second half of the places their radii,
/// as x-coordinates; what lies between is not looked at.
#[derive(Clone, Copy, Debug)]
pub struct MixedMeasure<const RADII: bool> {
    /// The number of faces around the vertex.
    pub valence: usize,
}

impl<const K: usize, const RADII: bool> Residual<K> for MixedMeasure<RADII> {
    const TRANSLATES: bool = !RADII;

    fn eval<R: Ring>(self, points: &[Point<R>; K], _: &R) -> R {
        let n = self.valence;
        let edges: Vec<_> = (1..=n).map(|j| &points[j] - &points[0]).collect();
        let views: Vec<Vector2<R>> = edges.iter().map(|e| e.top_view()).collect();
        let sines: Vec<R> = (0..n).map(|j| views[j].det(&views[(j + 1) % n])).collect();
        (0..n).fold(R::zero(), |sum, j| {
            let (before, after) = ((j + n - 1) % n, (j + 1) % n);
            let height = if RADII {
                lifted(&views[j], &points[K / 2].x, &points[K / 2 + 1 + j].x)
            } else {
                views[j].length2()
            };
            let volume = &edges[before].z * &sines[j]
                - &edges[j].z * views[before].det(&views[after])
                + &edges[after].z * &sines[before];
            let others = (0..n).filter(|&i| i != j && i != before);
            sum + others.fold(height * volume, |product, i| product * &sines[i])
        })
    }
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let topology = judge.topology();
    let star: Vec<HalfEdge> = topology.star(v).collect();
    let mut planar = match planes_around(judge, &star) {
        Ok(answer) => answer,
        Err(outcome) => return outcome,
    };
    for &h in &star {
        let face = topology.face_at(h);
        match lift(judge, face) {
            Answer::Nonzero => return Outcome::Undefined(Reason::NoLift(face)),
            answer => planar = planar.max(answer),
        }
        let corner = [topology.origin(topology.prev(h)), v, topology.target(h)];
        if judge.decide().sign(ProjectedArea::TopView, corner).0 == Sign::Zero {
            return Outcome::Undefined(Reason::StraightCorner(face));
        }
    }
    let around: Vec<VertexId> = star.iter().map(|&h| topology.target(h)).collect();
    let valence = around.len();
    match (valence, judge.radius(v)) {
        (n, None) if n <= TRIANGLES => {
            measure::<D, { 1 + TRIANGLES }, false>(judge, valence, padded(v, around), planar)
        }
        (n, None) if n <= MOST => {
            measure::<D, { 1 + MOST }, false>(judge, valence, padded(v, around), planar)
        }
        (n, Some(_)) if n <= USUAL => {
            let at = with_radii::<D, { 2 + 2 * USUAL }>(judge, v, &around);
            measure::<D, { 2 + 2 * USUAL }, true>(judge, valence, at, planar)
        }
        (n, Some(_)) if n <= MOST => {
            let at = with_radii::<D, { 2 + 2 * MOST }>(judge, v, &around);
            measure::<D, { 2 + 2 * MOST }, true>(judge, valence, at, planar)
        }
        _ => Outcome::Undefined(Reason::HighValence),
    }
}

/// Whether the lift of a face is planar.
fn lift<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Answer {
    let corners = judge.topology().face(face);
    if corners.len() == 3 {
        return Answer::Zero;
    }
    let answer = if judge.net.radii.is_some() {
        let poles = poles(judge, face);
        poles.into_iter().map(|at| judge.decide().decide(CoplanarPoles, at)).max()
    } else {
        let places = i_circular::places(judge.decide(), corners);
        places.into_iter().map(|at| judge.decide().decide(Concyclic, at)).max()
    };
    answer.unwrap_or(Answer::Zero)
}

/// A vertex with its neighbours, and in the second half their radii.
fn with_radii<D: Decide, const K: usize>(
    judge: &Judge<'_, D>,
    v: VertexId,
    around: &[VertexId],
) -> [VertexId; K] {
    let mut at = padded::<K>(v, around.iter().copied());
    for i in 0..=around.len() {
        at[K / 2 + i] = judge.radius(at[i]).unwrap_or(v);
    }
    at
}

fn measure<D: Decide, const K: usize, const RADII: bool>(
    judge: &Judge<'_, D>,
    valence: usize,
    at: [VertexId; K],
    planar: Answer,
) -> Outcome<D::Value> {
    let residual = MixedMeasure::<RADII> { valence };
    Outcome::of(judge.decide().decide(residual, at).max(planar), || {
        judge.failure("mixed measure 0", residual, at)
    })
}
