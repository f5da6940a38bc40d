//! Residuals with their derivatives: by dual numbers, and in closed form where speed asks for it.

use std::array::from_fn;

use super::polynomial::Polynomial;
use crate::check::{Residual, RootSum};
use crate::net::euclidean::{ConcyclicInSpace, ConcyclicNormals};
use crate::net::i_circular::Concyclic;
use crate::net::i_conical::{Balance, ConcyclicGradients};
use crate::net::planar::Coplanar;
use crate::scalar::{Dual, Magnitude};
use crate::space::{Point, Vector2, Vector3};

/// A function of `K` points with its derivatives.
pub trait Differentiable<const K: usize>: Copy + Send + Sync {
    /// The value.
    fn value(self, points: &[Point<f64>; K]) -> f64;

    /// The sum of the sizes of the terms of the value.
    fn scale(self, points: &[Point<f64>; K]) -> f64;

    /// The value, and the derivatives by the coordinates of each point.
    fn gradient(self, points: &[Point<f64>; K]) -> (f64, [Vector3<f64>; K]);

    /// The function over other numbers, if it is a polynomial.
    fn polynomial(self) -> Option<Polynomial> {
        None
    }
}

/// The derivatives of a function by dual numbers: the generic formula runs once for each point.
///
/// ```
/// use isogeo::net::planar::Coplanar;
/// use isogeo::optimise::by_dual_numbers;
/// use isogeo::check::Residual;
/// use isogeo::scalar::Ring;
/// use isogeo::space::Point;
/// let at = |x, y, z| Point::new(x, y, z);
/// let square = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0, 1.0, 0.5), at(0.0, 1.0, 0.0)];
/// let (value, slopes) = by_dual_numbers(&square, |p| Coplanar.eval(p, &Ring::one()));
/// assert_eq!(value, -0.5); // the third corner is too high
/// assert_eq!(slopes[2].z, -1.0);
/// ```
pub fn by_dual_numbers<const K: usize>(
    points: &[Point<f64>; K],
    function: impl Fn(&[Point<Dual<f64, 3>>; K]) -> Dual<f64, 3>,
) -> (f64, [Vector3<f64>; K]) {
    let constant = |p: &Point<f64>| p.map(|c| Dual::constant(*c));
    let mut duals = points.each_ref().map(constant);
    let mut value = 0.0;
    let slopes = from_fn(|i| {
        let [x, y, z] = Dual::variables([points[i].x, points[i].y, points[i].z]);
        duals[i] = Point::new(x, y, z);
        let result = function(&duals);
        duals[i] = constant(&points[i]);
        value = result.value;
        let [x, y, z] = result.partials;
        Vector3 { x, y, z }
    });
    (value, slopes)
}

/// The sizes of coordinates seen from the first point: the residuals here stay under translations.
fn sizes<const K: usize>(points: &[Point<f64>; K]) -> [Point<Magnitude<f64>>; K] {
    points.each_ref().map(|p| {
        let d = p - &points[0];
        Point::new(d.x, d.y, d.z).map(Magnitude::of)
    })
}

/// Residuals that are polynomials, with their derivatives.
macro_rules! differentiable {
    ($($residual:ident, $k:literal, |$this:ident, $points:ident| $gradient:expr;)*) => {$(
        impl Differentiable<$k> for $residual {
            #[inline]
            fn value(self, points: &[Point<f64>; $k]) -> f64 {
                self.eval(points, &1.0)
            }

            fn scale(self, points: &[Point<f64>; $k]) -> f64 {
                self.eval(&sizes(points), &Magnitude(1.0)).0
            }

            #[inline]
            fn gradient(self, $points: &[Point<f64>; $k]) -> (f64, [Vector3<f64>; $k]) {
                let $this = self;
                $gradient
            }

            fn polynomial(self) -> Option<Polynomial> {
                Some(Polynomial::$residual(self))
            }
        }
    )*};
}

differentiable! {
    Coplanar, 4, |_this, p| coplanar(p);
    Concyclic, 4, |_this, p| concyclic(p);
    Balance, 5, |_this, p| balance(p);
    ConcyclicGradients, 12, |this, p| by_dual_numbers(p, |p| this.eval(p, &Dual::constant(1.0)));
    ConcyclicInSpace, 4, |this, p| by_dual_numbers(p, |p| this.eval(p, &Dual::constant(1.0)));
}

