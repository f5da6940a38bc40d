//! The linear system of a Newton step, with the circles of small faces eliminated.
//!
//! A face circle meets only vertex circles, so its unknown is eliminated exactly and at once: half
//! of the unknowns are left, and a smoothing step on the rest is worth more.

use rayon::prelude::*;

use super::angles::{Circles, Linearised};
use super::sparse::Sparse;
use crate::mesh::{FaceId, HalfEdge, VertexId};

/// Which circle is which unknown, and where in the matrix the corners of each face go; fixed for all
/// steps.
pub(super) struct Reduced<'a> {
    circles: &'a Circles<'a>,
    /// The unknown of every circle, or `NONE`.
    unknown: Vec<u32>,
    /// The pattern of the matrix; every row begins with the diagonal.
    pattern: Sparse<()>,
    /// For every face the places of its pairs of unknown vertices, one face after the other: for
    /// eliminated faces all ordered pairs, for others the pairs with the face itself, both ways.
    places: Vec<u32>,
}

const NONE: u32 = u32::MAX;
/// A face of more corners is kept: its square of entries would be too large.
const MOST_CORNERS: usize = 16;
const CHUNK: usize = 1024;

impl<'a> Reduced<'a> {
    pub fn new(circles: &'a Circles<'a>) -> Self {
        let vertices = circles.topology.vertex_count();
        let mut unknown = vec![NONE; circles.asked.len()];
        let mut count = 0;
        for (circle, unknown) in unknown.iter_mut().enumerate() {
            let small = circle >= vertices && {
                let face = FaceId((circle - vertices) as u32);
                circles.topology.face(face).len() <= MOST_CORNERS
            };
            if circles.asked[circle].is_free() && !small {
                *unknown = count;
                count += 1;
            }
        }
        let mut rows: Vec<Vec<u32>> = (0..count).map(|own| vec![own]).collect();
        let mut reduced = Reduced {
            circles,
            unknown,
            pattern: Sparse { starts: vec![0], columns: Vec::new(), values: Vec::new() },
            places: Vec::new(),
        };
        // Places within the rows first.
        let mut within = Vec::new();
        reduced.pairs(|row, column| {
            let row = &mut rows[row as usize];
            let place = row.iter().position(|&c| c == column);
            within.push(place.unwrap_or(row.len()) as u32);
            if place.is_none() {
                row.push(column);
            }
        });
        for row in rows {
            reduced.pattern.columns.extend(row);
            reduced.pattern.starts.push(reduced.pattern.columns.len() as u32);
        }
        let mut places = Vec::with_capacity(within.len());
        let mut within = within.into_iter();
        reduced.pairs(|row, _| {
            let start = reduced.pattern.starts[row as usize];
            places.extend(within.next().map(|place| start + place));
        });
        reduced.places = places;
        reduced
    }

    /// The unknown vertices of a face, with their corners.
    fn unknown_corners(&self, face: FaceId) -> impl Iterator<Item = (u32, HalfEdge)> + Clone {
        let topology = self.circles.topology;
        let first = topology.half_edges(face).next().map_or(0, |h| h.0);
        let unknown = |(v, corner): (&VertexId, u32)| {
            let unknown = self.unknown[v.index()];
            (unknown != NONE).then_some((unknown, HalfEdge(corner)))
        };
        topology.face(face).iter().zip(first..).filter_map(unknown)
    }

    /// Row and column of every entry that a face adds to, always in the same order.
    fn pairs(&self, mut add: impl FnMut(u32, u32)) {
        for face in self.circles.topology.faces() {
            let circle = self.circles.of_face(face);
            let (own, corners) = (self.unknown[circle], self.unknown_corners(face));
            if own != NONE {
                for (vertex, _) in corners {
                    add(own, vertex);
                    add(vertex, own);
                }
            } else if self.circles.asked[circle].is_free() {
                for (row, _) in corners.clone() {
                    corners.clone().for_each(|(column, _)| add(row, column));
                }
            }
        }
    }

    /// Matrix and right-hand side of the step.
    pub fn system(&self, at: &Linearised) -> (Sparse<f64>, Vec<f64>) {
        let pattern = &self.pattern;
        let mut values = vec![0.0; pattern.columns.len()];
        let mut right = vec![0.0; pattern.rows()];
        for (circle, &unknown) in self.unknown.iter().enumerate() {
            if unknown != NONE {
                right[unknown as usize] = at.excess[circle];
            }
        }
        let mut places = self.places.iter().map(|&place| place as usize);
        let mut next = move || places.next().unwrap_or_default();
        let diagonal = |unknown: u32| pattern.starts[unknown as usize] as usize;
        for face in self.circles.topology.faces() {
            let circle = self.circles.of_face(face);
            let corners = self.unknown_corners(face);
            let weight = |h: HalfEdge| at.weights[h.0 as usize];
            let total: f64 = self.circles.topology.half_edges(face).map(weight).sum();
            corners.clone().for_each(|(vertex, h)| values[diagonal(vertex)] += weight(h));
            if self.unknown[circle] != NONE {
                values[diagonal(self.unknown[circle])] += total;
                for (_, h) in corners {
                    values[next()] -= weight(h);
                    values[next()] -= weight(h);
                }
            } else if self.circles.asked[circle].is_free() {
                let inverse = if total > 0.0 { total.recip() } else { 0.0 };
                for (row, h) in corners.clone() {
                    let share = weight(h) * inverse;
                    right[row as usize] += share * at.excess[circle];
                    for (_, other) in corners.clone() {
                        values[next()] -= share * weight(other);
                    }
                }
            }
        }
        let (starts, columns) = (pattern.starts.clone(), pattern.columns.clone());
        (Sparse { starts, columns, values }, right)
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
