//! The rotational i-minimal surface.

use super::{MeshPair, NoSurface};
use crate::construct::packing::{grid, powers, ring_ratio};
use crate::construct::{koebe_mesh, polar_packing, quad_patch};
use crate::mesh::Mesh;
use crate::net::RADIUS;
use crate::scalar::Field;
use crate::space::{Point, Rotation};

/// The discrete logarithmoid (Sec. 4): with `q = (1 + s)/(1 − s)` and unit vectors `e_j` at angles `2jφ`
///
/// ```math
/// S = (qᵏ e_j, q²ᵏ (1 − s²)/2),   R = s qᵏ,   M = (−q⁻ᵏ e_j, 2 s k),
/// ```
///
/// where `c = cos φ` and `s = sin φ` of half a sector φ are given. The rings of M lie at equal
/// distances; the smooth surface is `z = −ln r`. M has the radii `s q⁻ᵏ`, it is the dual scaled by `s²`.
/// Between the rings k and k + 1, `K = −q⁴ᵏ⁺²`.
///
/// ```
/// use isogeo::construct::minimal::logarithmoid;
/// use isogeo::scalar::{Field, Rational};
/// use isogeo::space::Rotation;
/// let q = |p, d| Rational::from_ratio(p, d);
/// let half_sector = Rotation::new(q(4, 5), q(3, 5))?;
/// let heights = logarithmoid(1, 1, &half_sector).map(|pair| pair.surface.points[2].z.clone());
/// assert_eq!(heights, Ok(q(6, 5)));
/// # Ok::<(), isogeo::space::SpaceError>(())
/// ```
///
/// # Errors
/// [`NoSurface::NoSector`] for `s = 0` or `±1`.
pub fn logarithmoid<T: Field>(
    rings: usize,
    sectors: usize,
    half_sector: &Rotation<T>,
) -> Result<MeshPair<T>, NoSurface<T>> {
    let circles = polar_packing(rings, sectors, half_sector).ok_or(NoSurface::NoSector)?;
    let ratio = ring_ratio(half_sector).ok_or(NoSurface::NoSector)?;
    let inverse = powers(&ratio.try_inv().ok_or(NoSurface::NoSector)?, rings);
    let sine = half_sector.sin();
    let step = sine * T::from_i64(2);
    let point = |((k, _), circle): ((usize, usize), &crate::space::OrientedCircle<T>)| {
        let shrink = -inverse[k].square();
        let (x, y) = (&circle.centre.x * &shrink, &circle.centre.y * &shrink);
        Point::new(x, y, &step * T::from_i64(k as i64))
    };
    let points = grid(rings, sectors).zip(&circles).map(point).collect();
    let radii = grid(rings, sectors).map(|(k, _)| &inverse[k] * sine).collect();
    let gauss = koebe_mesh(circles, quad_patch(rings, sectors))?;
    let mut surface = Mesh { points, ..gauss.clone() };
    surface.data.vertex.insert(RADIUS.to_owned(), radii);
    Ok(MeshPair { surface, gauss })
}
