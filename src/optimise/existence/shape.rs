//! What a property asks for beside its equations: that faces have planes with gradients, and that
//! the corners and faces that the equations compare are different.
//!
//! With it the equations are the property, as [`net`](crate::net) decides it:
//!
//! - Three corners of a face that are not collinear span its plane, and if their top views are not collinear,
//!   its circle; so it does not matter which other corners they are compared with. In space the same
//!   holds in a projection that is one-to-one on the plane.
//! - At a vertex of four faces the balance decides where no edge is seen as a point.
//! - Gradients of which three are different lie on one circle or line if each other one lies on that of the
//!   three; and the gradient of a face is that of any of its triangles.

use super::NoProof;
use super::bounds::ball;
use super::problem::Problem;
use crate::check::{Element, Residual};
use crate::mesh::{FaceId, Topology, VertexId, VertexKind};
use crate::net::euclidean::ConcyclicInSpace;
use crate::net::planar::ProjectedArea;
use crate::optimise::goal::spread;
use crate::optimise::{Goal, Polynomial};
use crate::scalar::{Ball, Ring};
use crate::space::Point;

const ALL: [ProjectedArea; 3] =
    [ProjectedArea::TopView, ProjectedArea::AlongX, ProjectedArea::AlongY];

/// Whether the property of a goal asks for something anywhere.
pub fn is_asked(topology: &Topology, goal: Goal) -> bool {
    match goal {
        Goal::IConical | Goal::Conical => {
            topology.interior_vertices().any(|v| topology.star(v).count() > 3)
        }
        Goal::Planar | Goal::ICircular | Goal::Circular => {
            topology.faces().any(|f| topology.face(f).len() > 3)
        }
    }
}

/// Points of the exact mesh, as far as they are known.
struct Near<'a> {
    problem: &'a Problem<'a>,
    topology: &'a Topology,
    reach: f64,
}

/// Whether the equations are the property for all points within `reach` of the centre.
pub fn is_as_asked(
    problem: &Problem<'_>,
    topology: &Topology,
    goal: Goal,
    reach: f64,
) -> Result<(), NoProof> {
    let near = Near { problem, topology, reach };
    for face in topology.faces() {
        let corners = topology.face(face);
        let needed: &[ProjectedArea] = match goal {
            Goal::ICircular => &[ProjectedArea::TopView],
            Goal::IConical if near.touches_interior(corners) => &[ProjectedArea::TopView],
            Goal::Circular => &ALL,
            // Four points are compared with each other, whatever they are.
            _ if corners.len() <= 4 => continue,
            _ => &ALL,
        };
        if !near.spans(needed, corners) {
            return Err(NoProof::Degenerate(Element::Face(face)));
        }
    }
    (0..problem.system.rows()).try_for_each(|row| near.compares(row))
}

impl Near<'_> {
    fn touches_interior(&self, corners: &[VertexId]) -> bool {
        corners.iter().any(|&v| self.topology.kind(v) == VertexKind::Interior)
    }

    fn at(&self, places: &[VertexId]) -> Vec<Point<Ball<f64>>> {
        self.problem.local(places, |difference, shift| ball(difference, shift, self.reach))
    }

    /// Whether three corners are certainly not collinear in one of the projections: those that the
    /// equations of the face compare with others.
    fn spans(&self, projections: &[ProjectedArea], corners: &[VertexId]) -> bool {
        let n = corners.len();
        let triangle = |at: [usize; 3]| {
            let at = at.map(|i| corners[i % n]);
            projections.iter().any(|&projection| self.has_area(projection, &at))
        };
        match n {
            0..=4 => (0..n).any(|i| triangle([i, i + 1, i + 2])),
            _ => triangle(spread(n)),
        }
    }

    fn has_area(&self, projection: ProjectedArea, triangle: &[VertexId]) -> bool {
        match <[Point<Ball<f64>>; 3]>::try_from(self.at(triangle)) {
            Ok(corners) => projection.eval(&corners, &Ball::one()).excludes_zero(),
            Err(_) => false,
        }
    }

    /// Whether an equation compares what it should.
    fn compares(&self, row: usize) -> Result<(), NoProof> {
        let places = self.problem.places(row);
        let wrong = match self.problem.polynomial(row) {
            Polynomial::Balance(_) => self.edge_without_length(places),
            Polynomial::ConcyclicGradients(_) => self.vertex_without_gradients(places),
            Polynomial::ConcyclicInSpace(ConcyclicInSpace(projection)) => {
                self.face_without_area(*projection, places)
            }
            Polynomial::Coplanar(_) | Polynomial::Concyclic(_) => None,
        };
        wrong.map_or(Ok(()), |element| Err(NoProof::Degenerate(element)))
    }

    /// An edge from the first vertex to another that may be seen as a point in the top view.
    fn edge_without_length(&self, places: &[VertexId]) -> Option<Element> {
        let (v, ends) = places.split_first()?;
        let is_point = |x: &&VertexId| match self.at(&[*v, **x]).as_slice() {
            [v, x] => {
                let edge = (x - v).top_view();
                !edge.x.excludes_zero() && !edge.y.excludes_zero()
            }
            _ => true,
        };
        ends.iter().find(is_point).map(|x| Element::Edge(*v, *x))
    }

    /// The common vertex of triangles that may have no gradients, or the first three not different ones.
    fn vertex_without_gradients(&self, places: &[VertexId]) -> Option<Element> {
        let triangles: Vec<&[VertexId]> = places.chunks(3).collect();
        let graphs = triangles.iter().all(|t| self.has_area(ProjectedArea::TopView, t));
        let different = [(0, 1), (1, 2), (2, 0)];
        if graphs && different.iter().all(|&(i, j)| self.differ(triangles[i], triangles[j])) {
            return None;
        }
        let common = places.iter().find(|v| triangles.iter().all(|t| t.contains(v)));
        common.or(places.first()).map(|v| Element::Vertex(*v))
    }

    /// The face of four corners whose projection may lie on a line.
    fn face_without_area(&self, projection: ProjectedArea, places: &[VertexId]) -> Option<Element> {
        let n = places.len();
        let triangle = |i: usize| [0, 1, 2].map(|k| places[(i + k) % n]);
        if (0..n).any(|i| self.has_area(projection, &triangle(i))) {
            return None;
        }
        let has_all = |f: &FaceId| places.iter().all(|v| self.topology.face(*f).contains(v));
        let face = self.topology.faces().find(has_all).map(Element::Face);
        face.or(places.first().map(|v| Element::Vertex(*v)))
    }

    /// Whether the gradients of the planes of two triangles are certainly different.
    fn differ(&self, a: &[VertexId], b: &[VertexId]) -> bool {
        let normal = |triangle| match self.at(triangle).as_slice() {
            [a, b, c] => Some((b - a).cross(&(c - a))),
            _ => None,
        };
        let (Some(m), Some(n)) = (normal(a), normal(b)) else { return false };
        let cross = m.cross(&n);
        cross.x.excludes_zero() || cross.y.excludes_zero()
    }
}
