//! Laws that are false, to see that failures are found, made small and played back.

use super::decider::decided;
use super::{accepted, check};
use crate::campaign::law::{Law, drawn};
use crate::check::Verdict;
use crate::claim::{Run, Stop};
use crate::construct::inscribed_v_parallel;
use crate::mesh::Mesh;
use crate::net::Property;
use crate::pair::{Misfit, Which};
use crate::scalar::Rational;
use crate::strategy::{any_mesh, quad_patches, small};

fn planar(mesh: &Mesh<Rational>) -> Run {
    let verdict = decided(mesh, Property::Planar).verdict();
    check(verdict != Verdict::Refuted, || format!("planar is {verdict}"))
}

/// Theorem 1 without its hypothesis.
fn inscribed(mesh: &Mesh<Rational>) -> Run {
    match inscribed_v_parallel(mesh) {
        Err(Misfit::Plane(Which::Mesh, _)) => Err(Stop::Excluded("no vertical face")),
        pair => accepted("inscribed and v-parallel", pair).map(|_| ()),
    }
}

pub(super) const LAWS: &[Law] = &[
    Law {
        id: "control-meshes-are-planar",
        says: "false: all meshes are planar",
        control: true,
        cases: || drawn(any_mesh(small()), planar),
    },
    Law {
        id: "control-thm-1-v",
        says: "false: all planar meshes have planar lifts, i-circular or not",
        control: true,
        cases: || drawn(quad_patches(), inscribed),
    },
];
