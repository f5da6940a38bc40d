//! What a mesh shall be as far as its conditions leave freedom: fair, close to where it was or to a
//! target.

use super::condition::{Conditions, Each};
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

/// What a coordinate, or its difference between two points, is more than it was.
#[derive(Clone, Copy, Debug)]
struct Along {
    axis: usize,
    from: f64,
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

impl Differentiable<1> for Along {
    fn value(self, [p]: &[Point<f64>; 1]) -> f64 {
        p.coordinates()[self.axis] - self.from
    }

    fn scale(self, [p]: &[Point<f64>; 1]) -> f64 {
        p.coordinates()[self.axis].abs() + self.from.abs()
    }

    fn gradient(self, points: &[Point<f64>; 1]) -> (f64, [Vector3<f64>; 1]) {
        (self.value(points), [unit(self.axis, 1.0)])
    }
}

impl Differentiable<2> for Along {
    fn value(self, [a, b]: &[Point<f64>; 2]) -> f64 {
        (b.coordinates()[self.axis] - a.coordinates()[self.axis]) - self.from
    }

    fn scale(self, points: &[Point<f64>; 2]) -> f64 {
        points.iter().map(|p| 2.0 * p.coordinates()[self.axis].abs()).sum()
    }

    fn gradient(self, points: &[Point<f64>; 2]) -> (f64, [Vector3<f64>; 2]) {
        (self.value(points), [-1.0, 1.0].map(|weight| unit(self.axis, weight)))
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
        let places = straight.iter().copied();
        kinds.push(Box::new(Each::everywhere("fairness", SecondDifference { axis }, places)));
        let places = forked.iter().copied();
        kinds.push(Box::new(Each::everywhere("fairness", ForkedDifference { axis }, places)));
    }
    kinds.retain(|kind| !kind.is_empty());
    kinds
}

/// The change of each edge from what it was, along each axis: it is small where a mesh moves smoothly, and no
/// edge vanishes.
pub fn shape(topology: &Topology, points: &[Point<f64>]) -> Box<dyn Conditions> {
    let place = |h| {
        let ends = [topology.origin(h), topology.target(h)];
        let [a, b] = ends.map(|v| points[v.index()].coordinates().map(|c| *c));
        (0..3).map(move |axis| (ends, Along { axis, from: b[axis] - a[axis] }))
    };
    Box::new(Each { name: "shape", places: topology.edges().flat_map(place).collect() })
}

/// The displacement of each vertex from where it was, along each axis.
pub fn closeness(points: &[Point<f64>]) -> Box<dyn Conditions> {
    let place = |(v, p): (u32, &Point<f64>)| {
        let from = p.coordinates().map(|c| *c);
        (0..3).map(move |axis| ([VertexId(v)], Along { axis, from: from[axis] }))
    };
    Box::new(Each { name: "closeness", places: (0..).zip(points).flat_map(place).collect() })
}
