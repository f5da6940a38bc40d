//! Delaunay: the top view is a Delaunay triangulation, which is what makes the lift to Σ convex.
//!
//! Tested are, exactly: that faces of more than three corners are convex and concyclic; and at every
//! interior edge that its faces lie on different sides and no vertex of the second face
//! lies inside the circumcircle of the first (cocircular is allowed). If moreover the mesh is a
//! disc with a convex boundary, its top view is a triangulation of a convex polygon, and edges
//! decide. Otherwise it is only *locally* Delaunay, and the boundary is reported as undefined.
//! Isolated vertices do not count.

use super::Judge;
use super::i_circular::{self, Concyclic};
use super::planar::{Difference, ProjectedArea};
use crate::check::{Answer, Decide, Element, Outcome, Reason, Residual};
use crate::mesh::{FaceId, HalfEdge, Topology, VertexId, VertexKind};
use crate::scalar::{Ring, Sign};
use crate::space::Point;

/// The interior edges, the faces and the boundary vertices.
pub(super) fn elements(topology: &Topology) -> Vec<Element> {
    let interior = topology.edges().filter(|&h| topology.twin(h).is_some());
    let edges = interior.map(|h| Element::Edge(topology.origin(h), topology.target(h)));
    let boundary = topology
        .vertices()
        .filter(|&v| matches!(topology.kind(v), VertexKind::Boundary | VertexKind::Pinched));
    topology.faces().map(Element::Face).chain(edges).chain(boundary.map(Element::Vertex)).collect()
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, element: Element) -> Outcome<D::Value> {
    match element {
        Element::Face(face) => face_outcome(judge, face),
        Element::Edge(a, b) => {
            let edge = judge.topology().edge(a, b);
            edge.map_or(Outcome::Trivial, |h| edge_outcome(judge, h))
        }
        Element::Vertex(v) => boundary_outcome(judge, v),
    }
}

fn area<D: Decide>(judge: &Judge<'_, D>, at: [VertexId; 3]) -> Sign {
    judge.decide().sign(ProjectedArea::TopView, at).0
}

fn face_outcome<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    let corners = judge.topology().face(face);
    let n = corners.len();
    let turn = |i: usize| area(judge, [corners[i], corners[(i + 1) % n], corners[(i + 2) % n]]);
    let sense = turn(0);
    if sense == Sign::Zero || (1..n).any(|i| turn(i) != sense) {
        return Outcome::Undefined(Reason::NotEmbedded(face));
    }
    if n == 3 {
        return Outcome::Trivial;
    }
    let places = i_circular::places(judge.decide(), corners);
    let answer = places.iter().map(|&at| judge.decide().decide(Concyclic, at)).max();
    Outcome::of(answer.unwrap_or(Answer::Zero), || {
        judge.worst("concyclic", Concyclic, places.into_iter())
    })
}

fn edge_outcome<D: Decide>(judge: &Judge<'_, D>, h: HalfEdge) -> Outcome<D::Value> {
    let topology = judge.topology();
    let Some(twin) = topology.twin(h) else {
        return Outcome::Trivial;
    };
    let apex = |h| topology.target(topology.next(h));
    let (a, b) = (topology.origin(h), topology.target(h));
    let (left, right) = (apex(h), apex(twin));
    let sense = area(judge, [a, b, left]);
    if sense == Sign::Zero || area(judge, [b, a, right]) != sense {
        return Outcome::Undefined(Reason::FoldedEdge);
    }
    let at = [a, b, left, right];
    if judge.decide().sign(Concyclic, at).0 != sense {
        return Outcome::Holds;
    }
    let mut answer = judge.decide().decide(Concyclic, at);
    let turns = |at| judge.decide().decide(ProjectedArea::TopView, at) == Answer::InBox;
    if answer == Answer::Nonzero && (turns([a, b, left]) || turns([b, a, right])) {
        // Somewhere in the box a triangle may turn over, and its inside with it.
        answer = Answer::InBox;
    }
    Outcome::of(answer, || judge.failure("empty circumcircle", Concyclic, at))
}

fn boundary_outcome<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let topology = judge.topology();
    if topology.kind(v) != VertexKind::Boundary || !judge.net.is_disc() {
        return Outcome::Undefined(Reason::NotConvex);
    }
    let Some(first) = topology.star(v).next() else {
        return Outcome::Trivial;
    };
    // The boundary runs with the faces on its left: into v along the last edge of the fan.
    let Some(before) = topology.star(v).last().map(|h| topology.origin(topology.prev(h))) else {
        return Outcome::Trivial;
    };
    let sense = area(judge, [v, topology.target(first), topology.target(topology.next(first))]);
    if is_convex(judge.decide(), [before, v, topology.target(first)], sense) {
        Outcome::Trivial
    } else {
        Outcome::Undefined(Reason::NotConvex)
    }
}

/// Whether a polygon turns to the side `sense` at the second point, or goes straight on.
fn is_convex<D: Decide>(decide: &D, at: [VertexId; 3], sense: Sign) -> bool {
    match decide.sign(ProjectedArea::TopView, at).0 {
        Sign::Zero => decide.sign(Onward, at).0 == Sign::Positive,
        turn => turn == sense,
    }
}

/// The inner product of two consecutive edges in the top view: positive if it goes on, not back.
#[derive(Clone, Copy, Debug)]
struct Onward;

impl Residual<3> for Onward {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, [a, b, c]: &[Point<R>; 3], _: &R) -> R {
        (b - a).top_view().dot(&(c - b).top_view())
    }
}

/// Whether the mesh is one disc, and its boundary, if it turns to one side only, winds once.
pub(super) fn is_disc<D: Decide>(topology: &Topology, decide: &D) -> bool {
    let loops = topology.boundary_loops();
    let [boundary] = loops.as_slice() else {
        return false;
    };
    let used = topology.vertices().filter(|&v| topology.kind(v) != VertexKind::Isolated).count();
    let isolated = topology.vertex_count() - used;
    if topology.component_count() - isolated != 1
        || topology.euler_characteristic() - isolated as i64 != 1
    {
        return false;
    }
    let n = boundary.len();
    let corners = (0..n).map(|i| [boundary[i], boundary[(i + 1) % n], boundary[(i + 2) % n]]);
    let one_sided = |sense| corners.clone().all(|at| is_convex(decide, at, sense));
    if !one_sided(Sign::Positive) && !one_sided(Sign::Negative) {
        // Reported where it bends the other way.
        return true;
    }
    // The signs of the differences of y along a closed convex polygon tell how often it winds.
    let next = boundary.iter().cycle().skip(1);
    let signs: Vec<Sign> = boundary
        .iter()
        .zip(next)
        .map(|(&a, &b)| decide.sign(Difference(1), [a, b]).0)
        .filter(|&s| s != Sign::Zero)
        .collect();
    let after = signs.iter().cycle().skip(1);
    let minima =
        signs.iter().zip(after).filter(|&(&a, &b)| a == Sign::Negative && b == Sign::Positive);
    minima.count() == 1
}
