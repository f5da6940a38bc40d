//! Oriented planes of Euclidean space, and the map (12).

use crate::scalar::{Field, Ring};
use crate::space::{Point, SpaceError, Vector3};

/// An oriented plane `n·x + h = 0` with a unit normal n (Sec. 2.2).
///
/// It is not [`Plane`](crate::space::Plane): it may be vertical, and it has two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OrientedPlane<T> {
    normal: Vector3<T>,
    height: T,
}

impl<T> OrientedPlane<T> {
    /// The unit normal n.
    pub const fn normal(&self) -> &Vector3<T> {
        &self.normal
    }

    /// The signed distance h of the origin.
    pub const fn height(&self) -> &T {
        &self.height
    }

    /// The plane with a normal that is known to have length 1.
    pub(crate) const fn trusted(normal: Vector3<T>, height: T) -> Self {
        OrientedPlane { normal, height }
    }
}

impl<T: Ring> OrientedPlane<T> {
    /// The plane with a unit normal and a height.
    ///
    /// # Errors
    /// [`SpaceError::NotAUnitNormal`] unless `n·n = 1`, without tolerance; types that round have
    /// [`of_isotropic`](OrientedPlane::of_isotropic).
    pub fn new(normal: Vector3<T>, height: T) -> Result<Self, SpaceError> {
        if normal.length2() != T::one() {
            return Err(SpaceError::NotAUnitNormal);
        }
        Ok(OrientedPlane::trusted(normal, height))
    }

    /// The signed distance `n·x + h` of a point: positive on the side of the normal.
    pub fn distance(&self, point: &Point<T>) -> T {
        T::dot([&self.normal.x, &self.normal.y, &self.normal.z], point.coordinates()) + &self.height
    }

    /// The same plane with the opposite orientation.
    pub fn turned(&self) -> Self {
        let Vector3 { x, y, z } = &self.normal;
        OrientedPlane::trusted(Vector3::new(-x, -y, -z), -&self.height)
    }
}

impl<T: Field> OrientedPlane<T> {
    /// The point `Pⁱ = (n₁, n₂, h)/(n₃ + 1)` of the isotropic model (12).
    ///
    /// # Errors
    /// [`SpaceError::SouthPole`] if `n₃ = −1`.
    pub fn to_isotropic(&self) -> Result<Point<T>, SpaceError> {
        let scale = (&self.normal.z + T::one()).try_inv().ok_or(SpaceError::SouthPole)?;
        Ok(Point::new(&self.normal.x * &scale, &self.normal.y * &scale, &self.height * &scale))
    }

    /// The inverse of (12), the map τ: `n = (2a, 2b, 1 − a² − b²)/(1 + a² + b²)`,
    /// `h = 2c/(1 + a² + b²)` for the point (a, b, c).
    ///
    /// Rational points give rational unit normals.
    ///
    /// ```
    /// use isogeo::space::{Point, Vector3, laguerre::OrientedPlane};
    /// let plane = OrientedPlane::of_isotropic(&Point::new(1.0, 0.0, 3.0));
    /// assert_eq!(*plane.normal(), Vector3::new(1.0, 0.0, 0.0));
    /// assert_eq!(plane.height(), &3.0); // x = −3, seen from larger x
    /// assert_eq!(plane.to_isotropic(), Ok(Point::new(1.0, 0.0, 3.0)));
    /// ```
    pub fn of_isotropic(point: &Point<T>) -> Self {
        let norm2 = point.top_view().norm2();
        // In ordered fields 1 + |x'|² is not 0.
        let scale = T::one() / (T::one() + &norm2);
        let twice = T::from_i64(2) * &scale;
        let normal = Vector3::new(&point.x * &twice, &point.y * &twice, (T::one() - norm2) * scale);
        OrientedPlane::trusted(normal, &point.z * twice)
    }
}
