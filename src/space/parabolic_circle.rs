//! i-circles of parabolic type.

use super::{IsotropicPlane, Point, SpaceError};
use crate::scalar::{Field, Ring};

/// An i-circle of parabolic type: a parabola with isotropic axis in an isotropic plane (Sec. 2.1).
///
/// Over `x' = origin + u·direction` it is `z = (A/2)|direction|² u² + slope·u + height`, so that
/// its isotropic curvature `A` does not depend on how the line is parametrised; positive `A` opens
/// upwards. Circles are equal as sets.
#[derive(Clone, Copy, Debug)]
pub struct ParabolicCircle<T> {
    plane: IsotropicPlane<T>,
    curvature: T,
    slope: T,
    height: T,
}

impl<T> ParabolicCircle<T> {
    /// The circle with a curvature that is known not to be 0.
    pub(super) const fn over(plane: IsotropicPlane<T>, curvature: T, slope: T, height: T) -> Self {
        ParabolicCircle { plane, curvature, slope, height }
    }
}

impl<T: Ring> ParabolicCircle<T> {
    /// The parabola over the line of `plane` with curvature `A`, and with slope and height at its
    /// origin; the slope belongs to the parameter of the line.
    ///
    /// # Errors
    /// [`SpaceError::ZeroCurvature`]: it would be a straight line.
    pub fn new(
        plane: IsotropicPlane<T>,
        curvature: T,
        slope: T,
        height: T,
    ) -> Result<Self, SpaceError> {
        if curvature.is_zero() {
            return Err(SpaceError::ZeroCurvature);
        }
        Ok(ParabolicCircle::over(plane, curvature, slope, height))
    }

    /// The isotropic plane it lies in.
    pub fn plane(&self) -> &IsotropicPlane<T> {
        &self.plane
    }

    /// The isotropic curvature `A`: the second derivative of z by i-arc length. Never 0.
    pub fn curvature(&self) -> &T {
        &self.curvature
    }

    /// `dz/du` at the origin of the line.
    pub fn slope(&self) -> &T {
        &self.slope
    }

    /// The height z at the origin of the line.
    pub fn height(&self) -> &T {
        &self.height
    }

    /// `dz/du` at the parameter `u`.
    pub fn slope_at(&self, u: &T) -> T {
        &self.curvature * self.plane.direction().length2() * u + &self.slope
    }
}

impl<T: Field> ParabolicCircle<T> {
    /// The height z at the parameter `u` of the line.
    pub fn height_at(&self, u: &T) -> T {
        (self.slope_at(u) + &self.slope) * u * T::from_ratio(1, 2) + &self.height
    }

    /// The point at the parameter `u` of the line.
    pub fn point_at(&self, u: &T) -> Point<T> {
        self.plane.top_view_at(u).at_height(self.height_at(u))
    }

    /// The residual of the plane, and the height over the parabola at the foot of the
    /// perpendicular; both 0 on the circle.
    pub fn residuals(&self, point: &Point<T>) -> [T; 2] {
        let at = point.top_view();
        let u = self.plane.parameter_of(&at);
        [self.plane.residual(&at), &point.z - self.height_at(&u)]
    }

    /// Whether the point lies on the i-circle.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residuals(point).iter().all(T::is_zero)
    }
}

impl<T: Field> PartialEq for ParabolicCircle<T> {
    fn eq(&self, other: &Self) -> bool {
        // Two parabolas of the same curvature over one line agree if they share two points.
        self.plane == other.plane
            && self.curvature == other.curvature
            && [T::zero(), T::one()].iter().all(|u| self.contains(&other.point_at(u)))
    }
}
