//! Fig. 4: an i-circular mesh, its image under an i-M-transformation, and an i-conical mesh, from
//! subdivision and optimisation.

use super::draw::{Anchor, Scene};
use super::frozen::{CANOPY, ROOF, frozen};
use super::nets::inverted;
use super::sheet::{seen, solid, top_view};
use super::{Exhibit, Figure, NoFigure, Plate};
use crate::net::Property;

pub(super) const FIGURE: Figure = Figure {
    number: 4,
    title: "an i-circular mesh, its i-M-image, and an i-conical mesh",
    caption: "M: an i-circular mesh of 16 by 12 faces. A control mesh of 4 by 3 faces, z = f(x) + g(y) with \
              f = 4/5, 6/5, -2/5, -3/5, 8/5 at x = -6, -3, 0, 3, 6 and g = 0, 9/5, 8/5, -3/5 at \
              y = -3, -1, 1, 3, the top view bent by w -> w - 9i/200 w^2, was optimised towards an i-circular \
              mesh, and twice subdivided (Catmull-Clark) and optimised again, with fairness 1. M1: its image \
              under the inversion at (0, 12, 0) with r^2 = 144, again i-circular. Right: an i-conical mesh, \
              made likewise from f = -3/5, 9/5, 13/5, 7/5, -6/5 at x = -5, -5/2, 0, 5/2, 5 and \
              g = -1/5, 6/5, 13/10, -2/5, bent by w -> w - 7/200 w^2. Below: the top views. The meshes of the \
              optimisation were made exact and kept: cargo run --release --example frozen -- \
              src/figure/frozen. Heights are scaled.",
    claims: &["thm-1-v", "moebius-cylindrical"],
    make,
};

fn make() -> Result<Plate, NoFigure> {
    let mesh = frozen(ROOF)?;
    let image = inverted(&mesh, [(0, 1), (12, 1), (0, 1)], 144)?;
    let conical = frozen(CANOPY)?;
    let mut scene = Scene::new(160.0, 78.0);
    for (mesh, x, viewer, label) in [
        (&mesh, 1.0, [1.0, -5.0, 5.5], "M"),
        (&image, 54.5, [2.0, -5.0, 4.0], "M1"),
        (&conical, 108.0, [3.0, -5.0, 4.0], "i-conical"),
    ] {
        scene.place(seen(solid(mesh), viewer, 0.3), [x, 42.0], [51.0, 35.0]);
        scene.place(top_view(mesh), [x + 3.0, 8.0], [45.0, 32.0]);
        scene.text([x + 25.5, 3.0], 3.0, Anchor::Middle, label);
    }
    let exhibits = vec![
        Exhibit::new("i-circular", mesh).is(&[Property::Planar, Property::ICircular]),
        Exhibit::new("image", image).is(&[Property::Planar, Property::ICircular]),
        Exhibit::new("i-conical", conical).is(&[Property::Planar, Property::IConical]),
    ];
    Ok(Plate { exhibits, scene })
}
