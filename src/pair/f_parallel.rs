//! f-parallel meshes: corresponding face planes are parallel (Sec. 3.1).

use std::borrow::Cow;

use super::{Misfit, Parallel, Which};
use crate::mesh::{FaceId, Mesh};
use crate::scalar::Field;
use crate::space::{Gradient, Plane};

/// A planar mesh M without vertical faces and a mesh S with the same combinatorics whose faces lie
/// in parallel planes.
///
/// Then the edges are parallel, too, where two planes that are not parallel meet in them; at the
/// boundary and between coplanar faces they need not be: see [`parallel`](Self::parallel). Faces of
/// S may degenerate to segments or points. Metric duality turns f-parallel pairs into
/// [v-parallel](super::VParallel) ones.
///
/// ```
/// use isogeo::construct::translational_net;
/// use isogeo::pair::{FParallel, Misfit};
/// use isogeo::scalar::{Field, Rational, Ring};
/// let at = |x: i64, z: i64| (Rational::from_i64(x), Rational::from_i64(z));
/// let m = translational_net(&[at(0, 0), at(2, 1)], &[at(0, 0), at(3, 5)])?;
/// let mut s = m.clone(); // the only face, twice
/// assert!(FParallel::new(&m, &s).is_ok());
/// s.points[3].z += &Rational::one();
/// assert!(matches!(FParallel::new(&m, &s), Err(Misfit::FacePlanes { residual, .. }) if residual == Rational::one()));
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FParallel<'a, T: Field> {
    mesh: &'a Mesh<T>,
    image: Cow<'a, Mesh<T>>,
    gradients: Vec<Gradient<T>>,
}

impl<'a, T: Field> FParallel<'a, T> {
    /// The pair (M, S).
    ///
    /// # Errors
    /// The first difference of the combinatorics, a face of M without a plane, or
    /// [`Misfit::FacePlanes`] with the height by which a corner of S misses the parallel plane.
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
        let plane = |f| mesh.face_plane(f).map_err(|reason| Misfit::Plane(Which::Mesh, reason));
        let mut gradients = Vec::with_capacity(mesh.topology.face_count());
        for face in mesh.topology.faces() {
            let gradient = plane(face)?.gradient;
            if let [first, rest @ ..] = mesh.topology.face(face) {
                let parallel = Plane::through_point(&image.points[first.index()], gradient.clone());
                for &vertex in rest {
                    let residual = parallel.residual(&image.points[vertex.index()]);
                    if !residual.is_zero() {
                        return Err(Misfit::FacePlanes { face, vertex, residual });
                    }
                }
            }
            gradients.push(gradient);
        }
        Ok(FParallel { mesh, image, gradients })
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

    /// The common gradient of the two planes of a face.
    pub fn gradient(&self, face: FaceId) -> &Gradient<T> {
        &self.gradients[face.0 as usize]
    }

    /// The same meshes as a pair with parallel edges.
    ///
    /// # Errors
    /// [`Misfit::Edge`] where an edge at the boundary or between coplanar faces is not parallel.
    pub fn parallel(&self) -> Result<Parallel<'_, T>, Misfit<T>> {
        Parallel::new(self.mesh, &self.image)
    }
}
