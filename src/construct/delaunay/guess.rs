//! spade as a guess: which triangles rounded places would make.

use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation};

use super::sphere::{Half, Sphere, next, prev};

/// A place and its rank.
struct Place {
    at: Point2<f64>,
    rank: u32,
}

impl HasPosition for Place {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.at
    }
}

/// The triangulation of the rounded places, without some of those that fall together.
///
/// Nothing of it is believed. `None` where there is no triangle.
pub(super) fn triangulation(near: &[[f64; 2]]) -> Option<Sphere> {
    // spade takes 0 and sizes from 2^-142.
    let cut = |c: f64| if c < f64::from(f32::MIN_POSITIVE) { 0.0 } else { c };
    let place = |(rank, &[x, y]): (usize, &[f64; 2])| Place {
        at: Point2::new(cut(x), cut(y)),
        rank: rank as u32,
    };
    let places = near.iter().enumerate().map(place).collect();
    let guess = DelaunayTriangulation::<Place>::bulk_load(places).ok()?;
    if guess.num_inner_faces() == 0 {
        return None;
    }
    let mut sphere = Sphere::empty(near.len());
    let infinity = sphere.infinity();
    // Our half-edge for each of spade's.
    let mut ours: Vec<Half> = vec![0; guess.num_directed_edges()];
    for face in guess.inner_faces() {
        let edges = face.adjacent_edges();
        let first = sphere.push(edges.map(|e| e.from().data().rank));
        for (i, e) in edges.iter().enumerate() {
            ours[e.index()] = first + i as u32;
        }
    }
    let outer: Vec<_> = guess.directed_edges().filter(|e| e.is_outer_edge()).collect();
    let mut from_infinity = vec![0; near.len()];
    for e in &outer {
        let first = sphere.push([e.from().data().rank, e.to().data().rank, infinity]);
        ours[e.index()] = first;
        from_infinity[e.from().data().rank as usize] = prev(first);
    }
    for e in guess.directed_edges() {
        sphere.join(ours[e.index()], ours[e.rev().index()]);
    }
    for e in &outer {
        sphere.join(next(ours[e.index()]), from_infinity[e.to().data().rank as usize]);
    }
    Some(sphere)
}
