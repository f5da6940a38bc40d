//! Planes: non-isotropic ones, which are graphs, and isotropic ones, which are vertical.

use super::{Gradient, Point, SpaceError, TopView, Vector2};
use crate::scalar::{Field, Ring};

/// The non-isotropic plane `z = p·x' + t`: not parallel to the z-direction (Sec. 2.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Plane<T> {
    /// The gradient `p`.
    pub gradient: Gradient<T>,
    /// The height `t` over the origin.
    pub height: T,
}

impl<T> Plane<T> {
    /// The plane `z = p·x' + t`.
    pub const fn new(gradient: Gradient<T>, height: T) -> Self {
        Plane { gradient, height }
    }
}

impl<T: Ring> Plane<T> {
    /// The plane with a given gradient through a point.
    pub fn through_point(point: &Point<T>, gradient: Gradient<T>) -> Self {
        let rise = gradient.along(&point.top_view().position());
        Plane { gradient, height: &point.z - rise }
    }

    /// The height `p·x' + t` of the plane over a top view.
    pub fn height_at(&self, at: &TopView<T>) -> T {
        self.gradient.along(&at.position()) + &self.height
    }

    /// The point of the plane over a top view.
    pub fn point_at(&self, at: &TopView<T>) -> Point<T> {
        at.at_height(self.height_at(at))
    }

    /// `z − p·x' − t`: positive for points above the plane, 0 on it.
    ///
    /// ```
    /// use isogeo::space::{Gradient, Plane, Point};
    /// let plane = Plane::new(Gradient::new(1.0, 0.0), 2.0);
    /// assert_eq!(plane.residual(&Point::new(3.0, 9.0, 6.0)), 1.0);
    /// ```
    pub fn residual(&self, point: &Point<T>) -> T {
        &point.z - self.height_at(&point.top_view())
    }

    /// Whether the point lies on the plane.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residual(point).is_zero()
    }

    /// The square of the i-angle: the squared distance of the gradients.
    pub fn i_angle2(&self, other: &Self) -> T {
        self.gradient.i_angle2(&other.gradient)
    }

    /// Whether two planes have the same gradient (*parallel planes*); equal planes are parallel.
    pub fn is_parallel_to(&self, other: &Self) -> bool {
        self.gradient == other.gradient
    }
}

impl<T: Field> Plane<T> {
    /// The plane through three points.
    ///
    /// ```
    /// use isogeo::space::{Gradient, Plane, Point, SpaceError};
    /// let (a, b) = (Point::new(0.0, 0.0, 1.0), Point::new(1.0, 0.0, 3.0));
    /// let plane = Plane::through(&a, &b, &Point::new(0.0, 1.0, 0.0));
    /// assert_eq!(plane, Ok(Plane::new(Gradient::new(2.0, -1.0), 1.0)));
    /// let vertical = Plane::through(&a, &b, &Point::new(2.0, 0.0, 0.0));
    /// assert_eq!(vertical, Err(SpaceError::CollinearTopViews));
    /// ```
    ///
    /// # Errors
    /// [`SpaceError::CollinearTopViews`]: the plane is isotropic or not determined.
    pub fn through(a: &Point<T>, b: &Point<T>, c: &Point<T>) -> Result<Self, SpaceError> {
        let (u, v) = (b - a, c - a);
        let det = u.top_view().det(&v.top_view());
        let scale = det.try_inv().ok_or(SpaceError::CollinearTopViews)?;
        let gradient = Gradient {
            x: T::det2(&u.z, &u.y, &v.z, &v.y) * &scale,
            y: T::det2(&u.x, &u.z, &v.x, &v.z) * &scale,
        };
        Ok(Plane::through_point(a, gradient))
    }

