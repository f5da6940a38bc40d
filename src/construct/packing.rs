//! Circle packings with the combinatorics of the square grid (Fig. 6): the vertex circles of Koebe
//! meshes, with signed radii.
//!
//! Row `i` and column `j` of a patch of `rows × columns` quads has the index `i (columns + 1) + j`,
//! as in [`quad_patch`](super::quad_patch()).

use std::fmt;

use crate::mesh::{FaceId, VertexId};
use crate::scalar::Field;
use crate::space::{OrientedCircle, Rotation, TopView, Vector2};

/// Why an inversion gives no packing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThroughCentre {
    /// The circle of this vertex passes through the centre: its image is a line.
    Vertex(VertexId),
    /// The circle of this face passes through the centre: the face would be vertical.
    Face(FaceId),
}

impl fmt::Display for ThroughCentre {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let element = match self {
            ThroughCentre::Vertex(v) => format!("vertex {}", v.0),
            ThroughCentre::Face(face) => format!("face {}", face.0),
        };
        write!(f, "the circle of {element} passes through the centre of the inversion")
    }
}

impl std::error::Error for ThroughCentre {}

/// Equal circles of radius 1/2 about the points `(i, j)` of the square grid.
pub fn square_packing<T: Field>(rows: usize, columns: usize) -> Vec<OrientedCircle<T>> {
    let number = |n: usize| T::from_i64(n as i64);
    let circle = |i, j| OrientedCircle {
        centre: TopView::new(number(i), number(j)),
        radius: T::from_ratio(1, 2),
    };
    grid(rows, columns).map(|(i, j)| circle(i, j)).collect()
}

/// Circles about the points at radius `qᵏ` on rays with the angle `2jφ`, with the radii `s qᵏ`, where
/// `c = cos φ`, `s = sin φ` and `q = (1 + s)/(1 − s)`.
///
/// Ring `k` is row `k`, ray `j` is column `j`. The sector stays open, also where the last ray
/// meets the first.
///
/// `None` where `s` is 0 or ±1, or so are rays on top of each other.
pub fn polar_packing<T: Field>(
    rings: usize,
    sectors: usize,
    half_sector: &Rotation<T>,
) -> Option<Vec<OrientedCircle<T>>> {
    let sine = half_sector.sin();
    if sine.is_zero() {
        return None;
    }
    let radii = powers(&ring_ratio(half_sector)?, rings);
    let rays = rays(&half_sector.then(half_sector), sectors);
    let circle = |k: usize, j: usize| OrientedCircle {
        centre: TopView::new(&radii[k] * &rays[j].x, &radii[k] * &rays[j].y),
        radius: &radii[k] * sine,
    };
    Some(grid(rings, sectors).map(|(k, j)| circle(k, j)).collect())
}

/// The images of circles under the inversion `p ↦ c + (p − c)/|p − c|²`, with signed radii.
///
/// # Errors
/// The first circle that passes through the centre c.
pub fn inverted_packing<T: Field>(
    circles: &[OrientedCircle<T>],
    centre: &TopView<T>,
) -> Result<Vec<OrientedCircle<T>>, ThroughCentre> {
    let through = |i: usize| ThroughCentre::Vertex(VertexId(i as u32));
    let image = |(i, circle): (usize, &OrientedCircle<T>)| {
        circle.inverted(centre).ok_or_else(|| through(i))
    };
    circles.iter().enumerate().map(image).collect()
}

/// `(1 + s)/(1 − s)`: the ratio of consecutive rings of touching circles; `None` if s is ±1.
pub(super) fn ring_ratio<T: Field>(half_sector: &Rotation<T>) -> Option<T> {
    let (one, sine) = (T::one(), half_sector.sin());
    let (outer, inner) = (&one + sine, one - sine);
    if outer.is_zero() { None } else { outer.try_div(&inner) }
}

/// `1, q, q², …, q^last`.
pub(super) fn powers<T: Field>(ratio: &T, last: usize) -> Vec<T> {
    std::iter::successors(Some(T::one()), |power| Some(power * ratio)).take(last + 1).collect()
}

/// The unit vectors that arise from `(1, 0)` by turning on and on.
pub(super) fn rays<T: Field>(turn: &Rotation<T>, last: usize) -> Vec<Vector2<T>> {
    let first = Vector2::new(T::one(), T::zero());
    std::iter::successors(Some(first), |ray| Some(turn.turn(ray))).take(last + 1).collect()
}

/// Rows and columns of the vertices of a patch, in their order.
pub(super) fn grid(rows: usize, columns: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=rows).flat_map(move |i| (0..=columns).map(move |j| (i, j)))
}
