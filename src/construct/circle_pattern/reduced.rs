//! The linear system of a Newton step, with the circles of small faces eliminated.
//!
//! A face circle meets only vertex circles, so its unknown is eliminated exactly and at once: half
//! of the unknowns are left, and a smoothing step on the rest is worth more.

use rayon::prelude::*;

use super::angles::{Circles, Linearised};
use super::sparse::Sparse;
use crate::mesh::{FaceId, HalfEdge, VertexId};

/// Which circle is which unknown; fixed for all steps.
pub(super) struct Reduced<'a> {
    circles: &'a Circles<'a>,
    /// The circles that are kept as unknowns.
    kept: Vec<u32>,
    /// The unknown of every circle, or `NONE`.
    unknown: Vec<u32>,
}

const NONE: u32 = u32::MAX;
/// A face of more corners is kept: its square of entries would be too large.
const MOST_CORNERS: usize = 16;
const CHUNK: usize = 1024;

impl<'a> Reduced<'a> {
    pub fn new(circles: &'a Circles<'a>) -> Self {
        let vertices = circles.topology.vertex_count();
        let is_kept = |circle: &u32| {
            let index = *circle as usize;
            let small = index >= vertices && {
                let face = FaceId((index - vertices) as u32);
                circles.topology.face(face).len() <= MOST_CORNERS
            };
            circles.asked[index].is_free() && !small
        };
        let kept: Vec<u32> = (0..circles.asked.len() as u32).filter(is_kept).collect();
        let mut unknown = vec![NONE; circles.asked.len()];
        (0u32..).zip(&kept).for_each(|(i, &circle)| unknown[circle as usize] = i);
        Reduced { circles, kept, unknown }
    }

    /// Matrix and right-hand side of the step.
    pub fn system(&self, at: &Linearised) -> (Sparse<f64>, Vec<f64>) {
        let rows: Vec<(Vec<(u32, f64)>, f64)> =
            self.kept.par_iter().with_min_len(CHUNK).map(|&circle| self.row(circle, at)).collect();
        let mut matrix = Sparse { starts: vec![0], columns: Vec::new(), values: Vec::new() };
        let mut right = Vec::with_capacity(rows.len());
        for (entries, value) in rows {
            for (column, entry) in entries {
                matrix.columns.push(column);
                matrix.values.push(entry);
            }
            matrix.starts.push(matrix.columns.len() as u32);
            right.push(value);
        }
        (matrix, right)
    }

    fn row(&self, circle: u32, at: &Linearised) -> (Vec<(u32, f64)>, f64) {
        let index = circle as usize;
        let own = self.unknown[index];
        let mut entries: Vec<(u32, f64)> = vec![(own, 0.0)];
        let mut right = at.excess[index];
        let mut add = |column: u32, value: f64| match entries.iter_mut().find(|e| e.0 == column) {
            Some(entry) => entry.1 += value,
            None => entries.push((column, value)),
        };
        let vertices = self.circles.topology.vertex_count();
        let weight = |h: HalfEdge| at.weights[h.0 as usize];
        if index >= vertices {
            for h in self.circles.topology.half_edges(FaceId((index - vertices) as u32)) {
                add(own, weight(h));
                let other = self.unknown[self.circles.ends(h).0];
                if other != NONE {
                    add(other, -weight(h));
                }
            }
            return (entries, right);
        }
        for &h in self.circles.at_vertex(VertexId(circle)) {
            add(own, weight(h));
            let (_, face) = self.circles.ends(h);
            if self.unknown[face] != NONE {
                add(self.unknown[face], -weight(h));
            } else if self.circles.asked[face].is_free() {
                let diagonal = self.diagonal(face, at);
                if diagonal > 0.0 {
                    let share = weight(h) / diagonal;
                    right += share * at.excess[face];
                    for other in self.corners(face) {
                        let column = self.unknown[self.circles.ends(other).0];
                        if column != NONE {
                            add(column, -share * weight(other));
                        }
                    }
                }
            }
        }
        (entries, right)
    }

    fn corners(&self, face: usize) -> impl Iterator<Item = HalfEdge> {
        let face = FaceId((face - self.circles.topology.vertex_count()) as u32);
        self.circles.topology.half_edges(face)
    }

    fn diagonal(&self, face: usize, at: &Linearised) -> f64 {
        self.corners(face).map(|h| at.weights[h.0 as usize]).sum()
    }

    /// The smallest sum of weights at a free circle: how firmly the angles hold it.
    pub fn stiffness(&self, at: &Linearised) -> f64 {
        let mut sums = vec![0.0; self.circles.asked.len()];
        for (corner, weight) in at.weights.iter().enumerate() {
            let (v, f) = self.circles.ends(HalfEdge(corner as u32));
            sums[v] += weight;
            sums[f] += weight;
        }
        let free = sums.iter().zip(&self.circles.asked).filter(|(_, asked)| asked.is_free());
        free.map(|(sum, _)| *sum).fold(f64::INFINITY, f64::min)
    }

    /// The step of all circles from that of the unknowns.
    pub fn expand(&self, x: &[f64], at: &Linearised) -> Vec<f64> {
        let step = |circle: usize| {
            if self.unknown[circle] != NONE {
                return x[self.unknown[circle] as usize];
            }
            if !self.circles.asked[circle].is_free() {
                return 0.0;
            }
            let known = |h: HalfEdge| {
                let unknown = self.unknown[self.circles.ends(h).0];
                if unknown == NONE { 0.0 } else { at.weights[h.0 as usize] * x[unknown as usize] }
            };
            let sum: f64 = self.corners(circle).map(known).sum();
            let diagonal = self.diagonal(circle, at);
            if diagonal > 0.0 { (at.excess[circle] + sum) / diagonal } else { 0.0 }
        };
        (0..self.circles.asked.len()).into_par_iter().with_min_len(CHUNK).map(step).collect()
    }
}
