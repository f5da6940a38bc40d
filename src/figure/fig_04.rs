//! Fig. 4: an i-circular mesh, its image under an i-M-transformation, and an i-conical mesh.

use super::draw::{Anchor, Scene};
use super::nets::{inverted, inverted_net, polynomial, profile};
use super::sheet::{seen, solid};
use super::{Exhibit, Figure, NoFigure, Plate};
use crate::construct::metric_dual;
use crate::net::Property;
use crate::scalar::{Field, Rational};

pub(super) const FIGURE: Figure = Figure {
    number: 4,
    title: "an i-circular mesh, its i-M-image, and an i-conical mesh",
    caption: "M: the net z = x/6 - x^3/30 + y^2/6 over 15 by 13 lines at distance 1/2 about 0 after the \
              inversion at (-1, -8, 0) with r^2 = 64. M1: its image under the inversion at (9, 3, -2) \
              with r^2 = 64, again i-circular. Right: an i-conical mesh, the metric dual of the net \
              z = -x^2/2 + x^4/120 - y^2/3 over 16 by 14 such lines after the inversion at (2, -9, 0) \
              with r^2 = 64. Heights are scaled.",
    claims: &["thm-1-v", "thm-2-dual", "moebius-cylindrical"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let half = Rational::from_ratio(1, 2);
    let f = profile(14, &half, polynomial(&[(0, 1), (1, 6), (0, 1), (-1, 30)]));
    let g = profile(12, &half, polynomial(&[(0, 1), (0, 1), (1, 6)]));
    let mesh = inverted_net(&f, &g, [(-1, 1), (-8, 1), (0, 1)], 64)?;
    let image = inverted(&mesh, [(9, 1), (3, 1), (-2, 1)], 64)?;
    let f = profile(15, &half, polynomial(&[(0, 1), (0, 1), (-1, 2), (0, 1), (1, 120)]));
    let g = profile(13, &half, polynomial(&[(0, 1), (0, 1), (-1, 3)]));
    let conical = metric_dual(&inverted_net(&f, &g, [(2, 1), (-9, 1), (0, 1)], 64)?);
    let conical = conical.map_err(NoFigure::of)?;
    let mut scene = Scene::new(160.0, 54.0);
    for (mesh, x, rise, label) in
        [(&mesh, 2.0, 0.4, "M"), (&image, 55.0, 0.4, "M1"), (&conical, 108.0, 0.5, "i-conical")]
    {
        scene.place(seen(solid(mesh), [2.0, -5.0, 5.0], rise), [x, 9.0], [50.0, 44.0]);
        scene.text([x + 25.0, 3.0], 3.0, Anchor::Middle, label);
    }
    let exhibits = vec![
        Exhibit::new("i-circular", mesh).is(&[Property::Planar, Property::ICircular]),
        Exhibit::new("image", image).is(&[Property::Planar, Property::ICircular]),
        Exhibit::new("i-conical", conical).is(&[Property::Planar, Property::IConical]),
    ];
    Ok(Plate { exhibits, scene })
}
