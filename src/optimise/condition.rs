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

    /// The function that shall vanish over other numbers, if it is one polynomial at all places.
    fn polynomial(&self) -> Option<Polynomial> {
        None
    }
}

/// Conditions of one kind: at each place a function that shall vanish.
#[derive(Clone, Debug)]
pub struct Each<R, const K: usize> {
    /// What they ask for.
    pub name: &'static str,
    /// The places and the functions.
    pub places: Vec<([VertexId; K], R)>,
}

impl<R: Copy, const K: usize> Each<R, K> {
    /// The same function at all places.
    pub fn everywhere(
        name: &'static str,
        function: R,
        places: impl IntoIterator<Item = [VertexId; K]>,
    ) -> Self {
        Each { name, places: places.into_iter().map(|place| (place, function)).collect() }
    }
}

impl<R: Differentiable<K>, const K: usize> Conditions for Each<R, K> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn len(&self) -> usize {
        self.places.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        &self.places[condition].0
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let (at, function) = &self.places[condition];
        function.value(&at.map(|v| points[v.index()]))
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let (at, function) = &self.places[condition];
        function.scale(&at.map(|v| points[v.index()]))
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        let (at, function) = &self.places[condition];
        let (value, slopes) = function.gradient(&at.map(|v| points[v.index()]));
        gradient[..K].copy_from_slice(&slopes);
        value
    }

    fn polynomial(&self) -> Option<Polynomial> {
        self.places.first()?.1.polynomial()
    }
}
