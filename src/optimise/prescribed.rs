//! Conditions with a value for each element: mean curvature at faces or vertices; and pairs of meshes.
//!
//! A pair is optimised as one list of points, M followed by S, as pairs are checked.

use super::condition::{Conditions, Each};
use super::gradient::{Differentiable, by_dual_numbers};
use crate::check::Residual;
use crate::mesh::{FaceId, Topology, VertexId};
use crate::pair::{ParallelPlanes, Ray, four_mixed_areas, star_forms, twice_area};
use crate::scalar::{Dual, Magnitude, Ring};
use crate::space::{Point, TopView, Vector3};

/// `4 area(F, S) − 4 H area(F)`: zero iff a face has the mean curvature H (17). The first half of the points
/// are the corners of F, the second those of S.
#[derive(Clone, Copy, Debug)]
pub struct FaceMean {
    /// The mean curvature.
    pub mean: f64,
}

impl FaceMean {
    fn eval<R: Ring, const K: usize>(mean: &R, points: &[Point<R>; K]) -> R {
        let views: Vec<TopView<R>> = points.iter().map(Point::top_view).collect();
        let (f, s) = views.split_at(K / 2);
        four_mixed_areas(f, s) - twice_area(f) * R::from_i64(2) * mean
    }
}

impl<const K: usize> Differentiable<K> for FaceMean {
    fn value(self, points: &[Point<f64>; K]) -> f64 {
        FaceMean::eval(&self.mean, points)
    }

    fn scale(self, points: &[Point<f64>; K]) -> f64 {
        FaceMean::eval(
            &Magnitude(self.mean.abs()),
            &points.each_ref().map(|p| p.map(Magnitude::of)),
        )
        .0
    }

    fn gradient(self, points: &[Point<f64>; K]) -> (f64, [Vector3<f64>; K]) {
        by_dual_numbers(points, |p| FaceMean::eval(&Dual::constant(self.mean), p))
    }
}

/// `D(v, s) − H D(s)` with the lift to Σ, times a common denominator: zero iff a vertex has the mean curvature
/// H (22), where `D(s)` is not 0. The points are the vertex and its neighbours in counter-clockwise
/// order.
#[derive(Clone, Copy, Debug)]
pub struct VertexMean {
    /// The mean curvature.
    pub mean: f64,
}

impl VertexMean {
    /// 0 where two consecutive edges are collinear in the top view: there is no curvature.
    fn eval<R: Ring, const K: usize>(mean: &R, points: &[Point<R>; K]) -> R {
        let rays: Vec<Ray<R>> = points[1..]
            .iter()
            .map(|p| {
                let to = p - &points[0];
                let edge = to.top_view();
                // Twice the lift, seen from the vertex: what is linear does not count.
                Ray { rise: [to.z, edge.length2()], edge }
            })
            .collect();
        match star_forms(&rays) {
            Some((forms, _)) => forms.mixed * R::from_i64(2) - forms.second * mean,
            None => R::zero(),
        }
    }
}

impl<const K: usize> Differentiable<K> for VertexMean {
    fn value(self, points: &[Point<f64>; K]) -> f64 {
        VertexMean::eval(&self.mean, points)
    }

    fn scale(self, points: &[Point<f64>; K]) -> f64 {
        let seen = points.each_ref().map(|p| {
            let d = p - &points[0];
            Point::new(d.x, d.y, d.z).map(Magnitude::of)
        });
        VertexMean::eval(&Magnitude(self.mean.abs()), &seen).0
    }

    fn gradient(self, points: &[Point<f64>; K]) -> (f64, [Vector3<f64>; K]) {
        by_dual_numbers(points, |p| VertexMean::eval(&Dual::constant(self.mean), p))
    }
}

