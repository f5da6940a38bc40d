//! Contact elements: a point with a plane through it.

use super::{Gradient, Plane, Point};
use crate::scalar::Ring;

/// A point together with a non-isotropic plane through it.
///
/// A surface seen as the set of its points *and* tangent planes consists of contact elements
/// (Sec. 2.1, metric duality). The plane is kept as its gradient, so that it cannot miss the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ContactElement<T> {
    /// The point.
    pub point: Point<T>,
    /// The gradient of the plane.
    pub gradient: Gradient<T>,
}

impl<T> ContactElement<T> {
    /// The point with the plane of that gradient through it.
    pub const fn new(point: Point<T>, gradient: Gradient<T>) -> Self {
        ContactElement { point, gradient }
    }
}

impl<T: Ring> ContactElement<T> {
    /// The plane of the element.
    ///
    /// ```
    /// use isogeo::space::{ContactElement, Gradient, Plane, Point};
    /// let element = ContactElement::new(Point::new(1.0, 2.0, 3.0), Gradient::new(5.0, 0.0));
    /// assert_eq!(element.plane(), Plane::new(Gradient::new(5.0, 0.0), -2.0));
    /// ```
    pub fn plane(&self) -> Plane<T> {
        Plane::through_point(&self.point, self.gradient.clone())
    }
}