/// The cofactors of the determinant: normals of the triangles of the other points.
#[inline]
fn coplanar([p, a, b, c]: &[Point<f64>; 4]) -> (f64, [Vector3<f64>; 4]) {
    let (a, b, c) = (a - p, b - p, c - p);
    let [u, v, w] = [b.cross(&c), c.cross(&a), a.cross(&b)];
    let own = (&(&u + &v) + &w).scaled(&-1.0);
    (a.dot(&u), [own, u, v, w])
}

/// With `n = |x'|²` the determinant has the rows `(x, y, n)`: its cofactors and the chain rule.
#[inline]
fn concyclic([p, a, b, c]: &[Point<f64>; 4]) -> (f64, [Vector3<f64>; 4]) {
    let lift = |q: &Point<f64>| {
        let view = (q - p).top_view();
        Vector3 { x: view.x, y: view.y, z: view.length2() }
    };
    let [a, b, c] = [a, b, c].map(lift);
    let [u, v, w] = [c.cross(&b), a.cross(&c), b.cross(&a)];
    let slope = |lifted: &Vector3<f64>, cofactor: &Vector3<f64>| Vector3 {
        x: cofactor.x + 2.0 * lifted.x * cofactor.z,
        y: cofactor.y + 2.0 * lifted.y * cofactor.z,
        z: 0.0,
    };
    let [u1, v1, w1] = [slope(&a, &u), slope(&b, &v), slope(&c, &w)];
    let own = Vector3 { x: -u1.x - v1.x - w1.x, y: -u1.y - v1.y - w1.y, z: 0.0 };
    (a.dot(&u), [own, u1, v1, w1])
}

/// `Im(e₀ e₂ \overline{e₁ e₃})` is linear in each edge: the derivative by `e₀` is the imaginary part of what
/// multiplies it.
#[inline]
fn balance([v, x @ ..]: &[Point<f64>; 5]) -> (f64, [Vector3<f64>; 5]) {
    let e: [Vector2<f64>; 4] = from_fn(|i| (&x[i] - v).top_view());
    let times = |a: &Vector2<f64>, b: &Vector2<f64>| Vector2 {
        x: a.x * b.x - a.y * b.y,
        y: a.x * b.y + a.y * b.x,
    };
    let conjugate = |a: Vector2<f64>| Vector2 { x: a.x, y: -a.y };
    let (even, odd) = (times(&e[0], &e[2]), times(&e[1], &e[3]));
    // Im(e f) changes by Im f and Re f with the parts of e; Im(f ē) by Im f and −Re f.
    let plain = |f: Vector2<f64>| Vector3 { x: f.y, y: f.x, z: 0.0 };
    let barred = |f: Vector2<f64>| Vector3 { x: f.y, y: -f.x, z: 0.0 };
    let bar = conjugate(odd);
    let slopes = [
        plain(times(&e[2], &bar)),
        barred(times(&even, &conjugate(e[3]))),
        plain(times(&e[0], &bar)),
        barred(times(&even, &conjugate(e[1]))),
    ];
    let sum = |f: fn(&Vector3<f64>) -> f64| -slopes.iter().map(f).sum::<f64>();
    let own = Vector3 { x: sum(|s| s.x), y: sum(|s| s.y), z: 0.0 };
    let [s0, s1, s2, s3] = slopes;
    (odd.det(&even), [own, s0, s1, s2, s3])
}

impl Differentiable<12> for ConcyclicNormals {
    fn value(self, points: &[Point<f64>; 12]) -> f64 {
        self.eval(points).iter().map(|(c, q)| c * q.sqrt()).sum()
    }

    fn scale(self, points: &[Point<f64>; 12]) -> f64 {
        self.eval(&sizes(points)).iter().map(|(c, q)| c.0 * q.0.sqrt()).sum()
    }

    fn gradient(self, points: &[Point<f64>; 12]) -> (f64, [Vector3<f64>; 12]) {
        by_dual_numbers(points, |p| {
            let terms = self.eval(p).map(|(c, q): (Dual<f64, 3>, Dual<f64, 3>)| {
                let root = q.value.sqrt();
                c * q.chain(root, &(0.5 / root))
            });
            terms.into_iter().fold(Dual::constant(0.0), |sum, term| sum + term)
        })
    }
}
