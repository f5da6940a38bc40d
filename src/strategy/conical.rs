//! i-conical meshes.

use proptest::prelude::*;

use super::circular::{cauchy_from, translational};
use crate::construct::metric_dual;
use crate::mesh::Mesh;
use crate::scalar::Field;

/// i-conical meshes of up to 3 × 3 quads: translational nets, and metric duals of i-circular ones.
///
/// There is at least one interior vertex.
pub fn conical<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let has_interior = |mesh: &Mesh<Q>| mesh.topology.interior_vertices().next().is_some();
    let dual = cauchy_from(3)
        .prop_filter_map("a face with a collinear top view", |mesh| metric_dual(&mesh).ok());
    prop_oneof![dual, translational()].prop_filter("no interior vertex", has_interior)
}
