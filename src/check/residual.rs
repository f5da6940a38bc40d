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
    /// Whether the value is the same after a common translation of all points.
    const TRANSLATES: bool;

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
pub trait Decide: Sync {
    /// The type of exact residuals in reports.
    type Value: Clone + Debug + Display + PartialEq + Send + Sync;

    /// Whether the residual vanishes.
    fn decide<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> Answer;

    /// The sign of the residual as printed, and whether it is the same in the whole box.
    fn sign<const K: usize>(&self, residual: impl Residual<K>, at: [VertexId; K]) -> (Sign, bool);

    /// The sign of the sum of a residual over several places, and whether it is the same in the
    /// whole box.
    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool);

    /// Whether the sum of roots vanishes.
    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Answer;

    /// Whether two vertices have the same top view as printed.
    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool;

    /// Whether two vertices are the same point as printed.
    fn same_point(&self, a: VertexId, b: VertexId) -> bool;

    /// A residual that does not vanish: its size compared with its terms, and itself at least
    /// where `exact` asks for it.
    fn failure<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        at: [VertexId; K],
        exact: bool,
    ) -> Failure<Self::Value>;

    /// A sum of roots that does not vanish; as it is no number of the field, it has no exact value.
    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        at: [VertexId; K],
    ) -> Failure<Self::Value>;
}
