//! Rows and columns of patches, and whether they lie in planes.

use super::Surface;
use crate::scalar::{Rational, Ring};
use crate::space::{Dual, Point, Vector3};

/// Whether points lie in a plane: exactly.
pub(super) fn coplanar(points: &[&Point<Rational>]) -> bool {
    let Some((first, others)) = points.split_first() else { return true };
    let steps: Vec<Vector3<Rational>> = others.iter().map(|p| *p - *first).collect();
    let Some(along) = steps.iter().find(|step| !step.length2().is_zero()) else { return true };
    let normals = steps.iter().map(|step| along.cross(step));
    let Some(normal) = normals.into_iter().find(|n| !n.length2().is_zero()) else { return true };
    steps.iter().all(|step| step.dot(&normal).is_zero())
}

/// Whether the points of each row of a patch lie in a plane, and those of each column; `width` points
/// make a row.
pub(super) fn planar_lines(points: &[Point<Rational>], width: usize) -> bool {
    let row = |row: &[Point<Rational>]| coplanar(&row.iter().collect::<Vec<_>>());
    let column = |j| coplanar(&points.iter().skip(j).step_by(width).collect::<Vec<_>>());
    points.chunks(width).all(row) && (0..width).all(column)
}

/// Whether the face planes along each row of a patch pass through a point, which may be at infinity,
/// and those along each column: whether their poles lie in planes.
pub(super) fn concurrent_lines(mesh: &Surface, width: usize) -> bool {
    let poles = mesh.topology.faces().map(|face| Some(mesh.face_plane(face).ok()?.dual()));
    poles.collect::<Option<Vec<_>>>().is_some_and(|poles| planar_lines(&poles, width))
}
