//! What the sheets of figures share: meshes in space, top views, circles.

use super::draw::{Color, Item, Model, Paint, Stroke, View, painted};
use crate::mesh::Mesh;
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

/// A mesh with both sides of its faces.
pub(super) fn solid<T: Approx>(mesh: &Mesh<T>) -> Model {
    let mut model = Model::default();
    model.add_mesh(mesh, EDGE, |_| SURFACE);
    model
}

/// A model from where the viewer stands; its heights are scaled so that it is `rise` times as high as
/// it is wide.
pub(super) fn seen(model: Model, viewer: [f64; 3], rise: f64) -> Vec<Item> {
    let extent = |axis: usize| {
        let values = model.points().map(move |p| p[axis]);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let (wide, high) = (extent(0).max(extent(1)), extent(2));
    let steep = if high > 0.0 { rise * wide / high } else { 1.0 };
    painted(&model.map(|[x, y, z]| [x, y, steep * z]), &View::from(viewer))
}

/// Points on a circle of radius 1, the last the first.
pub(super) fn round() -> impl Iterator<Item = [f64; 2]> {
    const STEPS: i32 = 12;
    let quarter = |turn: i32| {
        (0..STEPS).map(move |k| {
            let t = f64::from(k) / f64::from(STEPS);
            let (c, s) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
            [[c, s], [-s, c], [-c, -s], [s, -c]][turn as usize % 4]
        })
    };
    (0..4).flat_map(quarter).chain([[1.0, 0.0]])
}

/// The top view of a mesh: its edges.
pub(super) fn top_view<T: Approx>(mesh: &Mesh<T>) -> Vec<Item> {
    painted(&flat(mesh), &View::TOP)
}

/// The edges of a mesh in the plane of its top view.
pub(super) fn flat<T: Approx>(mesh: &Mesh<T>) -> Model {
    let mut model = Model::default();
    model.add_mesh(mesh, THIN, |_| Paint::Wire);
    model.map(|[x, y, _]| [x, y, 0.0])
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
