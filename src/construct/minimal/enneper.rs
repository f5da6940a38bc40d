//! The isotropic Enneper surface, in closed form.

use super::{MeshPair, NoSurface};
use crate::construct::packing::{ThroughCentre, grid};
use crate::construct::{koebe_mesh, quad_patch};
use crate::mesh::{FaceId, Mesh, VertexId};
use crate::net::RADIUS;
use crate::scalar::Field;
use crate::space::{OrientedCircle, Point, TopView, Vector2};

/// The isotropic Enneper surface (Fig. 8): the Christoffel dual of the Koebe mesh over the circles of
/// radius 1/2 about `(i, j)`, inverted by `p ↦ c + (p − c)/|p − c|²`.
///
/// With `(x, y) = (i, j) − c` and `N = x² + y² − 1/4`
///
/// ```math
/// S' = c + (x, y)/N,   R = 1/(2N),
/// M' = (xy² − x³/3 + x/12, −x²y + y³/3 − y/12),   z = (y² − x²)/2 + c·M',
/// ```
///
/// so `w = −ζ³/3 + ζ̄/12` in complex numbers, and M has the radii `N/2`. It is the dual scaled by
/// 1/4. At a face `K = −1/∏ N` over its corners. The circle about c, if there is one, is turned over.
/// All of this is linear in the number of faces, and the numbers have a few digits more than c.
///
/// ```
/// use isogeo::construct::minimal::enneper;
/// use isogeo::scalar::{Field, Rational};
/// use isogeo::space::{Point, TopView};
/// let q = |p, d| Rational::from_ratio(p, d);
/// let centre = TopView::new(q(-1, 2), q(-1, 2));
/// let first = enneper(1, 1, &centre).map(|pair| pair.gauss.points[0].top_view());
/// assert_eq!(first, Ok(TopView::new(q(3, 2), q(3, 2)))); // (2, 2) from c
/// ```
///
/// # Errors
/// [`NoSurface::ThroughCentre`] for a circle of a vertex or of a face through c, as `c = (1/2, 0)`.
pub fn enneper<T: Field>(
    rows: usize,
    columns: usize,
    centre: &TopView<T>,
) -> Result<MeshPair<T>, NoSurface<T>> {
    let [quarter, half, third, twelfth] = [4, 2, 3, 12].map(|n| T::from_ratio(1, n));
    let from_centre = |i: T, j: T| &TopView::new(i, j) - centre;
    let power = |v: &Vector2<T>| v.length2() - &quarter;
    let number = |n: usize| T::from_i64(n as i64);
    let count = (rows + 1) * (columns + 1);
    let (mut points, mut radii) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut circles = Vec::with_capacity(count);
    for (index, (i, j)) in grid(rows, columns).enumerate() {
        let v = from_centre(number(i), number(j));
        let power = power(&v);
        let vertex = VertexId(index as u32);
        let inverse = power.try_inv().ok_or(ThroughCentre::Vertex(vertex))?;
        circles
            .push(OrientedCircle { centre: centre + &v.scaled(&inverse), radius: inverse * &half });
        let (x2, y2) = (v.x.square(), v.y.square());
        let x = &v.x * (&y2 - &x2 * &third + &twelfth);
        let y = &v.y * (&y2 * &third - &x2 - &twelfth);
        let shear = T::dot([&centre.x, &centre.y], [&x, &y]);
        points.push(Point::new(x, y, (y2 - x2) * &half + shear));
        radii.push(power * &half);
    }
    let faces = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    for (index, (i, j)) in faces.enumerate() {
        let middle = from_centre(number(i) + &half, number(j) + &half);
        if power(&middle).is_zero() {
            return Err(ThroughCentre::Face(FaceId(index as u32)).into());
        }
    }
    let gauss = koebe_mesh(circles, quad_patch(rows, columns))?;
    let mut surface = Mesh { points, ..gauss.clone() };
    surface.data.vertex.insert(RADIUS.to_owned(), radii);
    Ok(MeshPair { surface, gauss })
}
