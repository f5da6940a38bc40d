//! Fig. 6: the two circle packings over an i-isothermic mesh.

use super::draw::{Item, Scene};
use super::sheet::{CIRCLE, OTHER, circles, round, seen, solid, top_view};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::{
    face_circle, inverted_packing, koebe_mesh, quad_patch, square_packing, vertex_circles,
};
use crate::net::Property;
use crate::scalar::{Approx, Field, Rational};
use crate::space::{OrientedCircle, TopView};

pub(super) const FIGURE: Figure = Figure {
    number: 6,
    title: "the two circle packings of an i-isothermic mesh",
    caption: "The circles of radius 1/2 about (i, j), 0 <= i <= 8, 0 <= j <= 6, inverted at (4, -5/2), moved \
              to the middle and taken eight times as large. Left: the top view of the Koebe mesh over them, and the \
              incircles of its faces, which touch where edges touch the unit i-sphere. Middle: with \
              the circles about the vertices, which touch in the same points and meet the others at \
              right angles. Right: the mesh, and where its faces cut the unit i-sphere.",
    claims: &["thm-3", "koebe-edge", "koebe-vertex"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let centre = TopView::new(q(4, 1), q(-5, 2));
    let packing = inverted_packing(&square_packing(8, 6), &centre).map_err(NoFigure::of)?;
    let (middle, scale) = (TopView::new(q(4, 1), q(-9, 4)), q(8, 1));
    let large = |circle: OrientedCircle<Rational>| {
        let from_middle = (&circle.centre - &middle).scaled(&scale);
        let centre = TopView::new(from_middle.x, from_middle.y);
        OrientedCircle { centre, radius: circle.radius * &scale }
    };
    let mesh = koebe_mesh(packing.into_iter().map(large).collect(), quad_patch(8, 6))?;
    let faces: Option<Vec<OrientedCircle<Rational>>> =
        mesh.topology.faces().map(|face| face_circle(&mesh, face).ok().flatten()).collect();
    let faces = faces.ok_or(NoFigure::Construction("a face without a circle".into()))?;
    let vertices = vertex_circles(&mesh).unwrap_or_default();
    let mut scene = Scene::new(160.0, 46.0);
    let mut left = top_view(&mesh);
    left.extend(circles(&faces, CIRCLE));
    scene.place(left, [2.0, 2.0], [50.0, 42.0]);
    let mut middle = circles(&vertices, OTHER);
    middle.extend(circles(&faces, CIRCLE));
    scene.place(middle, [55.0, 2.0], [50.0, 42.0]);
    scene.place(in_space(&mesh, &faces), [108.0, 2.0], [50.0, 42.0]);
    let exhibit = Exhibit::new("koebe", mesh).is(&[
        Property::Planar,
        Property::Midscribed,
        Property::IIsothermic,
    ]);
    Ok(Plate { exhibits: vec![exhibit], scene })
}

/// The mesh with the i-circles over the incircles of its faces.
fn in_space(mesh: &Surface, faces: &[OrientedCircle<Rational>]) -> Vec<Item> {
    let mut model = solid(mesh);
    for circle in faces {
        let [x, y, r] = [&circle.centre.x, &circle.centre.y, &circle.radius].map(Approx::to_f64);
        let on_sigma = |[c, s]: [f64; 2]| {
            let (x, y) = (x + r * c, y + r * s);
            [x, y, (x * x + y * y) / 2.0]
        };
        model.add_line(round().map(on_sigma), CIRCLE);
    }
    seen(model, [1.5, -4.0, 5.0], 0.4)
}
