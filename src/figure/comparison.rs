//! A mesh before and after.

use super::draw::{Anchor, Scene, svg};
use super::sheet::{seen, solid, top_view};
use crate::mesh::Mesh;
use crate::scalar::Approx;

/// Two meshes side by side as SVG: seen from the front, and below their top views.
pub fn comparison<T: Approx>(before: &Mesh<T>, after: &Mesh<T>) -> String {
    let mut scene = Scene::new(160.0, 140.0);
    for (mesh, x, label) in [(before, 2.0, "before"), (after, 82.0, "after")] {
        scene.place(seen(solid(mesh), [3.0, -5.0, 4.0], 0.4), [x, 76.0], [76.0, 62.0]);
        scene.place(top_view(mesh), [x, 8.0], [76.0, 62.0]);
        scene.text([x + 38.0, 3.0], 3.0, Anchor::Middle, label);
    }
    svg(&scene, "before and after")
}
