//! Metric duality on meshes and pairs.

use super::{accepted, check, given};
use crate::campaign::law::{Law, drawn};
use crate::claim::{Run, Stop};
use crate::construct::metric_dual;
use crate::construct::minimal::MeshPair;
use crate::mesh::Mesh;
use crate::pair::{FParallel, VParallel};
use crate::scalar::Rational;
use crate::space::Dual;
use crate::strategy::{circular, f_parallel, polygons, quad_patches, v_parallel};
use proptest::prelude::*;

/// The planes of the dual faces are dual to the interior vertices.
fn double(mesh: &Mesh<Rational>) -> Run {
    let dual = given("planar, without vertical faces", metric_dual(mesh))?;
    for (face, plane) in mesh.topology.faces().zip(&dual.points) {
        let plane = plane.dual();
        for v in mesh.topology.face(face) {
            let point = &mesh.points[v.index()];
            check(plane.contains(point), || format!("vertex {} is not in its plane", v.0))?;
        }
    }
    let mut seen = false;
    for (face, v) in dual.topology.faces().zip(mesh.topology.interior_vertices()) {
        // Of face planes through a line, the dual points lie on one, too.
        let Ok(plane) = dual.face_plane(face) else { continue };
        seen = true;
        let (point, again) = (&mesh.points[v.index()], plane.dual());
        check(again == *point, || format!("vertex {} becomes {again:?}", v.0))?;
    }
    if seen { Ok(()) } else { Err(Stop::Excluded("an interior vertex")) }
}

fn f_to_v(pair: &MeshPair<Rational>) -> Run {
    let [m, s] = [&pair.surface, &pair.gauss].map(metric_dual);
    let (m, s) = given("no vertical face", m.and_then(|m| s.map(|s| (m, s))))?;
    for (m, s) in m.points.iter().zip(&s.points) {
        check(m.is_parallel_to(s), || format!("{m:?} and {s:?} have different top views"))?;
    }
    Ok(())
}

fn v_to_f(pair: &MeshPair<Rational>) -> Run {
    accepted("v-parallel", VParallel::new(&pair.surface, &pair.gauss))?;
    let [m, s] = [&pair.surface, &pair.gauss].map(metric_dual);
    let (m, s) = given("combinatorics with a dual", m.and_then(|m| s.map(|s| (m, s))))?;
    if m.topology.faces().any(|face| m.face_plane(face).is_err()) {
        return Err(Stop::Excluded("no vertical dual face"));
    }
    accepted("f-parallel", FParallel::new(&m, &s)).map(|_| ())
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "double-dual",
        says: "the dual of the dual is the mesh, at interior vertices",
        control: false,
        cases: || drawn(prop_oneof![quad_patches(), polygons(), circular()], double),
    },
    Law {
        id: "dual-f-parallel",
        says: "the duals of f-parallel meshes are v-parallel",
        control: false,
        cases: || drawn(f_parallel(), f_to_v),
    },
    Law {
        id: "dual-v-parallel",
        says: "the duals of v-parallel meshes are f-parallel",
        control: false,
        cases: || drawn(v_parallel(), v_to_f),
    },
];
