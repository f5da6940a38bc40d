//! Triangle meshes: stars, and graphs over triangulations of the plane.

use proptest::prelude::*;

use super::combinatorics::{fan, points};
use super::number::{number, small};
use crate::construct::delaunay;
use crate::mesh::{FaceList, Mesh};
use crate::scalar::{Field, Rational, RationalField, Ring};
use crate::space::Point;

/// The star of one interior vertex of valence 3 to 7, wherever its points are: obtuse, folded in the
/// top view, with vertical triangles.
pub fn star<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    const MOST: usize = 7;
    (3..=MOST, points(MOST + 1)).prop_filter_map("a fan is a mesh", |(valence, mut points)| {
        let (vertices, faces) = fan(valence as u32, 1);
        points.truncate(vertices);
        Mesh::new(points, faces).ok()
    })
}

/// The most rows, and the most columns, of a patch.
const SIDE: usize = 3;

/// The triangles of a patch of quads, cut along the diagonal that `turned` asks for.
fn cut_patch(rows: usize, columns: usize, turned: impl Fn(usize, usize) -> bool) -> FaceList {
    let at = |i: usize, j: usize| (i * (columns + 1) + j) as u32;
    let mut faces = FaceList::new();
    for i in 0..rows {
        for j in 0..columns {
            let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let first = usize::from(turned(i, j));
            for k in [1, 2] {
                faces.push([0, k, k + 1].map(|corner| quad[(first + corner) % 4]));
            }
        }
    }
    faces
}

/// Graphs over translation-invariant lattices up to 3 × 3, spanned by any two vectors: all triangles
/// are congruent in the top view, and mostly obtuse; with any heights.
pub fn lattice<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let heights = prop::collection::vec(number::<Q>(), (SIDE + 1) * (SIDE + 1));
    (1..=SIDE, 1..=SIDE, [small::<Q>(), small(), small(), small()], heights).prop_filter_map(
        "the vectors are parallel",
        |(m, n, [a, b, c, d], heights)| {
            if Q::det2(&a, &b, &c, &d).is_zero() {
                return None;
            }
            let places = (0..=m as i64).flat_map(|i| (0..=n as i64).map(move |j| (i, j)));
            let point = |((i, j), z)| {
                let (i, j) = (Q::from_i64(i), Q::from_i64(j));
                Point::new(Q::dot([&i, &j], [&a, &c]), Q::dot([&i, &j], [&b, &d]), z)
            };
            let points = places.zip(heights).map(point).collect();
            Mesh::new(points, cut_patch(m, n, |_, _| false)).ok()
        },
    )
}

/// Graphs over square grids up to 3 × 3 with jittered vertices and random diagonals: embedded, and
/// hardly ever Delaunay.
pub fn jittered<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let places = prop::collection::vec((-4i64..=4, -4i64..=4), (SIDE + 1) * (SIDE + 1));
    let heights = prop::collection::vec(number(), (SIDE + 1) * (SIDE + 1));
    let diagonals = prop::collection::vec(any::<bool>(), SIDE * SIDE);
    (1..=SIDE, 1..=SIDE, places, heights, diagonals).prop_filter_map(
        "a grid is a mesh",
        |(m, n, places, heights, diagonals)| {
            // Within a quarter of the width of the grid, every quad stays convex.
            let at = |n: i64, d: i64| Q::from_ratio(17 * n + d, 17);
            let grid = (0..=m as i64).flat_map(|i| (0..=n as i64).map(move |j| (i, j)));
            let point = |(((i, j), (a, b)), z)| Point::new(at(i, a), at(j, b), z);
            let points = grid.zip(places).zip(heights).map(point).collect();
            Mesh::new(points, cut_patch(m, n, |i, j| diagonals[i * SIDE + j])).ok()
        },
    )
}

/// Graphs over the Delaunay triangulations of 4 to 12 random points, with any heights; points on
/// common circles are frequent.
pub fn delaunay_graph<Q: RationalField>() -> impl Strategy<Value = Mesh<Q>> {
    prop::collection::vec((-6i64..=6, -6i64..=6, number::<Rational>()), 4..=12).prop_filter_map(
        "points on a line, or on top of each other",
        |places| {
            let mut points: Vec<Point<Rational>> = Vec::new();
            for (x, y, z) in places {
                let point = Point::new(Rational::from_i64(x), Rational::from_i64(y), z);
                if !points.iter().any(|other| other.is_parallel_to(&point)) {
                    points.push(point);
                }
            }
            Some(delaunay(points).ok()?.map(Rational::convert))
        },
    )
}
