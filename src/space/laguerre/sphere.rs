//! Oriented spheres of Euclidean space.

use super::OrientedPlane;
use crate::scalar::{Field, Ring};
use crate::space::{MoebiusSphere, Point, Vector3};

/// An oriented sphere: a centre m and a signed radius r (Sec. 2.2). Points are spheres of radius 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OrientedSphere<T> {
    /// The centre m.
    pub centre: Point<T>,
    /// The signed radius r.
    pub radius: T,
}

impl<T> OrientedSphere<T> {
    /// The sphere with a centre and a signed radius.
    pub const fn new(centre: Point<T>, radius: T) -> Self {
        OrientedSphere { centre, radius }
    }
}

impl<T: Clone> OrientedSphere<T> {
    /// `[m₁, m₂, m₃, r]`.
    pub fn coordinates(&self) -> [T; 4] {
        let [x, y, z] = self.centre.coordinates().map(T::clone);
        [x, y, z, self.radius.clone()]
    }
}

impl<T> From<[T; 4]> for OrientedSphere<T> {
    fn from([x, y, z, radius]: [T; 4]) -> Self {
        OrientedSphere { centre: Point::new(x, y, z), radius }
    }
}

impl<T: Ring> OrientedSphere<T> {
    /// `n·m + h − r`: 0 iff the plane touches the sphere, as oriented ones.
    ///
    /// ```
    /// use isogeo::space::{Point, Vector3, laguerre::{OrientedPlane, OrientedSphere}};
    /// let floor = OrientedPlane::new(Vector3::new(0.0, 0.0, 1.0), 0.0)?;
    /// let ball = OrientedSphere::new(Point::new(7.0, 7.0, 2.0), 2.0);
    /// assert_eq!(ball.tangency(&floor), 0.0);
    /// assert_eq!(ball.tangency(&floor.turned()), -4.0);
    /// # Ok::<(), isogeo::space::SpaceError>(())
    /// ```
    pub fn tangency(&self, plane: &OrientedPlane<T>) -> T {
        plane.distance(&self.centre) - &self.radius
    }

    /// `|m₁ − m₂|² − (r₁ − r₂)²`: 0 iff two spheres touch, as oriented ones.
    pub fn contact(&self, other: &Self) -> T {
        let Vector3 { x, y, z } = &self.centre - &other.centre;
        let difference = &self.radius - &other.radius;
        T::dot([&x, &y, &z], [&x, &y, &z]) - difference.square()
    }
}

impl<T: Field> From<&OrientedSphere<T>> for MoebiusSphere<T> {
    /// `(A, B, C, D) = (m₃ + r, −m₁, −m₂, (r − m₃)/2)`: the sphere as set of its tangent planes in the
    /// isotropic model.
    fn from(sphere: &OrientedSphere<T>) -> Self {
        isotropic(sphere.coordinates()).into()
    }
}

impl<T: Field> From<&MoebiusSphere<T>> for OrientedSphere<T> {
    /// `m = (−B, −C, A/2 − D)`, `r = A/2 + D`. Every i-M-sphere is the image of one sphere.
    fn from(sphere: &MoebiusSphere<T>) -> Self {
        standard(sphere.coefficients()).into()
    }
}

/// From the coordinates of the standard model to those of the isotropic one.
pub(super) fn isotropic<T: Field>([x, y, z, r]: [T; 4]) -> [T; 4] {
    let half = T::from_ratio(1, 2);
    [&z + &r, -x, -y, (r - z) * half]
}

/// And back.
pub(super) fn standard<T: Field>([a, b, c, d]: [T; 4]) -> [T; 4] {
    let half = a * T::from_ratio(1, 2);
    [-b, -c, &half - &d, half + d]
}
