//! i-spheres of both types, and i-M-spheres: (3) with `A = 0` included.

use std::ops::Deref;

use super::{
    Circle, ContactElement, Gradient, ICircle, IsotropicPlane, ParabolicCircle, Plane, Point,
    SpaceError, TopView,
};
use crate::scalar::{Field, Ring};

/// An i-M-sphere `z = (A/2)|x'|² + Bx + Cy + D`: a parabolic i-sphere, or a plane if `A = 0`.
///
/// It is kept as `A` times the unit i-sphere plus the plane `z = Bx + Cy + D`.
///
/// ```
/// use isogeo::space::{MoebiusSphere, Point, TopView};
/// let sphere = MoebiusSphere::new(2.0, 0.0, 1.0, -3.0); // z = x² + y² + y − 3
/// assert_eq!(sphere.height_at(&TopView::new(1.0, 2.0)), 4.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MoebiusSphere<T> {
    /// The coefficient `A`, the isotropic mean curvature; positive opens upwards.
    pub a: T,
    /// The plane `z = Bx + Cy + D`: the tangent plane over the origin.
    pub plane: Plane<T>,
}

impl<T> MoebiusSphere<T> {
    /// The i-M-sphere with the coefficients of (3).
    pub const fn new(a: T, b: T, c: T, d: T) -> Self {
        MoebiusSphere { a, plane: Plane::new(Gradient::new(b, c), d) }
    }
}

impl<T: Ring> MoebiusSphere<T> {
    /// The gradient `(Ax + B, Ay + C)` of the tangent plane over a top view.
    pub fn gradient_at(&self, at: &TopView<T>) -> Gradient<T> {
        &self.plane.gradient + &at.position().scaled(&self.a)
    }

    /// `2(z − Bx − Cy − D) − A|x'|²`, *twice* the height of a point over the i-M-sphere: positive
    /// above, 0 on it, and free of divisions.
    pub fn residual(&self, point: &Point<T>) -> T {
        let over_plane = self.plane.residual(point) * T::from_i64(2);
        over_plane - &self.a * point.top_view().norm2()
    }

    /// Whether the point lies on the i-M-sphere.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residual(point).is_zero()
    }

    /// `|p − (B, C)|² + 2A(t − D)` for the plane `z = p·x' + t`: 0 if it touches, positive if it
    /// cuts in a real i-circle, negative if in an imaginary one (`A ≠ 0`).
    ///
    /// For Σ this says: a plane touches Σ iff its pole lies on Σ.
    ///
    /// ```
    /// use isogeo::space::{Gradient, MoebiusSphere, Plane};
    /// let sigma = MoebiusSphere::new(1.0, 0.0, 0.0, 0.0);
    /// assert_eq!(sigma.tangency(&Plane::new(Gradient::new(2.0, 0.0), -2.0)), 0.0);
    /// assert_eq!(sigma.tangency(&Plane::new(Gradient::new(0.0, 0.0), -2.0)), -4.0); // below
    /// ```
    pub fn tangency(&self, plane: &Plane<T>) -> T {
        let over = (&plane.height - &self.plane.height) * T::from_i64(2);
        self.plane.i_angle2(plane) + &self.a * over
    }
}

impl<T: Field> MoebiusSphere<T> {
    /// The height of the i-M-sphere over a top view.
    pub fn height_at(&self, at: &TopView<T>) -> T {
        &self.a * at.norm2() * T::from_ratio(1, 2) + self.plane.height_at(at)
    }

    /// The point of the i-M-sphere over a top view, with its tangent plane.
    pub fn contact_at(&self, at: &TopView<T>) -> ContactElement<T> {
        ContactElement::new(at.at_height(self.height_at(at)), self.gradient_at(at))
    }

    /// The tangent plane over a top view.
    pub fn tangent_plane(&self, at: &TopView<T>) -> Plane<T> {
        self.contact_at(at).plane()
    }
}

impl<T: Ring> From<Plane<T>> for MoebiusSphere<T> {
    fn from(plane: Plane<T>) -> Self {
        MoebiusSphere { a: T::zero(), plane }
    }
}

impl<T> From<ParabolicSphere<T>> for MoebiusSphere<T> {
    fn from(sphere: ParabolicSphere<T>) -> Self {
        sphere.0
    }
}

/// An i-sphere of parabolic type: (3) with `A ≠ 0`, a paraboloid of revolution with isotropic axis.
///
/// It dereferences to the [`MoebiusSphere`] that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ParabolicSphere<T>(pub(super) MoebiusSphere<T>);

