//! Fig. 3: a circle pattern and the mesh of its centres.

use super::draw::{Anchor, Color, Item, Scene, Stroke};
use super::nets::{inverted_net, polynomial, profile};
use super::sheet::{CIRCLE, top_view};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::{lift, metric_dual};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational};
use crate::space::{Circle, Point};

pub(super) const FIGURE: Figure = Figure {
    number: 3,
    title: "a circle pattern and the mesh of its centres",
    caption: "Left: the top view of an i-circular mesh, the image of the net z = x^2/8 - y^2/6 over \
              9 by 8 lines at distance 1 about 0 under the inversion at (-3/2, -15/2, 0) with r^2 = 64, and \
              the circumcircles of its faces. Right: the centres of these circles form the top view of \
              an i-conical mesh, the metric dual of the mesh over the pattern that is inscribed to the \
              unit i-sphere.",
    claims: &["eq-13-circular", "eq-14-conical", "thm-2-dual", "thm-2-f"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let one = Rational::from_ratio(1, 1);
    let f = profile(8, &one, polynomial(&[(0, 1), (0, 1), (1, 8)]));
    let g = profile(7, &one, polynomial(&[(0, 1), (0, 1), (-1, 6)]));
    let mesh = inverted_net(&f, &g, [(-3, 2), (-15, 2), (0, 1)], 64)?;
    let lifted = lift(&mesh);
    let centres = metric_dual(&lifted).map_err(NoFigure::of)?;
    let mut scene = Scene::new(160.0, 71.0);
    let mut left = circumcircles(&mesh, CIRCLE)?;
    left.extend(top_view(&mesh));
    scene.place(left, [2.0, 9.0], [76.0, 60.0]);
    let mut right = circumcircles(&mesh, Stroke::new(Color::CIRCLE.mixed(Color::WHITE, 0.6), 0.1))?;
    right.extend(top_view(&centres));
    right.extend(dots(&centres));
    scene.place(right, [82.0, 9.0], [76.0, 60.0]);
    scene.text([40.0, 3.0], 3.0, Anchor::Middle, "i-circular");
    scene.text([120.0, 3.0], 3.0, Anchor::Middle, "i-conical");
    let circular = Exhibit::new("i-circular", mesh)
        .is(&[Property::Planar, Property::ICircular])
        .with("inscribed", &[PairProperty::VParallel]);
    let inscribed = Exhibit::new("inscribed", lifted).is(&[Property::Planar, Property::Inscribed]);
    let conical = Exhibit::new("i-conical", centres).is(&[
        Property::Planar,
        Property::IConical,
        Property::Circumscribed,
    ]);
    Ok(Plate { exhibits: vec![circular, inscribed, conical], scene })
}

/// The circumcircles of the top views of faces.
fn circumcircles(mesh: &Surface, stroke: Stroke) -> Result<Vec<Item>, NoFigure> {
    let circle = |face| {
        let [a, b, c, ..] = mesh.topology.face(face) else {
            return Err(NoFigure::Construction("a face of two corners".into()));
        };
        let [a, b, c] = [a, b, c].map(|v| mesh.points[v.index()].top_view());
        let Circle { centre, radius2 } = Circle::through(&a, &b, &c).map_err(NoFigure::of)?;
        let center = [centre.x.to_f64(), centre.y.to_f64()];
        let radius = radius2.to_f64().sqrt();
        Ok(Item::Circle { center, radius, fill: None, stroke: Some(stroke) })
    };
    mesh.topology.faces().map(circle).collect()
}

/// The vertices in the top view.
fn dots(mesh: &Surface) -> Vec<Item> {
    let dot = |p: &Point<Rational>| Item::Circle {
        center: [p.x.to_f64(), p.y.to_f64()],
        radius: 1.0 / 24.0,
        fill: Some(Color::INK),
        stroke: None,
    };
    mesh.points.iter().map(dot).collect()
}
