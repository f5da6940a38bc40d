//! Circles in the top view with a signed radius.

use super::{Circle, Point, TopView};
use crate::scalar::{Field, Ring};

/// A circle in the top view with a signed radius: turned over, the radius is negative.
///
/// Inversions and Christoffel duals keep formulas of touching circles only with the signs: circles
/// that touch from outside have distance `|r₁ + r₂|`, and so have a circle and one of the
/// opposite sign that lies inside of it.
///
/// ```
/// use isogeo::space::{OrientedCircle, TopView};
/// let at = |x: f64, radius| OrientedCircle { centre: TopView::new(x, 0.0), radius };
/// assert_eq!(at(0.0, 1.0).tangency(&at(3.0, 2.0)), 0.0);
/// assert_eq!(at(0.0, 3.0).tangency(&at(1.0, -2.0)), 0.0); // from inside
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OrientedCircle<T> {
    /// The centre.
    pub centre: TopView<T>,
    /// The radius with its sign; 0 for a point.
    pub radius: T,
}

impl<T: Ring> OrientedCircle<T> {
    /// The same circle without its sign.
    pub fn circle(&self) -> Circle<T> {
        Circle::new(self.centre.clone(), self.radius.square())
    }

    /// `|m₁ − m₂|² − (r₁ + r₂)²`: 0 iff the circles touch with their signs.
    pub fn tangency(&self, other: &Self) -> T {
        self.centre.distance2(&other.centre) - (&self.radius + &other.radius).square()
    }

    /// `|m₁ − m₂|² − r₁² − r₂²`: 0 iff the circles are orthogonal, whatever their signs.
    pub fn orthogonality(&self, other: &Self) -> T {
        self.circle().power(&other.centre) - other.radius.square()
    }
}

impl<T: Field> OrientedCircle<T> {
    /// The pole `(m, (|m|² − r²)/2)` of the plane that cuts Σ in the points over the circle.
    ///
    /// Poles of orthogonal circles lie in each other's planes; the line of the poles of touching
    /// circles touches Σ.
    pub fn pole(&self) -> Point<T> {
        let height = (self.centre.norm2() - self.radius.square()) * T::from_ratio(1, 2);
        self.centre.at_height(height)
    }

    /// The image under the inversion `p ↦ c + (p − c)/|p − c|²`: with the power `N` of c the centre
    /// is `c + (m − c)/N`, the radius `r/N`.
    ///
    /// A circle around c is turned over, since there `N < 0`. `None` for circles through c: their
    /// images are lines.
    ///
    /// ```
    /// use isogeo::space::{OrientedCircle, TopView};
    /// let circle = OrientedCircle { centre: TopView::new(1.0, 0.0), radius: 3.0 };
    /// let image = circle.inverted(&TopView::new(0.0, 0.0));
    /// assert_eq!(image, Some(OrientedCircle { centre: TopView::new(-0.125, 0.0), radius: -0.375 }));
    /// ```
    pub fn inverted(&self, at: &TopView<T>) -> Option<Self> {
        let inverse = self.circle().power(at).try_inv()?;
        let centre = at + &(&self.centre - at).scaled(&inverse);
        Some(OrientedCircle { centre, radius: &self.radius * inverse })
    }
}
