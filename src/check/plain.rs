//! The plain ways to decide: exactly in a rational field, or observed in `f64`.

use super::report::Failure;
use super::residual::{Answer, Decide, Residual, RootSum};
use super::roots::{sign_over, vanish_over};
use crate::mesh::VertexId;
use crate::scalar::{Magnitude, Ordered, RationalField, Ring, Sign};
use crate::space::Point;

/// Decides by evaluation in an exact field: the definition that the fast way is held against.
#[derive(Clone, Copy, Debug)]
pub struct Plain<'a, Q>(pub &'a [Point<Q>]);

/// Decides by evaluation in `f64`.
///
/// Nothing is ever found to be zero: a residual is [`Near`](Answer::Near) if it is at most
/// `tolerance` times its scale.
#[derive(Clone, Copy, Debug)]
pub struct Observed<'a> {
    /// The points of the mesh.
    pub points: &'a [Point<f64>],
    /// The largest `|residual| / scale` that counts as near.
    pub tolerance: f64,
}

fn at<T: Clone, const K: usize>(points: &[Point<T>], at: [VertexId; K]) -> [Point<T>; K] {
    at.map(|v| points[v.index()].clone())
}

fn sum<R: Ring, const K: usize>(
    points: &[Point<R>],
    residual: impl Residual<K>,
    places: &[[VertexId; K]],
) -> R {
    let value = |&v| residual.eval(&at(points, v), &R::one());
    places.iter().map(value).fold(R::zero(), |sum, value| sum + value)
}

/// `|value| / scale`; where every term is zero, so is the value.
fn defect(value: f64, scale: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.abs() / scale }
}

/// The sizes of coordinates, after the first point of each block is moved to the origin if that is
/// allowed.
fn sizes<T: Ordered, const K: usize>(
    points: &[Point<T>; K],
    block: Option<usize>,
) -> [Point<Magnitude<T>>; K] {
    let zero = Point::new(T::zero(), T::zero(), T::zero());
    std::array::from_fn(|i| {
        let origin = block.map_or(&zero, |block| &points[i - i % block]);
        let v = &points[i] - origin;
        Point::new(Magnitude::of(&v.x), Magnitude::of(&v.y), Magnitude::of(&v.z))
    })
}

fn failure<T: Ordered, R: Residual<K>, const K: usize>(
    condition: &'static str,
    residual: R,
    points: &[Point<T>],
    places: &[[VertexId; K]],
    ratio: impl Fn(&T, &T) -> f64,
) -> Failure<T> {
    let value = sum(points, residual, places);
    let block = R::TRANSLATES.then_some(R::BLOCK);
    let size = |&v| residual.eval(&sizes(&at(points, v), block), &Magnitude(T::one()));
    let scale = places.iter().map(size).fold(Magnitude(T::zero()), |sum, size| sum + size).0;
    Failure { condition, defect: ratio(&value, &scale), residual: Some(value) }
}

fn root_failure<T, const K: usize, const TERMS: usize>(
    condition: &'static str,
    sum: impl RootSum<K, TERMS>,
    points: &[Point<f64>; K],
) -> Failure<T> {
    let value = sum.eval(points).iter().map(|(c, q)| c * q.sqrt()).sum();
    let scale = sum.eval(&sizes(points, Some(K))).iter().map(|(c, q)| c.0 * q.0.sqrt()).sum();
    Failure { condition, defect: defect(value, scale), residual: None }
}

/// The points moved to the first and scaled so that doubles hold them.
fn normalised<Q: RationalField, const K: usize>(points: &[Point<Q>; K]) -> [Point<f64>; K] {
    let moved: [Point<Q>; K] = std::array::from_fn(|i| {
        let v = &points[i] - &points[0];
        Point::new(v.x, v.y, v.z)
    });
    let sizes = moved.iter().flat_map(|p| p.coordinates()).map(Q::magnitude);
    let largest = sizes.fold(Q::zero(), |a, b| if b > a { b } else { a });
    let scale = largest.try_inv().unwrap_or_else(Q::one);
    moved.map(|p| p.map(|c| (c * &scale).to_f64()))
}

impl<Q: RationalField> Decide for Plain<'_, Q> {
    type Value = Q;

    fn decide_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> Answer {
        if sum(self.0, residual, places).is_zero() { Answer::Zero } else { Answer::Nonzero }
    }

    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        let value = sum(self.0, residual, places);
        (value.certain_sign().unwrap_or(Sign::Zero), true)
    }

    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> Answer {
        match vanish_over(&sum.eval(&at(self.0, v))) {
            Some(true) => Answer::Zero,
            _ => Answer::Nonzero,
        }
    }

    fn sign_of_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> (Sign, bool) {
        let sign = sign_over(&sum.eval(&at(self.0, v)));
        (sign.unwrap_or(Sign::Zero), sign.is_some())
    }

    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        self.0[a.index()].is_parallel_to(&self.0[b.index()])
    }

    fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        self.0[a.index()] == self.0[b.index()]
    }

    fn failure_of_sum<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
        _: bool,
    ) -> Failure<Q> {
        failure(condition, residual, self.0, places, |value, scale| {
            value.try_div(scale).map_or(0.0, |d| d.to_f64().abs())
        })
    }

    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> Failure<Q> {
        root_failure(condition, sum, &normalised(&at(self.0, v)))
    }
}

impl Observed<'_> {
    fn near(&self, failure: Failure<f64>) -> Answer {
        if failure.defect <= self.tolerance { Answer::Near } else { Answer::Nonzero }
    }
}

impl Decide for Observed<'_> {
    type Value = f64;

    fn decide_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> Answer {
        self.near(self.failure_of_sum("", residual, places, false))
    }

    fn sign_of_sum<const K: usize>(
        &self,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
    ) -> (Sign, bool) {
        let value = sum(self.points, residual, places);
        (value.certain_sign().unwrap_or(Sign::Zero), false)
    }

    fn decide_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> Answer {
        self.near(self.root_failure("", sum, v))
    }

    fn sign_of_roots<const K: usize, const TERMS: usize>(
        &self,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> (Sign, bool) {
        let terms = sum.eval(&at(self.points, v));
        let value: f64 = terms.iter().map(|(c, q)| c * q.sqrt()).sum();
        (value.certain_sign().unwrap_or(Sign::Zero), false)
    }

    fn same_top_view(&self, a: VertexId, b: VertexId) -> bool {
        self.points[a.index()].is_parallel_to(&self.points[b.index()])
    }

    fn same_point(&self, a: VertexId, b: VertexId) -> bool {
        self.points[a.index()] == self.points[b.index()]
    }

    fn failure_of_sum<const K: usize>(
        &self,
        condition: &'static str,
        residual: impl Residual<K>,
        places: &[[VertexId; K]],
        _: bool,
    ) -> Failure<f64> {
        failure(condition, residual, self.points, places, |value, scale| defect(*value, *scale))
    }

    fn root_failure<const K: usize, const TERMS: usize>(
        &self,
        condition: &'static str,
        sum: impl RootSum<K, TERMS>,
        v: [VertexId; K],
    ) -> Failure<f64> {
        root_failure(condition, sum, &at(self.points, v))
    }
}
