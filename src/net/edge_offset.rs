//! Edge-offset meshes of Euclidean space (Remark 2): planar meshes M that are parallel to a mesh S whose
//! edges touch the unit sphere.
//!
//! An edge of S may have length 0; its line is then the one through its ends in the direction of
//! the edge of M. So S is a point s for every vertex such that the lines through the points at both
//! ends of an edge e, in the direction of e, are one line that touches the sphere: one *point of contact*
//! p with `|p| = 1` and `p·e = 0`. Faces of S are planar if those of M are.
//!
//! *At a vertex* with the edges `e_j` the lines touch iff `(s·e_j)² = (|s|² − 1) |e_j|²`. With the multiple
//! `a = s/√(|s|² − 1)` this says `a·e_j = ε_j |e_j|` for signs `ε_j = ±1`: the edges as *lines* lie on a cone of
//! revolution with the axis a. Not as rays: at a saddle the dual of a mesh turns every other edge. If
//! the edges do not lie in a plane, three of them with their signs determine a, and `|a| > 1`; so there are
//! up to four cones, and for each a and −a, which give s and −s. The other edges decide which cones there are
//! ([`EdgesOnCone`]).
//!
//! *At an edge* between two such vertices, with the axes a and b, the point of contact seen from
//! the one end is `a⊥/|a⊥|`, where a⊥ is the part of a orthogonal to e, and `|a⊥|² = |a|² − 1 > 0`. Both ends see
//! the same iff b⊥ is a positive multiple of a⊥: the axes lie in a plane with the edge
//! ([`CoplanarAxes`]), and `(e×a)·(e×b) > 0` ([`SameSide`]). Without the latter they see antipodes.
//!
//! *A vertex with two edges* that do not lie on a line has no cone of its own. The lines of its edges,
//! if they are known, lie in the plane of the face of S, and meet there. A chain of such vertices has free
//! edges; in that plane, which meets the sphere, there are tangents of any direction. But
//! vertices with cones that such chains separate within a face know nothing of each other, and
//! whether their face planes agree is not asked: that face is undecided.
//!
//! So S exists iff faces are planar and at every vertex with three edges or more an axis can be
//! *chosen*, one of up to eight, such that both conditions hold along every edge. This takes care
//! of symmetric stars, of loops around holes and handles, and of face planes through the centre. Tested
//! are, exactly, all elements by themselves: faces, vertices (is there a cone), edges (do any two cones
//! fit); then, for each component where all are content, whether there is a joint choice,
//! found by trial. If there is none, a vertex fails; if the search is given up, it is
//! undecided. Over boxes the search goes by what is possible at each element by itself.
//!
//! Vertices on the boundary and pinched ones count like others. Undefined are vertices with three
//! edges or more that lie in a plane, with two on a line or one of length 0, and edges at them.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::Judge;
use super::choice::{Choices, Found, Link, Search, components};
use super::planar::{self, Coplanar, ProjectedArea};
use crate::check::{Answer, Decide, Element, Failure, Outcome, Reason, RootSum};
use crate::mesh::{FaceId, Topology, VertexId, VertexKind};
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
        let ends = [(v, a.each_ref()), (w, [b0, b1, b2])];
        axes(ends, self.turned, |m, n| Vector3::det(&along, m, n))
    }
}

/// `(e×a)·(e×b)` for an edge and the axes at its ends, of the same points as [`CoplanarAxes`]: where that is
/// zero, the sign tells whether the axes lie on the same side of the edge, provided the three edges of
/// either have the same orientation. It is never zero then.
#[derive(Clone, Copy, Debug)]
pub struct SameSide {
    /// At each end, which of the second and third edges have another sign than the first.
    pub turned: [[bool; 2]; 2],
}

impl RootSum<8, 9> for SameSide {
    fn eval<R: Ring>(self, [v, w, a @ .., b0, b1, b2]: &[Point<R>; 8]) -> [(R, R); 9] {
        let along = w - v;
        let ends = [(v, a.each_ref()), (w, [b0, b1, b2])];
        axes(ends, self.turned, |m, n| along.cross(m).dot(&along.cross(n)))
    }
}

