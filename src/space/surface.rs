//! Smooth surfaces as graphs `z = f(x, y)` and their isotropic curvatures (4)–(11).

use super::{ContactElement, Dual, MoebiusSphere, ParabolicSphere, Plane, Point, TopView, Vector2};
use crate::scalar::{Field, Ring};

/// A smooth surface without isotropic tangent planes, given as a graph `z = f(x, y)` (4).
pub trait Graph<T> {
    /// Value, gradient and Hessian of `f` at a top view; `None` where `f` is not defined.
    fn jet(&self, at: &TopView<T>) -> Option<Jet2<T>>;
}

/// The 2-jet of a surface at a point: the contact element `(x, y, f), (f_x, f_y)` and the Hessian.
///
/// ```
/// use isogeo::space::{Graph, Jet2, ParabolicSphere, TopView};
/// let jet = ParabolicSphere::unit().jet(&TopView::new(2.0, 1.0)).unwrap();
/// assert_eq!((jet.mean_curvature(), jet.curvature()), (1.0, 1.0)); // Σ opens upwards: H > 0
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Jet2<T> {
    /// The point with its tangent plane.
    pub contact: ContactElement<T>,
    /// The second derivatives.
    pub hessian: Hessian<T>,
}

/// The Hessian `∇²f`: the matrix of the isotropic shape operator (7), symmetric.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Hessian<T> {
    /// `f_xx`
    pub xx: T,
    /// `f_xy`
    pub xy: T,
    /// `f_yy`
    pub yy: T,
}

impl<T: Ring> Hessian<T> {
    /// The shape operator `v ↦ ∇²f · v` (7): the change of the Gauss image along `v`.
    pub fn apply(&self, v: &Vector2<T>) -> Vector2<T> {
        Vector2 {
            x: T::dot([&self.xx, &self.xy], [&v.x, &v.y]),
            y: T::dot([&self.xy, &self.yy], [&v.x, &v.y]),
        }
    }

    /// The second fundamental form `uᵀ ∇²f v`; 0 iff the directions are conjugate.
    pub fn form(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        u.dot(&self.apply(v))
    }

    /// `det(v, ∇²f v)`: 0 iff `v` is an isotropic principal curvature direction (an eigenvector).
    pub fn principality(&self, v: &Vector2<T>) -> T {
        v.det(&self.apply(v))
    }

    /// `f_xx + f_yy = Δf`, the sum of the i-principal curvatures.
    pub fn trace(&self) -> T {
        &self.xx + &self.yy
    }

    /// `f_xx f_yy − f_xy²`, the product of the i-principal curvatures.
    pub fn det(&self) -> T {
        T::det2(&self.xx, &self.xy, &self.xy, &self.yy)
    }

    /// The multiple `factor · ∇²f`.
    pub fn scaled(&self, factor: &T) -> Self {
        Hessian { xx: &self.xx * factor, xy: &self.xy * factor, yy: &self.yy * factor }
    }
}

impl<T: Field> Hessian<T> {
    /// The inverse matrix, or `None` where the determinant is 0.
    pub fn inverse(&self) -> Option<Self> {
        let adjugate = Hessian { xx: self.yy.clone(), xy: -&self.xy, yy: self.xx.clone() };
        self.det().try_inv().map(|scale| adjugate.scaled(&scale))
    }
}

impl<T: Ring> Jet2<T> {
    /// The tangent plane.
    pub fn tangent_plane(&self) -> Plane<T> {
        self.contact.plane()
    }

    /// The isotropic curvature `K = κ₁κ₂ = f_xx f_yy − f_xy²` (8).
    ///
    /// Positive where the surface is locally convex, whichever way it opens.
    pub fn curvature(&self) -> T {
        self.hessian.det()
    }
}

impl<T: Field> Jet2<T> {
    /// The isotropic mean curvature `H = (κ₁ + κ₂)/2 = Δf/2` (9); positive opens upwards.
    pub fn mean_curvature(&self) -> T {
        self.hessian.trace() * T::from_ratio(1, 2)
    }

    /// The Gauss image `(f_x, f_y, (f_x² + f_y²)/2)` on Σ (6), where the tangent plane of Σ is
    /// parallel to that of the surface.
    pub fn gauss_image(&self) -> Point<T> {
        let sigma = ParabolicSphere::unit();
        sigma.contact_at(&self.contact.gradient.dual()).point
    }

    /// The 2-jet of the metric dual surface at the dual contact element (10): its Hessian is the
    /// inverse one, hence `H* = H/K`, `K* = 1/K` (11).
    ///
    /// `None` where `K = 0`: the dual surface is singular there.
    ///
    /// ```
    /// use isogeo::space::{ContactElement, Gradient, Hessian, Jet2, Point};
    /// // z = x² + y²/4 over (1, 2); the dual surface is z = x²/4 + y²
    /// let contact = ContactElement::new(Point::new(1.0, 2.0, 2.0), Gradient::new(2.0, 1.0));
    /// let jet = Jet2 { contact, hessian: Hessian { xx: 2.0, xy: 0.0, yy: 0.5 } };
    /// let dual = jet.dual().unwrap();
    /// assert_eq!(dual.contact.point, Point::new(2.0, 1.0, 2.0));
    /// assert_eq!(dual.hessian, Hessian { xx: 0.5, xy: 0.0, yy: 2.0 });
    /// ```
    pub fn dual(&self) -> Option<Self> {
        let hessian = self.hessian.inverse()?;
        Some(Jet2 { contact: self.contact.dual(), hessian })
    }
}

impl<T: Field> Graph<T> for MoebiusSphere<T> {
    /// Defined everywhere; `H = A`, `K = A²`.
    fn jet(&self, at: &TopView<T>) -> Option<Jet2<T>> {
        let hessian = Hessian { xx: self.a.clone(), xy: T::zero(), yy: self.a.clone() };
        Some(Jet2 { contact: self.contact_at(at), hessian })
    }
}
