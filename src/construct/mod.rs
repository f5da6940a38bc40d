//! Floor 6: exact families of meshes, and meshes made from others or from samples.

pub mod accuracy;
pub mod christoffel;
mod circle_centres;
mod circle_pattern;
mod circular_net;
mod circumscribed;
mod delaunay;
mod discrete_power;
mod enclosure;
pub mod family;
pub mod gauss_image;
pub mod hexagonal;
mod incircle_image;
mod inscribed;
mod koebe;
mod metric_dual;
pub mod minimal;
mod moebius_image;
mod packing;
pub mod rotational;
mod spread;
mod star;
pub mod subdivision;
pub mod transfer;
mod translational_net;
mod voronoi;

pub use christoffel::{
    ChristoffelDual, NoChristoffelDual, christoffel_by_diagonals, christoffel_by_radii,
};
pub use circle_centres::{CircleCentres, Intruder, NotCircumscribed};
pub use circle_pattern::{CircleCondition, CirclePattern, Koebe, Layout, NoPattern};
pub use circular_net::circular_net;
pub use circumscribed::{Circumscribed, circumscribed_f_parallel, circumscribed_v_parallel};
pub use delaunay::{NoTriangulation, delaunay};
pub use discrete_power::discrete_power;
pub use enclosure::{ENCLOSURE, Enclosed};
pub use gauss_image::NoGaussImage;
pub use incircle_image::{NoIncircleImage, incircle_image, koebe_image};
pub use inscribed::{inscribed_f_parallel, inscribed_v_parallel, lift, mean_gradient};
pub use koebe::{face_circle, koebe_mesh, schramm_residual, vertex_circles};
pub use metric_dual::{NoDual, face_plane, metric_dual};
pub use moebius_image::{VertexAtInfinity, moebius_image};
pub use packing::{ThroughCentre, inverted_packing, polar_packing, square_packing};
pub use translational_net::translational_net;
pub use voronoi::voronoi_areas;

use crate::mesh::FaceList;

/// The faces of an `rows × columns` patch of quads, row by row; the vertex in row `i` and column
/// `j` has index `i (columns + 1) + j`. Faces run counter-clockwise if rows go along x and columns
/// along y.
pub fn quad_patch(rows: usize, columns: usize) -> FaceList {
    let at = |i: usize, j: usize| (i * (columns + 1) + j) as u32;
    let mut faces = FaceList::new();
    for i in 0..rows {
        for j in 0..columns {
            faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    faces
}
