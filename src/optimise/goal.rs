//! What a mesh shall become, as conditions.

use super::angle::{AnglesAround, AnglesInSpace, OppositeAngles};
use super::condition::{Conditions, Each};
use super::gradient::Differentiable;
use crate::mesh::{FaceId, Topology, VertexId};
use crate::net::Property;
use crate::net::euclidean::{ConcyclicInSpace, ConcyclicNormals};
use crate::net::i_circular::Concyclic;
use crate::net::i_conical::{Balance, ConcyclicGradients};
use crate::net::planar::{Coplanar, ProjectedArea};
use crate::space::{Point, Vector3};

/// A class of mesh to reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Goal {
    /// Faces lie in planes.
    Planar,
    /// Planar, and the top views of faces are concyclic: the first kind of i-principal mesh.
    ICircular,
    /// Planar, and the gradients around interior vertices are concyclic: the second kind.
    IConical,
    /// Planar, and faces have circumcircles in Euclidean space.
    Circular,
    /// Planar, and the face planes around interior vertices touch a Euclidean cone of revolution.
    Conical,
}

impl Goal {
    /// All goals.
    pub const ALL: [Goal; 5] =
        [Goal::Planar, Goal::ICircular, Goal::IConical, Goal::Circular, Goal::Conical];

    /// The property that decides whether the goal is reached.
    pub fn property(self) -> Property {
        match self {
            Goal::Planar => Property::Planar,
            Goal::ICircular => Property::ICircular,
            Goal::IConical => Property::IConical,
            Goal::Circular => Property::Circular,
            Goal::Conical => Property::Conical,
        }
    }

    /// The conditions on the top view alone that remain when heights may be chosen; `None` if the goal
    /// does not split so.
    ///
    /// Given the top view, planarity is linear in the heights. i-conical meshes split so where four faces meet
    /// at each interior vertex.
    pub fn top_view_conditions(self, topology: &Topology) -> Option<Vec<Box<dyn Conditions>>> {
        match self {
            Goal::ICircular => Some(vec![everywhere("concyclic", Concyclic, corners(topology))]),
            Goal::IConical => {
                let regular = topology.interior_vertices().all(|v| topology.star(v).count() == 4);
                let balances = || stars(topology, &[]).0;
                regular.then(|| vec![everywhere("angle balance", Balance, balances())])
            }
            Goal::Planar | Goal::Circular | Goal::Conical => None,
        }
    }

    /// The same conditions for a mesh that is far from the goal, with the lengths that their values are to be
    /// multiplied by to be distances, where they are angles: so nothing is gained if edges shrink.
    pub fn far_conditions(
        self,
        topology: &Topology,
        points: &[Point<f64>],
        edge: f64,
    ) -> Vec<(Box<dyn Conditions>, Option<f64>)> {
        let angles: Option<Box<dyn Conditions>> = match self {
            Goal::ICircular => {
                let (quads, _) = quads(topology);
                Some(everywhere("concyclic", OppositeAngles, quads))
            }
            Goal::IConical => {
                Some(everywhere("angle balance", AnglesAround, stars(topology, points).0))
            }
            Goal::Planar | Goal::Circular | Goal::Conical => None,
        };
        let replaced = angles.as_ref().map(|angles| angles.name());
        let mut kinds: Vec<_> = self
            .conditions(topology, points)
            .into_iter()
            .filter(|kind| Some(kind.name()) != replaced)
            .map(|kind| (kind, None))
            .collect();
        if self == Goal::ICircular {
            kinds.push((everywhere("concyclic", Concyclic, quads(topology).1), None));
        }
        kinds.extend(angles.map(|angles| (angles, Some(edge))));
        kinds.retain(|(kind, _)| !kind.is_empty());
        kinds
    }

    /// The conditions on the vertices, in kinds; those of planarity come first.
    ///
    /// A face of `k` corners has `k − 3` conditions of each kind, a vertex of `n` faces `n − 3`. Which
    /// corners they compare depends on the points only where a projection has to be chosen.
    pub fn conditions(
        self,
        topology: &Topology,
        points: &[Point<f64>],
    ) -> Vec<Box<dyn Conditions>> {
        let mut kinds = vec![everywhere("planar", Coplanar, corners(topology))];
        match self {
            Goal::Planar => {}
            Goal::ICircular => kinds.push(everywhere("concyclic", Concyclic, corners(topology))),
            Goal::IConical => {
                let (balances, planes) = stars(topology, points);
                kinds.push(everywhere("angle balance", Balance, balances));
                kinds.push(everywhere("concyclic gradients", ConcyclicGradients, planes));
            }
            Goal::Circular => {
                for projection in
                    [ProjectedArea::TopView, ProjectedArea::AlongX, ProjectedArea::AlongY]
                {
                    let shown = |&f: &FaceId| widest(topology, points, f) == axis(projection);
                    let faces = topology.faces().filter(shown);
                    let places = faces.flat_map(|f| quadruples(topology.face(f))).collect();
                    let residual = ConcyclicInSpace(projection);
                    kinds.push(everywhere("circumcircle in space", residual, places));
                }
            }
            Goal::Conical => {
                let (angles, planes) = stars(topology, points);
                kinds.push(everywhere("angles in space", AnglesInSpace, angles));
                kinds.push(everywhere("cone of revolution", ConcyclicNormals, planes));
            }
        }
        kinds.retain(|kind| !kind.is_empty());
        kinds
    }
}

