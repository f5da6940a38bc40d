//! i-Koebe meshes: all edges touch the unit i-sphere.

use proptest::prelude::*;

use super::number::{proper, small};
use super::planar::is_graph;
use crate::construct::{inverted_packing, koebe_mesh, polar_packing, quad_patch, square_packing};
use crate::mesh::Mesh;
use crate::scalar::Field;
use crate::space::{Rotation, TopView};

/// i-Koebe meshes up to 3 × 3 with the signed radii of their vertex circles: over square and polar
/// packings, inverted at a random centre or not.
///
/// All faces have planes with a gradient. Circles that an inversion turned over have negative radii.
pub fn koebe<Q: Field>() -> impl Strategy<Value = Mesh<Q>> {
    let centre = prop::option::of([small(), small()]);
    (1usize..=3, 1usize..=3, prop::option::of(proper()), centre).prop_filter_map(
        "a circle through the centre",
        |(m, n, half_sector, centre)| {
            let packing = match half_sector {
                None => square_packing(m, n),
                Some(t) => polar_packing(m, n, &Rotation::from_parameter(&t).ok()?)?,
            };
            let circles = match centre {
                None => packing,
                Some([x, y]) => inverted_packing(&packing, &TopView::new(x, y)).ok()?,
            };
            let mesh = koebe_mesh(circles, quad_patch(m, n)).ok()?;
            is_graph(&mesh).then_some(mesh)
        },
    )
}