impl<T: Ring> ParabolicSphere<T> {
    /// The i-sphere with the coefficients of (3).
    ///
    /// # Errors
    /// [`SpaceError::ZeroCurvature`] if `A = 0`.
    pub fn new(a: T, b: T, c: T, d: T) -> Result<Self, SpaceError> {
        MoebiusSphere::new(a, b, c, d).try_into()
    }

    /// The unit i-sphere `Σ: z = |x'|²/2` (5).
    pub fn unit() -> Self {
        ParabolicSphere(MoebiusSphere::new(T::one(), T::zero(), T::zero(), T::zero()))
    }
}

impl<T: Field> ParabolicSphere<T> {
    /// The intersection with a non-isotropic plane: an i-circle of elliptic type.
    ///
    /// Its squared radius is [`tangency`](MoebiusSphere::tangency)` / A²`: 0 for a tangent plane,
    /// negative for a plane that misses the sphere (an imaginary i-circle).
    ///
    /// ```
    /// use isogeo::space::{Circle, Gradient, ParabolicSphere, Plane, TopView};
    /// let plane = Plane::new(Gradient::new(1.0, 0.0), 4.0);
    /// let section = ParabolicSphere::unit().section(&plane);
    /// assert_eq!(section.top_view, Circle::new(TopView::new(1.0, 0.0), 9.0));
    /// ```
    pub fn section(&self, plane: &Plane<T>) -> ICircle<T> {
        let inverse = T::one() / &self.a;
        let centre = (&plane.gradient - &self.plane.gradient).scaled(&inverse);
        let radius2 = self.tangency(plane) * inverse.square();
        let centre = TopView::new(centre.x, centre.y);
        ICircle { plane: plane.clone(), top_view: Circle { centre, radius2 } }
    }

    /// The intersection with an isotropic plane: an i-circle of parabolic type with the curvature
    /// `A` of the sphere.
    pub fn isotropic_section(&self, plane: &IsotropicPlane<T>) -> ParabolicCircle<T> {
        let start = self.contact_at(plane.origin());
        let slope = start.gradient.along(plane.direction());
        ParabolicCircle::over(plane.clone(), self.a.clone(), slope, start.point.z)
    }
}

impl<T> Deref for ParabolicSphere<T> {
    type Target = MoebiusSphere<T>;
    fn deref(&self) -> &MoebiusSphere<T> {
        &self.0
    }
}

impl<T: Ring> TryFrom<MoebiusSphere<T>> for ParabolicSphere<T> {
    type Error = SpaceError;
    fn try_from(sphere: MoebiusSphere<T>) -> Result<Self, SpaceError> {
        if sphere.a.is_zero() {
            return Err(SpaceError::ZeroCurvature);
        }
        Ok(ParabolicSphere(sphere))
    }
}

/// An i-sphere of cylindrical type: all points at i-distance r from a point, that is, over a
/// circle of the top view (Sec. 2.1).
///
/// Every point of the axis serves as centre. The squared radius is not 0; if it is negative, the
/// sphere is imaginary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CylindricalSphere<T>(pub(super) Circle<T>);

impl<T: Ring> CylindricalSphere<T> {
    /// The i-sphere over a circle.
    ///
    /// # Errors
    /// [`SpaceError::ZeroRadius`]: it would be an isotropic line.
    pub fn new(top_view: Circle<T>) -> Result<Self, SpaceError> {
        if top_view.radius2.is_zero() {
            return Err(SpaceError::ZeroRadius);
        }
        Ok(CylindricalSphere(top_view))
    }

    /// The circle of the top view.
    pub fn top_view(&self) -> &Circle<T> {
        &self.0
    }

    /// The power of the top view of a point: positive outside, 0 on the sphere.
    pub fn residual(&self, point: &Point<T>) -> T {
        self.0.power(&point.top_view())
    }

    /// Whether the point lies on the sphere.
    pub fn contains(&self, point: &Point<T>) -> bool {
        self.residual(point).is_zero()
    }

    /// `r²|d|² − det(d, m' − o)²` for the isotropic plane over `o + u·d`: 0 if it touches,
    /// positive if it cuts in two isotropic lines.
    pub fn tangency(&self, plane: &IsotropicPlane<T>) -> T {
        let distance = plane.residual(&self.0.centre);
        &self.0.radius2 * plane.direction().length2() - distance.square()
    }

    /// The intersection with a non-isotropic plane: an i-circle with the same top view.
    pub fn section(&self, plane: &Plane<T>) -> ICircle<T> {
        ICircle { plane: plane.clone(), top_view: self.0.clone() }
    }
}
