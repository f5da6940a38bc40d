//! Polynomials that must vanish, and what it means to decide whether they do.

use std::fmt::{Debug, Display};

use super::report::Failure;
use crate::mesh::VertexId;
use crate::scalar::{Ring, Sign};
use crate::space::Point;

/// A polynomial in the coordinates of `K` points that vanishes where a property holds.
///
/// It is homogeneous in the coordinates together with `unit`, the length 1: a formula that speaks
/// of the unit i-sphere writes `2 z · unit − x² − y²`. So it may be evaluated on integers after
/// denominators have been cleared, with the common denominator for `unit`.
pub trait Residual<const K: usize>: Copy + Send + Sync {
    /// Whether the value is the same after a translation of each block of points.
    const TRANSLATES: bool;

    /// How many consecutive points form a block: all of them, or those of one mesh of a pair, which
    /// may lie far from the other.
    const BLOCK: usize = K;

    /// The value.
    fn eval<R: Ring>(self, points: &[Point<R>; K], unit: &R) -> R;
}

/// A sum `Σ cᵢ √qᵢ` whose `cᵢ` and `qᵢ` are polynomials in the coordinates of `K` points,
/// unchanged under translation and homogeneous.
pub trait RootSum<const K: usize, const TERMS: usize>: Copy + Send + Sync {
    /// The pairs `(cᵢ, qᵢ)`.
    fn eval<R: Ring>(self, points: &[Point<R>; K]) -> [(R, R); TERMS];
}

/// What is known of a residual; ordered from best to worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Answer {
    /// Exactly zero.
    Zero,
    /// Not zero as printed, but zero is possible within the box of the printed digits.
    InBox,
    /// Not zero, or not known to be, but within the tolerance that was asked for.
    Near,
    /// Not zero.
    Nonzero,
}

/// Decides polynomial conditions on the points of a mesh, named by their vertices.
///
/// A condition is a residual at one place, or the sum of its values at several, as an area is the
/// sum of triangles.
pub trait Decide: Sync {
    /// The type of exact residuals in reports.
    type Value: Clone + Debug + Display + PartialEq + Send + Sync;

    /// Whether the sum of a residual over several places vanishes.
    fn decide_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> Answer;

    /// The sign of the sum of a residual over several places as printed, and whether it is the
    /// same in the whole box.
    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool);

    /// A sum that does not vanish: its size compared with its terms, and itself at least where
    /// `exact` asks for it.
    fn failure_of_sum<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
        exact: bool,
    ) -> Failure<Self::Value>;

    /// Whether the sum of roots vanishes.
    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Answer;

    /// Whether each of several sums of roots vanishes.
    fn decide_each_roots<const K: usize, const TERMS: usize, const N: usize>(
        &self,
        sums: [impl RootSum<K, TERMS>; N],
        at: [VertexId; K],
    ) -> [Answer; N] {
        sums.map(|sum| self.decide_roots(sum, at))
    }

    /// The sign of the sum of roots as printed, and whether it is the same in the whole box.
    fn sign_of_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> (Sign, bool);

    /// Whether two vertices have the same top view as printed.
    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool;

    /// Whether two vertices are the same point as printed.
    fn same_point(&self, a: VertexId, b: VertexId) -> bool;

    /// A sum of roots that does not vanish; as it is no number of the field, it has no exact value.
    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Failure<Self::Value>;

    /// Whether the residual vanishes at one place.
    #[inline]
    fn decide<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> Answer {
        self.decide_sum(residual, &[at])
    }

    /// The sign of the residual at one place as printed, and whether it is the same in the whole
    /// box.
    #[inline]
    fn sign<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> (Sign, bool) {
        self.sign_of_sum(residual, &[at])
    }

    /// A residual that does not vanish at one place.
    fn failure<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        at: [VertexId; K],
        exact: bool,
    ) -> Failure<Self::Value> {
        self.failure_of_sum(condition, residual, &[at], exact)
    }

    /// The failure with the largest defect among several places, each by itself.
    fn worst<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: impl Iterator<Item = [VertexId; K]>,
        exact: bool,
    ) -> Failure<Self::Value> {
        let failures = places.map(|at| self.failure(condition, residual, at, exact));
        let none = Failure { condition, defect: 0.0, residual: None };
        failures.reduce(Failure::worse).unwrap_or(none)
    }
}
