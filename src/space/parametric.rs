//! Surfaces given by polynomials of two parameters.

use super::{ContactElement, Gradient, Hessian, Jet2, Point, Polynomial, TopView, Vector2};
use crate::scalar::Field;

/// A surface `(u, v) ↦ (x, y, z)` with polynomial coordinates: where the top view is regular, it
/// is locally the graph of a function that need not be a polynomial.
///
/// ```
/// use isogeo::scalar::Ring;
/// use isogeo::space::{ParametricSurface, Point, Polynomial, TopView};
/// let (u, v) = (Polynomial::<f64>::x(), Polynomial::y());
/// // z = √x over the parameter u = √x
/// let surface = ParametricSurface(Point::new(u.square(), v, u));
/// let jet = surface.jet(&TopView::new(0.5, 7.0)).unwrap();
/// assert_eq!((jet.contact.gradient.x, jet.hessian.xx), (1.0, -2.0));
/// assert!(surface.jet(&TopView::new(0.0, 7.0)).is_none()); // vertical tangent plane
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ParametricSurface<T>(pub Point<Polynomial<T>>);

impl<T: Field> ParametricSurface<T> {
    /// The dual surface (10) of the graph of a polynomial, over the parameters `(x, y)`.
    pub fn dual_of(f: &Polynomial<T>) -> Self {
        let (fx, fy) = (f.dx(), f.dy());
        let height = Polynomial::x() * &fx + Polynomial::y() * &fy - f;
        ParametricSurface(Point::new(fx, fy, height))
    }

    /// The point with given parameters.
    pub fn point_at(&self, parameters: &TopView<T>) -> Point<T> {
        self.0.map(|coordinate| coordinate.value_at(parameters))
    }

    /// The 2-jet of the graph that the surface is near the point with given parameters.
    ///
    /// It follows by implicit differentiation. With `J` the derivative of the top view and
    /// `p = ∇f`: `Jᵀp = ∇z`, and `Jᵀ(∇²f)J = ∇²z − p₁∇²x − p₂∇²y` by the parameters.
    /// `None` where `det J = 0`.
    pub fn jet(&self, parameters: &TopView<T>) -> Option<Jet2<T>> {
        let Point { x, y, z } = self.0.map(|f| derivatives(f, parameters));
        // The columns of J⁻¹: the parameter directions that go along x and y.
        let scale = x.0.det(&y.0).try_inv()?;
        let along_x = Vector2::new(y.0.y.clone(), -&y.0.x).scaled(&scale);
        let along_y = Vector2::new(-&x.0.y, x.0.x.clone()).scaled(&scale);
        let gradient = Gradient::new(z.0.dot(&along_x), z.0.dot(&along_y));
        let second = |u: &Vector2<T>, v: &Vector2<T>| {
            z.1.form(u, v) - &gradient.x * x.1.form(u, v) - &gradient.y * y.1.form(u, v)
        };
        let hessian = Hessian {
            xx: second(&along_x, &along_x),
            xy: second(&along_x, &along_y),
            yy: second(&along_y, &along_y),
        };
        Some(Jet2 { contact: ContactElement::new(self.point_at(parameters), gradient), hessian })
    }
}

/// First and second derivatives by the parameters.
fn derivatives<T: Field>(f: &Polynomial<T>, at: &TopView<T>) -> (Vector2<T>, Hessian<T>) {
    let (fu, fv) = (f.dx(), f.dy());
    let hessian =
        Hessian { xx: fu.dx().value_at(at), xy: fu.dy().value_at(at), yy: fv.dy().value_at(at) };
    (Vector2::new(fu.value_at(at), fv.value_at(at)), hessian)
}
