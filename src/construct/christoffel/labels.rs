//! The signs of edges that alternate around every face: rows and columns of a grid.

use super::NoChristoffelDual;
use crate::construct::spread::{joined_faces, spread};
use crate::mesh::{FaceId, HalfEdge, Topology, VertexKind};

/// Whether each face begins with an edge of the positive kind.
pub(super) struct Labels<'a> {
    topology: &'a Topology,
    starts: Vec<bool>,
}

impl<'a> Labels<'a> {
    /// The labels in which the first edge of the first face is positive.
    ///
    /// # Errors
    /// A face with an odd number of sides, an interior vertex of odd valence, or a cycle of faces
    /// around a hole or a handle that does not alternate.
    pub fn new<T>(topology: &'a Topology) -> Result<Self, NoChristoffelDual<T>> {
        if let Some(face) = topology.faces().find(|&f| topology.face(f).len() % 2 == 1) {
            return Err(NoChristoffelDual::OddFace(face));
        }
        let odd = topology.vertices().filter(|&v| topology.kind(v) == VertexKind::Interior);
        if let Some(vertex) = odd.into_iter().find(|&v| topology.star(v).count() % 2 == 1) {
            return Err(NoChristoffelDual::OddVertex(vertex));
        }
        // Two faces see their edge with the same sign.
        let same = |h: HalfEdge| {
            topology.twin(h).is_none_or(|twin| is_even(topology, h) == is_even(topology, twin))
        };
        let found = spread(&joined_faces(topology), 0, &true, |&start, _, _, h| {
            Ok::<_, NoChristoffelDual<T>>(start == same(h))
        })?;
        for h in topology.edges() {
            let Some(twin) = topology.twin(h) else { continue };
            let (f, g) = (topology.face_at(h).index(), topology.face_at(twin).index());
            if (found.values[f] == found.values[g]) != same(h) {
                let cycle = found.cycle(f, g).into_iter().map(|i| FaceId(i as u32)).collect();
                return Err(NoChristoffelDual::FaceCycle(cycle));
            }
        }
        Ok(Labels { topology, starts: found.values })
    }

    /// Whether the edge is of the positive kind.
    pub fn is_positive(&self, h: HalfEdge) -> bool {
        self.starts[self.topology.face_at(h).index()] == is_even(self.topology, h)
    }
}

/// Whether the half-edge has an even place in its face.
fn is_even(topology: &Topology, h: HalfEdge) -> bool {
    let first = topology.half_edges(topology.face_at(h)).next().unwrap_or(h);
    (h.0 - first.0).is_multiple_of(2)
}
