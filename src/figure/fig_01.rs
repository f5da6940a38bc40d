//! Fig. 1: an architectural study.

use super::draw::{Color, Item, Model, Paint, Piece, Scene, Stroke, View, painted};
use super::fig_08::bonnet_patch;
use super::sheet::EDGE;
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::MeshPair;
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational, Ring};
use crate::space::{Rotation, Scaling, Transform};

pub(super) const FIGURE: Figure = Figure {
    number: 1,
    title: "beams along the i-principal lines of an i-minimal surface",
    caption: "caption",
    claims: &["koebe-minimal"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let half_sector = Rotation::new(q(60, 61), q(11, 61)).map_err(NoFigure::of)?;
    let pair = bonnet_patch([10, 10], &half_sector, &q(36, 25))?;
    let slope = q(6, 1);
    let steeper = Scaling::new(q(1, 1), slope.clone()).map_err(NoFigure::of)?;
    let larger = Scaling::new(slope.clone(), slope.square()).map_err(NoFigure::of)?;
    let roof = MeshPair { surface: steeper.apply(&pair.surface), gauss: larger.apply(&pair.gauss) };
    let mut lower = roof.surface.clone();
    lower.data = Default::default();
    let depth = q(1, 1);
    for (p, s) in lower.points.iter_mut().zip(&roof.gauss.points) {
        p.x += &(&s.x * &depth);
        p.y += &(&s.y * &depth);
        p.z += &((&s.z - Rational::one()) * &depth);
    }
    let mut scene = Scene::new(160.0, 100.0);
    let mut model = beams(&roof.surface, &lower);
    scene.place(painted(&model, &View::from([3.0, -5.0, 3.0])), [2.0, 2.0], [156.0, 96.0]);
    for p in roof.surface.points.iter().chain(&roof.gauss.points) {
        eprintln!("{:?}", p.coordinates().map(Approx::to_f64));
    }
    let exhibits = vec![
        Exhibit::new("roof", roof.surface)
            .is(&[Property::Planar])
            .with("gauss", &[PairProperty::FParallel, PairProperty::IMinimal])
            .with("lower", &[PairProperty::Parallel, PairProperty::FParallel]),
        Exhibit::new("lower", lower).is(&[Property::Planar]),
        Exhibit::new("gauss", roof.gauss).is(&[Property::Planar]),
    ];
    Ok(Plate { exhibits, scene })
}

/// The strips between two meshes along their edges.
fn beams(upper: &Surface, lower: &Surface) -> Model {
    let mut model = Model::default();
    let at = |mesh: &Surface, v: usize| mesh.points[v].coordinates().map(Approx::to_f64);
    for h in upper.topology.edges() {
        let [a, b] = [upper.topology.origin(h), upper.topology.target(h)].map(|v| v.index());
        let corners = vec![at(upper, a), at(upper, b), at(lower, b), at(lower, a)];
        model.pieces.push(Piece::Face {
            corners,
            drawn: vec![true; 4],
            paint: Paint::Sides([Color::BACK, Color::BACK]),
            stroke: EDGE,
        });
    }
    model
}
