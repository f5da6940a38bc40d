//! The dual combinatorics: faces become vertices, interior vertices become faces.

use super::{FaceList, Topology, TopologyError, VertexId};

/// The dual of a [`Topology`] and what its faces stand for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DualTopology {
    /// Vertex `i` is face `i` of the primal mesh.
    pub topology: Topology,
    /// Face `k` is this interior vertex of the primal mesh.
    pub vertex_of_face: Vec<VertexId>,
}

impl Topology {
    /// The dual: one vertex for every face, one face for every interior vertex, its corners in the
    /// counter-clockwise order of the faces around that vertex.
    ///
    /// Boundary vertices have no dual face. The dual of the dual is the mesh without its outermost
    /// vertices; orders of elements are kept.
    ///
    /// # Errors
    /// Where the dual is no mesh: an interior vertex of valence 2, or two faces with two edges in
    /// common.
    pub fn dual(&self) -> Result<DualTopology, TopologyError> {
        let mut faces = FaceList::new();
        let mut vertex_of_face = Vec::new();
        for v in self.interior_vertices() {
            faces.push(self.star(v).map(|h| self.face_at(h).0));
            vertex_of_face.push(v);
        }
        let topology = Topology::new(self.face_count(), faces)?;
        Ok(DualTopology { topology, vertex_of_face })
    }
}
