//! Metric duality: the polarity at the unit i-sphere `Σ: z = |x'|²/2` (Sec. 2.1).

use super::{ContactElement, Gradient, MoebiusSphere, ParabolicSphere, Plane, Point, TopView};
use crate::scalar::{Field, Ring};

/// An object with a metric dual; dualising twice gives the object back, in type and in value.
///
/// The sign of the third coordinate: the point `(p₁, p₂, p₃)` and the plane
/// `z = p₁x + p₂y − p₃` are dual. The dual of a plane is also called its *pole*.
///
/// ```
/// use isogeo::space::{Dual, Gradient, Plane, Point};
/// let plane = Point::new(1.0, 2.0, 3.0).dual();
/// assert_eq!(plane, Plane::new(Gradient::new(1.0, 2.0), -3.0)); // z = x + 2y − 3
/// assert_eq!(plane.dual(), Point::new(1.0, 2.0, 3.0));
/// ```
///
/// Isotropic planes have no dual: it would lie at infinity.
pub trait Dual {
    /// The kind of the dual object.
    type Dual: Dual<Dual = Self>;

    /// The dual object.
    fn dual(&self) -> Self::Dual;
}

impl<T: Ring> Dual for TopView<T> {
    type Dual = Gradient<T>;

    /// The common gradient of the planes dual to the points of this top view.
    fn dual(&self) -> Gradient<T> {
        Gradient { x: self.x.clone(), y: self.y.clone() }
    }
}

impl<T: Ring> Dual for Gradient<T> {
    type Dual = TopView<T>;

    /// The common top view of the poles of the planes with this gradient.
    fn dual(&self) -> TopView<T> {
        TopView { x: self.x.clone(), y: self.y.clone() }
    }
}

impl<T: Ring> Dual for Point<T> {
    type Dual = Plane<T>;

    /// The polar plane `z = p₁x + p₂y − p₃`.
    fn dual(&self) -> Plane<T> {
        Plane { gradient: self.top_view().dual(), height: -&self.z }
    }
}

impl<T: Ring> Dual for Plane<T> {
    type Dual = Point<T>;

    /// The pole `(p₁, p₂, −t)`.
    fn dual(&self) -> Point<T> {
        self.gradient.dual().at_height(-&self.height)
    }
}

impl<T: Ring> Dual for ContactElement<T> {
    type Dual = Self;

    /// The pole of the plane with the polar plane of the point: with the element of a graph this
    /// is `(f_x, f_y, x f_x + y f_y − f)` (10) and the gradient `(x, y)`.
    fn dual(&self) -> Self {
        let gradient = self.point.top_view().dual();
        ContactElement { point: self.plane().dual(), gradient }
    }
}

impl<T: Field> Dual for ParabolicSphere<T> {
    type Dual = Self;

    /// The sphere of the poles of all tangent planes, `z = |x' − (B, C)|²/(2A) − D`.
    fn dual(&self) -> Self {
        let inverse = T::one() / &self.a;
        let Gradient { x: b, y: c } = &self.plane.gradient;
        let height =
            self.plane.gradient.norm2() * &inverse * T::from_ratio(1, 2) - &self.plane.height;
        let gradient = Gradient { x: -b * &inverse, y: -c * &inverse };
        ParabolicSphere(MoebiusSphere { a: inverse, plane: Plane { gradient, height } })
    }
}
