//! Conditions of a mesh to optimise: the residuals of the classes of mesh, with their derivatives.

use super::gradient::Differentiable;
use super::polynomial::Polynomial;
use crate::mesh::VertexId;
use crate::space::{Point, Vector3};

/// The most points that one condition speaks of.
pub const MOST_POINTS: usize = 16;

/// Conditions of one kind, each on a few points: polynomials that shall vanish.
pub trait Conditions: Send + Sync {
    /// What they ask for, as in reports of failures.
    fn name(&self) -> &'static str;

    /// How many there are.
    fn len(&self) -> usize;

    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The points that a condition speaks of, each once; at most [`MOST_POINTS`].
    fn points(&self, condition: usize) -> &[VertexId];

    /// The value of a condition.
    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64;

    /// The sum of the sizes of the terms of the value.
    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64;

    /// The value, and the derivatives by its points in their order.
    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64;

    /// The function that shall vanish over other numbers, if it is a polynomial.
    fn polynomial(&self) -> Option<Polynomial> {
        None
    }
}

/// The same residual at many places.
#[derive(Clone, Debug)]
pub struct Everywhere<R, const K: usize> {
    /// What it asks for.
    pub name: &'static str,
    /// The polynomial.
    pub residual: R,
    /// Where it shall vanish.
    pub places: Vec<[VertexId; K]>,
}

impl<R: Differentiable<K>, const K: usize> Everywhere<R, K> {
    fn corners(&self, condition: usize, points: &[Point<f64>]) -> [Point<f64>; K] {
        self.places[condition].map(|v| points[v.index()])
    }
}

impl<R: Differentiable<K>, const K: usize> Conditions for Everywhere<R, K> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn len(&self) -> usize {
        self.places.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        &self.places[condition]
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        self.residual.value(&self.corners(condition, points))
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        self.residual.scale(&self.corners(condition, points))
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        let (value, slopes) = self.residual.gradient(&self.corners(condition, points));
        gradient[..K].copy_from_slice(&slopes);
        value
    }

    fn polynomial(&self) -> Option<Polynomial> {
        self.residual.polynomial()
    }
}
