//! Fig. 5: i-conical meshes of rising fineness.

use super::draw::{Anchor, Scene};
use super::nets::{inverted_net, polynomial, profile};
use super::sheet::{seen, solid};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::metric_dual;
use crate::net::Property;
use crate::scalar::{Field, Rational};

pub(super) const FIGURE: Figure = Figure {
    number: 5,
    title: "i-conical meshes of rising fineness",
    caption: "Meshes of 4 by 3, 8 by 6 and 16 by 12 faces: the metric duals of the nets \
              z = -x^2/2 - x^4/160 + y^2/2 + y^3/60 over grids of step 8/5, 4/5 and 2/5 after the \
              inversion at (2, -9, 0) with r^2 = 64. Each is exactly i-conical, and they sample one \
              smooth surface, the dual of the inverted one. Heights are scaled. The paper's meshes, \
              from subdivision and optimisation, and the one fitted to a given surface wait for the \
              optimisation.",
    claims: &["thm-2-dual"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let mut scene = Scene::new(160.0, 46.0);
    let mut exhibits = Vec::new();
    for (level, name) in ["m0", "m1", "m2"].into_iter().enumerate() {
        let mesh = conical(1 << level)?;
        let x = 2.0 + 53.0 * level as f64;
        scene.place(seen(solid(&mesh), [4.0, -3.0, 4.0], 0.4), [x, 9.0], [50.0, 35.0]);
        scene.text([x + 25.0, 3.0], 3.0, Anchor::Middle, format!("M{level}"));
        exhibits.push(Exhibit::new(name, mesh).is(&[Property::Planar, Property::IConical]));
    }
    Ok(Plate { exhibits, scene })
}

/// The mesh with `4 fine` by `3 fine` faces.
fn conical(fine: i64) -> Result<Surface, NoFigure> {
    let step = Rational::from_ratio(8, 5 * fine);
    let f = polynomial(&[(0, 1), (0, 1), (-1, 2), (0, 1), (-1, 160)]);
    let g = polynomial(&[(0, 1), (0, 1), (1, 2), (1, 60)]);
    let net = inverted_net(
        &profile(4 * fine + 1, &step, f),
        &profile(3 * fine + 1, &step, g),
        [(2, 1), (-9, 1), (0, 1)],
        64,
    )?;
    metric_dual(&net).map_err(NoFigure::of)
}
