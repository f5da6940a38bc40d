//! v-parallel meshes: corresponding vertices have the same top view (Sec. 3.1).

use std::borrow::Cow;

use super::{Misfit, Which};
use crate::mesh::{FaceId, Mesh};
use crate::scalar::Field;
use crate::space::{Gradient, Vector2};

/// Two planar meshes M and S without vertical faces, with the same combinatorics and equal top
/// views of corresponding vertices.
///
/// A triangle mesh has such pairs with any heights over its top view. Metric duality turns v-parallel
/// pairs into [f-parallel](super::FParallel) ones.
///
/// ```
/// use isogeo::mesh::{FaceList, Mesh};
/// use isogeo::pair::{Misfit, VParallel};
/// use isogeo::space::{Point, Vector2};
/// let mut faces = FaceList::new();
/// faces.push([0, 1, 2]);
/// let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y, x * y));
/// let m = Mesh::new(points.to_vec(), faces)?;
/// let mut s = m.clone();
/// s.points[2].z = 7.0;
/// assert!(VParallel::new(&m, &s).is_ok());
/// s.points[2].x = 0.5;
/// let moved = Vector2::new(0.5, 0.0);
/// assert!(matches!(VParallel::new(&m, &s), Err(Misfit::TopViews { residual, .. }) if residual == moved));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct VParallel<'a, T: Field> {
    mesh: &'a Mesh<T>,
    image: Cow<'a, Mesh<T>>,
    gradients: [Vec<Gradient<T>>; 2],
}

impl<'a, T: Field> VParallel<'a, T> {
    /// The pair (M, S).
    ///
    /// # Errors
    /// The first difference of the combinatorics, [`Misfit::TopViews`] with the difference of two
    /// top views, or a face of M or of S without a plane.
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

    fn checked(mesh: &'a Mesh<T>, image: Cow<'a, Mesh<T>>) -> Result<Self, Misfit<T>> {
        Misfit::of_combinatorics(mesh, &image)?;
        for vertex in mesh.topology.vertices() {
            let (m, s) = (&mesh.points[vertex.index()], &image.points[vertex.index()]);
            let residual = Vector2::new(&s.x - &m.x, &s.y - &m.y);
            if !(residual.x.is_zero() && residual.y.is_zero()) {
                return Err(Misfit::TopViews { vertex, residual });
            }
        }
        let gradients = |which, mesh: &Mesh<T>| {
            let gradient = |f| Ok(mesh.face_plane(f)?.gradient);
            let all: Result<_, _> = mesh.topology.faces().map(gradient).collect();
            all.map_err(|reason| Misfit::Plane(which, reason))
        };
        let gradients = [gradients(Which::Mesh, mesh)?, gradients(Which::Image, &image)?];
        Ok(VParallel { mesh, image, gradients })
    }

    /// The mesh M.
    pub fn mesh(&self) -> &Mesh<T> {
        self.mesh
    }

    /// The mesh S.
    pub fn image(&self) -> &Mesh<T> {
        &self.image
    }

    /// The mesh S, taken out of the pair.
    pub fn into_image(self) -> Mesh<T> {
        self.image.into_owned()
    }

    /// The gradient of a face in one of the meshes: `p` in M, `q` in S.
    pub fn gradient(&self, which: Which, face: FaceId) -> &Gradient<T> {
        let [p, q] = &self.gradients;
        match which {
            Which::Mesh => &p[face.0 as usize],
            Which::Image => &q[face.0 as usize],
        }
    }
}
