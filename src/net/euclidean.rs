//! The Euclidean notions, for comparison with those of isotropic geometry (Sec. 3.1): circular and
//! conical meshes.

use super::Judge;
use super::i_circular::distinct;
use super::i_conical::{join, normal, planar_failure};
use super::planar::{self, ProjectedArea, spanning_triangle};
use crate::check::{Answer, Decide, Failure, Outcome, Reason, Residual, RootSum};
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::scalar::{Ring, Sign, det3};
use crate::space::{Point, Vector3};

/// The in-circle determinant of four coplanar points in a projection, with lengths measured in
/// space: zero iff they lie on a circle or a line, provided the projection is one-to-one.
#[derive(Clone, Copy, Debug)]
pub struct ConcyclicInSpace(pub ProjectedArea);

impl Residual<4> for ConcyclicInSpace {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, [p, a, b, c]: &[Point<R>; 4], _: &R) -> R {
        let [a, b, c] = [a, b, c].map(|q| q - p);
        let [na, nb, nc] = [a.length2(), b.length2(), c.length2()];
        let row = |v: Vector3<R>| match self.0 {
            ProjectedArea::AlongX => (v.y, v.z),
            ProjectedArea::AlongY => (v.z, v.x),
            ProjectedArea::TopView => (v.x, v.y),
        };
        let [a, b, c] = [a, b, c].map(row);
        det3([&a.0, &a.1, &na], [&c.0, &c.1, &nc], [&b.0, &b.1, &nb])
    }
}

/// The determinant with rows `(N, |N|)` for the normals of four planes, each through three points:
/// zero iff the unit normals `N/|N|` lie in a plane, hence on a circle of the unit sphere, and the
/// oriented planes touch a common cone of revolution.
///
/// It is a sum of four square roots, and whether it vanishes is decided exactly.
#[derive(Clone, Copy, Debug)]
pub struct ConcyclicNormals;

impl RootSum<12, 4> for ConcyclicNormals {
    fn eval<R: Ring>(self, p: &[Point<R>; 12]) -> [(R, R); 4] {
        let n = [0, 3, 6, 9].map(|i| normal(&p[i], &p[i + 1], &p[i + 2]));
        [[1, 3, 2], [0, 2, 3], [0, 3, 1], [0, 1, 2]].map(|[i, j, k]| {
            let own = 6 - i - j - k;
            (Vector3::det(&n[i], &n[j], &n[k]), n[own].length2())
        })
    }
}

/// The components of the cross product of two normals, and their inner product.
#[derive(Clone, Copy, Debug)]
enum CompareNormals {
    Cross(usize),
    Dot,
}

impl Residual<6> for CompareNormals {
    const TRANSLATES: bool = true;

    fn eval<R: Ring>(self, [a, b, c, d, e, f]: &[Point<R>; 6], _: &R) -> R {
        let (m, n) = (normal(a, b, c), normal(d, e, f));
        match self {
            CompareNormals::Dot => m.dot(&n),
            CompareNormals::Cross(0) => R::det2(&m.y, &m.z, &n.y, &n.z),
            CompareNormals::Cross(1) => R::det2(&m.z, &m.x, &n.z, &n.x),
            CompareNormals::Cross(_) => R::det2(&m.x, &m.y, &n.x, &n.y),
        }
    }
}

/// Circular: the face is planar and has a circumcircle in space. A collinear face is undefined.
pub(super) fn circular<D: Decide>(judge: &Judge<'_, D>, face: FaceId) -> Outcome<D::Value> {
    let shape = judge.net.shape(face);
    let corners = judge.topology().face(face);
    if shape.planar == Answer::Nonzero {
        return Outcome::Fails(planar::failure(judge, face));
    }
    let Some((projection, _)) = spanning_triangle(judge.decide(), corners) else {
        return Outcome::Undefined(Reason::CollinearFace(face));
    };
    if corners.len() == 3 {
        return Outcome::Trivial;
    }
    let residual = ConcyclicInSpace(projection);
    let base = match *corners {
        [a, b, c, _] => Some([a, b, c]),
        _ => distinct(corners, |a, b| judge.decide().same_point(a, b)),
    };
    let others = |base: [VertexId; 3]| {
        let others = corners.iter().filter(move |v| !base.contains(v));
        others.map(move |&v| [base[0], base[1], base[2], v])
    };
    let places: Vec<_> = base.into_iter().flat_map(others).collect();
    let answer = places.iter().map(|&at| judge.decide().decide(residual, at)).max();
    Outcome::of(answer.unwrap_or(Answer::Zero).max(shape.planar), || {
        judge.worst("circumcircle in space", residual, places.into_iter())
    })
}

