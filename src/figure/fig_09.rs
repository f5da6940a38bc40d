//! Fig. 9: the metric duals of the surfaces of Fig. 8.

use super::draw::{Anchor, Model, Scene, View, painted};
use super::fig_08::{SECTORS, SIDE, surfaces};
use super::lines::concurrent_lines;
use super::sheet::{flat, seen, solid};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::MeshPair;
use crate::construct::{face_circle, metric_dual};
use crate::net::{Property, RADIUS};
use crate::pair::PairProperty;
use crate::scalar::Rational;

pub(super) const FIGURE: Figure = Figure {
    number: 9,
    title: "i-minimal meshes whose face planes along rows and columns pass through points",
    caption: "The metric duals of the two meshes of Fig. 8, with the radii of the circles that the dual \
              Koebe meshes have; below their top views, which are those of these Koebe meshes. Drawn \
              without the faces that reach far out: nine around the middle on the left, two columns at \
              each end on the right. Heights are scaled.",
    claims: &["i-minimal-dual", "fig-9-concurrent"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let [left, right] = surfaces()?;
    let [left, right] = [dual(left)?, dual(right)?];
    let mut scene = Scene::new(160.0, 118.0);
    // Nine faces around the middle; two columns on each side.
    let middle = |line: usize| line.abs_diff(SIDE / 2 - 1) <= 1;
    let ends = |column: usize| column < 2 || column + 3 >= SECTORS;
    place(
        &mut scene,
        &left.surface,
        2.0,
        |f| middle(f / (SIDE - 1)) && middle(f % (SIDE - 1)),
        ([3.0, -5.0, 3.4], 0.7),
    );
    place(&mut scene, &right.surface, 83.0, |f| ends(f % (SECTORS - 1)), ([0.8, -5.0, 4.0], 0.6));
    scene.text([4.0, 113.0], 3.4, Anchor::Start, "dual of Enneper");
    scene.text([85.0, 113.0], 3.4, Anchor::Start, "dual of Bonnet");
    let enneper =
        exhibits("enneper-dual", "enneper-dual-gauss", left, |m| concurrent_lines(m, SIDE - 1));
    let bonnet =
        exhibits("bonnet-dual", "bonnet-dual-gauss", right, |m| concurrent_lines(m, SECTORS - 1));
    Ok(Plate { exhibits: enneper.into_iter().chain(bonnet).collect(), scene })
}

/// The duals of M and of the Koebe mesh S, both with the radii of the face circles of S.
fn dual(pair: MeshPair<Rational>) -> Result<MeshPair<Rational>, NoFigure> {
    let circle = |face| face_circle(&pair.gauss, face).ok().flatten().map(|circle| circle.radius);
    let radii: Option<Vec<_>> = pair.gauss.topology.faces().map(circle).collect();
    let radii = radii.ok_or(NoFigure::Construction("a face without a circle".into()))?;
    let dual = |mesh: &Surface| -> Result<Surface, NoFigure> {
        let mut dual = metric_dual(mesh).map_err(NoFigure::of)?;
        dual.data.vertex.insert(RADIUS.to_owned(), radii.clone());
        Ok(dual)
    };
    Ok(MeshPair { surface: dual(&pair.surface)?, gauss: dual(&pair.gauss)? })
}

fn exhibits(
    name: &'static str,
    gauss: &'static str,
    pair: MeshPair<Rational>,
    concurrent: fn(&Surface) -> bool,
) -> [Exhibit; 2] {
    let surface = Exhibit::new(name, pair.surface)
        .is(&[Property::Planar, Property::IMinimal, Property::IIsothermic])
        .gauss(gauss, &[PairProperty::VParallel])
        .shows("face planes of rows and columns through points", concurrent);
    [surface, Exhibit::new(gauss, pair.gauss).is(&[Property::Planar, Property::Midscribed])]
}

/// A dual above its top view, without the faces that reach far out.
fn place(
    scene: &mut Scene,
    mesh: &Surface,
    x: f64,
    far: impl Fn(usize) -> bool,
    (viewer, rise): ([f64; 3], f64),
) {
    let kept = |mut model: Model| {
        let pieces = model.pieces.into_iter().enumerate();
        model.pieces = pieces.filter(|(face, _)| !far(*face)).map(|(_, piece)| piece).collect();
        model
    };
    let above = seen(kept(solid(mesh)), viewer, rise);
    scene.place(above, [x, 50.0], [75.0, 60.0]);
    scene.place(painted(&kept(flat(mesh)), &View::TOP), [x + 15.0, 4.0], [45.0, 42.0]);
}
