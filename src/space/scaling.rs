//! Scalings: the similarities beyond i-motions.

use super::{
    Circle, Gradient, Hessian, MoebiusSphere, ParabolicCircle, Plane, Point, SpaceError, TopView,
    Transform, Vector2, Vector3,
};
use crate::scalar::Field;

/// The scaling `x' ↦ λ x'`, `z ↦ μ z` with factors that are not 0 (they may be negative).
///
/// Together with the [`Motion`](super::Motion)s these make up the similarities of isotropic space.
/// Curvatures change by `H ↦ μλ⁻² H`, `K ↦ μ²λ⁻⁴ K`; whether they are 0 does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Scaling<T> {
    horizontal: T,
    vertical: T,
    /// μ/λ, the factor of slopes.
    slope: T,
    /// μ/λ², the factor of curvatures.
    curvature: T,
}

impl<T: Field> Scaling<T> {
    /// The scaling with the factor λ of the top view and the factor μ of heights.
    ///
    /// # Errors
    /// [`SpaceError::ZeroFactor`] if one is 0.
    pub fn new(horizontal: T, vertical: T) -> Result<Self, SpaceError> {
        if vertical.is_zero() {
            return Err(SpaceError::ZeroFactor);
        }
        let inverse = horizontal.try_inv().ok_or(SpaceError::ZeroFactor)?;
        let slope = &vertical * &inverse;
        let curvature = &slope * inverse;
        Ok(Scaling { horizontal, vertical, slope, curvature })
    }

    /// The scaling that changes nothing.
    pub fn identity() -> Self {
        let one = T::one;
        Scaling { horizontal: one(), vertical: one(), slope: one(), curvature: one() }
    }

    /// The factor λ of the top view.
    pub fn horizontal(&self) -> &T {
        &self.horizontal
    }

    /// The factor μ of heights.
    pub fn vertical(&self) -> &T {
        &self.vertical
    }

    /// This scaling, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        Scaling {
            horizontal: &self.horizontal * &next.horizontal,
            vertical: &self.vertical * &next.vertical,
            slope: &self.slope * &next.slope,
            curvature: &self.curvature * &next.curvature,
        }
    }

    /// The scaling that undoes this one.
    pub fn inverse(&self) -> Self {
        let inverse = |x| T::one() / x;
        Scaling {
            horizontal: inverse(&self.horizontal),
            vertical: inverse(&self.vertical),
            slope: inverse(&self.slope),
            curvature: inverse(&self.curvature),
        }
    }
}

impl<T: Field> Transform<Vector2<T>> for Scaling<T> {
    fn apply(&self, v: &Vector2<T>) -> Vector2<T> {
        v.scaled(&self.horizontal)
    }
}

impl<T: Field> Transform<TopView<T>> for Scaling<T> {
    fn apply(&self, at: &TopView<T>) -> TopView<T> {
        TopView { x: &at.x * &self.horizontal, y: &at.y * &self.horizontal }
    }
}

impl<T: Field> Transform<Vector3<T>> for Scaling<T> {
    fn apply(&self, v: &Vector3<T>) -> Vector3<T> {
        let Vector2 { x, y } = self.apply(&v.top_view());
        Vector3 { x, y, z: &v.z * &self.vertical }
    }
}

impl<T: Field> Transform<Point<T>> for Scaling<T> {
    fn apply(&self, point: &Point<T>) -> Point<T> {
        self.apply(&point.top_view()).at_height(&point.z * &self.vertical)
    }
}

impl<T: Field> Transform<Gradient<T>> for Scaling<T> {
    fn apply(&self, gradient: &Gradient<T>) -> Gradient<T> {
        Gradient { x: &gradient.x * &self.slope, y: &gradient.y * &self.slope }
    }
}

impl<T: Field> Transform<Plane<T>> for Scaling<T> {
    fn apply(&self, plane: &Plane<T>) -> Plane<T> {
        Plane::new(self.apply(&plane.gradient), &plane.height * &self.vertical)
    }
}

impl<T: Field> Transform<MoebiusSphere<T>> for Scaling<T> {
    fn apply(&self, sphere: &MoebiusSphere<T>) -> MoebiusSphere<T> {
        MoebiusSphere { a: &sphere.a * &self.curvature, plane: self.apply(&sphere.plane) }
    }
}

impl<T: Field> Transform<Circle<T>> for Scaling<T> {
    fn apply(&self, circle: &Circle<T>) -> Circle<T> {
        Circle::new(self.apply(&circle.centre), &circle.radius2 * self.horizontal.square())
    }
}

impl<T: Field> Transform<ParabolicCircle<T>> for Scaling<T> {
    fn apply(&self, circle: &ParabolicCircle<T>) -> ParabolicCircle<T> {
        ParabolicCircle::over(
            self.apply(circle.plane()),
            circle.curvature() * &self.curvature,
            circle.slope() * &self.vertical,
            circle.height() * &self.vertical,
        )
    }
}

impl<T: Field> Transform<Hessian<T>> for Scaling<T> {
    fn apply(&self, hessian: &Hessian<T>) -> Hessian<T> {
        hessian.scaled(&self.curvature)
    }
}