/// A bilinear form of the axes at two points, each by three edges to others with signs.
fn axes<R: Ring>(
    [(v, a), (w, b)]: [(&Point<R>, [&Point<R>; 3]); 2],
    [first, second]: [[bool; 2]; 2],
    form: impl Fn(&Vector3<R>, &Vector3<R>) -> R,
) -> [(R, R); 9] {
    let (a, b) = (axis(a.map(|x| x - v), first), axis(b.map(|x| x - w), second));
    std::array::from_fn(|i| {
        let ((m, p), (n, q)) = (&a[i / 3], &b[i % 3]);
        (form(m, n), p.clone() * q)
    })
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

/// The faces, the vertices that are not isolated, and the edges.
pub(super) fn elements(topology: &Topology) -> Vec<Element> {
    let used = |&v: &VertexId| topology.kind(v) != VertexKind::Isolated;
    let edges = topology.edges().map(|h| Element::Edge(topology.origin(h), topology.target(h)));
    let vertices = topology.vertices().filter(used).map(Element::Vertex);
    topology.faces().map(Element::Face).chain(vertices).chain(edges).collect()
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, element: Element) -> Outcome<D::Value> {
    let Some(axes) = judge.net.axes.get() else {
        return Outcome::Undecided;
    };
    match element {
        Element::Face(face) => at_face(judge, axes, face),
        Element::Vertex(v) => at_vertex(axes, v),
        Element::Edge(a, b) => at_edge(judge, axes, [a, b]),
    }
}

/// The edges at a vertex: three that are independent, and the others.
#[derive(Clone, Debug)]
struct Cones {
    /// Their determinant is positive.
    base: [VertexId; 3],
    /// Whether it is in the whole box.
    oriented: bool,
    others: Vec<VertexId>,
    /// For each choice of [`SIGNS`] whether the others fit.
    fits: [Answer; 4],
    /// By how much the worst edge misses with the signs that come nearest.
    defect: f64,
}

/// For the cones at both ends of an edge, and the axes as they are or one of them turned over, whether
/// both see the same point of contact.
type Contact = [[[Answer; 2]; 4]; 4];

/// What is known of the cones of a mesh.
#[derive(Debug)]
pub(super) struct Axes {
    /// The cones at each vertex, which has them of its choice if it has two edges; or why it has none.
    cones: Vec<Result<Option<Cones>, Reason>>,
    /// The edges between vertices with cones, in ascending order.
    contacts: Vec<([VertexId; 2], Contact)>,
    /// Vertices at which it was seen how well the cones of a component fit together, if that is not
    /// as well as its elements do.
    joint: BTreeMap<VertexId, Result<Answer, Reason>>,
}

impl Axes {
    /// All that is to know.
    pub fn find<D: Decide>(topology: &Topology, decide: &D) -> Self {
        let vertices = 0..topology.vertex_count() as u32;
        let at = |v| cones(topology, decide, VertexId(v));
        let cones: Vec<_> = vertices.into_par_iter().map(at).collect();
        let edges: Vec<_> =
            topology.edges().map(|h| [topology.origin(h), topology.target(h)]).collect();
        let contact = |&ends: &[VertexId; 2]| match ends.map(|v| &cones[v.index()]) {
            [Ok(Some(a)), Ok(Some(b))] => Some((ends, contact(decide, ends, [a, b]))),
            _ => None,
        };
        let mut contacts: Vec<_> = edges.par_iter().filter_map(contact).collect();
        contacts.sort_unstable_by_key(|(ends, _)| *ends);
        let mut axes = Axes { cones, contacts, joint: BTreeMap::new() };
        axes.join();
        axes
    }

    /// Looks for joint choices.
    fn join(&mut self) {
        let ends: Vec<_> =
            self.contacts.iter().map(|(ends, _)| ends.map(VertexId::index)).collect();
        let best = |cones: &Result<Option<Cones>, _>| match cones {
            Ok(Some(cones)) => cones.best(),
            _ => Answer::Zero,
        };
        let mut worst: Vec<Answer> = self.cones.iter().map(best).collect();
        for (ends, (_, contact)) in ends.iter().zip(&self.contacts) {
            ends.iter().for_each(|&v| worst[v] = worst[v].max(least(contact)));
        }
        let mut searches = [const { None }; 3];
        for component in components(&self.choices(Answer::Near), &ends) {
            let own = component.iter().map(|&v| worst[v]).max().unwrap_or(Answer::Zero);
            let (mut seen_at, mut joint) = (component[0], Ok(Answer::Nonzero));
            for (level, search) in LEVELS.into_iter().zip(&mut searches) {
                if level < own {
                    continue;
                }
                let search = search.get_or_insert_with(|| self.search(level));
                match search.run(&component) {
                    Found::Fitting => joint = Ok(level),
                    Found::Nothing(v) => {
                        seen_at = v;
                        continue;
                    }
                    Found::Lost(v) => joint = Err(Reason::ManyCones(VertexId(v as u32))),
                }
                break;
            }
            if joint != Ok(own) {
                self.joint.insert(VertexId(seen_at as u32), joint);
            }
        }
    }

    /// The search among what is no worse than `level`.
    fn search(&self, level: Answer) -> Search {
        let link = |&(ends, contact): &([VertexId; 2], Contact)| {
            let fits = |c: usize, d: usize, turned| contact[c][d][usize::from(turned)] <= level;
            Link::new(ends.map(VertexId::index), fits)
        };
        Search::new(self.choices(level), self.contacts.iter().map(link).collect())
    }

    /// The cones at each vertex that are no worse than `level`, each with both axes.
    fn choices(&self, level: Answer) -> Vec<Choices> {
        let choices = |cones: &Result<Option<Cones>, _>| match cones {
            Ok(Some(Cones { fits, .. })) => {
                let bit = |c: usize| if fits[c] <= level { 0x11 << c } else { 0 };
                (0..4).map(bit).fold(0, |all, bit| all | bit)
            }
            _ => 0,
        };
        self.cones.iter().map(choices).collect()
    }
}

/// All answers but no.
const LEVELS: [Answer; 3] = [Answer::Zero, Answer::InBox, Answer::Near];

/// The answer for the cones that fit best.
fn least(contact: &Contact) -> Answer {
    contact.iter().flatten().flatten().copied().min().unwrap_or(Answer::Nonzero)
}

/// The cones of edges at a vertex.
fn cones<D: Decide>(topology: &Topology, decide: &D, v: VertexId) -> Result<Option<Cones>, Reason> {
    let mut others = topology.neighbours(v);
    if others.iter().any(|&x| decide.same_point(v, x)) {
        return Err(Reason::PointEdge(v));
    }
    if let [a, b] = *others {
        return if spans(decide, [v, a, b]) { Ok(None) } else { Err(Reason::StraightVertex(v)) };
    }
    if others.is_empty() {
        return Ok(None);
    }
    let (base, oriented) = independent(decide, v, &others).ok_or(Reason::FlatVertex(v))?;
    others.retain(|x| !base.contains(x));
    let mut cones = Cones { base, oriented, others, fits: [Answer::Zero; 4], defect: 0.0 };
    for (sums, at) in cones.places(v) {
        let found = decide.decide_each_roots(sums, at);
        let either = found.chunks(2).map(|pair| pair.iter().copied().min());
        for (fit, either) in cones.fits.iter_mut().zip(either.flatten()) {
            *fit = either.max(*fit);
        }
    }
    if cones.best() != Answer::Zero {
        cones.defect = cones.find_defect(decide, v);
    }
    Ok(Some(cones))
}

/// Which cones at the ends of an edge have the same point of contact.
fn contact<D: Decide>(decide: &D, ends: [VertexId; 2], [a, b]: [&Cones; 2]) -> Contact {
    let at = places(ends, [a, b]);
    let fit = |c: usize, d: usize| {
        let (fit, turned) = (a.fits[c].max(b.fits[d]), [SIGNS[c], SIGNS[d]]);
        if fit == Answer::Nonzero {
            return [fit; 2];
        }
        let fit = fit.max(decide.decide_roots(CoplanarAxes { turned }, at));
        if fit == Answer::Nonzero {
            return [fit; 2];
        }
        let (sign, certain) = decide.sign_of_roots(SameSide { turned }, at);
        let otherwise = match certain && a.oriented && b.oriented {
            true => Answer::Nonzero,
            false => fit.max(Answer::InBox),
        };
        match sign {
            Sign::Positive => [fit, otherwise],
            Sign::Negative => [otherwise, fit],
            Sign::Zero => [fit; 2],
        }
    };
    std::array::from_fn(|c| std::array::from_fn(|d| fit(c, d)))
}

/// Where the axes at the ends of an edge are evaluated.
fn places([v, w]: [VertexId; 2], [a, b]: [&Cones; 2]) -> [VertexId; 8] {
    let ([a0, a1, a2], [b0, b1, b2]) = (a.base, b.base);
    [v, w, a0, a1, a2, b0, b1, b2]
}

impl Cones {
    /// The residuals of the other edges: for each of [`SIGNS`] those with either sign of the other.
    fn places(&self, v: VertexId) -> Vec<([EdgesOnCone; 8], [VertexId; 5])> {
        let [a, b, c] = self.base;
        let turned = |i: usize| [SIGNS[i / 2][0], SIGNS[i / 2][1], i % 2 == 1];
        let sums = std::array::from_fn(|i| EdgesOnCone { turned: turned(i) });
        self.others.iter().map(|&x| (sums, [v, a, b, c, x])).collect()
    }

    fn best(&self) -> Answer {
        self.fits.into_iter().min().unwrap_or(Answer::Zero)
    }

    fn find_defect<D: Decide>(&self, decide: &D, v: VertexId) -> f64 {
        let mut worst = [0.0f64; 4];
        for (sums, at) in self.places(v) {
            let defects = sums.map(|sum| decide.root_failure("", sum, at).defect);
            for (worst, pair) in worst.iter_mut().zip(defects.chunks(2)) {
                *worst = worst.max(pair[0].min(pair[1]));
            }
        }
        worst.into_iter().fold(f64::INFINITY, f64::min)
    }

    fn failure<V>(&self) -> Failure<V> {
        Failure { condition: "edges on a cone", defect: self.defect, residual: None }
    }
}

/// A face is planar, and its vertices with cones follow each other.
fn at_face<D: Decide>(judge: &Judge<'_, D>, axes: &Axes, face: FaceId) -> Outcome<D::Value> {
    let corners = judge.topology().face(face);
    let free = |v: &VertexId| matches!(axes.cones[v.index()], Ok(None));
    let next = corners.iter().cycle().skip(1);
    let chains = corners.iter().zip(next).filter(|(v, w)| free(v) && !free(w)).count();
    match planar::outcome(judge, face) {
        Outcome::Holds | Outcome::Trivial | Outcome::Consistent if chains > 1 => {
            Outcome::Undefined(Reason::LooseFace(face))
        }
        outcome => outcome,
    }
}

fn at_vertex<V>(axes: &Axes, v: VertexId) -> Outcome<V> {
    let cones = match &axes.cones[v.index()] {
        Ok(Some(cones)) => cones,
        Ok(None) => return Outcome::Trivial,
        Err(reason) => return Outcome::Undefined(*reason),
    };
    // A choice is made or not; nothing is nearly one.
    let failure = || Failure { condition: "cones that fit together", defect: 1.0, residual: None };
    match axes.joint.get(&v) {
        Some(Ok(answer)) => Outcome::of(*answer, failure),
        Some(Err(reason)) => Outcome::Undefined(*reason),
        None if cones.others.is_empty() => Outcome::Trivial,
        None => Outcome::of(cones.best(), || cones.failure()),
    }
}

fn at_edge<D: Decide>(judge: &Judge<'_, D>, axes: &Axes, ends: [VertexId; 2]) -> Outcome<D::Value> {
    let cones = match ends.map(|v| &axes.cones[v.index()]) {
        [Ok(Some(a)), Ok(Some(b))] => [a, b],
        [Err(reason), _] | [_, Err(reason)] => return Outcome::Undefined(*reason),
        _ => return Outcome::Trivial,
    };
    let Ok(found) = axes.contacts.binary_search_by_key(&ends, |(ends, _)| *ends) else {
        return Outcome::Trivial;
    };
    Outcome::of(least(&axes.contacts[found].1), || {
        let [a, b] = cones;
        let at = places(ends, cones);
        let pairs = (0..16).map(|i| (i / 4, i % 4));
        let fitting = pairs.filter(|&(c, d)| a.fits[c].max(b.fits[d]) != Answer::Nonzero);
        let failure = |(c, d): (usize, usize)| {
            let sum = CoplanarAxes { turned: [SIGNS[c], SIGNS[d]] };
            judge.decide().root_failure("axes in a plane with the edge", sum, at)
        };
        match (a.best(), b.best()) {
            // Without a cone at an end there is no axis.
            (Answer::Nonzero, _) => a.failure(),
            (_, Answer::Nonzero) => b.failure(),
            _ => nearest(fitting.map(failure)),
        }
    })
}

/// The failure with the smallest defect.
fn nearest<V>(failures: impl Iterator<Item = Failure<V>>) -> Failure<V> {
    let none = Failure { condition: "axes in a plane with the edge", defect: 0.0, residual: None };
    let less = |a: Failure<V>, b: Failure<V>| if b.defect < a.defect { b } else { a };
    failures.reduce(less).unwrap_or(none)
}

/// Whether three points do not lie on a line.
fn spans<D: Decide>(decide: &D, at: [VertexId; 3]) -> bool {
    let projections = ProjectedArea::ALL.into_iter();
    projections.map(|p| decide.sign(p, at).0).any(|sign| sign != Sign::Zero)
}

/// Three of the points that do not lie in a plane with the vertex, positively oriented as printed; and
/// whether they are so in the whole box.
fn independent<D: Decide>(
    decide: &D,
    v: VertexId,
    ends: &[VertexId],
) -> Option<([VertexId; 3], bool)> {
    let (&a, others) = ends.split_first()?;
    let b = others.iter().copied().find(|&b| spans(decide, [v, a, b]))?;
    others.iter().find_map(|&c| match decide.sign(Coplanar, [v, a, b, c]) {
        (Sign::Positive, certain) => Some(([a, b, c], certain)),
        (Sign::Negative, certain) => Some(([a, c, b], certain)),
        (Sign::Zero, _) => None,
    })
}
