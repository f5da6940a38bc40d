//! Fig. 8: i-minimal meshes with planar parameter lines, and their top views.

use super::draw::{Anchor, Scene};
use super::sheet::{spatial, top_view};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::{MeshPair, bonnet, enneper};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Field, Rational};
use crate::space::{Motion, Rotation, TopView, Transform, Vector2};

pub(super) const FIGURE: Figure = Figure {
    number: 8,
    title: "i-minimal meshes whose parameter lines are planar",
    caption: "Left: the isotropic counterpart of Enneper's surface, the Christoffel dual of the circles of \
              radius 1/2 about (i, j), 0 <= i, j <= 9, inverted at (9/2, 9/2). Right: the counterpart of \
              Bonnet's surface, from 8 rings of 11 circles inverted at (2/3, 1/5). Heights are drawn \
              steeper. Below: their top views, which are not embedded.",
    claims: &["koebe-minimal", "fig-8-planar-lines"],
    make,
};

/// The two surfaces with their Gauss images, Enneper's first.
pub(super) fn surfaces() -> Result<[MeshPair<Rational>; 2], NoFigure> {
    let q = Rational::from_ratio;
    let centre = TopView::new(q(9, 2), q(9, 2));
    let pair = enneper(9, 9, &centre).map_err(NoFigure::of)?;
    // The inversion leaves a shear, which an i-motion takes away.
    let shear = Motion { shear: Vector2::new(-&centre.x, -&centre.y), ..Motion::identity() };
    let enneper = MeshPair { surface: shear.apply(&pair.surface), gauss: shear.apply(&pair.gauss) };
    let half_sector = Rotation::new(q(24, 25), q(7, 25)).map_err(NoFigure::of)?;
    let bonnet = bonnet(8, 11, &half_sector, &TopView::new(q(2, 3), q(1, 5)));
    Ok([enneper, bonnet.map_err(NoFigure::of)?])
}

fn make() -> Result<Plate, NoFigure> {
    let [left, right] = surfaces()?;
    let mut scene = Scene::new(160.0, 120.0);
    place(&mut scene, &left.surface, 2.0, [3.0, -5.0, 3.0], 7.0);
    place(&mut scene, &right.surface, 82.0, [3.0, -5.0, 3.0], 1.0);
    scene.text([4.0, 114.0], 3.6, Anchor::Start, "Enneper");
    scene.text([84.0, 114.0], 3.6, Anchor::Start, "Bonnet");
    let [enneper, bonnet] = [("enneper", "enneper-gauss", left), ("bonnet", "bonnet-gauss", right)]
        .map(|(name, gauss, MeshPair { surface, gauss: image })| {
            let surface = Exhibit::new(name, surface)
                .is(&[Property::Planar, Property::IMinimal])
                .with(gauss, &[PairProperty::FParallel, PairProperty::IMinimal]);
            [surface, Exhibit::new(gauss, image).is(&[Property::Planar])]
        });
    Ok(Plate { exhibits: enneper.into_iter().chain(bonnet).collect(), scene })
}

/// A surface above its top view.
fn place(scene: &mut Scene, mesh: &Surface, x: f64, viewer: [f64; 3], steep: f64) {
    scene.place(spatial(mesh, viewer, steep), [x, 52.0], [76.0, 66.0]);
    scene.place(top_view(mesh), [x + 12.0, 2.0], [52.0, 46.0]);
}
