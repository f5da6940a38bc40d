//! Planar meshes: nets of quads, and meshes of n-gons.

use proptest::prelude::*;

use super::combinatorics::points;
use super::number::{nonzero, number};
use super::triangles::{delaunay_graph, star};
use crate::construct::{metric_dual, quad_patch};
use crate::mesh::Mesh;
use crate::scalar::{Field, RationalField};

/// The most rows, and the most columns, of a patch.
const SIDE: usize = 3;

/// Planar quads with the combinatorics of the square grid, up to 3 × 3.
///
/// Two polygons are free; each further vertex is `a + α(b − a) + β(c − a)` in the plane of its three
/// neighbours. Faces may be folded, vertical or of area 0.
pub fn quad_patches<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let factors = prop::collection::vec((nonzero(), number()), SIDE * SIDE);
    (1..=SIDE, 1..=SIDE, points(SIDE + 1), points(SIDE), factors).prop_filter_map(
        "a patch is a mesh",
        |(m, n, rows, columns, factors)| {
            let width = n + 1;
            let mut points = vec![rows[0].clone()];
            points.extend(columns.into_iter().take(n));
            for (i, start) in rows.into_iter().enumerate().take(m + 1).skip(1) {
                points.push(start);
                for j in 1..width {
                    let (alpha, beta) = &factors[(i - 1) * SIDE + j - 1];
                    let at = points.len();
                    let corner = &points[at - width - 1];
                    let (u, v) = (&points[at - 1] - corner, &points[at - width] - corner);
                    let fourth = &(corner + &u.scaled(alpha)) + &v.scaled(beta);
                    points.push(fourth);
                }
            }
            Mesh::new(points, quad_patch(m, n)).ok()
        },
    )
}

/// Whether all faces have planes, and none is vertical.
pub(super) fn is_graph<Q: Field>(mesh: &Mesh<Q>) -> bool {
    mesh.topology.faces().all(|face| mesh.face_plane(face).is_ok())
}

/// Planar meshes of n-gons of any size: the metric duals of triangle meshes, whose vertices become
/// faces.
///
/// From one star there comes one face; from a Delaunay triangulation a patch, mostly of hexagons.
/// Vertices have valence 3, faces may cross themselves.
pub fn polygons<Q: RationalField>() -> impl Strategy<Value = Mesh<Q>> {
    prop_oneof![star(), delaunay_graph()]
        .prop_filter_map("a triangle with a collinear top view", |mesh| metric_dual(&mesh).ok())
}
