//! What a mesh shall be as far as its conditions leave freedom: fair, close to where it was or to a
//! target.

use super::condition::{Conditions, Everywhere};
use super::gradient::Differentiable;
use crate::mesh::{Topology, VertexId, VertexKind};
use crate::space::{Point, Vector3};

/// `a − 2b + c` along an axis: the second difference of a polyline.
#[derive(Clone, Copy, Debug)]
struct SecondDifference {
    axis: usize,
}

/// `a − 2b + (c + d)/2` along an axis: the second difference where the polyline ends between two edges.
#[derive(Clone, Copy, Debug)]
struct ForkedDifference {
    axis: usize,
}

fn unit(axis: usize, length: f64) -> Vector3<f64> {
    let at = |i| if i == axis { length } else { 0.0 };
    Vector3::new(at(0), at(1), at(2))
}

impl Differentiable<3> for SecondDifference {
    fn value(self, points: &[Point<f64>; 3]) -> f64 {
        let [a, b, c] = points.each_ref().map(|p| *p.coordinates()[self.axis]);
        (a - b) + (c - b)
    }

    fn scale(self, points: &[Point<f64>; 3]) -> f64 {
        points.iter().map(|p| 2.0 * p.coordinates()[self.axis].abs()).sum()
    }

    fn gradient(self, points: &[Point<f64>; 3]) -> (f64, [Vector3<f64>; 3]) {
        (self.value(points), [1.0, -2.0, 1.0].map(|weight| unit(self.axis, weight)))
    }
}

impl Differentiable<4> for ForkedDifference {
    fn value(self, points: &[Point<f64>; 4]) -> f64 {
        let [a, b, c, d] = points.each_ref().map(|p| *p.coordinates()[self.axis]);
        (a - b) + 0.5 * ((c - b) + (d - b))
    }

    fn scale(self, points: &[Point<f64>; 4]) -> f64 {
        points.iter().map(|p| 2.0 * p.coordinates()[self.axis].abs()).sum()
    }

    fn gradient(self, points: &[Point<f64>; 4]) -> (f64, [Vector3<f64>; 4]) {
        (self.value(points), [1.0, -2.0, 0.5, 0.5].map(|weight| unit(self.axis, weight)))
    }
}

/// Second differences along the polylines of a mesh: through opposite edges of interior vertices, and along the
/// boundary, corners left out.
///
/// At an interior vertex with an odd number of edges each polyline goes on between the two edges
/// opposite to it. At a boundary vertex only the boundary is fair, and that of a vertex in one face,
/// a corner, is not asked to be.
pub fn fairness(topology: &Topology) -> Vec<Box<dyn Conditions>> {
    let (mut straight, mut forked) = (Vec::new(), Vec::new());
    for v in topology.vertices() {
        let star: Vec<_> = topology.star(v).collect();
        let ends: Vec<VertexId> = star.iter().map(|&h| topology.target(h)).collect();
        let n = ends.len();
        match topology.kind(v) {
            VertexKind::Interior if n.is_multiple_of(2) => {
                straight.extend((0..n / 2).map(|i| [ends[i], v, ends[i + n / 2]]));
            }
            VertexKind::Interior => {
                let opposite = |i: usize| [(i + n / 2) % n, (i + n / 2 + 1) % n];
                forked.extend((0..n).map(|i| {
                    let [j, k] = opposite(i);
                    [ends[i], v, ends[j], ends[k]]
                }));
            }
            VertexKind::Boundary if n > 1 => {
                let last = topology.origin(topology.prev(star[n - 1]));
                straight.push([ends[0], v, last]);
            }
            _ => {}
        }
    }
    let mut kinds: Vec<Box<dyn Conditions>> = Vec::new();
    for axis in 0..3 {
        let places = straight.clone();
        let residual = SecondDifference { axis };
        kinds.push(Box::new(Everywhere { name: "fairness", residual, places }));
        let places = forked.clone();
        let residual = ForkedDifference { axis };
        kinds.push(Box::new(Everywhere { name: "fairness", residual, places }));
    }
    kinds.retain(|kind| !kind.is_empty());
    kinds
}

/// The change of each edge from what it was, along each axis: it is small where a mesh moves smoothly, and no
/// edge vanishes.
pub struct Shape {
    edges: Vec<[VertexId; 2]>,
    from: Vec<Vector3<f64>>,
}

impl Shape {
    /// The shape of a mesh with these points.
    pub fn new(topology: &Topology, points: &[Point<f64>]) -> Self {
        let ends = |h| [topology.origin(h), topology.target(h)];
        let edges: Vec<_> = topology.edges().map(ends).collect();
        let from = edges.iter().map(|[a, b]| &points[b.index()] - &points[a.index()]).collect();
        Shape { edges, from }
    }
}

impl Conditions for Shape {
    fn name(&self) -> &'static str {
        "shape"
    }

    fn len(&self) -> usize {
        3 * self.edges.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        &self.edges[condition / 3]
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let (edge, axis) = (condition / 3, condition % 3);
        let [a, b] = self.edges[edge].map(|v| *points[v.index()].coordinates()[axis]);
        let from = &self.from[edge];
        (b - a) - [from.x, from.y, from.z][axis]
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let ends =
            self.edges[condition / 3].map(|v| points[v.index()].coordinates()[condition % 3].abs());
        2.0 * (ends[0] + ends[1])
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        gradient[0] = unit(condition % 3, -1.0);
        gradient[1] = unit(condition % 3, 1.0);
        self.value(condition, points)
    }
}

/// The displacement of each vertex from a place, along each axis.
pub struct Closeness {
    places: Vec<VertexId>,
    from: Vec<Point<f64>>,
}

impl Closeness {
    /// Close to where the points are.
    pub fn new(points: &[Point<f64>]) -> Self {
        Closeness {
            places: (0..points.len() as u32).map(VertexId).collect(),
            from: points.to_vec(),
        }
    }
}

impl Conditions for Closeness {
    fn name(&self) -> &'static str {
        "closeness"
    }

    fn len(&self) -> usize {
        3 * self.places.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        std::slice::from_ref(&self.places[condition / 3])
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let at = |points: &[Point<f64>]| *points[condition / 3].coordinates()[condition % 3];
        at(points) - at(&self.from)
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let size = |points: &[Point<f64>]| points[condition / 3].coordinates()[condition % 3].abs();
        size(points) + size(&self.from)
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        gradient[0] = unit(condition % 3, 1.0);
        self.value(condition, points)
    }
}
