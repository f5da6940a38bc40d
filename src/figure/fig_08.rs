//! Fig. 8: i-minimal meshes with planar parameter lines, and their top views.

use super::draw::{Anchor, Scene};
use super::lines::planar_lines;
use super::sheet::{seen, solid, top_view};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::{MeshPair, bonnet, enneper};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Field, Rational, Ring};
use crate::space::{Motion, Rotation, TopView, Transform, Vector2, Vector3};

pub(super) const FIGURE: Figure = Figure {
    number: 8,
    title: "i-minimal meshes whose parameter lines are planar",
    caption: "Left: the isotropic counterpart of Enneper's surface, the Christoffel dual of the circles of \
              radius 1/2 about (i, j), 0 <= i, j <= 12, inverted at (6, 6). Right: the counterpart of \
              Bonnet's surface, the dual of 9 rings of 15 touching circles with half sectors of \
              (40/41, 9/41), inverted at the point opposite the middle of the middle ring. In both the \
              shear that the inversion leaves is taken away; heights are drawn steeper. Below: the top \
              views, which have several sheets around branch points, and those of the Koebe meshes.",
    claims: &["koebe-minimal", "minimal-at-vertices", "fig-8-planar-lines"],
    make,
};

/// Faces of Enneper's surface along a side.
pub(super) const SIDE: usize = 12;
/// Rings and sectors of faces of Bonnet's surface.
pub(super) const RINGS: usize = 8;
pub(super) const SECTORS: usize = 14;

/// The two surfaces with their Gauss images, Enneper's first.
pub(super) fn surfaces() -> Result<[MeshPair<Rational>; 2], NoFigure> {
    let q = Rational::from_ratio;
    let centre = TopView::new(q(6, 1), q(6, 1));
    let pair = enneper(SIDE, SIDE, &centre).map_err(NoFigure::of)?;
    let enneper = unsheared(pair, &centre);
    let half_sector = Rotation::new(q(40, 41), q(9, 41)).map_err(NoFigure::of)?;
    Ok([enneper, bonnet_patch([RINGS, SECTORS], &half_sector, &q(25, 16))?])
}

/// Bonnet's surface with its planes of symmetry upright over the axes: the circles are inverted
/// opposite the middle of the middle ring. The `ratio` of the rings is that of the sector.
pub(super) fn bonnet_patch(
    [rings, sectors]: [usize; 2],
    half_sector: &Rotation<Rational>,
    ratio: &Rational,
) -> Result<MeshPair<Rational>, NoFigure> {
    let turn = (0..sectors).fold(Rotation::identity(), |turn, _| turn.then(half_sector));
    let radius = (0..rings / 2).fold(Rational::from_i64(-1), |radius, _| radius * ratio);
    // Infinity goes to the centre c, 0 to c - c/|c|^2.
    let middle = &radius - Rational::from_ratio(1, 2) / &radius;
    let on_axis = |radius: &Rational| TopView::new(radius * turn.cos(), radius * turn.sin());
    let pair = bonnet(rings, sectors, half_sector, &on_axis(&radius)).map_err(NoFigure::of)?;
    let bonnet = unsheared(pair, &on_axis(&middle));
    Ok(moved(bonnet, |_| Motion { rotation: turn.inverse(), ..Motion::identity() }))
}

/// The pair without the shear by this gradient; S touches the unit i-sphere afterwards as before.
fn unsheared(pair: MeshPair<Rational>, gradient: &TopView<Rational>) -> MeshPair<Rational> {
    let shear = Vector2::new(-&gradient.x, -&gradient.y);
    let rise = gradient.norm2() * Rational::from_ratio(1, 2);
    let translation = Vector3 { x: shear.x.clone(), y: shear.y.clone(), z: rise };
    moved(pair, |image| {
        let motion = Motion { shear: shear.clone(), ..Motion::identity() };
        if image { Motion { translation: translation.clone(), ..motion } } else { motion }
    })
}

/// The pair after motions of M and of S.
fn moved(
    pair: MeshPair<Rational>,
    motion: impl Fn(bool) -> Motion<Rational>,
) -> MeshPair<Rational> {
    let (surface, gauss) = (motion(false).apply(&pair.surface), motion(true).apply(&pair.gauss));
    MeshPair { surface, gauss }
}

fn make() -> Result<Plate, NoFigure> {
    let [left, right] = surfaces()?;
    let mut scene = Scene::new(160.0, 118.0);
    place(&mut scene, &left, 2.0, [3.0, -5.0, 3.6], 0.9);
    place(&mut scene, &right, 83.0, [3.0, -5.0, 3.2], 0.55);
    scene.text([4.0, 113.0], 3.4, Anchor::Start, "Enneper");
    scene.text([85.0, 113.0], 3.4, Anchor::Start, "Bonnet");
    let enneper = exhibits("enneper", "enneper-gauss", left, |m| planar_lines(&m.points, SIDE + 1));
    let bonnet =
        exhibits("bonnet", "bonnet-gauss", right, |m| planar_lines(&m.points, SECTORS + 1));
    Ok(Plate { exhibits: enneper.into_iter().chain(bonnet).collect(), scene })
}

fn exhibits(
    name: &'static str,
    gauss: &'static str,
    pair: MeshPair<Rational>,
    planar: fn(&Surface) -> bool,
) -> [Exhibit; 2] {
    const PLANAR: &str = "planar rows and columns";
    let surface = Exhibit::new(name, pair.surface)
        .is(&[Property::Planar, Property::IMinimal, Property::IIsothermic])
        .gauss(gauss, &[PairProperty::FParallel, PairProperty::IMinimal])
        .shows(PLANAR, planar);
    let gauss = Exhibit::new(gauss, pair.gauss)
        .is(&[Property::Planar, Property::Midscribed, Property::IIsothermic])
        .shows(PLANAR, planar);
    [surface, gauss]
}

/// A surface above its top view and that of its Gauss image.
fn place(scene: &mut Scene, pair: &MeshPair<Rational>, x: f64, viewer: [f64; 3], rise: f64) {
    scene.place(seen(solid(&pair.surface), viewer, rise), [x, 50.0], [75.0, 60.0]);
    scene.place(top_view(&pair.surface), [x, 9.0], [36.0, 37.0]);
    scene.place(top_view(&pair.gauss), [x + 39.0, 9.0], [36.0, 37.0]);
    scene.text([x + 18.0, 3.0], 2.8, Anchor::Middle, "M'");
    scene.text([x + 57.0, 3.0], 2.8, Anchor::Middle, "S'");
}
