//! Translational nets over a rectangular grid: the simplest principal meshes.

use super::quad_patch;
use crate::mesh::{Mesh, TopologyError};
use crate::scalar::Ring;
use crate::space::Point;

/// The net `(x_i, y_j, f_i + g_j)` from profiles `(x_i, f_i)` and `(y_j, g_j)`.
///
/// Its faces are parallelograms in space and rectangles in the top view: it is planar, i-circular
/// and i-conical for all data. Counts: `profile.len() − 1` rows, `other.len() − 1` columns.
///
/// # Errors
/// Where a profile has fewer than two points there is no face, which is a mesh; the error is that
/// of too many vertices.
pub fn translational_net<T: Ring>(
    profile: &[(T, T)],
    other: &[(T, T)],
) -> Result<Mesh<T>, TopologyError> {
    let points = profile
        .iter()
        .flat_map(|(x, f)| other.iter().map(move |(y, g)| Point::new(x.clone(), y.clone(), f + g)))
        .collect();
    Mesh::new(points, quad_patch(profile.len().saturating_sub(1), other.len().saturating_sub(1)))
}
