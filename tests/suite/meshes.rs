//! The meshes that the tests share: the public strategies, over the second exact scalar.

use isogeo::mesh::Mesh;
use isogeo::scalar::BigRational;
use isogeo::strategy;
use proptest::prelude::*;

pub use strategy::{any_mesh, combinatorics, relabelled};

pub type Q = BigRational;

pub fn small() -> impl Strategy<Value = Q> + Clone {
    strategy::small()
}

pub fn fraction() -> impl Strategy<Value = Q> + Clone {
    strategy::fraction()
}

/// Translational nets with an interior vertex.
pub fn translational() -> impl Strategy<Value = Mesh<Q>> {
    strategy::translational().prop_filter("no interior vertex", has_interior)
}

/// i-circular nets from Cauchy data, with an interior vertex.
pub fn circular() -> impl Strategy<Value = Mesh<Q>> {
    strategy::cauchy().prop_filter("no interior vertex", has_interior)
}

fn has_interior(mesh: &Mesh<Q>) -> bool {
    mesh.topology.interior_vertices().next().is_some()
}
