//! Planar meshes with fixed normals: the offsets of their planes solve a linear system.

use super::incidence::{Incidence, Placement};
use super::linear::{Rows, solution_near};
use super::placing::{Placing, Sheet};
use super::{NoExactMesh, Obstacle};
use crate::mesh::{Topology, VertexId};
use crate::scalar::{Approx, Rational, Ring};
use crate::space::{Point, Vector3};

/// Points near their targets, in which all faces are planar: normals are rounded, then of the offsets as many
/// as may be chosen; a vertex is the common point of its planes.
///
/// # Errors
/// Planes that do not determine a vertex; not enough memory.
pub(super) fn offsets(
    topology: &Topology,
    incidence: &Incidence,
    targets: &[Point<f64>],
    bits: i32,
) -> Result<Vec<Point<Rational>>, NoExactMesh> {
    let mut placing = Placing::new(topology, targets, bits);
    let zero = || Rational::zero();
    let mut normals = vec![Vector3::new(zero(), zero(), zero()); topology.face_count()];
    let mut offsets = vec![0.0; topology.face_count()];
    for f in topology.faces().filter(|&f| topology.face(f).len() > 3) {
        let Sheet { normal, offset } = placing.target_sheet(f);
        let normal = placing.rounded_vector(&normal);
        normals[f.index()] = normal.ok_or(Obstacle::Degenerate.at_face(f))?;
        offsets[f.index()] = offset;
    }
    let planes = |v: VertexId| incidence.faces_at(v).collect::<Vec<usize>>();
    let bases: Vec<_> = topology.vertices().map(|v| base(&planes(v), &normals)).collect();
    let mut rows = Rows::new();
    for (v, base) in topology.vertices().zip(&bases) {
        if let [a, b, c] = base[..] {
            let others = planes(v).into_iter().filter(|d| !base.contains(d));
            rows.extend(others.map(|d| concurrency([a, b, c, d], &normals)));
        }
    }
    let offsets = solution_near(&offsets, &rows);
    let offsets = offsets.map_err(|_| Obstacle::OutOfMemory.at_vertex(VertexId(0)))?;
    for (f, (normal, offset)) in normals.into_iter().zip(offsets).enumerate() {
        placing.put_sheet(f, Sheet { normal, offset });
    }
    for (v, base) in topology.vertices().zip(bases) {
        let on = base.iter().map(|f| topology.vertex_count() + f).collect();
        placing
            .place(&Placement { node: v.index(), on })
            .ok_or(Obstacle::Degenerate.at_vertex(v))?;
    }
    Ok(placing.into_points())
}

/// Three of some planes, as far from parallel as may be; or all, if there are no three.
fn base(planes: &[usize], normals: &[Vector3<Rational>]) -> Vec<usize> {
    if planes.len() <= 3 {
        return planes.to_vec();
    }
    let near = |f: usize| {
        let Vector3 { x, y, z } = &normals[f];
        Vector3::new(x.to_f64(), y.to_f64(), z.to_f64())
    };
    let farthest = |size: &dyn Fn(Vector3<f64>) -> f64| {
        let sizes = planes.iter().map(|&f| (f, size(near(f))));
        sizes.fold((planes[0], -1.0), |best, next| if next.1 > best.1 { next } else { best }).0
    };
    let a = planes[0];
    let b = farthest(&|n| near(a).cross(&n).length2());
    let c = farthest(&|n| Vector3::det(&near(a), &near(b), &n).abs());
    vec![a, b, c]
}

/// `Σ aᵢ dᵢ = 0` for four planes `nᵢ·x = dᵢ` to have a common point.
fn concurrency(planes: [usize; 4], normals: &[Vector3<Rational>]) -> Vec<(usize, Rational)> {
    let [a, b, c, d] = planes.map(|f| &normals[f]);
    let minors = [
        Vector3::det(b, c, d),
        -Vector3::det(a, c, d),
        Vector3::det(a, b, d),
        -Vector3::det(a, b, c),
    ];
    planes.into_iter().zip(minors).collect()
}
