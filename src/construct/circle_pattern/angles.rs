//! The angles of a circle pattern as functions of the logarithms of the radii.
//!
//! Every corner of a face is a kite between the centres of a vertex circle and a face circle, with
//! right angles where the two circles cross: half of it has the angle `arctan(ρ/r)` at the vertex and
//! `arctan(r/ρ)` at the face. With `x` the logarithm of the radius, the sums of these half angles are
//! the gradient of a convex function (Bobenko and Springborn 2004), and its second derivative is a
//! graph Laplacian with the weights `1/(2 cosh(x_f − x_v))`.

use std::f64::consts::FRAC_PI_2;

use rayon::prelude::*;

use crate::mesh::{FaceId, HalfEdge, Topology, VertexId};

/// What is asked of the circle of a vertex or of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CircleCondition {
    /// It has this radius.
    Radius(f64),
    /// The kites at its centre have this angle together: 2π where they close.
    Angle(f64),
    /// It is a straight line: an angle π of every neighbour is taken.
    Line,
}

impl CircleCondition {
    /// Whether its radius is to be found.
    pub(super) fn is_free(self) -> bool {
        matches!(self, CircleCondition::Angle(_))
    }
}

/// The circles of a mesh, vertices first, then faces.
pub(super) struct Circles<'a> {
    pub topology: &'a Topology,
    pub asked: Vec<CircleCondition>,
    /// `corners[starts[v]..starts[v + 1]]` are the corners at a vertex, in order.
    starts: Vec<u32>,
    corners: Vec<HalfEdge>,
}

/// The state at given radii.
pub(super) struct Linearised {
    /// `½ (angle − angle asked)` at every free circle, 0 at the others.
    pub excess: Vec<f64>,
    /// The weight of every corner.
    pub weights: Vec<f64>,
}

impl<'a> Circles<'a> {
    pub fn new(topology: &'a Topology, asked: Vec<CircleCondition>) -> Self {
        let mut starts = vec![0u32; topology.vertex_count() + 1];
        let corners = || topology.faces().flat_map(|f| topology.half_edges(f));
        corners().for_each(|h| starts[topology.origin(h).index() + 1] += 1);
        (0..topology.vertex_count()).for_each(|v| starts[v + 1] += starts[v]);
        let mut next = starts.clone();
        let mut sorted = vec![HalfEdge(0); topology.corner_count()];
        for h in corners() {
            let at = &mut next[topology.origin(h).index()];
            sorted[*at as usize] = h;
            *at += 1;
        }
        Circles { topology, asked, starts, corners: sorted }
    }

    /// The corners at a vertex.
    pub fn at_vertex(&self, v: VertexId) -> &[HalfEdge] {
        let v = v.index();
        &self.corners[self.starts[v] as usize..self.starts[v + 1] as usize]
    }

    /// The two circles of a corner: of the vertex and of the face.
    pub fn ends(&self, corner: HalfEdge) -> (usize, usize) {
        (self.topology.origin(corner).index(), self.of_face(self.topology.face_at(corner)))
    }

    /// The number of the circle of a face.
    pub fn of_face(&self, face: FaceId) -> usize {
        self.topology.vertex_count() + face.index()
    }

    /// The half angles of a kite at the vertex and at the face, and its weight.
    pub fn kite(&self, corner: HalfEdge, x: &[f64]) -> [f64; 3] {
        let (v, f) = self.ends(corner);
        match (self.asked[v], self.asked[f]) {
            (CircleCondition::Line, CircleCondition::Line) => [0.0; 3],
            (CircleCondition::Line, _) => [0.0, FRAC_PI_2, 0.0],
            (_, CircleCondition::Line) => [FRAC_PI_2, 0.0, 0.0],
            _ => {
                let ratio = (x[v] - x[f]).exp();
                let small = ratio.min(ratio.recip());
                let at_face = ratio.atan();
                [FRAC_PI_2 - at_face, at_face, small / (1.0 + small * small)]
            }
        }
    }

    /// The system of the harmonic function with the values x at the given radii, as a step from x:
    /// all weights are those of equal radii.
    pub fn harmonic(&self, x: &[f64]) -> Linearised {
        let corners = (0..self.topology.corner_count() as u32).map(HalfEdge);
        let line = |circle: usize| self.asked[circle] == CircleCondition::Line;
        let mut excess = vec![0.0; x.len()];
        let mut weights = Vec::with_capacity(self.topology.corner_count());
        for (v, f) in corners.map(|h| self.ends(h)) {
            let weight = if line(v) || line(f) { 0.0 } else { 0.5 };
            let pull = weight * (x[f] - x[v]);
            excess[v] += pull;
            excess[f] -= pull;
            weights.push(weight);
        }
        for (excess, asked) in excess.iter_mut().zip(&self.asked) {
            if !asked.is_free() {
                *excess = 0.0;
            }
        }
        Linearised { excess, weights }
    }

    /// Excess angles and weights for the logarithms x of the radii.
    pub fn linearise(&self, x: &[f64]) -> Linearised {
        let corners = (0..self.topology.corner_count() as u32).into_par_iter();
        let kites: Vec<[f64; 3]> =
            corners.with_min_len(CHUNK).map(|c| self.kite(HalfEdge(c), x)).collect();
        let half = |circle: usize| match self.asked[circle] {
            CircleCondition::Angle(angle) => Some(angle / 2.0),
            CircleCondition::Radius(_) | CircleCondition::Line => None,
        };
        let vertices = self.topology.vertex_count();
        let excess = |circle: usize| {
            let Some(half) = half(circle) else { return 0.0 };
            let found: f64 = if circle < vertices {
                let corners = self.at_vertex(VertexId(circle as u32));
                corners.iter().map(|h| kites[h.0 as usize][0]).sum()
            } else {
                let corners = self.topology.half_edges(FaceId((circle - vertices) as u32));
                corners.map(|h| kites[h.0 as usize][1]).sum()
            };
            found - half
        };
        let circles = (0..self.asked.len()).into_par_iter().with_min_len(CHUNK);
        let excess = circles.map(excess).collect();
        let weights = kites.par_iter().with_min_len(CHUNK).map(|kite| kite[2]).collect();
        Linearised { excess, weights }
    }
}

const CHUNK: usize = 4096;
