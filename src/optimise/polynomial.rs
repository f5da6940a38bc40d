//! Conditions that are polynomials, over any numbers.

use crate::check::Residual;
use crate::net::euclidean::ConcyclicInSpace;
use crate::net::i_circular::Concyclic;
use crate::net::i_conical::{Balance, ConcyclicGradients};
use crate::net::planar::Coplanar;
use crate::scalar::Ring;
use crate::space::Point;

/// The polynomial of a condition, of whatever number of points.
#[derive(Clone, Copy, Debug)]
pub enum Polynomial {
    /// Four points in a plane.
    Coplanar(Coplanar),
    /// Four top views on a circle.
    Concyclic(Concyclic),
    /// The angles at a vertex of four faces.
    Balance(Balance),
    /// Four gradients on a circle.
    ConcyclicGradients(ConcyclicGradients),
    /// Four points of a plane on a circle in space.
    ConcyclicInSpace(ConcyclicInSpace),
}

impl Polynomial {
    /// The value; `None` for a list of another length than the polynomial speaks of.
    ///
    /// ```
    /// use isogeo::net::planar::Coplanar;
    /// use isogeo::optimise::Polynomial;
    /// use isogeo::space::Point;
    /// let at = |x, y, z| Point::new(x, y, z);
    /// let corners = [at(0, 0, 0), at(1, 0, 0), at(1, 1, 1), at(0, 1, 0)].map(|p| p.map(|&c: &i64| c as f64));
    /// assert_eq!(Polynomial::Coplanar(Coplanar).eval(&corners), Some(-1.0));
    /// assert_eq!(Polynomial::Coplanar(Coplanar).eval(&corners[..3]), None);
    /// ```
    pub fn eval<R: Ring>(&self, corners: &[Point<R>]) -> Option<R> {
        match *self {
            Polynomial::Coplanar(residual) => at(residual, corners),
            Polynomial::Concyclic(residual) => at(residual, corners),
            Polynomial::Balance(residual) => at(residual, corners),
            Polynomial::ConcyclicGradients(residual) => at(residual, corners),
            Polynomial::ConcyclicInSpace(residual) => at(residual, corners),
        }
    }
}

fn at<R: Ring, const K: usize>(residual: impl Residual<K>, corners: &[Point<R>]) -> Option<R> {
    Some(residual.eval(corners.try_into().ok()?, &R::one()))
}
