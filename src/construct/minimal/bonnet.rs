//! The isotropic counterpart of Bonnet's minimal surface.

use super::{MeshPair, NoSurface};
use crate::construct::packing::ThroughCentre;
use crate::construct::{
    christoffel_by_radii, inverted_packing, koebe_mesh, polar_packing, quad_patch,
};
use crate::mesh::{Mesh, NoPlane};
use crate::scalar::Field;
use crate::space::{Rotation, TopView};

/// The isotropic counterpart of Bonnet's surface (Fig. 8): the Christoffel dual, scaled by `s²`, of the
/// Koebe mesh over the circles of [`polar_packing`], inverted at c.
///
/// The top view of S discretises two orthogonal pencils of circles through the images of 0 and ∞;
/// circles around c are turned over. The smooth surface is `w = ζ + sinh ζ`, `z = Re cosh ζ`.
///
/// # Errors
/// [`NoSurface::ThroughCentre`] for a circle of a vertex or of a face through c;
/// [`NoSurface::NoSector`] for `s = 0` or `±1`.
pub fn bonnet<T: Field>(
    rings: usize,
    sectors: usize,
    half_sector: &Rotation<T>,
    centre: &TopView<T>,
) -> Result<MeshPair<T>, NoSurface<T>> {
    let circles = polar_packing(rings, sectors, half_sector).ok_or(NoSurface::NoSector)?;
    let circles = inverted_packing(&circles, centre)?;
    let radii: Vec<T> = circles.iter().map(|circle| circle.radius.clone()).collect();
    let gauss = koebe_mesh(circles, quad_patch(rings, sectors))?;
    for face in gauss.topology.faces() {
        if let Err(NoPlane::NotAGraph(face)) = gauss.face_plane(face) {
            return Err(ThroughCentre::Face(face).into());
        }
    }
    let dual = christoffel_by_radii(&gauss, &radii)?.mesh;
    let scale = half_sector.sin().square();
    let points = dual.points.iter().map(|p| p.map(|c| c * &scale)).collect();
    let mut surface = Mesh { points, ..dual };
    for radii in surface.data.vertex.values_mut() {
        radii.iter_mut().for_each(|radius| *radius = &*radius * &scale);
    }
    Ok(MeshPair { surface, gauss })
}
