//! Gradients of non-isotropic planes.

use std::ops::{Add, Sub};

use super::Vector2;
use crate::scalar::Ring;

/// The gradient `p = (p₁, p₂)` of a non-isotropic plane `z = p·x' + t`.
///
/// Parallel planes are planes with the same gradient. A gradient is no
/// [`TopView`](super::TopView): only [duality](super::Dual) turns one into the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Gradient<T> {
    /// Slope in the direction of x.
    pub x: T,
    /// Slope in the direction of y.
    pub y: T,
}

impl<T> Gradient<T> {
    /// The gradient `(x, y)`.
    pub const fn new(x: T, y: T) -> Self {
        Gradient { x, y }
    }
}

impl<T: Ring> Gradient<T> {
    /// The square of the i-angle of two planes with these gradients,
    /// `φ² = (p₁ − q₁)² + (p₂ − q₂)²` (Sec. 2.1, metric duality).
    ///
    /// It stays squared, so that it stays in the field. Zero means parallel.
    ///
    /// ```
    /// use isogeo::space::Gradient;
    /// assert_eq!(Gradient::new(1.0, 0.0).i_angle2(&Gradient::new(4.0, 4.0)), 25.0);
    /// ```
    pub fn i_angle2(&self, other: &Self) -> T {
        (self - other).length2()
    }

    /// `|p|²`, the squared i-angle with a horizontal plane.
    pub fn norm2(&self) -> T {
        self.x.square() + self.y.square()
    }

    /// The rise `p·v` of the plane along a vector of the top view; positive if it goes up.
    pub fn along(&self, v: &Vector2<T>) -> T {
        T::dot([&self.x, &self.y], [&v.x, &v.y])
    }
}

impl<T: Ring> Sub for &Gradient<T> {
    type Output = Vector2<T>;
    fn sub(self, other: Self) -> Vector2<T> {
        Vector2 { x: &self.x - &other.x, y: &self.y - &other.y }
    }
}

impl<T: Ring> Add<&Vector2<T>> for &Gradient<T> {
    type Output = Gradient<T>;
    fn add(self, v: &Vector2<T>) -> Gradient<T> {
        Gradient { x: &self.x + &v.x, y: &self.y + &v.y }
    }
}
