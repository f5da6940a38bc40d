//! Why two meshes are no pair.

use std::fmt;

use crate::mesh::{FaceId, Mesh, NoPlane, Topology, VertexId};
use crate::space::{Vector2, Vector3};

/// One of the two meshes of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The mesh M.
    Mesh,
    /// The mesh S that stands for its Gauss image.
    Image,
}

/// Why two meshes do not fit: the first element that fails, and by how much, exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Misfit<T> {
    /// A mesh with more or fewer points than vertices.
    Points(Which),
    /// The numbers of vertices or of faces differ.
    Counts {
        /// Vertices of M and of S.
        vertices: (usize, usize),
        /// Faces of M and of S.
        faces: (usize, usize),
    },
    /// A face that lists different vertices in M and in S.
    Face(FaceId),
    /// Corresponding edges that are not parallel.
    Edge {
        /// The edge.
        edge: (VertexId, VertexId),
        /// The cross product of the edge of M and the edge of S.
        residual: Vector3<T>,
    },
    /// A face without a plane, or with an isotropic one.
    Plane(Which, NoPlane<T>),
    /// Corresponding faces that do not lie in parallel planes.
    FacePlanes {
        /// The face.
        face: FaceId,
        /// A corner.
        vertex: VertexId,
        /// How far the corner of S lies above the plane that is parallel to that of M and goes
        /// through the first corner of S.
        residual: T,
    },
    /// Corresponding vertices with different top views.
    TopViews {
        /// The vertex.
        vertex: VertexId,
        /// From the top view in M to the top view in S.
        residual: Vector2<T>,
    },
}

impl<T> Misfit<T> {
    /// Checks that both meshes consist of the same faces, with a point for every vertex.
    pub(super) fn of_combinatorics(mesh: &Mesh<T>, image: &Mesh<T>) -> Result<(), Self> {
        let (m, s) = (&mesh.topology, &image.topology);
        for (which, mesh) in [(Which::Mesh, mesh), (Which::Image, image)] {
            if mesh.points.len() != mesh.topology.vertex_count() {
                return Err(Misfit::Points(which));
            }
        }
        Self::of_topologies(m, s)
    }

    /// Checks that both meshes consist of the same faces.
    ///
    /// # Errors
    /// [`Misfit::Counts`] or the first face that differs.
    pub fn of_topologies(m: &Topology, s: &Topology) -> Result<(), Self> {
        let vertices = (m.vertex_count(), s.vertex_count());
        let faces = (m.face_count(), s.face_count());
        if vertices.0 != vertices.1 || faces.0 != faces.1 {
            return Err(Misfit::Counts { vertices, faces });
        }
        m.faces().find(|&f| m.face(f) != s.face(f)).map_or(Ok(()), |f| Err(Misfit::Face(f)))
    }
}

impl<T> Misfit<T> {
    /// The same with `f` applied to every number, to show them in another form.
    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> Misfit<S> {
        match self {
            Misfit::Points(which) => Misfit::Points(*which),
            Misfit::Counts { vertices, faces } => {
                Misfit::Counts { vertices: *vertices, faces: *faces }
            }
            Misfit::Face(face) => Misfit::Face(*face),
            Misfit::Edge { edge, residual: Vector3 { x, y, z } } => {
                Misfit::Edge { edge: *edge, residual: Vector3 { x: f(x), y: f(y), z: f(z) } }
            }
            Misfit::Plane(which, reason) => Misfit::Plane(*which, reason.map(f)),
            Misfit::FacePlanes { face, vertex, residual } => {
                Misfit::FacePlanes { face: *face, vertex: *vertex, residual: f(residual) }
            }
            Misfit::TopViews { vertex, residual: Vector2 { x, y } } => {
                Misfit::TopViews { vertex: *vertex, residual: Vector2 { x: f(x), y: f(y) } }
            }
        }
    }
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Which::Mesh => "the mesh",
            Which::Image => "the Gauss image",
        })
    }
}

impl<T: fmt::Display> fmt::Display for Misfit<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Misfit::Points(which) => {
                write!(f, "{which} has more or fewer points than vertices")
            }
            Misfit::Counts { vertices: (v, w), faces: (a, b) } => {
                write!(f, "the combinatorics differ: {v} and {w} vertices, {a} and {b} faces")
            }
            Misfit::Face(face) => {
                write!(f, "the combinatorics differ: face {} has other vertices", face.0)
            }
            Misfit::Edge { edge: (a, b), residual: Vector3 { x, y, z } } => write!(
                f,
                "the edges between vertices {} and {} are not parallel: their cross product is ({x}, {y}, {z})",
                a.0, b.0
            ),
            Misfit::Plane(which, reason) => write!(f, "in {which}, {reason}"),
            Misfit::FacePlanes { face, vertex, residual } => write!(
                f,
                "the planes of face {} are not parallel: vertex {} of the Gauss image lies {residual} above the parallel plane",
                face.0, vertex.0
            ),
            Misfit::TopViews { vertex, residual: Vector2 { x, y } } => {
                write!(f, "vertex {} has different top views: they differ by ({x}, {y})", vertex.0)
            }
        }
    }
}

impl<T: fmt::Debug + fmt::Display> std::error::Error for Misfit<T> {}
