//! What the sheets of figures share: meshes in space, top views, circles.

use super::Surface;
use super::draw::{Color, Item, Model, Paint, Stroke, View, painted};
use crate::scalar::{Approx, Rational};
use crate::space::OrientedCircle;

/// The edges of meshes in space.
pub(super) const EDGE: Stroke = Stroke::new(Color::INK, 0.15);
/// The edges of top views.
pub(super) const THIN: Stroke = Stroke::new(Color::INK, 0.12);
/// Circles.
pub(super) const CIRCLE: Stroke = Stroke::new(Color::CIRCLE, 0.14);
/// Circles of a second family.
pub(super) const OTHER: Stroke = Stroke::new(Color::OTHER_CIRCLE, 0.14);
/// Both sides of a surface.
pub(super) const SURFACE: Paint = Paint::Sides([Color::FRONT, Color::BACK]);

/// A mesh in space, seen from where the viewer stands; heights are taken `steep` times.
pub(super) fn spatial(mesh: &Surface, viewer: [f64; 3], steep: f64) -> Vec<Item> {
    let mut model = Model::default();
    model.add_mesh(mesh, EDGE, |_| SURFACE);
    painted(&model.map(|[x, y, z]| [x, y, steep * z]), &View::from(viewer))
}

/// The top view of a mesh: its edges.
pub(super) fn top_view(mesh: &Surface) -> Vec<Item> {
    let mut model = Model::default();
    model.add_mesh(mesh, THIN, |_| Paint::Wire);
    painted(&model.map(|[x, y, _]| [x, y, 0.0]), &View::TOP)
}

/// Circles of the top view.
pub(super) fn circles(circles: &[OrientedCircle<Rational>], stroke: Stroke) -> Vec<Item> {
    let one = |circle: &OrientedCircle<Rational>| Item::Circle {
        center: [circle.centre.x.to_f64(), circle.centre.y.to_f64()],
        radius: circle.radius.to_f64().abs(),
        fill: None,
        stroke: Some(stroke),
    };
    circles.iter().map(one).collect()
}
