//! Images of meshes under i-M-transformations (Sec. 2.1, Remark 1).

use std::fmt;

use crate::mesh::{Data, Mesh, VertexId};
use crate::scalar::Field;
use crate::space::MoebiusTransformation;

/// A vertex over the centre of a transformation, which has no image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexAtInfinity(pub VertexId);

impl fmt::Display for VertexAtInfinity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "vertex {} lies over the centre: its image is at infinity", self.0.0)
    }
}

impl std::error::Error for VertexAtInfinity {}

/// The mesh with the images of the vertices.
///
/// The image of an i-circular mesh is i-circular, except that a face whose circle passes through the
/// centre has a collinear top view. Other planar faces do not stay planar, other circles than those
/// through vertices do not stay with them: data on elements are not carried over.
///
/// # Errors
/// The first vertex that goes to infinity.
pub fn moebius_image<T: Field>(
    mesh: &Mesh<T>,
    map: &MoebiusTransformation<T>,
) -> Result<Mesh<T>, VertexAtInfinity> {
    let image =
        |v: VertexId| map.map_point(&mesh.points[v.index()]).map_err(|_| VertexAtInfinity(v));
    let points = mesh.topology.vertices().map(image).collect::<Result<_, _>>()?;
    Ok(Mesh { topology: mesh.topology.clone(), points, data: Data::default() })
}