/// Conical: the oriented face planes at an interior vertex touch a common cone of revolution, for
/// any valence. At a face of oriented area zero it is undefined.
pub(super) fn conical<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let topology = judge.topology();
    let star: Vec<HalfEdge> = topology.star(v).collect();
    let faces = || star.iter().map(|&h| topology.face_at(h));
    let planar = faces().map(|f| judge.net.shape(f).planar).max().unwrap_or(Answer::Zero);
    if planar == Answer::Nonzero {
        return Outcome::Fails(planar_failure(judge, &star));
    }
    let mut triangles = Vec::with_capacity(star.len());
    let mut oriented = true;
    for face in faces() {
        match oriented_triangle(judge, face) {
            Ok((triangle, certain)) => {
                triangles.push(triangle);
                oriented &= certain;
            }
            Err(reason) => return Outcome::Undefined(reason),
        }
    }
    if triangles.len() < 4 {
        return match planar {
            Answer::Zero => Outcome::Trivial,
            answer => Outcome::of(answer, || planar_failure(judge, &star)),
        };
    }
    let places: Vec<[VertexId; 12]> = match *triangles.as_slice() {
        [a, b, c, d] => vec![join([a, b, c, d])],
        _ => match distinct(&triangles, |a, b| same_normal(judge, a, b)) {
            Some(base) => {
                let others = triangles.iter().filter(|c| !base.contains(c));
                others.map(|&c| join([base[0], base[1], base[2], c])).collect()
            }
            None => Vec::new(),
        },
    };
    let conical = places.iter().map(|&at| judge.decide().decide_roots(ConcyclicNormals, at)).max();
    let mut answer = conical.unwrap_or(Answer::Zero).max(planar);
    if !oriented && answer == Answer::Nonzero {
        // Somewhere in the box a face may turn over, and there it is another cone.
        answer = Answer::InBox;
    }
    Outcome::of(answer, || {
        let failures = places
            .iter()
            .map(|&at| judge.decide().root_failure("cone of revolution", ConcyclicNormals, at));
        let worst = failures.reduce(Failure::worse);
        worst.unwrap_or_else(|| planar_failure(judge, &star))
    })
}

/// Three points of a face in such an order that their normal is that of the oriented face, and
/// whether it is so in the whole box.
///
/// A face with reflex corners, or one that crosses itself, is oriented by its vector area.
fn oriented_triangle<D: Decide>(
    judge: &Judge<'_, D>,
    face: FaceId,
) -> Result<([VertexId; 3], bool), Reason> {
    let corners = judge.topology().face(face);
    if let [a, b, c] = *corners {
        let spans = spanning_triangle(judge.decide(), corners).is_some();
        return if spans { Ok(([a, b, c], true)) } else { Err(Reason::CollinearFace(face)) };
    }
    // The projection is one-to-one on the plane of the face.
    let (projection, [a, b, c]) =
        spanning_triangle(judge.decide(), corners).ok_or(Reason::CollinearFace(face))?;
    let fan: Vec<_> = corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]]).collect();
    let (own, own_certain) = judge.decide().sign(projection, [a, b, c]);
    let (whole, certain) = judge.decide().sign_of_sum(projection, &fan);
    match whole {
        Sign::Zero => Err(Reason::NoOrientation(face)),
        _ if whole == own => Ok(([a, b, c], own_certain && certain)),
        _ => Ok(([a, c, b], own_certain && certain)),
    }
}

fn same_normal<D: Decide>(judge: &Judge<'_, D>, a: [VertexId; 3], b: [VertexId; 3]) -> bool {
    let at = [a[0], a[1], a[2], b[0], b[1], b[2]];
    let sign = |residual| judge.decide().sign(residual, at).0;
    (0..3).all(|axis| sign(CompareNormals::Cross(axis)) == Sign::Zero)
        && sign(CompareNormals::Dot) == Sign::Positive
}