fn everywhere<R: Differentiable<K> + 'static, const K: usize>(
    name: &'static str,
    residual: R,
    places: Vec<[VertexId; K]>,
) -> Box<dyn Conditions> {
    Box::new(Each::everywhere(name, residual, places))
}

/// Three corners far apart with each other corner, for all faces.
fn corners(topology: &Topology) -> Vec<[VertexId; 4]> {
    topology.faces().flat_map(|f| quadruples(topology.face(f))).collect()
}

fn quadruples(face: &[VertexId]) -> impl Iterator<Item = [VertexId; 4]> + '_ {
    let base = spread(face.len());
    let others = (0..face.len()).filter(move |i| !base.contains(i));
    others.map(move |i| [face[base[0]], face[base[1]], face[base[2]], face[i]])
}

/// The quads, and the other faces by quadruples of corners.
fn quads(topology: &Topology) -> (Vec<[VertexId; 4]>, Vec<[VertexId; 4]>) {
    let (mut quads, mut others) = (Vec::new(), Vec::new());
    for face in topology.faces().map(|f| topology.face(f)) {
        match *face {
            [a, b, c, d] => quads.push([a, b, c, d]),
            _ => others.extend(quadruples(face)),
        }
    }
    (quads, others)
}

/// Three of `n` numbers in a cycle, far apart.
pub(super) fn spread(n: usize) -> [usize; 3] {
    if n == 4 { [0, 1, 2] } else { [0, n / 3, 2 * n / 3] }
}

/// The interior vertices of four faces with the ends of their edges; those of more by triangles of four of
/// their faces.
fn stars(topology: &Topology, points: &[Point<f64>]) -> (Vec<[VertexId; 5]>, Vec<[VertexId; 12]>) {
    let (mut balances, mut planes) = (Vec::new(), Vec::new());
    for v in topology.interior_vertices() {
        let star: Vec<_> = topology.star(v).collect();
        if star.len() < 4 {
            continue;
        }
        if let [a, b, c, d] = star.as_slice() {
            let [a, b, c, d] = [a, b, c, d].map(|h| topology.target(*h));
            balances.push([v, a, b, c, d]);
            continue;
        }
        let triangles: Vec<_> =
            star.iter().map(|&h| triangle(topology, points, topology.face_at(h))).collect();
        let base = spread(star.len());
        let others = (0..star.len()).filter(|i| !base.contains(i));
        planes.extend(others.map(|i| {
            let four = [base[0], base[1], base[2], i].map(|j| triangles[j]);
            std::array::from_fn(|j| four[j / 3][j % 3])
        }));
    }
    (balances, planes)
}

/// Three corners of a face with the largest triangle among consecutive ones, in their order.
fn triangle(topology: &Topology, points: &[Point<f64>], face: FaceId) -> [VertexId; 3] {
    let corners = topology.face(face);
    let n = corners.len();
    let size = |[a, b, c]: &[VertexId; 3]| {
        let [a, b, c] = [a, b, c].map(|v| &points[v.index()]);
        (b - a).cross(&(c - a)).length2()
    };
    let triangles = (0..n).map(|i| [corners[i], corners[(i + 1) % n], corners[(i + 2) % n]]);
    let largest = triangles.max_by(|a, b| size(a).total_cmp(&size(b)));
    largest.unwrap_or([corners[0], corners[1], corners[2]])
}

/// The coordinate axis along which the vector area of a face is largest.
fn widest(topology: &Topology, points: &[Point<f64>], face: FaceId) -> usize {
    let corners = topology.face(face);
    let origin = &points[corners[0].index()];
    let seen = |v: &VertexId| &points[v.index()] - origin;
    let zero = Vector3::new(0.0, 0.0, 0.0);
    let area = corners.windows(2).fold(zero, |sum, pair| {
        let n = seen(&pair[0]).cross(&seen(&pair[1]));
        Vector3::new(sum.x + n.x, sum.y + n.y, sum.z + n.z)
    });
    let sizes = [area.x.abs(), area.y.abs(), area.z.abs()];
    (0..3).rev().max_by(|&i, &j| sizes[i].total_cmp(&sizes[j])).unwrap_or(2)
}

fn axis(projection: ProjectedArea) -> usize {
    match projection {
        ProjectedArea::AlongX => 0,
        ProjectedArea::AlongY => 1,
        ProjectedArea::TopView => 2,
    }
}
