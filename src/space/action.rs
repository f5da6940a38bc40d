//! How transformations act on the objects of space; what i-motions do to each of them.

use super::{
    Circle, ContactElement, CylindricalSphere, Gradient, Hessian, ICircle, IsotropicPlane, Jet2,
    MoebiusSphere, Motion, ParabolicCircle, ParabolicSphere, Plane, Point, Polynomial, TopView,
    Vector2, Vector3,
};
use crate::scalar::{Field, Ring};

/// A transformation of space that maps each `X` to an `X`.
///
/// The images fit: a point on a plane is mapped to a point on the image of the plane. A `Vector2`
/// counts as a difference of top views; differences of gradients follow their gradients.
///
/// ```
/// use isogeo::space::{Gradient, Plane, Point, Scaling, Transform};
/// let steeper = Scaling::new(1.0, 3.0)?;
/// let plane = Plane::new(Gradient::new(1.0, 0.0), 2.0);
/// assert_eq!(steeper.apply(&plane), Plane::new(Gradient::new(3.0, 0.0), 6.0));
/// assert_eq!(steeper.apply(&Point::new(1.0, 0.0, 3.0)), Point::new(1.0, 0.0, 9.0));
/// # Ok::<(), isogeo::space::SpaceError>(())
/// ```
///
/// Objects made of others follow from their parts, for every transformation. An implementation must
/// therefore be a bijection: `A ≠ 0` of a sphere and `r² ≠ 0` of a cylinder have to stay.
pub trait Transform<X> {
    /// The image.
    fn apply(&self, object: &X) -> X;
}

impl<T, G: Transform<Point<T>> + Transform<Gradient<T>>> Transform<ContactElement<T>> for G {
    fn apply(&self, element: &ContactElement<T>) -> ContactElement<T> {
        ContactElement::new(self.apply(&element.point), self.apply(&element.gradient))
    }
}

impl<T, G: Transform<ContactElement<T>> + Transform<Hessian<T>>> Transform<Jet2<T>> for G {
    fn apply(&self, jet: &Jet2<T>) -> Jet2<T> {
        Jet2 { contact: self.apply(&jet.contact), hessian: self.apply(&jet.hessian) }
    }
}

impl<T, G: Transform<TopView<T>> + Transform<Vector2<T>>> Transform<IsotropicPlane<T>> for G {
    /// Origin and direction are mapped, so that parameters stay.
    fn apply(&self, plane: &IsotropicPlane<T>) -> IsotropicPlane<T> {
        IsotropicPlane::over(self.apply(plane.origin()), self.apply(plane.direction()))
    }
}

impl<T, G: Transform<Plane<T>> + Transform<Circle<T>>> Transform<ICircle<T>> for G {
    fn apply(&self, circle: &ICircle<T>) -> ICircle<T> {
        ICircle { plane: self.apply(&circle.plane), top_view: self.apply(&circle.top_view) }
    }
}

impl<T, G: Transform<MoebiusSphere<T>>> Transform<ParabolicSphere<T>> for G {
    fn apply(&self, sphere: &ParabolicSphere<T>) -> ParabolicSphere<T> {
        ParabolicSphere(self.apply(&sphere.0))
    }
}

impl<T, G: Transform<Circle<T>>> Transform<CylindricalSphere<T>> for G {
    fn apply(&self, sphere: &CylindricalSphere<T>) -> CylindricalSphere<T> {
        CylindricalSphere(self.apply(&sphere.0))
    }
}

impl<T: Ring> Transform<Vector2<T>> for Motion<T> {
    /// `v ↦ R v`.
    fn apply(&self, v: &Vector2<T>) -> Vector2<T> {
        self.rotation.turn(v)
    }
}

impl<T: Ring> Transform<TopView<T>> for Motion<T> {
    /// `x' ↦ R x' + (a, b)`.
    fn apply(&self, at: &TopView<T>) -> TopView<T> {
        let turned = self.rotation.turn(&at.position());
        TopView { x: turned.x + &self.translation.x, y: turned.y + &self.translation.y }
    }
}

