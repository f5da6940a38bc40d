//! Fig. 1: an architectural study.
//!
//! The mesh is an exact patch of an i-minimal surface, not one from optimisation: so it is i-minimal
//! as it stands, which an optimised mesh near such a surface is not.

use super::draw::{Color, Item, Model, Paint, Piece, Scene, Stroke, View, painted};
use super::fig_08::bonnet_patch;
use super::sheet::EDGE;
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::MeshPair;
use crate::mesh::{Data, HalfEdge, VertexId};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational, Ring};
use crate::space::{Point, Rotation, Scaling, Transform};

pub(super) const FIGURE: Figure = Figure {
    number: 1,
    title: "beams along the i-principal lines of an i-minimal surface",
    caption: "Beams between a patch of the isotropic counterpart of Bonnet's surface (Fig. 8; 11 rings of 11 \
              circles, half sector (60/61, 11/61), heights times 6) and a parallel mesh: M and \
              M + 5/2 (S - e), with the Koebe mesh S as Gauss image and e = (0, 0, 1). As edges are \
              parallel, beams are planar; at a vertex they share the line from M to its \
              image, so that nodes have no torsion (right). Below: the top view, where the beams follow \
              an orthogonal network in the limit.",
    claims: &["koebe-minimal", "parallel-linear"],
    make,
};

/// The height of the beams.
const DEPTH: (i64, i64) = (5, 2);
/// The vertex in the middle.
const MIDDLE: VertexId = VertexId(60);
/// Where the viewer stands.
const VIEWER: [f64; 3] = [3.0, -5.0, 3.0];

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let half_sector = Rotation::new(q(60, 61), q(11, 61)).map_err(NoFigure::of)?;
    let MeshPair { surface, gauss } = bonnet_patch([10, 10], &half_sector, &q(36, 25))?;
    let steeper = Scaling::new(q(1, 1), q(6, 1)).map_err(NoFigure::of)?;
    let larger = Scaling::new(q(6, 1), q(36, 1)).map_err(NoFigure::of)?;
    let [roof, gauss] = [steeper.apply(&surface), larger.apply(&gauss)];
    // The radii of S are those before scaling; those of M are not concerned.
    let gauss = Surface { data: Data::default(), ..gauss };
    let below = |(p, s): (&Point<Rational>, &Point<Rational>)| {
        let step = [s.x.clone(), s.y.clone(), &s.z - Rational::one()];
        let [x, y, z] = step.map(|c| c * q(DEPTH.0, DEPTH.1));
        Point::new(&p.x + x, &p.y + y, &p.z + z)
    };
    let points = roof.points.iter().zip(&gauss.points).map(below).collect();
    let lower = Surface { topology: roof.topology.clone(), points, data: Data::default() };
    let mut scene = Scene::new(160.0, 92.0);
    let view = View::from(VIEWER);
    let all: Vec<HalfEdge> = roof.topology.edges().collect();
    let mut model = beams(&roof, &lower, &all);
    let floor = model.points().fold(0.0, |low: f64, p| low.min(p[2])) - 18.0;
    model.pieces.extend(plan(&roof, floor));
    scene.place(painted(&model, &view), [2.0, 2.0], [114.0, 88.0]);
    let star: Vec<HalfEdge> = roof.topology.star(MIDDLE).collect();
    let mut node = painted(&beams(&roof, &lower, &star), &view);
    node.push(axis(&roof, &lower, &view));
    scene.place(node, [122.0, 6.0], [36.0, 34.0]);
    let exhibits = vec![
        Exhibit::new("roof", roof)
            .is(&[Property::Planar, Property::IIsothermic, Property::IMinimal])
            .gauss("gauss", &[PairProperty::FParallel, PairProperty::IMinimal])
            .with("lower", &[PairProperty::Parallel, PairProperty::FParallel]),
        Exhibit::new("lower", lower).is(&[Property::Planar]),
        Exhibit::new("gauss", gauss).is(&[Property::Planar, Property::Midscribed]),
    ];
    Ok(Plate { exhibits, scene })
}

fn place_of(mesh: &Surface, v: VertexId) -> [f64; 3] {
    mesh.points[v.index()].coordinates().map(Approx::to_f64)
}

fn ends(mesh: &Surface, h: HalfEdge) -> [[f64; 3]; 2] {
    [mesh.topology.origin(h), mesh.topology.target(h)].map(|v| place_of(mesh, v))
}

/// The strips between two meshes along edges.
fn beams(upper: &Surface, lower: &Surface, edges: &[HalfEdge]) -> Model {
    let strip = |&h: &HalfEdge| {
        let ([a, b], [c, d]) = (ends(upper, h), ends(lower, h));
        let paint = Paint::Sides([Color::BACK, Color::BACK]);
        Piece::Face { corners: vec![a, b, d, c], drawn: vec![true; 4], paint, stroke: EDGE }
    };
    Model { pieces: edges.iter().map(strip).collect() }
}

/// The top view, on a floor.
fn plan(mesh: &Surface, floor: f64) -> Vec<Piece> {
    let segment = |h| Piece::Segment {
        ends: ends(mesh, h).map(|[x, y, _]| [x, y, floor]),
        stroke: Stroke::new(Color::FAINT, 0.12),
    };
    mesh.topology.edges().map(segment).collect()
}

/// The line in which the beams of the middle vertex meet, somewhat longer than they are high.
fn axis(upper: &Surface, lower: &Surface, view: &View) -> Item {
    let [from, to] = [upper, lower].map(|mesh| place_of(mesh, MIDDLE));
    let at = |t: f64| view.project([0, 1, 2].map(|i| from[i] + t * (to[i] - from[i])));
    Item::Polyline { points: vec![at(-0.8), at(1.8)], stroke: Stroke::new(Color::CIRCLE, 0.4) }
}
