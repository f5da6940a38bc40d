//! Edge-offset meshes of Euclidean space (Remark 2): planar meshes that are parallel to one whose edges
//! touch the unit sphere.
//!
//! Let S be that mesh and s its vertex that belongs to v. The lines through s in the directions of
//! the edges `e_j` at v touch the unit sphere, so `(s·e_j)² = (|s|² − 1) |e_j|²`: with signs
//! `ε_j = ±1` and a multiple a of s, `a·e_j = ε_j |e_j|`. Three independent edges determine a for given
//! signs; always `|a| > 1`, and `s = ±a/√(|a|² − 1)` is real. What is tested are, exactly,
//!
//! - faces: they are planar;
//! - vertices with more than three edges: for some signs they have a common a, that is, the edges as
//!   *lines* lie on a cone of revolution with that axis ([`EdgesOnCone`]). Not as rays: at a saddle
//!   the dual of a mesh turns every other edge;
//! - edges: the axes at both ends lie in a plane with the edge ([`CoplanarAxes`]), so that both ask for the
//!   same point of contact. An edge fails also where an end has no cone.
//!
//! All three are necessary. They suffice if M is simply connected, no vertex has more than one such
//! cone, and no face plane of S passes through the centre: around a face the points of contact then agree
//! with their signs. Cones alone do not suffice, unlike planes of a conical mesh. Where edges are
//! symmetric, or only three, several choices of signs may have a cone, and every edge is content
//! with one of them by itself: that they fit together is not asked.
//!
//! Vertices on the boundary count as well, by the edges that they have; with two edges they, and with them
//! their edges, are free. Undefined are vertices whose edges lie in a plane or of which one has
//! length 0, and edges at them. Pinched vertices are left out.

use super::Judge;
use super::planar::{self, Coplanar, ProjectedArea};
use crate::check::{Answer, Decide, Element, Failure, Outcome, Reason, RootSum};
use crate::mesh::{Topology, VertexId, VertexKind};
use crate::scalar::{Ring, Sign};
use crate::space::{Point, Vector3};

/// The determinant with rows `(ε_j e_j, |e_j|)` for the edges from the first point to four others: zero
/// iff they lie, as lines with these signs, on a cone of revolution, provided they do not lie in a plane.
///
/// It is a sum of four square roots, decided exactly.
#[derive(Clone, Copy, Debug)]
pub struct EdgesOnCone {
    /// Which of the second to fourth edges have another sign than the first.
    pub turned: [bool; 3],
}

impl RootSum<5, 4> for EdgesOnCone {
    fn eval<R: Ring>(self, [v, x @ ..]: &[Point<R>; 5]) -> [(R, R); 4] {
        let e = [0, 1, 2, 3].map(|j| &x[j] - v);
        let [second, third, fourth] = self.turned;
        // Every minor has the signs of all edges but one.
        [(0, [1, 3, 2]), (1, [0, 2, 3]), (2, [0, 3, 1]), (3, [0, 1, 2])].map(|(own, [i, j, k])| {
            let minor = Vector3::det(&e[i], &e[j], &e[k]);
            let minor = if [false, second, third, fourth][own] { -minor } else { minor };
            (minor, e[own].length2())
        })
    }
}

/// The determinant of an edge and the axes at its ends, each by three edges with signs: zero iff the
/// three lie in a plane. The points are the ends, then three neighbours of each.
///
/// The axis of edges `e_j` is, up to a factor, `Σ ε_j |e_j| e_k × e_l`, so this is a sum of nine square
/// roots, decided exactly.
#[derive(Clone, Copy, Debug)]
pub struct CoplanarAxes {
    /// At each end, which of the second and third edges have another sign than the first.
    pub turned: [[bool; 2]; 2],
}

impl RootSum<8, 9> for CoplanarAxes {
    fn eval<R: Ring>(self, [v, w, a @ .., b0, b1, b2]: &[Point<R>; 8]) -> [(R, R); 9] {
        let along = w - v;
        let [first, second] = self.turned;
        let a = axis([0, 1, 2].map(|j| &a[j] - v), first);
        let b = axis([b0, b1, b2].map(|x| x - w), second);
        std::array::from_fn(|i| {
            let ((m, p), (n, q)) = (&a[i / 3], &b[i % 3]);
            (Vector3::det(&along, m, n), p.clone() * q)
        })
    }
}

