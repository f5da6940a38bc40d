//! Christoffel duals: parallel meshes with mixed area 0 at every face (Sec. 4, Fig. 7, (20)).
//!
//! | rule | for | edge of the dual |
//! | --- | --- | --- |
//! | [`christoffel_by_radii`] | meshes with touching vertex circles of radii `R` | `±(v_j − v_i)/(R_i R_j)` |
//! | [`christoffel_by_diagonals`] | planar quads | `(v_j − v_i)/(ν_i ν_j)` |
//!
//! The signs alternate around every face. The factors ν of a quad are the signed distances
//! `(α, β, γ, δ)` of its corners from the point of its diagonals, up to a factor for each diagonal;
//! that they fit together along all diagonals of the mesh is Koenigs' condition. Opposite signs
//! on a diagonal make the signs of the first rule.
//!
//! Whether a mesh has a dual is found out exactly: the ratios around every interior vertex, the
//! edges around every face, and what is left around holes and handles. A dual is unique up to scale
//! and translation; its own factors are `1/ν`, and with them its dual is the mesh again.

mod diagonals;
mod labels;
mod no_dual;
mod radii;

use super::spread::{joined_vertices, spread};
use crate::mesh::{Data, FaceId, HalfEdge, Mesh, VertexId};
use crate::pair::four_mixed_areas;
use crate::scalar::Field;
use crate::space::{Point, TopView, Vector3};

pub use diagonals::{christoffel_by_diagonals, diagonal_ratio};
pub use no_dual::NoChristoffelDual;
pub use radii::christoffel_by_radii;

/// A Christoffel dual with what proves that it closes.
#[derive(Clone, Debug, PartialEq)]
pub struct ChristoffelDual<T> {
    /// The dual, with its first vertex at the origin.
    pub mesh: Mesh<T>,
    /// The factor `1/ν` or `1/R` of every vertex of the dual: with these its dual is the mesh, moved.
    pub factors: Vec<T>,
}

/// Adds up the edges `factor · (v_j − v_i)` and checks that all faces and cycles close and that mixed
/// areas are 0. In numbers that round nothing is checked, since nothing would be zero.
fn integrated<T: Field>(
    mesh: &Mesh<T>,
    factor: impl Fn(HalfEdge) -> T,
) -> Result<Mesh<T>, NoChristoffelDual<T>> {
    let topology = &mesh.topology;
    let along = |h: HalfEdge| {
        let (a, b) = (topology.origin(h), topology.target(h));
        let (edge, factor) = (&mesh.points[b.index()] - &mesh.points[a.index()], factor(h));
        Vector3::new(&edge.x * &factor, &edge.y * &factor, &edge.z * &factor)
    };
    let step = |p: &Point<T>, from: usize, h: HalfEdge| {
        let v = along(h);
        if topology.origin(h).index() == from {
            p + &v
        } else {
            Point::new(&p.x - &v.x, &p.y - &v.y, &p.z - &v.z)
        }
    };
    let origin = Point::new(T::zero(), T::zero(), T::zero());
    let neighbours = joined_vertices(topology);
    let found = spread(&neighbours, 0, &origin, |p, from, _, h| {
        Ok::<_, NoChristoffelDual<T>>(step(p, from, h))
    })?;
    let points = &found.values;
    if T::EXACT {
        for face in topology.faces() {
            let mut end = origin.clone();
            topology.half_edges(face).for_each(|h| end = &end + &along(h));
            let residual = &end - &origin;
            if ![&residual.x, &residual.y, &residual.z].into_iter().all(T::is_zero) {
                return Err(NoChristoffelDual::FaceOpen { face, residual });
            }
        }
        for h in topology.edges() {
            let (a, b) = (topology.origin(h).index(), topology.target(h).index());
            if step(&points[a], a, h) != points[b] {
                return Err(NoChristoffelDual::VertexCycle(cycle(found.cycle(a, b))));
            }
        }
        for face in topology.faces() {
            let [f, s] = [&mesh.points, points].map(|points| top_views(mesh, points, face));
            let residual = four_mixed_areas(&f, &s);
            if !residual.is_zero() {
                return Err(NoChristoffelDual::MixedArea { face, residual });
            }
        }
    }
    Ok(Mesh { topology: topology.clone(), points: found.values, data: Data::default() })
}

fn top_views<T: Clone>(mesh: &Mesh<T>, points: &[Point<T>], face: FaceId) -> Vec<TopView<T>> {
    mesh.topology.face(face).iter().map(|v| points[v.index()].top_view()).collect()
}

fn cycle(indices: Vec<usize>) -> Vec<VertexId> {
    indices.into_iter().map(|i| VertexId(i as u32)).collect()
}
