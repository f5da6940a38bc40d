//! Instances for the chapters on vertices: stars of triangles, and parallel polygons.

use super::{Run, Stop, Trial};
use crate::mesh::{FaceList, Mesh, TopologyError};
use crate::scalar::Field;
use crate::space::{Gradient, Point, TopView};

pub(super) const NOT_VERTICAL: &str = "no face of the star is vertical";
pub(super) const IMAGE_MEASURE: &str = "D(s) != 0";
pub(super) const DUAL_EDGES: &str =
    "consecutive faces around the vertex are not coplanar, in M and in S";
const CLOSING: &str = "the last two edges are not parallel";

/// A star of k triangles around vertex 0, with the top views and heights of M free.
pub(super) fn triangles<T: Field>(trial: &mut Trial<T>) -> Result<Mesh<T>, Stop> {
    let k = trial.size();
    let mut points: Vec<Point<T>> = vec![trial.free_point()];
    points.extend((0..k).map(|_| trial.free_point()));
    let mut faces = FaceList::new();
    for j in 0..k {
        faces.push([0, 1 + j, 1 + (j + 1) % k].map(|v| v as u32));
    }
    let mesh = trial.accepted("a star", Mesh::new(points, faces))?;
    not_vertical(trial, &mesh)?;
    trial.exhibit("M", &mesh);
    Ok(mesh)
}

/// The same top views with other heights.
pub(super) fn at_heights<T: Field>(mesh: &Mesh<T>, height: impl Fn(usize) -> T) -> Mesh<T> {
    let points = mesh.points.iter().enumerate();
    let points = points.map(|(n, p)| p.top_view().at_height(height(n))).collect();
    Mesh { points, ..mesh.clone() }
}

pub(super) fn not_vertical<T: Field>(trial: &mut Trial<T>, mesh: &Mesh<T>) -> Run {
    let k = mesh.points.len() - 1;
    let view = |j: usize| &mesh.points[1 + j % k].top_view() - &mesh.points[0].top_view();
    for j in 0..k {
        trial.nonzero(NOT_VERTICAL, &view(j).det(&view(j + 1)))?;
        trial.parameter("no edge of the star has length 0", &view(j).length2())?;
    }
    Ok(())
}

/// Corners of a polygon F in the plane, and the factors of its edges in a parallel polygon S.
pub(super) struct ParallelPolygons<T> {
    pub(super) f: Vec<TopView<T>>,
    pub(super) s: Vec<TopView<T>>,
    pub(super) factors: Vec<T>,
}

impl<T: Field> ParallelPolygons<T> {
    pub(super) fn free(trial: &mut Trial<T>) -> Result<Self, Stop> {
        let k = trial.size();
        let f: Vec<_> = (0..k).map(|_| TopView::new(trial.free(), trial.free())).collect();
        let edge = |j: usize| &f[(j + 1) % k] - &f[j];
        let mut factors: Vec<T> = (0..k - 2).map(|_| trial.free()).collect();
        let mut s = vec![TopView::new(T::zero(), T::zero())];
        for (j, factor) in factors.iter().enumerate() {
            s.push(&s[j] + &edge(j).scaled(factor));
        }
        if k == 3 {
            // Triangles are parallel iff they are similar.
            factors = vec![factors[0].clone(); 3];
            s.push(&s[1] + &edge(1).scaled(&factors[1]));
            return Ok(ParallelPolygons { f, s, factors });
        }
        let (last, back) = (edge(k - 2), edge(k - 1));
        let sine = last.det(&back);
        trial.parameter(CLOSING, &sine)?;
        let gap = &s[0] - &s[k - 2];
        for factor in [gap.det(&back).try_div(&sine), last.det(&gap).try_div(&sine)] {
            factors.push(trial.defined(CLOSING, factor)?);
        }
        s.push(&s[k - 2] + &last.scaled(&factors[k - 2]));
        Ok(ParallelPolygons { f, s, factors })
    }
}

/// The star over its vertex at the origin that has these gradients: neighbour j lies over the line
/// where the faces j and j + 1 meet, which is that of all stars with parallel polygons of gradients.
pub(super) fn star_of<T: Field>(
    gradients: &[TopView<T>],
    polygon: &[TopView<T>],
    reach: &[T],
) -> Result<Mesh<T>, TopologyError> {
    let k = gradients.len();
    let mut points = vec![Point::new(T::zero(), T::zero(), T::zero())];
    for j in 0..k {
        let at = (&polygon[(j + 1) % k] - &polygon[j]).turned().scaled(&reach[j]);
        let p = Gradient::new(gradients[j].x.clone(), gradients[j].y.clone());
        points.push(Point::new(at.x.clone(), at.y.clone(), p.along(&at)));
    }
    let mut faces = FaceList::new();
    for j in 0..k {
        faces.push([0, 1 + (j + k - 1) % k, 1 + j].map(|v| v as u32));
    }
    Mesh::new(points, faces)
}

/// Two v-parallel stars with parallel polygons of gradients.
pub(super) fn dual_stars<T: Field>(trial: &mut Trial<T>) -> Result<[Mesh<T>; 2], Stop> {
    let k = trial.size();
    let polygons = ParallelPolygons::free(trial)?;
    let reach: Vec<T> = (0..k).map(|_| trial.free()).collect();
    let edge = |j: usize| &polygons.f[(j + 1) % k] - &polygons.f[j];
    for (j, factor) in reach.iter().enumerate() {
        trial.parameter("the neighbours are not over the vertex", factor)?;
        trial.parameter(DUAL_EDGES, &edge(j).length2())?;
        trial.parameter(DUAL_EDGES, &polygons.factors[j])?;
        trial.parameter(DUAL_EDGES, &edge((j + k - 1) % k).det(&edge(j)))?;
    }
    let m = trial.accepted("M", star_of(&polygons.f, &polygons.f, &reach))?;
    let s = trial.accepted("S", star_of(&polygons.s, &polygons.f, &reach))?;
    not_vertical(trial, &m)?;
    Ok([m, s])
}
