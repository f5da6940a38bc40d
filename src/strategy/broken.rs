//! Faces that form no mesh.

use proptest::prelude::*;
use proptest::sample::Index;

use super::combinatorics::combinatorics;
use crate::mesh::{FaceId, FaceList, Topology};

/// What is wrong with the faces of [`Broken`] combinatorics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// A face of two corners.
    TooSmall,
    /// A corner that is no vertex.
    NoSuchVertex,
    /// A vertex twice in a face.
    Repeated,
    /// A face twice.
    Doubled,
    /// A face beside another one, turned over.
    TurnedOver,
    /// A third face at an edge.
    ThreeAtAnEdge,
}

impl Defect {
    /// All of them.
    pub const ALL: [Defect; 6] = [
        Defect::TooSmall,
        Defect::NoSuchVertex,
        Defect::Repeated,
        Defect::Doubled,
        Defect::TurnedOver,
        Defect::ThreeAtAnEdge,
    ];
}

/// Faces that form no oriented mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// How many vertices there are.
    pub vertices: usize,
    /// The faces, by the indices of their vertices.
    pub faces: Vec<Vec<u32>>,
    /// What is wrong with them.
    pub defect: Defect,
}

impl Broken {
    /// The faces as [`Topology::new`] takes them, to refuse them.
    pub fn face_list(&self) -> FaceList {
        let mut list = FaceList::new();
        self.faces.iter().for_each(|face| list.push(face.iter().copied()));
        list
    }
}

/// Faces that form no mesh, one for each [`Defect`], somewhere among faces that do.
///
/// ```
/// use isogeo::mesh::Topology;
/// use isogeo::strategy::broken;
/// use proptest::strategy::{Strategy, ValueTree};
/// use proptest::test_runner::TestRunner;
/// let tree = broken().new_tree(&mut TestRunner::deterministic());
/// let refused = |faces: isogeo::strategy::Broken| Topology::new(faces.vertices, faces.face_list()).is_err();
/// assert!(tree.is_ok_and(|tree| refused(tree.current())));
/// ```
pub fn broken() -> impl Strategy<Value = Broken> {
    let defect = prop::sample::select(&Defect::ALL[..]);
    let index = any::<Index>;
    (prop::sample::select(combinatorics()), defect, index(), index()).prop_filter_map(
        "no mesh of one kind in the first place",
        |((vertices, faces), defect, face, corner)| {
            let topology = Topology::new(vertices, faces).ok()?;
            let corners = |f: FaceId| topology.face(f).iter().map(|v| v.0).collect::<Vec<_>>();
            let mut faces: Vec<Vec<u32>> = topology.faces().map(corners).collect();
            let mut vertices = vertices;
            let n = face.index(faces.len());
            let k = corner.index(faces[n].len());
            let next = (k + 1) % faces[n].len();
            match defect {
                Defect::TooSmall => faces[n].truncate(2),
                Defect::NoSuchVertex => faces[n][k] = vertices as u32,
                Defect::Repeated => {
                    let first = faces[n][k];
                    faces[n].insert(next, first);
                }
                Defect::Doubled => faces.push(faces[n].clone()),
                Defect::TurnedOver => {
                    // The edge runs the same way in both faces.
                    faces.push(vec![faces[n][k], faces[n][next], vertices as u32]);
                    vertices += 1;
                }
                Defect::ThreeAtAnEdge => {
                    let (a, b) = (faces[n][k], faces[n][next]);
                    let v = vertices as u32;
                    faces.extend([vec![b, a, v], vec![b, a, v + 1]]);
                    vertices += 2;
                }
            }
            Some(Broken { vertices, faces, defect })
        },
    )
}
