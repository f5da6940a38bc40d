//! All conditions of a mesh as one system of equations, and its linearisation.

use std::ops::Range;

use rayon::prelude::*;

use super::Mobility;
use super::condition::{Conditions, MOST_POINTS};
use super::report::Worst;
use crate::mesh::VertexId;
use crate::space::{Point, Vector3};

/// The conditions of all kinds in a row, with the points that each speaks of.
pub struct System {
    kinds: Vec<Box<dyn Conditions>>,
    /// What the rows of each kind are multiplied by; without, they are divided by the lengths of
    /// their gradients.
    weights: Vec<Option<f64>>,
    /// `places[starts[i]..starts[i + 1]]` are the points of row `i`.
    starts: Vec<u32>,
    places: Vec<VertexId>,
}

/// The conditions at a point, linearised: each row is divided by the length of its gradient, so that
/// its residual is, to first order, the distance to where it vanishes.
#[derive(Clone, Debug)]
pub struct Linearisation {
    /// The gradients of the rows in the directions that are allowed, in the order of the places.
    pub gradients: Vec<Vector3<f64>>,
    /// The distances.
    pub residuals: Vec<f64>,
    /// What the rows were divided by; 0 where nothing changes the value, which is 0 then.
    pub lengths: Vec<f64>,
    /// Whether an allowed direction changes the value of each row. Where none does, the row has no
    /// gradient, and its distance is that of points that could move.
    pub free: Vec<bool>,
}

const CHUNK: usize = 512;

impl System {
    /// The system of some kinds of conditions that shall hold.
    pub fn new(kinds: Vec<Box<dyn Conditions>>) -> Self {
        System::weighted(kinds.into_iter().map(|kind| (kind, None)).collect())
    }

    /// The system of some kinds of conditions, those with a weight as they are: their rows are multiplied
    /// by it.
    pub fn weighted(kinds: Vec<(Box<dyn Conditions>, Option<f64>)>) -> Self {
        let (kinds, weights): (Vec<_>, _) = kinds.into_iter().unzip();
        let (mut starts, mut places) = (vec![0], Vec::new());
        for kind in &kinds {
            for condition in 0..kind.len() {
                places.extend_from_slice(kind.points(condition));
                starts.push(places.len() as u32);
            }
        }
        System { kinds, weights, starts, places }
    }