/// Mean curvatures at interior vertices, by vertex; vertices of more than 8 faces are left out.
pub fn vertex_means(
    topology: &Topology,
    mean: impl Fn(VertexId) -> f64,
) -> Vec<Box<dyn Conditions>> {
    fn of<const K: usize>(
        topology: &Topology,
        mean: &dyn Fn(VertexId) -> f64,
    ) -> Box<dyn Conditions> {
        let stars = topology.interior_vertices().filter(|&v| topology.star(v).count() + 1 == K);
        let place = |v| {
            let mut at = [v; K];
            let ends = topology.star(v).map(|h| topology.target(h));
            at[1..].iter_mut().zip(ends).for_each(|(slot, end)| *slot = end);
            (at, VertexMean { mean: mean(v) })
        };
        Box::new(Each { name: "mean curvature at vertices", places: stars.map(place).collect() })
    }
    let mut kinds = vec![
        of::<4>(topology, &mean),
        of::<5>(topology, &mean),
        of::<6>(topology, &mean),
        of::<7>(topology, &mean),
        of::<8>(topology, &mean),
        of::<9>(topology, &mean),
    ];
    kinds.retain(|kind| !kind.is_empty());
    kinds
}

/// Mean curvatures at faces of a pair, M with its points first, by face; faces of more than 8 corners are
/// left out.
pub fn face_means(topology: &Topology, mean: impl Fn(FaceId) -> f64) -> Vec<Box<dyn Conditions>> {
    fn of<const K: usize>(
        topology: &Topology,
        mean: &dyn Fn(FaceId) -> f64,
    ) -> Box<dyn Conditions> {
        let image = |v: VertexId| VertexId(v.0 + topology.vertex_count() as u32);
        let faces = topology.faces().filter(|&f| 2 * topology.face(f).len() == K);
        let place = |f| {
            let corners = topology.face(f);
            let both = corners.iter().copied().chain(corners.iter().map(|&v| image(v)));
            let mut at = [corners[0]; K];
            at.iter_mut().zip(both).for_each(|(slot, v)| *slot = v);
            (at, FaceMean { mean: mean(f) })
        };
        Box::new(Each { name: "mean curvature at faces", places: faces.map(place).collect() })
    }
    let mut kinds = vec![
        of::<6>(topology, &mean),
        of::<8>(topology, &mean),
        of::<10>(topology, &mean),
        of::<12>(topology, &mean),
        of::<14>(topology, &mean),
        of::<16>(topology, &mean),
    ];
    kinds.retain(|kind| !kind.is_empty());
    kinds
}

/// That the face planes of a pair are parallel: all edges of S but one of each face are parallel to the plane
/// through three corners of the face of M. That M is planar is another condition.
pub fn f_parallel(topology: &Topology) -> Box<dyn Conditions> {
    let image = |v: VertexId| VertexId(v.0 + topology.vertex_count() as u32);
    let places = topology.faces().flat_map(|f| {
        let corners = topology.face(f);
        let edges = corners.windows(2);
        edges.map(|edge| {
            let at = [corners[0], corners[1], corners[2], image(edge[0]), image(edge[1])];
            (at, ParallelPlanes)
        })
    });
    Box::new(Each { name: "f-parallel", places: places.collect() })
}

impl Differentiable<5> for ParallelPlanes {
    fn value(self, points: &[Point<f64>; 5]) -> f64 {
        self.eval(points, &1.0)
    }

    fn scale(self, points: &[Point<f64>; 5]) -> f64 {
        let seen = |i: usize| if i < 3 { &points[0] } else { &points[3] };
        let sizes = std::array::from_fn(|i| {
            let d = &points[i] - seen(i);
            Point::new(d.x, d.y, d.z).map(Magnitude::of)
        });
        self.eval(&sizes, &Magnitude(1.0)).0
    }

    fn gradient(self, points: &[Point<f64>; 5]) -> (f64, [Vector3<f64>; 5]) {
        by_dual_numbers(points, |p| self.eval(p, &Dual::constant(1.0)))
    }
}
