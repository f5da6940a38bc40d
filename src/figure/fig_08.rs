//! Fig. 8: i-minimal meshes with planar parameter lines, and their top views.

use super::draw::{Anchor, Color, Model, Paint, Scene, Stroke, View, painted};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::minimal::{MeshPair, bonnet, enneper};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Field, Rational};
use crate::space::{Rotation, TopView};

pub(super) const FIGURE: Figure = Figure {
    number: 8,
    title: "i-minimal meshes whose parameter lines are planar",
    caption: "Left: the isotropic counterpart of Enneper's surface, the Christoffel dual of the circles of \
              radius 1/2 about (i, j), 0 <= i, j <= 9, inverted at (9/2, 9/2). Right: the counterpart of \
              Bonnet's surface. Below: their top views, which are not embedded.",
    claims: &["koebe-minimal", "fig-8-planar-lines"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let left = enneper(9, 9, &TopView::new(q(9, 2), q(9, 2))).map_err(NoFigure::of)?;
    let half_sector = Rotation::new(q(24, 25), q(7, 25)).map_err(NoFigure::of)?;
    let right =
        bonnet(8, 9, &half_sector, &TopView::new(q(1, 3), q(1, 7))).map_err(NoFigure::of)?;
    let mut scene = Scene::new(160.0, 120.0);
    for (pair, x) in [(&left, 2.0), (&right, 82.0)] {
        scene.place(spatial(&pair.surface), [x, 52.0], [76.0, 66.0]);
        scene.place(top_view(&pair.surface), [x + 12.0, 2.0], [52.0, 46.0]);
    }
    scene.text([4.0, 114.0], 3.6, Anchor::Start, "Enneper");
    scene.text([84.0, 114.0], 3.6, Anchor::Start, "Bonnet");
    let [enneper, bonnet] = [("enneper", "enneper-gauss", left), ("bonnet", "bonnet-gauss", right)]
        .map(|(name, gauss, MeshPair { surface, gauss: image })| {
            let surface = Exhibit::new(name, surface)
                .is(&[Property::Planar, Property::IIsothermic, Property::IMinimal])
                .with(gauss, &[PairProperty::FParallel, PairProperty::IMinimal]);
            [surface, Exhibit::new(gauss, image).is(&[Property::Midscribed])]
        });
    Ok(Plate { exhibits: enneper.into_iter().chain(bonnet).collect(), scene })
}

fn spatial(mesh: &Surface) -> Vec<super::draw::Item> {
    let mut model = Model::default();
    let paint = Paint::Sides([Color::FRONT, Color::BACK]);
    model.add_mesh(mesh, Stroke::new(Color::INK, 0.15), |_| paint);
    painted(&model, &View::from([3.0, -5.0, 3.0]))
}

fn top_view(mesh: &Surface) -> Vec<super::draw::Item> {
    let mut model = Model::default();
    model.add_mesh(mesh, Stroke::new(Color::INK, 0.12), |_| Paint::Wire);
    painted(&model.map(|[x, y, _]| [x, y, 0.0]), &View::TOP)
}
