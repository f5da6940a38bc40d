//! Faces in an order and with diagonals that depend on the points alone.

use rayon::prelude::*;

use super::sphere::{Half, Sphere, next};

/// The triangles by rank, each from its lowest, in lexicographic order.
///
/// Triangles joined by `ties` have one circumcircle; together they fill a convex polygon, which is
/// cut again by the diagonals from its lowest vertex.
pub(super) fn canonical_faces(sphere: &Sphere, ties: &[Half]) -> Vec<[u32; 3]> {
    let mut tied = vec![false; if ties.is_empty() { 0 } else { sphere.len() as usize }];
    for &h in ties {
        tied[h as usize] = true;
        tied[sphere.twin(h) as usize] = true;
    }
    let is_tied = |h: Half| tied.get(h as usize) == Some(&true);
    let mut done = vec![false; sphere.len() as usize / 3];
    let mut faces = Vec::with_capacity(done.len());
    for h in 0..sphere.len() {
        if done[h as usize / 3] || is_tied(h) {
            continue;
        }
        done[h as usize / 3] = true;
        let triangle = sphere.triangle(h);
        if triangle.contains(&sphere.infinity()) {
            continue;
        }
        let sides = [h, next(h), next(next(h))];
        if !sides.into_iter().any(is_tied) {
            faces.push(from_lowest(triangle));
            continue;
        }
        // Around the polygon: past tied edges to the next side.
        let mut polygon = vec![sphere.origin(h)];
        let mut side = h;
        loop {
            side = next(side);
            while is_tied(side) {
                side = next(sphere.twin(side));
                done[side as usize / 3] = true;
            }
            if side == h {
                break;
            }
            polygon.push(sphere.origin(side));
        }
        let lowest = (0..polygon.len()).min_by_key(|&i| polygon[i]).unwrap_or(0);
        polygon.rotate_left(lowest);
        faces.extend(polygon[1..].windows(2).map(|side| [polygon[0], side[0], side[1]]));
    }
    faces.par_sort_unstable();
    faces
}

fn from_lowest([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
