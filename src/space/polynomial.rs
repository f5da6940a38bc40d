//! Polynomials in the two coordinates of the top view.

use std::collections::BTreeMap;

use super::{ContactElement, Gradient, Graph, Hessian, Jet2, TopView};
use crate::scalar::Ring;
use crate::scalar::ring::ring_operators;

/// A polynomial `Σ a_ij xⁱ yʲ`; its graph is a test surface whose jets are exact.
///
/// Polynomials are a [`Ring`] themselves, so any generic formula can be evaluated *at* them: with
/// the point `(x, y, f)` in it, the formula speaks of all points of the graph at once.
///
/// ```
/// use isogeo::scalar::Ring;
/// use isogeo::space::{Graph, Polynomial, TopView};
/// let (x, y) = (Polynomial::<f64>::x(), Polynomial::y());
/// let saddle = &x * &x - y.square();
/// let jet = saddle.jet(&TopView::new(3.0, 1.0)).unwrap();
/// assert_eq!((jet.contact.point.z, jet.mean_curvature(), jet.curvature()), (8.0, 0.0, -4.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial<T> {
    /// The coefficients that are not 0, by the exponents of x and y.
    terms: BTreeMap<(u32, u32), T>,
}

impl<T: Ring> Polynomial<T> {
    /// The sum of the terms `a xⁱ yʲ` given as `(i, j, a)`; terms of equal degree are added.
    pub fn new(terms: impl IntoIterator<Item = (u32, u32, T)>) -> Self {
        let mut sum = Polynomial { terms: BTreeMap::new() };
        for (i, j, a) in terms {
            sum.add_term((i, j), a);
        }
        sum
    }

    /// The constant polynomial.
    pub fn constant(a: &T) -> Self {
        Polynomial::new([(0, 0, a.clone())])
    }

    /// The coordinate function x.
    pub fn x() -> Self {
        Polynomial::new([(1, 0, T::one())])
    }

    /// The coordinate function y.
    pub fn y() -> Self {
        Polynomial::new([(0, 1, T::one())])
    }

    /// The terms `(i, j, a_ij)` with a coefficient that is not 0.
    pub fn terms(&self) -> impl Iterator<Item = (u32, u32, &T)> {
        self.terms.iter().map(|(&(i, j), a)| (i, j, a))
    }

    /// The value at a top view.
    pub fn value_at(&self, at: &TopView<T>) -> T {
        self.substitute(&at.x, &at.y, T::clone)
    }

    /// The polynomial with other polynomials in the place of x and y.
    pub fn compose(&self, x: &Self, y: &Self) -> Self {
        self.substitute(x, y, Polynomial::constant)
    }

    /// The value at elements of another ring that coefficients are `lift`ed to.
    pub fn substitute<S: Ring>(&self, x: &S, y: &S, lift: impl Fn(&T) -> S) -> S {
        let (mut powers_x, mut powers_y) = (vec![S::one()], vec![S::one()]);
        self.terms().fold(S::zero(), |sum, (i, j, a)| {
            sum + lift(a) * power(&mut powers_x, x, i) * power(&mut powers_y, y, j)
        })
    }

    /// The partial derivative by x.
    pub fn dx(&self) -> Self {
        let lowered = |(i, j, a): (u32, u32, &T)| Some((i.checked_sub(1)?, j, times(i, a)));
        Polynomial::new(self.terms().filter_map(lowered))
    }

    /// The partial derivative by y.
    pub fn dy(&self) -> Self {
        let lowered = |(i, j, a): (u32, u32, &T)| Some((i, j.checked_sub(1)?, times(j, a)));
        Polynomial::new(self.terms().filter_map(lowered))
    }

    fn add_term(&mut self, degree: (u32, u32), a: T) {
        let sum = match self.terms.remove(&degree) {
            Some(b) => a + b,
            None => a,
        };
        if !sum.is_zero() {
            self.terms.insert(degree, sum);
        }
    }
}

/// `base^n`, from a list of the powers so far.
fn power<'a, S: Ring>(powers: &'a mut Vec<S>, base: &S, n: u32) -> &'a S {
    let n = n as usize;
    while powers.len() <= n {
        let next = &powers[powers.len() - 1] * base;
        powers.push(next);
    }
    &powers[n]
}

fn times<T: Ring>(n: u32, a: &T) -> T {
    T::from_i64(n.into()) * a
}

fn add<T: Ring>(f: &Polynomial<T>, g: &Polynomial<T>) -> Polynomial<T> {
    let mut sum = f.clone();
    for (&degree, a) in &g.terms {
        sum.add_term(degree, a.clone());
    }
    sum
}

fn subtract<T: Ring>(f: &Polynomial<T>, g: &Polynomial<T>) -> Polynomial<T> {
    add(f, &negate(g))
}

fn multiply<T: Ring>(f: &Polynomial<T>, g: &Polynomial<T>) -> Polynomial<T> {
    let products =
        f.terms().flat_map(|(i, j, a)| g.terms().map(move |(k, l, b)| (i + k, j + l, a * b)));
    Polynomial::new(products)
}

fn negate<T: Ring>(f: &Polynomial<T>) -> Polynomial<T> {
    Polynomial { terms: f.terms.iter().map(|(&degree, a)| (degree, -a)).collect() }
}

ring_operators!([T: Ring] Polynomial<T>, add, subtract, multiply, negate);

impl<T: Ring> Ring for Polynomial<T> {
    const EXACT: bool = T::EXACT;

    fn from_i64(n: i64) -> Self {
        Polynomial::constant(&T::from_i64(n))
    }

    fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }
}

impl<T: Ring> Graph<T> for Polynomial<T> {
    /// Defined everywhere.
    fn jet(&self, at: &TopView<T>) -> Option<Jet2<T>> {
        let (fx, fy) = (self.dx(), self.dy());
        Some(Jet2 {
            contact: ContactElement::new(
                at.at_height(self.value_at(at)),
                Gradient::new(fx.value_at(at), fy.value_at(at)),
            ),
            hessian: Hessian {
                xx: fx.dx().value_at(at),
                xy: fx.dy().value_at(at),
                yy: fy.dy().value_at(at),
            },
        })
    }
}