    /// The number of equations.
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// Where the points of a row stand.
    #[inline]
    pub fn range(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// The points of all rows, one row after the other.
    pub fn places(&self) -> &[VertexId] {
        &self.places
    }

    /// The kinds with their rows.
    pub fn kinds(&self) -> impl Iterator<Item = (&dyn Conditions, Range<usize>)> {
        let mut start = 0;
        self.kinds.iter().map(move |kind| {
            let rows = start..start + kind.len();
            start = rows.end;
            (kind.as_ref(), rows)
        })
    }

    /// Values and gradients at the given points.
    pub fn linearise(&self, points: &[Point<f64>], mobility: &[Mobility]) -> Linearisation {
        let zero = Vector3::new(0.0, 0.0, 0.0);
        let mut gradients = vec![zero; self.places.len()];
        let (mut residuals, mut lengths) = (vec![0.0; self.rows()], vec![0.0; self.rows()]);
        let mut free = vec![false; self.rows()];
        for (index, (kind, rows)) in self.kinds().enumerate() {
            let weight = self.weights[index];
            let at = self.starts[rows.start] as usize..self.starts[rows.end] as usize;
            let width = at.len() / rows.len().max(1);
            let first = rows.start;
            let chunks = gradients[at].par_chunks_mut(width.max(1) * CHUNK);
            let chunks = chunks
                .zip(residuals[rows.clone()].par_chunks_mut(CHUNK))
                .zip(lengths[rows.clone()].par_chunks_mut(CHUNK))
                .zip(free[rows].par_chunks_mut(CHUNK));
            chunks.enumerate().for_each(|(chunk, (((gradients, residuals), lengths), free))| {
                for (i, gradient) in gradients.chunks_exact_mut(width).enumerate() {
                    let condition = chunk * CHUNK + i;
                    let value = kind.linearise(condition, points, gradient);
                    let places = &self.places[self.range(first + condition)];
                    let whole: f64 = gradient.iter().map(Vector3::length2).sum();
                    for (g, v) in gradient.iter_mut().zip(places) {
                        *g = mobility[v.index()].part(g);
                    }
                    let allowed: f64 = gradient.iter().map(Vector3::length2).sum();
                    free[i] = allowed > 0.0 && allowed.is_finite();
                    let length = if free[i] { allowed } else { whole }.sqrt();
                    let length = weight.map_or(length, |weight| 1.0 / weight);
                    let factor = if free[i] { 1.0 / length } else { 0.0 };
                    gradient.iter_mut().for_each(|g| *g = g.scaled(&factor));
                    if length > 0.0 && length.is_finite() {
                        lengths[i] = length;
                        residuals[i] = value / length;
                    }
                }
            });
        }
        Linearisation { gradients, residuals, lengths, free }
    }

    /// The residuals at other points, divided by the same lengths.
    pub fn residuals(&self, points: &[Point<f64>], lengths: &[f64]) -> Vec<f64> {
        let mut residuals = vec![0.0; self.rows()];
        for (kind, rows) in self.kinds() {
            let lengths = &lengths[rows.clone()];
            residuals[rows].par_iter_mut().enumerate().with_min_len(CHUNK).for_each(
                |(i, residual)| {
                    if lengths[i] > 0.0 {
                        *residual = kind.value(i, points) / lengths[i];
                    }
                },
            );
        }
        residuals
    }

    /// Whether all values are within their rounding: a few units in the last place of the sums of the sizes
    /// of their terms, beside what coordinates leave of a distance.
    pub fn is_rounding(&self, points: &[Point<f64>], at: &Linearisation, floor: f64) -> bool {
        let within = |(kind, rows): (&dyn Conditions, Range<usize>)| {
            let first = rows.start;
            rows.into_par_iter().with_min_len(CHUNK).all(|row| {
                let above = (at.residuals[row].abs() - floor) * at.lengths[row];
                above <= 16.0 * f64::EPSILON * kind.scale(row - first, points)
            })
        };
        self.kinds().all(within)
    }

    /// The worst condition of each kind.
    pub fn worst(&self, residuals: &[f64]) -> Vec<Worst> {
        let worst = |(kind, rows): (&dyn Conditions, Range<usize>)| {
            let sizes = residuals[rows].iter().map(|r| r.abs()).enumerate();
            let (condition, distance) =
                sizes.fold((0, 0.0), |worst, next| if next.1 > worst.1 { next } else { worst });
            Worst { name: kind.name(), at: kind.points(condition).to_vec(), distance }
        };
        self.kinds().map(worst).collect()
    }

    /// `Jᵀ y`, by points.
    pub fn transposed(&self, at: &Linearisation, y: &[f64], points: usize) -> Vec<Vector3<f64>> {
        let mut sum = vec![Vector3::new(0.0, 0.0, 0.0); points];
        for (row, y) in y.iter().enumerate() {
            for i in self.range(row) {
                let sum = &mut sum[self.places[i].index()];
                *sum = &*sum + &at.gradients[i].scaled(y);
            }
        }
        sum
    }

    /// `J x`, by rows.
    pub fn times(&self, at: &Linearisation, x: &[Vector3<f64>]) -> Vec<f64> {
        let rows = (0..self.rows()).into_par_iter().with_min_len(CHUNK);
        let row =
            |row| self.range(row).map(|i| at.gradients[i].dot(&x[self.places[i].index()])).sum();
        rows.map(row).collect()
    }
}

// Gradients of a condition fit on the stack of whoever asks for one of them.
const _: () = assert!(MOST_POINTS >= 12);
