//! A triangle mesh and its lift: the forms of all vertices in one pass over the faces.
//!
//! The weights of an edge are sums over its two faces: in the lift half the cotangents of the
//! opposite angles, in M the terms `det(e, p)/|e|²` with the gradients p. So every face adds its
//! share to its corners, and nobody has to know who is next to whom.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::{Curvatures, Forms, VertexForms, VertexUndefined};
use crate::mesh::{FaceId, Mesh, Topology, VertexId, VertexKind};
use crate::scalar::Field;
use crate::space::{Point, Vector2, Vector3};

/// The forms (21) of all vertices of a triangle mesh with its lift to Σ as image.
///
/// In `f64` this is the fast way for meshes of millions of faces. Time and memory are linear: three
/// numbers for every vertex, twice that where the order of the vertices is far from that in space.
/// The values are those of
/// [`inscribed_v_parallel`](crate::construct::inscribed_v_parallel()), up to rounding where `T`
/// rounds.
///
/// ```
/// use isogeo::mesh::{FaceList, Mesh, VertexId};
/// use isogeo::pair::LiftedForms;
/// use isogeo::space::Point;
/// // A pyramid of height 3 over the square (±1, ±1); that of its lift has height 1.
/// let mut faces = FaceList::new();
/// (0..4).for_each(|i| faces.push([0, 1 + i, 1 + (i + 1) % 4]));
/// let ring = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
/// let ring = ring.map(|(x, y)| Point::new(x, y, 3.0));
/// let mesh = Mesh::new([&[Point::new(0.0, 0.0, 0.0)], ring.as_slice()].concat(), faces)?;
/// let curvatures = LiftedForms::new(&mesh).map(|forms| forms.vertex_curvatures(VertexId(0)));
/// assert_eq!(curvatures.map(|c| c.map(|c| (c.mean, c.gauss))), Ok(Ok((3.0, 9.0))));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct LiftedForms<'a, T> {
    topology: &'a Topology,
    /// `2 D(v)`, `4 D(v, s)`, `8 D(s)` of every vertex.
    sums: Vec<Forms<T>>,
    /// The vertices of vertical faces, each with one of them.
    vertical: BTreeMap<VertexId, FaceId>,
}

/// A face that is no triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoTriangle(pub FaceId);

impl std::fmt::Display for NoTriangle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "face {} is no triangle", self.0.0)
    }
}

impl std::error::Error for NoTriangle {}

impl<'a, T: Field> LiftedForms<'a, T> {
    /// Adds up all faces.
    ///
    /// # Errors
    /// The first face that is no triangle.
    pub fn new(mesh: &'a Mesh<T>) -> Result<Self, NoTriangle> {
        let topology = &mesh.topology;
        if topology.corner_count() != 3 * topology.face_count()
            && let Some(face) = topology.faces().find(|&f| topology.face(f).len() != 3)
        {
            return Err(NoTriangle(face));
        }
        let mut sums = vec![Forms::zero(); topology.vertex_count()];
        let vertical = add_all(mesh, &mut sums).into_iter();
        let vertical =
            vertical.flat_map(|f| topology.face(f).iter().map(move |&v| (v, f))).collect();
        Ok(LiftedForms { topology, sums, vertical })
    }

    /// The measures of a vertex and its image.
    ///
    /// # Errors
    /// Where the faces around the vertex form no closed cycle, or one of them is vertical.
    pub fn vertex_forms(&self, vertex: VertexId) -> Result<VertexForms<T>, VertexUndefined> {
        match self.topology.kind(vertex) {
            VertexKind::Interior => {}
            kind => return Err(VertexUndefined::NotInterior(vertex, kind)),
        }
        if let Some(&face) = self.vertical.get(&vertex) {
            return Err(VertexUndefined::NotAGraph(vertex, face));
        }
        let Forms { first, mixed, second } = &self.sums[vertex.index()];
        let four = Forms {
            first: first * T::from_i64(2),
            mixed: mixed.clone(),
            second: second * T::from_ratio(1, 2),
        };
        Ok(VertexForms { vertex, four })
    }

    /// H and K at a vertex (22).
    ///
    /// # Errors
    /// As for [`vertex_forms`](Self::vertex_forms), or `D(s) = 0`.
    pub fn vertex_curvatures(&self, vertex: VertexId) -> Result<Curvatures<T>, VertexUndefined> {
        self.vertex_forms(vertex)?.curvatures()
    }
}

