//! The right hyperbolic paraboloid.

use super::{MeshPair, NoSurface};
use crate::construct::packing::grid;
use crate::construct::{koebe_mesh, quad_patch, square_packing};
use crate::mesh::Mesh;
use crate::net::RADIUS;
use crate::scalar::Field;
use crate::space::Point;

/// `M = (x, −y, (x² − y²)/2)` over the square grid `x = i, y = j`, and the Koebe mesh
/// `S = (x, y, (x² + y² − 1/4)/2)`: the simplest i-minimal surface, `K = −1`.
///
/// ```
/// use isogeo::construct::minimal::saddle;
/// let pair = saddle::<f64>(2, 1);
/// assert!(pair.is_ok_and(|pair| pair.surface.points[5].coordinates() == [&2.0, &-1.0, &1.5]));
/// ```
///
/// # Errors
/// Where there are too many faces to count.
pub fn saddle<T: Field>(rows: usize, columns: usize) -> Result<MeshPair<T>, NoSurface<T>> {
    let gauss = koebe_mesh(square_packing(rows, columns), quad_patch(rows, columns))?;
    let half = T::from_ratio(1, 2);
    let point = |(i, j): (usize, usize)| {
        let (x, y) = (T::from_i64(i as i64), T::from_i64(j as i64));
        let height = (x.square() - y.square()) * &half;
        Point::new(x, -y, height)
    };
    let points = grid(rows, columns).map(point).collect();
    let mut surface = Mesh { points, ..gauss.clone() };
    surface.data.vertex.insert(RADIUS.to_owned(), vec![half; gauss.points.len()]);
    Ok(MeshPair { surface, gauss })
}
