//! The vertices that an exact mesh shares with the one in doubles.

use super::NoProof;
use crate::mesh::{Topology, VertexId};
use crate::optimise::Mobility;

/// Vertices that do not move.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pinned {
    /// None.
    Nothing,
    /// Those of the boundary.
    Boundary,
    /// These.
    Vertices(Vec<VertexId>),
}

impl Pinned {
    /// How each vertex may move.
    ///
    /// # Errors
    /// Where a vertex is named that the mesh does not have.
    pub fn mobility(&self, topology: &Topology) -> Result<Vec<Mobility>, NoProof> {
        let mut mobility = vec![Mobility::Free; topology.vertex_count()];
        match self {
            Pinned::Nothing => {}
            Pinned::Boundary => {
                let boundary = topology.boundary_loops().concat();
                boundary.iter().for_each(|v| mobility[v.index()] = Mobility::Fixed);
            }
            Pinned::Vertices(vertices) => {
                for &v in vertices {
                    *mobility.get_mut(v.index()).ok_or(NoProof::NoSuchVertex(v))? = Mobility::Fixed;
                }
            }
        }
        Ok(mobility)
    }

    /// Those that are fixed.
    pub fn of(mobility: &[Mobility]) -> Self {
        let fixed = (0..).zip(mobility).filter(|(_, m)| **m == Mobility::Fixed);
        let fixed: Vec<_> = fixed.map(|(v, _)| VertexId(v)).collect();
        if fixed.is_empty() { Pinned::Nothing } else { Pinned::Vertices(fixed) }
    }
}