/// The terms `ε_j e_k × e_l` of an axis and the squares of their factors `|e_j|`.
fn axis<R: Ring>(e: [Vector3<R>; 3], [second, third]: [bool; 2]) -> [(Vector3<R>, R); 3] {
    let term = |turned: bool, own: usize| {
        let (k, l) = (&e[(own + 1) % 3], &e[(own + 2) % 3]);
        (if turned { l.cross(k) } else { k.cross(l) }, e[own].length2())
    };
    [term(false, 0), term(second, 1), term(third, 2)]
}

/// The signs of three edges, up to a common one.
const SIGNS: [[bool; 2]; 4] = [[false, false], [false, true], [true, false], [true, true]];

/// The faces, the vertices that are not pinched, and the edges.
pub(super) fn elements(topology: &Topology) -> Vec<Element> {
    let whole =
        |&v: &VertexId| matches!(topology.kind(v), VertexKind::Interior | VertexKind::Boundary);
    let edges = topology.edges().map(|h| (topology.origin(h), topology.target(h)));
    let edges = edges.filter(|(a, b)| whole(a) && whole(b)).map(|(a, b)| Element::Edge(a, b));
    let vertices = topology.vertices().filter(whole).map(Element::Vertex);
    topology.faces().map(Element::Face).chain(vertices).chain(edges).collect()
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, element: Element) -> Outcome<D::Value> {
    match element {
        Element::Face(face) => planar::outcome(judge, face),
        Element::Vertex(v) => at_vertex(judge, v),
        Element::Edge(a, b) => at_edge(judge, a, b),
    }
}

/// The edges at a vertex: three that are independent, and the others.
#[derive(Clone, Debug)]
pub(super) struct Cones {
    base: [VertexId; 3],
    others: Vec<VertexId>,
    /// For each choice of [`SIGNS`] whether the others fit.
    fits: [Answer; 4],
    /// By how much the worst edge misses with the signs that come nearest.
    defect: f64,
}

/// The cones at a vertex, which has them of its choice if it has two edges; or why it has none.
pub(super) type AtVertex = Result<Option<Cones>, Reason>;

/// The cones of edges at a vertex.
pub(super) fn cones<D: Decide>(topology: &Topology, decide: &D, v: VertexId) -> AtVertex {
    let mut others = neighbours(topology, v);
    if others.len() < 3 {
        return Ok(None);
    }
    if others.iter().any(|&x| decide.same_point(v, x)) {
        return Err(Reason::PointEdge(v));
    }
    let base = independent(decide, v, &others).ok_or(Reason::FlatVertex(v))?;
    others.retain(|x| !base.contains(x));
    let mut cones = Cones { base, others, fits: [Answer::Zero; 4], defect: 0.0 };
    cones.fits = SIGNS.map(|signs| {
        let fit = |pair: [(EdgesOnCone, [VertexId; 5]); 2]| {
            pair.into_iter().map(|(sum, at)| decide.decide_roots(sum, at)).min()
        };
        cones.places(v, signs).filter_map(fit).max().unwrap_or(Answer::Zero)
    });
    if cones.best() != Answer::Zero {
        cones.defect = cones.find_defect(decide, v);
    }
    Ok(Some(cones))
}

/// The same, if it has been found out before.
fn known<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> AtVertex {
    match judge.net.cones.get() {
        Some(cones) => cones[v.index()].clone(),
        None => cones(judge.topology(), judge.decide(), v),
    }
}

impl Cones {
    /// The residuals of the other edges, for either sign of each.
    fn places(
        &self,
        v: VertexId,
        [second, third]: [bool; 2],
    ) -> impl Iterator<Item = [(EdgesOnCone, [VertexId; 5]); 2]> {
        let [a, b, c] = self.base;
        self.others.iter().map(move |&x| {
            let at = [v, a, b, c, x];
            [false, true].map(|fourth| (EdgesOnCone { turned: [second, third, fourth] }, at))
        })
    }

