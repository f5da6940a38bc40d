//! L-transformations.

use super::sphere::{isotropic, standard};
use super::{Cone, OrientedPlane, OrientedSphere};
use crate::scalar::{Field, Ring};
use crate::space::{
    Model, MoebiusTransformation, Point, Similarity, SpaceError, Transform, Vector3,
};

/// Oriented spheres as points `(m₁, m₂, m₃, r)`, with `⟨x, x⟩ = m·m − r²` (Sec. 2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StandardModel;

impl Model for StandardModel {
    fn lower<T: Ring>([x, y, z, r]: &[T; 4]) -> [T; 4] {
        [x.clone(), y.clone(), z.clone(), -r]
    }
}

/// An L-transformation: an affine map `(m, r) ↦ a + R (m, r)` of oriented spheres with `RᵀDR = D`,
/// `D = diag(1, 1, 1, −1)` (Sec. 2.2); with a factor k the Euclidean similarities are included.
///
/// Oriented planes, as sets of the spheres that touch them, are mapped accordingly: the plane (n, h)
/// is the hyperplane `⟨(n, 1), x⟩ = −h`.
///
/// ```
/// use isogeo::space::{Point, Transform, laguerre::*};
/// let offset = LaguerreTransformation::offset(0.5);
/// let point = OrientedSphere::new(Point::new(1.0, 2.0, 3.0), 0.0);
/// assert_eq!(offset.apply(&point).radius, 0.5);
/// ```
pub type LaguerreTransformation<T> = Similarity<T, StandardModel>;

impl<T: Ring> LaguerreTransformation<T> {
    /// Offsetting: it adds d to all radii, hence to the heights h of planes. In the isotropic model
    /// this is `z ↦ z + d (1 + |x'|²)/2`.
    pub fn offset(d: T) -> Self {
        Similarity::translation([T::zero(), T::zero(), T::zero(), d])
    }
}

impl<T: Ring> Transform<OrientedSphere<T>> for LaguerreTransformation<T> {
    fn apply(&self, sphere: &OrientedSphere<T>) -> OrientedSphere<T> {
        self.image(&sphere.coordinates()).into()
    }
}

impl<T: Field> Transform<OrientedPlane<T>> for LaguerreTransformation<T> {
    fn apply(&self, plane: &OrientedPlane<T>) -> OrientedPlane<T> {
        let Vector3 { x, y, z } = plane.normal().clone();
        let ([x, y, z, w], height) = self.hyperplane(&[x, y, z, T::one()], plane.height());
        // Isotropic vectors have w ≠ 0 in ordered fields.
        let scale = T::one() / w;
        OrientedPlane::trusted(Vector3::new(x * &scale, y * &scale, z * &scale), height * scale)
    }
}

impl<T: Field> LaguerreTransformation<T> {
    /// The image of a cone of revolution.
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] if it is a cylinder.
    pub fn map_cone(&self, cone: &Cone<T>) -> Result<Cone<T>, SpaceError> {
        // The spheres that touch all planes of the cone: a line with one point of radius 0.
        let Vector3 { x, y, z } = cone.axis.clone();
        let [x, y, z, w] = self.turn(&[x, y, z, T::one()]);
        let scale = w.try_inv().ok_or(SpaceError::AtInfinity)?;
        let axis = Vector3::new(x * &scale, y * &scale, z * &scale);
        let start = OrientedSphere::new(cone.vertex.clone(), T::zero());
        let OrientedSphere { centre, radius } = self.apply(&start);
        let vertex = Point::new(
            centre.x - &radius * &axis.x,
            centre.y - &radius * &axis.y,
            centre.z - &radius * &axis.z,
        );
        Ok(Cone { vertex, axis })
    }
}

impl<T: Field> From<&MoebiusTransformation<T>> for LaguerreTransformation<T> {
    fn from(map: &MoebiusTransformation<T>) -> Self {
        Similarity::of_affine(|s| standard(map.image(&isotropic(s))), map.factor().clone())
    }
}

impl<T: Field> From<&LaguerreTransformation<T>> for MoebiusTransformation<T> {
    fn from(map: &LaguerreTransformation<T>) -> Self {
        Similarity::of_affine(|s| isotropic(map.image(&standard(s))), map.factor().clone())
    }
}
