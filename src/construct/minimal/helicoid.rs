//! The conjugate of the logarithmoid.

use super::NoSurface;
use crate::construct::packing::{grid, powers, rays, ring_ratio};
use crate::construct::quad_patch;
use crate::mesh::Mesh;
use crate::scalar::Field;
use crate::space::{Point, Rotation};

/// The discrete helicoid `(−q⁻ᵏ e_j, −2csj)`, with the top view of the
/// [`logarithmoid`](super::logarithmoid()): an A-net.
///
/// The edges at every vertex lie in a plane; its rays are straight and its rings are helices. The
/// faces are skew, so there is no f-parallel Gauss image. The smooth surface is `z = −arg x'`, up to a
/// constant: it is conjugate to the logarithmoid, and H = 0 as the asymptotic directions are
/// orthogonal.
///
/// # Errors
/// [`NoSurface::NoSector`] for `s = 0` or `±1`.
pub fn helicoid<T: Field>(
    rings: usize,
    sectors: usize,
    half_sector: &Rotation<T>,
) -> Result<Mesh<T>, NoSurface<T>> {
    let ratio = ring_ratio(half_sector).ok_or(NoSurface::NoSector)?;
    if half_sector.sin().is_zero() {
        return Err(NoSurface::NoSector);
    }
    let inverse = powers(&ratio.try_inv().ok_or(NoSurface::NoSector)?, rings);
    let turn = half_sector.then(half_sector);
    let rays = rays(&turn, sectors);
    let point = |(k, j): (usize, usize)| {
        let shrink = -&inverse[k];
        let height = -(turn.sin() * T::from_i64(j as i64));
        Point::new(&rays[j].x * &shrink, &rays[j].y * shrink, height)
    };
    let points = grid(rings, sectors).map(point).collect();
    Ok(Mesh::new(points, quad_patch(rings, sectors))?)
}