    fn best(&self) -> Answer {
        self.fits.into_iter().min().unwrap_or(Answer::Zero)
    }

    fn find_defect<D: Decide>(&self, decide: &D, v: VertexId) -> f64 {
        let defect = |(sum, at)| decide.root_failure("", sum, at).defect;
        let worst = |signs| {
            let each = self.places(v, signs).map(|pair| pair.map(defect));
            each.map(|[a, b]| a.min(b)).fold(0.0, f64::max)
        };
        SIGNS.map(worst).into_iter().fold(f64::INFINITY, f64::min)
    }

    fn failure<V>(&self) -> Failure<V> {
        Failure { condition: "edges on a cone", defect: self.defect, residual: None }
    }
}

fn at_vertex<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let cones = match known(judge, v) {
        Ok(Some(cones)) => cones,
        Ok(None) => return Outcome::Trivial,
        Err(reason) => return Outcome::Undefined(reason),
    };
    if cones.others.is_empty() {
        return Outcome::Trivial;
    }
    Outcome::of(cones.best(), || cones.failure())
}

fn at_edge<D: Decide>(judge: &Judge<'_, D>, v: VertexId, w: VertexId) -> Outcome<D::Value> {
    let [a, b] = match [v, w].map(|end| known(judge, end)) {
        [Ok(Some(a)), Ok(Some(b))] => [a, b],
        [Err(reason), _] | [_, Err(reason)] => return Outcome::Undefined(reason),
        _ => return Outcome::Trivial,
    };
    let [a0, a1, a2] = a.base;
    let [b0, b1, b2] = b.base;
    let at = [v, w, a0, a1, a2, b0, b1, b2];
    let mut choices = Vec::with_capacity(16);
    for (signs, fit) in SIGNS.into_iter().zip(a.fits) {
        for (others, other) in SIGNS.into_iter().zip(b.fits) {
            choices.push((CoplanarAxes { turned: [signs, others] }, fit.max(other)));
        }
    }
    choices.retain(|(_, fit)| *fit != Answer::Nonzero);
    let mut answer = Answer::Nonzero;
    for (sum, fit) in &choices {
        if answer > Answer::Zero {
            answer = answer.min(judge.decide().decide_roots(*sum, at).max(*fit));
        }
    }
    Outcome::of(answer, || {
        let failure =
            |(sum, _)| judge.decide().root_failure("axes in a plane with the edge", sum, at);
        match (a.best(), b.best()) {
            // Without a cone at an end there is no axis.
            (Answer::Nonzero, _) => a.failure(),
            (_, Answer::Nonzero) => b.failure(),
            _ => nearest(choices.into_iter().map(failure)),
        }
    })
}

/// The failure with the smallest defect.
fn nearest<V>(failures: impl Iterator<Item = Failure<V>>) -> Failure<V> {
    let none = Failure { condition: "axes in a plane with the edge", defect: 0.0, residual: None };
    let less = |a: Failure<V>, b: Failure<V>| if b.defect < a.defect { b } else { a };
    failures.reduce(less).unwrap_or(none)
}

/// The other ends of the edges at an interior or a boundary vertex.
fn neighbours(topology: &Topology, v: VertexId) -> Vec<VertexId> {
    let mut ends: Vec<VertexId> = topology.star(v).map(|h| topology.target(h)).collect();
    if topology.kind(v) == VertexKind::Boundary {
        ends.extend(topology.star(v).last().map(|h| topology.origin(topology.prev(h))));
    }
    ends
}

/// Three of the points that do not lie in a plane with the vertex.
fn independent<D: Decide>(decide: &D, v: VertexId, ends: &[VertexId]) -> Option<[VertexId; 3]> {
    let (&a, others) = ends.split_first()?;
    let spans = |b: VertexId| {
        let projections = ProjectedArea::ALL.into_iter();
        projections.map(|p| decide.sign(p, [v, a, b]).0).any(|sign| sign != Sign::Zero)
    };
    let b = others.iter().copied().find(|&b| spans(b))?;
    let c =
        others.iter().copied().find(|&c| decide.sign(Coplanar, [v, a, b, c]).0 != Sign::Zero)?;
    Some([a, b, c])
}
