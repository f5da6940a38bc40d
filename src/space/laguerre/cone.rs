//! Cones of revolution as sets of oriented planes.

use super::OrientedPlane;
use crate::scalar::{Field, Ring};
use crate::space::{Circle, Gradient, ICircle, Plane, Point, SpaceError, TopView, Vector3};

/// An oriented cone of revolution: the planes `n·x + h = 0` through its vertex g with `n·s = 1`, for a
/// vector s along its axis (Sec. 2.2).
///
/// The sphere with the centre `g + d s` and the radius d touches all of them. The cone is real if
/// `|s|² > 1`; for `|s|² = 1` it is one plane, and below it is imaginary. Cylinders are excluded: their
/// vertex lies at infinity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cone<T> {
    /// The vertex g.
    pub vertex: Point<T>,
    /// The axis s.
    pub axis: Vector3<T>,
}

impl<T: Ring> Cone<T> {
    /// `n·g + h` and `n·s − 1`: both 0 iff the plane touches the cone, as oriented ones.
    pub fn tangency(&self, plane: &OrientedPlane<T>) -> [T; 2] {
        [plane.distance(&self.vertex), plane.normal().dot(&self.axis) - T::one()]
    }
}

impl<T: Field> Cone<T> {
    /// The cone whose planes are the points of an i-circle in the isotropic model.
    ///
    /// For the i-circle with the centre c and `N = |c|² − ρ²` in the plane `z = p·x' + t` the vertex
    /// has `g₃ = −2t/(1 + N)` and `g' = g₃ c − p`, and the axis is `s = (2c, 1 − N)/(1 + N)`.
    ///
    /// ```
    /// use isogeo::space::{Circle, Gradient, ICircle, Plane, Point, TopView, Vector3};
    /// use isogeo::space::laguerre::Cone;
    /// let top_view = Circle::new(TopView::new(0.0, 0.0), 0.5);
    /// let circle = ICircle { plane: Plane::new(Gradient::new(0.0, 0.0), 1.0), top_view };
    /// let cone = Cone { vertex: Point::new(0.0, 0.0, -4.0), axis: Vector3::new(0.0, 0.0, 3.0) };
    /// assert_eq!(Cone::of_isotropic(&circle), Ok(cone));
    /// ```
    ///
    /// # Errors
    /// [`SpaceError::AtInfinity`] if `1 + N = 0`: the i-circle is the image of a great circle, the
    /// planes envelop a cylinder.
    pub fn of_isotropic(circle: &ICircle<T>) -> Result<Self, SpaceError> {
        let Circle { centre, radius2 } = &circle.top_view;
        let Plane { gradient, height } = &circle.plane;
        let n = centre.norm2() - radius2;
        let scale = (T::one() + &n).try_inv().ok_or(SpaceError::AtInfinity)?;
        let twice = T::from_i64(2) * &scale;
        let g3 = -(height * &twice);
        Ok(Cone {
            vertex: Point::new(&g3 * &centre.x - &gradient.x, &g3 * &centre.y - &gradient.y, g3),
            axis: Vector3::new(&centre.x * &twice, &centre.y * &twice, (T::one() - n) * scale),
        })
    }

    /// The i-circle whose points are the planes of the cone in the isotropic model: the inverse of
    /// [`of_isotropic`](Cone::of_isotropic).
    ///
    /// # Errors
    /// [`SpaceError::SouthPole`] if `s₃ = −1`: a plane of the cone has the normal (0, 0, −1).
    pub fn to_isotropic(&self) -> Result<ICircle<T>, SpaceError> {
        let Cone { vertex: g, axis: s } = self;
        let scale = (T::one() + &s.z).try_inv().ok_or(SpaceError::SouthPole)?;
        let centre = TopView::new(&s.x * &scale, &s.y * &scale);
        let gradient = Gradient::new(&g.z * &centre.x - &g.x, &g.z * &centre.y - &g.y);
        let radius2 = centre.norm2() - (T::one() - &s.z) * &scale;
        let plane = Plane::new(gradient, -(&g.z * scale));
        Ok(ICircle { plane, top_view: Circle::new(centre, radius2) })
    }
}
