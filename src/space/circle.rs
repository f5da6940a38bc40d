//! Circles: Euclidean ones in the top view, and the i-circles of space.

use super::{Plane, Point, SpaceError, TopView, Vector2};
use crate::scalar::{Field, Ordered, Ring, Sign};

/// A Euclidean circle in the top view, `|x' − m'|² = r²`.
///
/// The squared radius may be 0 (a point) or negative (an *imaginary* circle with a real centre:
/// no points, but still powers, sections and transforms).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Circle<T> {
    /// The centre `m'`.
    pub centre: TopView<T>,
    /// The squared radius `r²`.
    pub radius2: T,
}

impl<T> Circle<T> {
    /// The circle with a centre and a squared radius.
    pub const fn new(centre: TopView<T>, radius2: T) -> Self {
        Circle { centre, radius2 }
    }
}

impl<T: Ring> Circle<T> {
    /// The power `|x' − m'|² − r²`: positive outside, 0 on the circle.
    pub fn power(&self, at: &TopView<T>) -> T {
        self.centre.distance2(at) - &self.radius2
    }
}

impl<T: Ordered> Circle<T> {
    /// Whether the squared radius is certainly negative.
    pub fn is_imaginary(&self) -> bool {
        self.radius2.certain_sign() == Some(Sign::Negative)
    }
}

impl<T: Field> Circle<T> {
    /// The circle through three top views.
    ///
    /// ```
    /// use isogeo::space::{Circle, TopView};
    /// let at = |x: f64, y: f64| TopView::new(x, y);
    /// let circle = Circle::through(&at(0.0, 0.0), &at(2.0, 0.0), &at(0.0, 2.0));
    /// assert_eq!(circle, Ok(Circle::new(at(1.0, 1.0), 2.0)));
    /// ```
    ///
    /// # Errors
    /// [`SpaceError::CollinearTopViews`].
    pub fn through(a: &TopView<T>, b: &TopView<T>, c: &TopView<T>) -> Result<Self, SpaceError> {
        let (u, v) = (b - a, c - a);
        let (uu, vv) = (u.length2(), v.length2());
        let twice_det = u.det(&v) * T::from_i64(2);
        let scale = twice_det.try_inv().ok_or(SpaceError::CollinearTopViews)?;
        // The centre has inner products |u|²/2 and |v|²/2 with u and v, seen from a.
        let radius = Vector2::new(
            T::det2(&uu, &u.y, &vv, &v.y) * &scale,
            T::det2(&u.x, &uu, &v.x, &vv) * &scale,
        );
        Ok(Circle { centre: a + &radius, radius2: radius.length2() })
    }
}

/// An i-circle of elliptic type: the points of a non-isotropic plane at constant i-distance from
/// one of them (Sec. 2.1). It may be imaginary, like its top view.
///
/// i-circles of the other type are [`ParabolicCircle`](super::ParabolicCircle)s.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ICircle<T> {
    /// The plane it lies in.
    pub plane: Plane<T>,
    /// Its top view.
    pub top_view: Circle<T>,
}

impl<T: Ring> ICircle<T> {
    /// The centre: the point of the plane over the centre of the top view.
    pub fn centre(&self) -> Point<T> {
        self.plane.point_at(&self.top_view.centre)
    }

    /// The residual of the plane and the power in the top view; both 0 on the circle.
    pub fn residuals(&self, point: &Point<T>) -> [T; 2] {
        [self.plane.residual(point), self.top_view.power(&point.top_view())]
    }

    /// Whether the point lies on the i-circle.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residuals(point).iter().all(T::is_zero)
    }
}

impl<T: Field> ICircle<T> {
    /// The i-circle of elliptic type through three points.
    ///
    /// # Errors
    /// [`SpaceError::CollinearTopViews`].
    pub fn through(a: &Point<T>, b: &Point<T>, c: &Point<T>) -> Result<Self, SpaceError> {
        let plane = Plane::through(a, b, c)?;
        let top_view = Circle::through(&a.top_view(), &b.top_view(), &c.top_view())?;
        Ok(ICircle { plane, top_view })
    }
}
