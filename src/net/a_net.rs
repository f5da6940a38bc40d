//! A-nets: the edges at every interior vertex lie in a plane.
//!
//! They discretise nets of asymptotic lines; their faces are skew. The plane at a vertex stands for
//! the tangent plane. The conjugates of i-minimal circular nets are A-nets. Vertices whose edges lie
//! in a vertical plane count as well.

use super::Judge;
use super::planar::{self, Coplanar};
use crate::check::{Decide, Outcome};
use crate::mesh::VertexId;

pub(super) fn outcome<D: Decide>(judge: &Judge<'_, D>, v: VertexId) -> Outcome<D::Value> {
    let topology = judge.topology();
    let star: Vec<VertexId> =
        std::iter::once(v).chain(topology.star(v).map(|h| topology.target(h))).collect();
    let answer = planar::shape(judge.decide(), &star).planar;
    Outcome::of(answer, || {
        let places = planar::places(judge.decide(), &star);
        judge.worst("edges in a plane", Coplanar, places.into_iter().flatten())
    })
}
