//! i-conical meshes: the face planes at a vertex touch an isotropic cone of revolution (Sec. 3.2,
//! Theorem 2).
//!
//! That is so iff the gradients of the planes lie on a circle (or on a line): the metric dual of
//! "concyclic top views". Three planes are so by themselves. At a vertex of valence 4 the gradients
//! `p₀ … p₃` of consecutive faces satisfy `p_j − p_{j−1} = w_j J e_j'` with the edges `e_j`, since
//! two planes agree along their common line; so their in-circle determinant is
//! `w₀ w₁ w₂ w₃` times the [`Balance`] of the edges in the top view, which is the angle balance (14)
//! modulo π. It vanishes iff the balance does or two adjacent faces are coplanar (`w_j = 0`). Along an
//! edge of length zero two planes need not agree, so there the gradients themselves are tested.

use super::Judge;
use super::i_circular::distinct;
use super::planar::{self, Coplanar, Position, ProjectedArea};
use crate::check::{Answer, Decide, Failure, Outcome, Reason, Residual};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::{Ring, Sign, det3};
use crate::space::{Point, Vector2, Vector3};

/// `Im(e₀ e₂ · conj(e₁ e₃))` for the top views `e_j` of the edges from the first point to the others
/// in cyclic order, as complex numbers; of degree 4 in x and y.
///
/// Zero iff the angles satisfy `ω₁ + ω₃ = ω₂ + ω₄` modulo π (14); for edges in cyclic order in the
/// top view both sums are then π.
#[derive(Clone, Copy, Debug)]
pub struct Balance;

impl Residual<5> for Balance {
    const TRANSLATES: bool = true;

    #[inline]
    fn eval<R: Ring>(self, [v, x @ ..]: &[Point<R>; 5], _: &R) -> R {
        let [e0, e1, e2, e3] = [0, 1, 2, 3].map(|i| (&x[i] - v).top_view());
        product(&e1, &e3).det(&product(&e0, &e2))
    }
}

/// The product of complex numbers.
pub(super) fn product<R: Ring>(a: &Vector2<R>, b: &Vector2<R>) -> Vector2<R> {
    Vector2 { x: R::det2(&a.x, &a.y, &b.y, &b.x), y: R::dot([&a.x, &a.y], [&b.y, &b.x]) }
}

/// The in-circle determinant of the gradients of four planes, each through three points.
///
/// With normals `N = (N₁, N₂, N₃)` the gradients are `−(N₁, N₂)/N₃`; the rows
/// `(N₁ N₃, N₂ N₃, N₁² + N₂², N₃²)` make the determinant a polynomial of degree 16.
#[derive(Clone, Copy, Debug)]
pub struct ConcyclicGradients;

impl Residual<12> for ConcyclicGradients {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, p: &[Point<R>; 12], _: &R) -> R {
        let [a, b, c, d] = [0, 3, 6, 9].map(|i| {
            let n = normal(&p[i], &p[i + 1], &p[i + 2]);
            [&n.x * &n.z, &n.y * &n.z, n.top_view().length2(), n.z.square()]
        });
        let minor = |a: &[R; 4], b: &[R; 4], c: &[R; 4]| {
            det3([&a[0], &a[1], &a[2]], [&b[0], &b[1], &b[2]], [&c[0], &c[1], &c[2]])
        };
        let minors = [minor(&b, &d, &c), minor(&a, &c, &d), minor(&a, &d, &b), minor(&a, &b, &c)];
        let [m0, m1, m2, m3] = &minors;
        R::dot([&a[3], &b[3], &c[3], &d[3]], [m0, m1, m2, m3])
    }
}

/// A component of the cross product of the normals of two planes, each through three points: both
/// vanish iff the planes are parallel.
#[derive(Clone, Copy, Debug)]
struct ParallelPlanes {
    along_x: bool,
}

impl Residual<6> for ParallelPlanes {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, [a, b, c, d, e, f]: &[Point<R>; 6], _: &R) -> R {
        let (m, n) = (normal(a, b, c), normal(d, e, f));
        if self.along_x { R::det2(&m.y, &m.z, &n.y, &n.z) } else { R::det2(&m.z, &m.x, &n.z, &n.x) }
    }
}

