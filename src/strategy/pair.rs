//! Pairs of meshes: M with a mesh S that stands for its Gauss image.

use proptest::prelude::*;

use super::circular::{circular, i_minimal};
use super::number::{nonzero, number};
use super::planar::is_graph;
use super::triangles::{delaunay_graph, jittered, star};
use crate::construct::minimal::MeshPair;
use crate::construct::{lift, metric_dual};
use crate::mesh::Mesh;
use crate::scalar::{Field, RationalField};
use crate::space::Point;

/// v-parallel pairs: triangle meshes with any heights over the same top view, and i-circular meshes
/// M with `aM + b lift(M)`.
///
/// No face of M or S is vertical.
pub fn v_parallel<Q: RationalField>() -> impl Strategy<Value = MeshPair<Q>> {
    let circular = (circular::<Q>(), nonzero(), nonzero()).prop_map(|(surface, a, b)| {
        let lifted = lift(&surface).points.into_iter();
        let height = |(m, s): (&Point<Q>, Point<Q>)| &a * &m.z + &b * s.z;
        let heights = surface.points.iter().zip(lifted).map(height).collect();
        with_image(surface, heights)
    });
    let pair = prop_oneof![over_triangles(), circular];
    pair.prop_filter("a face with a collinear top view", |pair| is_graph(&pair.surface))
}

fn over_triangles<Q: RationalField>() -> impl Strategy<Value = MeshPair<Q>> {
    let heights = prop::collection::vec(number(), 16);
    (prop_oneof![star(), jittered(), delaunay_graph()], heights).prop_map(
        |(surface, mut heights)| {
            heights.truncate(surface.points.len());
            with_image(surface, heights)
        },
    )
}

fn with_image<Q: Field>(surface: Mesh<Q>, heights: Vec<Q>) -> MeshPair<Q> {
    let points = surface.points.iter().zip(heights).map(|(p, z)| p.top_view().at_height(z));
    let gauss = Mesh { points: points.collect(), ..surface.clone() };
    MeshPair { surface, gauss }
}

/// f-parallel pairs: the metric duals of v-parallel ones, with n-gons of any size, and i-minimal nets
/// with their Gauss images.
///
/// No face of M is vertical; faces of S may be points.
pub fn f_parallel<Q: RationalField>() -> impl Strategy<Value = MeshPair<Q>> {
    let dual = v_parallel().prop_filter_map("no dual", |pair| {
        let [surface, gauss] = [pair.surface, pair.gauss].map(|mesh| metric_dual(&mesh).ok());
        Some(MeshPair { surface: surface?, gauss: gauss? })
    });
    prop_oneof![dual, i_minimal()].prop_filter("a vertical face, or none", |pair| {
        pair.surface.topology.face_count() > 0 && is_graph(&pair.surface)
    })
}
