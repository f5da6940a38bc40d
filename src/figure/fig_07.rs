//! Fig. 7: quads with mixed area zero, and a Christoffel pair.

use super::draw::{Anchor, Color, Item, Model, Paint, Scene, Stroke, View, painted};
use super::sheet::{CIRCLE, OTHER, THIN, circles};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::{
    christoffel_by_radii, face_circle, inverted_packing, koebe_mesh, quad_patch, square_packing,
    vertex_circles,
};
use crate::mesh::{FaceList, Mesh};
use crate::net::{Property, RADIUS};
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational};
use crate::space::{OrientedCircle, Rotation, TopView, Vector2};

pub(super) const FIGURE: Figure = Figure {
    number: 7,
    title: "parallel quads with mixed area zero, and Christoffel dual meshes",
    caption: "Left: the quad about the unit circle with the tangent lengths 1/2, 3/2, 1, 9/7 and its \
              Christoffel dual, which runs the other way round and has an incircle, too. Diagonals of one \
              colour are parallel. Right: the top views of the Koebe mesh over the circles of radius 1/2 \
              about (i, j), 0 <= i <= 7, 0 <= j <= 4, inverted at (7/2, -5), and of its Christoffel \
              dual, with incircles and a pair of corresponding faces.",
    claims: &["eq-20", "eq-20-incircle", "christoffel-dual"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let mut face = FaceList::new();
    face.push(0..4);
    let quad = koebe_mesh(about_unit_circle([q(1, 2), q(3, 2), q(1, 1), q(9, 7)])?, face)?;
    let centre = TopView::new(q(7, 2), q(-5, 1));
    let packing = inverted_packing(&square_packing(7, 4), &centre).map_err(NoFigure::of)?;
    let mesh = koebe_mesh(packing, quad_patch(7, 4))?;
    let [quad_dual, mesh_dual] = [dual(&quad)?, dual(&mesh)?];
    let mut scene = Scene::new(160.0, 66.0);
    scene.place(with_diagonals(&quad, [CIRCLE, OTHER])?, [2.0, 35.0], [44.0, 29.0]);
    scene.place(with_diagonals(&quad_dual, [OTHER, CIRCLE])?, [2.0, 2.0], [44.0, 29.0]);
    scene.place(with_incircles(&mesh)?, [50.0, 8.0], [53.0, 56.0]);
    scene.place(with_incircles(&mesh_dual)?, [105.0, 8.0], [53.0, 56.0]);
    scene.text([77.0, 14.0], 3.0, Anchor::Middle, "S'");
    scene.text([132.0, 14.0], 3.0, Anchor::Middle, "M'");
    let pair = |names: [&'static str; 2], mesh, dual| {
        let is = [Property::Planar, Property::IIsothermic];
        let pair = [PairProperty::FParallel, PairProperty::ChristoffelDual];
        [
            Exhibit::new(names[0], mesh).is(&is),
            Exhibit::new(names[1], dual).is(&is).gauss(names[0], &pair),
        ]
    };
    let quads = pair(["quad", "quad-dual"], quad, quad_dual);
    let meshes = pair(["koebe", "christoffel-dual"], mesh, mesh_dual);
    Ok(Plate { exhibits: quads.into_iter().chain(meshes).collect(), scene })
}

fn dual(mesh: &Surface) -> Result<Surface, NoFigure> {
    let radii = mesh.data.vertex.get(RADIUS).map_or(&[][..], Vec::as_slice);
    Ok(christoffel_by_radii(mesh, radii).map_err(NoFigure::of)?.mesh)
}

/// The vertex circles of the quad around the unit circle with these tangent lengths.
/// They have to fit: their sum is that of their products by threes.
fn about_unit_circle(lengths: [Rational; 4]) -> Result<Vec<OrientedCircle<Rational>>, NoFigure> {
    let mut turn = Rotation::identity();
    let mut circles = Vec::new();
    for radius in lengths {
        let at = turn.turn(&Vector2::new(Rational::from_ratio(1, 1), radius.clone()));
        turn = turn.then(&Rotation::from_parameter(&radius).map_err(NoFigure::of)?);
        circles.push(OrientedCircle { centre: TopView::new(at.x, at.y), radius });
    }
    Ok(circles)
}

/// The incircles of a mesh with radii: those of the Koebe mesh over its vertex circles.
fn incircles(mesh: &Surface) -> Result<Vec<Item>, NoFigure> {
    let circles_of = vertex_circles(mesh).unwrap_or_default();
    let points = circles_of.iter().map(OrientedCircle::pole).collect();
    let koebe = Mesh { points, ..mesh.clone() };
    let all = koebe.topology.faces().map(|face| face_circle(&koebe, face).ok().flatten());
    let all: Vec<OrientedCircle<Rational>> = all.flatten().collect();
    Ok(circles(&all, Stroke::new(Color::FAINT, 0.16)))
}

fn with_diagonals(mesh: &Surface, strokes: [Stroke; 2]) -> Result<Vec<Item>, NoFigure> {
    let mut items = with_incircles(mesh)?;
    let at = |i: usize| [mesh.points[i].x.to_f64(), mesh.points[i].y.to_f64()];
    for (ends, stroke) in [[0, 2], [1, 3]].into_iter().zip(strokes) {
        let stroke = Stroke { width: 0.3, ..stroke };
        items.push(Item::Polyline { points: ends.map(at).to_vec(), stroke });
    }
    Ok(items)
}

/// The top view of a mesh with the incircles of its faces, and one face marked.
fn with_incircles(mesh: &Surface) -> Result<Vec<Item>, NoFigure> {
    let marked = mesh.topology.face_count() / 2;
    let mut model = Model::default();
    model.add_mesh(mesh, THIN, |face| {
        if face.index() == marked { Paint::Flat(Color::FRONT.lit(1.6)) } else { Paint::Wire }
    });
    let mut items = painted(&model.map(|[x, y, _]| [x, y, 0.0]), &View::TOP);
    items.extend(incircles(mesh)?);
    Ok(items)
}