/// Adds all faces to their corners, on two threads where that pays; returns the vertical ones.
fn add_all<T: Field>(mesh: &Mesh<T>, sums: &mut [Forms<T>]) -> Vec<FaceId> {
    const SHARED: usize = 50_000;
    let faces = mesh.topology.face_count() as u32;
    let all = Share { mesh, faces: 0..faces, first: 0 };
    if (faces as usize) < SHARED {
        return all.add(sums, |_| true);
    }
    let middle = sums.len() / 2;
    let side = |corners: &[usize; 3]| {
        let low = corners.iter().filter(|&&v| v < middle).count();
        [Side::Upper, Side::Both, Side::Both, Side::Lower][low]
    };
    let crossing = all.count(|corners| side(corners) == Side::Both);
    if crossing < SHARED / 10 {
        // Each thread has the vertices of one half for itself.
        let (lower, upper) = sums.split_at_mut(middle);
        let above = Share { first: middle, ..all.clone() };
        let (mut vertical, more) = rayon::join(
            || all.add(lower, |corners| side(corners) == Side::Lower),
            || above.add(upper, |corners| side(corners) == Side::Upper),
        );
        vertical.extend(more);
        vertical.extend(all.add(sums, |corners| side(corners) == Side::Both));
        vertical.sort_unstable();
        return vertical;
    }
    let half = faces / 2;
    let (left, right) =
        (Share { faces: 0..half, ..all.clone() }, Share { faces: half..faces, ..all });
    let mut others = vec![Forms::zero(); sums.len()];
    let (mut vertical, more) =
        rayon::join(|| left.add(sums, |_| true), || right.add(&mut others, |_| true));
    vertical.extend(more);
    let pairs = sums.par_iter_mut().zip(&others).with_min_len(4096);
    pairs.for_each(|(sum, other)| *sum = sum.plus(other));
    vertical
}

/// Where a face lies in the list of vertices.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Lower,
    Upper,
    Both,
}

/// Some faces, and the first of the vertices that they are added to.
#[derive(Clone)]
struct Share<'a, T> {
    mesh: &'a Mesh<T>,
    faces: std::ops::Range<u32>,
    first: usize,
}

impl<T: Field> Share<'_, T> {
    fn triangles(&self) -> impl Iterator<Item = (FaceId, [usize; 3])> {
        self.faces.clone().map(FaceId).filter_map(|face| match *self.mesh.topology.face(face) {
            [a, b, c] => Some((face, [a, b, c].map(VertexId::index))),
            _ => None,
        })
    }

    fn count(&self, chosen: impl Fn(&[usize; 3]) -> bool) -> usize {
        self.triangles().filter(|(_, corners)| chosen(corners)).count()
    }

    /// Adds the chosen faces; returns those of them that are vertical.
    fn add(&self, sums: &mut [Forms<T>], chosen: impl Fn(&[usize; 3]) -> bool) -> Vec<FaceId> {
        let mut vertical = Vec::new();
        for (face, corners) in self.triangles().filter(|(_, corners)| chosen(corners)) {
            match shares(corners.map(|v| &self.mesh.points[v])) {
                None => vertical.push(face),
                Some(shares) => add_face(sums, corners.map(|v| v - self.first), &shares),
            }
        }
        vertical
    }
}

/// What each edge of a triangle adds at its ends; the edges lie opposite to the corners of the same
/// place. `None` if the triangle is vertical.
#[inline]
fn shares<T: Field>([p, q, r]: [&Point<T>; 3]) -> Option<[Forms<T>; 3]> {
    let edges = [r - q, p - r, q - p];
    let [u, v, w] = &edges;
    let inverse = T::det2(&w.x, &w.y, &u.x, &u.y).try_inv()?;
    let gradient = Vector2::new(
        T::det2(&w.z, &w.y, &u.z, &u.y) * &inverse,
        T::det2(&w.x, &w.z, &u.x, &u.z) * &inverse,
    );
    let cotangent = |e: &Vector3<T>, f: &Vector3<T>| -(dot(e, f) * &inverse);
    let cotangents = [cotangent(v, w), cotangent(w, u), cotangent(u, v)];
    let share = |i: usize| {
        let (edge, cotangent) = (&edges[i], &cotangents[i]);
        let length2 = dot(edge, edge);
        let weight = T::det2(&edge.x, &edge.y, &gradient.x, &gradient.y) * length2.try_inv()?;
        Some(Forms {
            first: weight * &edge.z,
            mixed: cotangent * &edge.z,
            second: cotangent * length2,
        })
    };
    Some([share(0)?, share(1)?, share(2)?])
}

/// A corner sees the edge to the next corner rise, and the edge from the one before fall.
#[inline]
fn add_face<T: Field>(sums: &mut [Forms<T>], [a, b, c]: [usize; 3], [u, v, w]: &[Forms<T>; 3]) {
    for (corner, leaving, arriving) in [(a, w, v), (b, u, w), (c, v, u)] {
        let sum = &mut sums[corner];
        sum.first += &(&leaving.first - &arriving.first);
        sum.mixed += &(&leaving.mixed - &arriving.mixed);
        sum.second += &(&leaving.second + &arriving.second);
    }
}

fn dot<T: Field>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    T::dot([&a.x, &a.y], [&b.x, &b.y])
}
