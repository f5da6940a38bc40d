//! Floor 2: meshes — combinatorics without coordinates, data on elements, files.

mod dual;
mod exact_points;
mod face_plane;
pub mod file;
mod topology;
mod topology_error;

use std::collections::BTreeMap;

use crate::space::{Point, Transform};

pub use dual::DualTopology;
pub(crate) use exact_points::common_multiple;
pub use exact_points::{ExactPoints, Lattice};
pub use face_plane::NoPlane;
pub(crate) use face_plane::spanning_plane;
pub use topology::{FaceId, FaceList, HalfEdge, Topology, VertexId, VertexKind};
pub use topology_error::TopologyError;

/// A mesh: combinatorics, a point for every vertex, and named values on its elements.
///
/// `T` is any scalar, or [`Numeral`](crate::scalar::Numeral) for a mesh as a file gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh<T> {
    /// Who meets whom.
    pub topology: Topology,
    /// The points of the vertices, in the order of the vertices.
    pub points: Vec<Point<T>>,
    /// Named values on vertices and faces.
    pub data: Data<T>,
}

/// Named values on the elements of a mesh, in the order of the elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Data<T> {
    /// One value for every vertex.
    pub vertex: BTreeMap<String, Vec<T>>,
    /// One value for every face.
    pub face: BTreeMap<String, Vec<T>>,
}

impl<T> Default for Data<T> {
    fn default() -> Self {
        Data { vertex: BTreeMap::new(), face: BTreeMap::new() }
    }
}

impl<T> Data<T> {
    fn map<S>(&self, f: impl Fn(&T) -> S) -> Data<S> {
        let convert = |arrays: &BTreeMap<String, Vec<T>>| {
            arrays.iter().map(|(k, v)| (k.clone(), v.iter().map(&f).collect())).collect()
        };
        Data { vertex: convert(&self.vertex), face: convert(&self.face) }
    }
}

impl<T> Mesh<T> {
    /// A mesh without data.
    ///
    /// # Errors
    /// Where the faces do not form an oriented mesh: see [`TopologyError`].
    pub fn new(points: Vec<Point<T>>, faces: FaceList) -> Result<Self, TopologyError> {
        let topology = Topology::new(points.len(), faces)?;
        Ok(Mesh { topology, points, data: Data::default() })
    }

    /// The same mesh with `f` applied to every number: the step from one scalar to another.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> Mesh<S> {
        Mesh {
            topology: self.topology.clone(),
            points: self.points.iter().map(|p| p.map(&f)).collect(),
            data: self.data.map(&f),
        }
    }
}

/// Whatever transforms points transforms meshes, vertex by vertex; values on elements are kept as
/// they are.
impl<T: Clone, G: Transform<Point<T>>> Transform<Mesh<T>> for G {
    fn apply(&self, mesh: &Mesh<T>) -> Mesh<T> {
        let points = mesh.points.iter().map(|p| self.apply(p)).collect();
        Mesh { topology: mesh.topology.clone(), points, data: mesh.data.clone() }
    }
}