/// A normal of the plane through three points, `(b − a) × (c − a)`.
pub(super) fn normal<R: Ring>(a: &Point<R>, b: &Point<R>, c: &Point<R>) -> Vector3<R> {
    (b - a).cross(&(c - a))
}

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let topology = judge.topology();
    let star: Vec<HalfEdge> = topology.star(v).collect();
    let planar = match planes_around(judge, &star) {
        Ok(answer) => answer,
        Err(outcome) => return outcome,
    };
    if star.len() < 4 {
        return match planar {
            Answer::Zero => Outcome::Trivial,
            answer => Outcome::of(answer, || planar_failure(judge, &star)),
        };
    }
    let ends = || star.iter().map(|&h| topology.target(h));
    if let [a, b, c, d] = *star.as_slice()
        && !ends().any(|x| judge.decide().same_top_view(v, x))
    {
        let [a, b, c, d] = [a, b, c, d].map(|h| topology.target(h));
        let at = [v, a, b, c, d];
        let mut answer = judge.decide().decide(Balance, at);
        if answer == Answer::Nonzero {
            // The determinant is a product: the smallest factor decides.
            let flattest = star.iter().map(|&h| coplanar_faces(judge, h)).min();
            answer = flattest.unwrap_or(Answer::Nonzero);
        }
        return Outcome::of(answer.max(planar), || judge.failure("angle balance", Balance, at));
    }
    let places = places(judge, &star);
    let conical = places.iter().map(|&at| judge.decide().decide(ConcyclicGradients, at)).max();
    Outcome::of(conical.unwrap_or(Answer::Zero).max(planar), || {
        judge.worst("concyclic gradients", ConcyclicGradients, places.into_iter())
    })
}

/// Whether the faces around a vertex have planes with gradients; if not, the outcome.
pub(super) fn planes_around<D: Decide>(
    judge: &Judge<'_, D>,
    star: &[HalfEdge],
) -> Result<Answer, Outcome<D::Value>> {
    let faces = star.iter().map(|&h| judge.topology().face_at(h));
    let mut planar = Answer::Zero;
    let mut undefined = None;
    for face in faces {
        let shape = judge.net.shape(face);
        planar = planar.max(shape.planar);
        undefined = undefined.or(match shape.position {
            Position::Graph => None,
            Position::Vertical => Some(Reason::VerticalFace(face)),
            Position::Collinear => Some(Reason::CollinearFace(face)),
        });
    }
    match undefined {
        _ if planar == Answer::Nonzero => Err(Outcome::Fails(planar_failure(judge, star))),
        Some(reason) => Err(Outcome::Undefined(reason)),
        None => Ok(planar),
    }
}

/// The worst of the faces around a vertex that are not planar.
pub(super) fn planar_failure<D: Decide>(
    judge: &Judge<'_, D>,
    star: &[HalfEdge],
) -> Failure<D::Value> {
    let faces = star.iter().map(|&h| judge.topology().face_at(h));
    let failures = faces
        .filter(|&f| judge.net.shape(f).planar != Answer::Zero)
        .map(|f| planar::failure(judge, f));
    let none = Failure { condition: "planar", defect: 0.0, residual: None };
    failures.fold(none, Failure::worse)
}

/// Whether the planes of the two faces at an edge agree: the factor `w` of that edge.
fn coplanar_faces<D: Decide>(judge: &Judge<'_, D>, h: HalfEdge) -> Answer {
    let topology = judge.topology();
    let (v, x) = (topology.origin(h), topology.target(h));
    let off_edge = |face: FaceId| {
        let corners = topology.face(face).iter().copied();
        corners
            .filter(|&p| p != v && p != x)
            .find(|&p| judge.decide().sign(ProjectedArea::TopView, [v, x, p]).0 != Sign::Zero)
    };
    let right = topology.twin(h).and_then(|twin| off_edge(topology.face_at(twin)));
    match (off_edge(topology.face_at(h)), right) {
        (Some(a), Some(b)) => judge.decide().decide(Coplanar, [v, x, a, b]),
        // A face that is no line in the top view has a point off the edge.
        _ => Answer::Nonzero,
    }
}

/// Three faces with different gradients and each other face, by three points of each.
fn places<D: Decide>(judge: &Judge<'_, D>, star: &[HalfEdge]) -> Vec<[VertexId; 12]> {
    let topology = judge.topology();
    let triangle = |h: &HalfEdge| {
        let face = topology.face(topology.face_at(*h));
        planar::triangle(judge.decide(), ProjectedArea::TopView, face)
    };
    let triangles: Vec<[VertexId; 3]> = star.iter().filter_map(triangle).collect();
    let parallel = |[a, b, c]: [VertexId; 3], [d, e, f]: [VertexId; 3]| {
        [true, false].into_iter().all(|along_x| {
            let (sign, _) = judge.decide().sign(ParallelPlanes { along_x }, [a, b, c, d, e, f]);
            sign == Sign::Zero
        })
    };
    let Some(base) = distinct(&triangles, parallel) else {
        return Vec::new();
    };
    let others = triangles.iter().filter(|t| !base.contains(t));
    others.map(|&t| join([base[0], base[1], base[2], t])).collect()
}

/// The points of four triangles in a row.
pub(super) fn join(triangles: [[VertexId; 3]; 4]) -> [VertexId; 12] {
    std::array::from_fn(|i| triangles[i / 3][i % 3])
}