    /// The plane with the least sum of squared vertical distances from some points: the one that they
    /// lie in, if they do. An affine map that keeps the z-direction maps it to that of the images.
    ///
    /// ```
    /// use isogeo::space::{Gradient, Plane, Point};
    /// let square = [(0.0, 0.0, 1.0), (2.0, 0.0, -1.0), (2.0, 2.0, 1.0), (0.0, 2.0, -1.0)];
    /// let square = square.map(|(x, y, z)| Point::new(x, y, z));
    /// let plane = Plane::nearest(&square.each_ref());
    /// assert_eq!(plane, Some(Plane::new(Gradient::new(0.0, 0.0), 0.0)));
    /// ```
    ///
    /// `None` if the top views are collinear; in a field without order, where there is no least sum,
    /// also if they are isotropic in some direction.
    pub fn nearest(points: &[&Point<T>]) -> Option<Self> {
        let [mut x, mut y, mut z] = std::array::from_fn(|_| T::zero());
        for p in points {
            x += &p.x;
            y += &p.y;
            z += &p.z;
        }
        let part = T::from_i64(points.len() as i64).try_inv()?;
        let mean = Point { x: x * &part, y: y * &part, z: z * &part };
        let [mut xx, mut xy, mut yy, mut xz, mut yz] = std::array::from_fn(|_| T::zero());
        for &p in points {
            let d = p - &mean;
            xx += &d.x.square();
            xy += &(&d.x * &d.y);
            yy += &d.y.square();
            xz += &(&d.x * &d.z);
            yz += &(&d.y * &d.z);
        }
        let scale = T::det2(&xx, &xy, &xy, &yy).try_inv()?;
        let gradient = Gradient {
            x: T::det2(&xz, &xy, &yz, &yy) * &scale,
            y: T::det2(&xx, &xz, &xy, &yz) * &scale,
        };
        Some(Plane::through_point(&mean, gradient))
    }
}

/// An isotropic plane: parallel to the z-direction, all points over a line of the top view.
///
/// The line is `x' = origin + u·direction`. Two isotropic planes are equal if their lines are,
/// whatever origin and direction they were made from.
#[derive(Clone, Copy, Debug)]
pub struct IsotropicPlane<T> {
    origin: TopView<T>,
    direction: Vector2<T>,
}

impl<T> IsotropicPlane<T> {
    /// The plane with a direction that is known not to be the zero vector.
    pub(super) const fn over(origin: TopView<T>, direction: Vector2<T>) -> Self {
        IsotropicPlane { origin, direction }
    }

    /// The top view with parameter 0.
    pub const fn origin(&self) -> &TopView<T> {
        &self.origin
    }

    /// The direction of the line; not the zero vector.
    pub const fn direction(&self) -> &Vector2<T> {
        &self.direction
    }
}

impl<T: Ring> IsotropicPlane<T> {
    /// The plane over the line through `origin` in a direction.
    ///
    /// # Errors
    /// [`SpaceError::ZeroDirection`].
    pub fn new(origin: TopView<T>, direction: Vector2<T>) -> Result<Self, SpaceError> {
        if direction.x.is_zero() && direction.y.is_zero() {
            return Err(SpaceError::ZeroDirection);
        }
        Ok(IsotropicPlane::over(origin, direction))
    }

    /// The plane over the line that joins two different top views.
    ///
    /// # Errors
    /// [`SpaceError::ZeroDirection`] if they agree.
    pub fn through(a: &TopView<T>, b: &TopView<T>) -> Result<Self, SpaceError> {
        IsotropicPlane::new(a.clone(), b - a)
    }

    /// The top view `origin + u·direction`.
    pub fn top_view_at(&self, u: &T) -> TopView<T> {
        &self.origin + &self.direction.scaled(u)
    }

    /// `det(direction, x' − origin)`: positive left of the directed line, 0 on it.
    pub fn residual(&self, at: &TopView<T>) -> T {
        self.direction.det(&(at - &self.origin))
    }

    /// Whether the plane contains a point, that is, all points parallel to it.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residual(&point.top_view()).is_zero()
    }

    /// Whether the lines of two isotropic planes have the same direction; the same line has.
    pub fn is_parallel_to(&self, other: &Self) -> bool {
        self.direction.det(&other.direction).is_zero()
    }
}

impl<T: Field> IsotropicPlane<T> {
    /// The parameter `u` of the foot of the perpendicular from a top view to the line.
    pub fn parameter_of(&self, at: &TopView<T>) -> T {
        (at - &self.origin).dot(&self.direction) / self.direction.length2()
    }
}

impl<T: Ring> PartialEq for IsotropicPlane<T> {
    fn eq(&self, other: &Self) -> bool {
        self.is_parallel_to(other) && self.residual(&other.origin).is_zero()
    }
}
