//! Parallel meshes: corresponding edges are parallel (Sec. 3.1, Fig. 2).

use std::borrow::Cow;

use super::Misfit;
use crate::mesh::Mesh;
use crate::scalar::Ring;

/// Two meshes M and S with the same combinatorics and parallel edges.
///
/// The zero vector is parallel to everything, so edges of either mesh may have length zero. For a
/// planar M whose faces have no two consecutive edges on a line the face planes are parallel as
/// well. With M parallel to S, so is every linear combination of them.
///
/// ```
/// use isogeo::mesh::{FaceList, Mesh};
/// use isogeo::pair::Parallel;
/// use isogeo::space::Point;
/// let triangle = |scale: f64| {
///     let mut faces = FaceList::new();
///     faces.push([0, 1, 2]);
///     let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)];
///     let points = corners.map(|(x, y)| Point::new(scale * x, scale * y, scale * x));
///     Mesh::new(points.to_vec(), faces)
/// };
/// let (m, mut s) = (triangle(1.0)?, triangle(-2.0)?);
/// assert!(Parallel::new(&m, &s).is_ok());
/// s.points[2].z = 1.0;
/// assert!(Parallel::new(&m, &s).is_err());
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Parallel<'a, T: Ring> {
    mesh: &'a Mesh<T>,
    image: Cow<'a, Mesh<T>>,
}

impl<'a, T: Ring> Parallel<'a, T> {
    /// The pair (M, S).
    ///
    /// # Errors
    /// The first difference of the combinatorics, or [`Misfit::Edge`] with the cross product of
    /// two edges.
    pub fn new(mesh: &'a Mesh<T>, image: &'a Mesh<T>) -> Result<Self, Misfit<T>> {
        Self::checked(mesh, Cow::Borrowed(image))
    }

    /// The pair (M, S) with an S of its own.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn owning(mesh: &'a Mesh<T>, image: Mesh<T>) -> Result<Self, Misfit<T>> {
        Self::checked(mesh, Cow::Owned(image))
    }

    pub(super) fn checked(mesh: &'a Mesh<T>, image: Cow<'a, Mesh<T>>) -> Result<Self, Misfit<T>> {
        Misfit::of_combinatorics(mesh, &image)?;
        for h in mesh.topology.edges() {
            let edge = (mesh.topology.origin(h), mesh.topology.target(h));
            let along = |m: &Mesh<T>| &m.points[edge.1.index()] - &m.points[edge.0.index()];
            let residual = along(mesh).cross(&along(&image));
            if ![&residual.x, &residual.y, &residual.z].into_iter().all(T::is_zero) {
                return Err(Misfit::Edge { edge, residual });
            }
        }
        Ok(Parallel { mesh, image })
    }

    /// The mesh M.
    pub fn mesh(&self) -> &Mesh<T> {
        self.mesh
    }

    /// The mesh S.
    pub fn image(&self) -> &Mesh<T> {
        &self.image
    }
}