impl<T: Ring> Transform<Vector3<T>> for Motion<T> {
    /// `(v', v₃) ↦ (R v', v₃ + (c₁, c₂)·v')`.
    fn apply(&self, v: &Vector3<T>) -> Vector3<T> {
        let top_view = v.top_view();
        let Vector2 { x, y } = self.rotation.turn(&top_view);
        Vector3 { x, y, z: self.shear.dot(&top_view) + &v.z }
    }
}

impl<T: Ring> Transform<Point<T>> for Motion<T> {
    /// Equation (1).
    fn apply(&self, point: &Point<T>) -> Point<T> {
        let at = point.top_view();
        let rise = self.shear.dot(&at.position()) + &self.translation.z;
        self.apply(&at).at_height(rise + &point.z)
    }
}

impl<T: Ring> Transform<Gradient<T>> for Motion<T> {
    /// `p ↦ R(p + (c₁, c₂))`: an i-motion is a Euclidean motion of the gradients, too.
    fn apply(&self, gradient: &Gradient<T>) -> Gradient<T> {
        let Gradient { x, y } = gradient + &self.shear;
        let turned = self.rotation.turn(&Vector2 { x, y });
        Gradient { x: turned.x, y: turned.y }
    }
}

impl<T: Ring> Transform<Plane<T>> for Motion<T> {
    /// The plane with the image of the gradient through the image of the point over the origin.
    fn apply(&self, plane: &Plane<T>) -> Plane<T> {
        let gradient = self.apply(&plane.gradient);
        let rise = gradient.along(&self.translation.top_view());
        let height = &plane.height + &self.translation.z - rise;
        Plane { gradient, height }
    }
}

impl<T: Field> Transform<MoebiusSphere<T>> for Motion<T> {
    /// `A` stays; `(A/2)|x'|²` becomes `(A/2)|x' − (a, b)|²`.
    fn apply(&self, sphere: &MoebiusSphere<T>) -> MoebiusSphere<T> {
        let shift = self.translation.top_view();
        let plane = self.apply(&sphere.plane);
        MoebiusSphere {
            a: sphere.a.clone(),
            plane: Plane {
                height: plane.height + &sphere.a * shift.length2() * T::from_ratio(1, 2),
                gradient: &plane.gradient + &shift.scaled(&-&sphere.a),
            },
        }
    }
}

impl<T: Ring> Transform<Circle<T>> for Motion<T> {
    fn apply(&self, circle: &Circle<T>) -> Circle<T> {
        Circle::new(self.apply(&circle.centre), circle.radius2.clone())
    }
}

impl<T: Ring> Transform<ParabolicCircle<T>> for Motion<T> {
    /// The curvature stays; slope and height at the origin follow the shear.
    fn apply(&self, circle: &ParabolicCircle<T>) -> ParabolicCircle<T> {
        let line = circle.plane();
        let start = self.apply(&line.origin().at_height(circle.height().clone()));
        let slope = circle.slope() + self.shear.dot(line.direction());
        ParabolicCircle::over(self.apply(line), circle.curvature().clone(), slope, start.z)
    }
}

impl<T: Ring> Transform<Hessian<T>> for Motion<T> {
    /// `Q ↦ R Q Rᵀ`.
    fn apply(&self, hessian: &Hessian<T>) -> Hessian<T> {
        let back = self.rotation.inverse();
        let image = |v| self.rotation.turn(&hessian.apply(&back.turn(&v)));
        let (first, second) =
            (image(Vector2::new(T::one(), T::zero())), image(Vector2::new(T::zero(), T::one())));
        Hessian { xx: first.x, xy: first.y, yy: second.y }
    }
}

impl<T: Ring> Transform<Polynomial<T>> for Motion<T> {
    /// The polynomial whose graph is the image of the graph: `f + c₁x + c₂y + c`, with the
    /// inverse motion substituted for x and y.
    fn apply(&self, f: &Polynomial<T>) -> Polynomial<T> {
        let lifted = Point::new(Polynomial::x(), Polynomial::y(), f.clone());
        let constants = self.map(Polynomial::constant);
        let image = constants.apply(&lifted).z;
        let back = constants.inverse().apply(&lifted.top_view());
        image.compose(&back.x, &back.y)
    }
}
