//! Fig. 5: i-conical meshes of rising fineness, and one that is fitted to a given surface.

use super::draw::{Anchor, Scene};
use super::frozen::{FITTED, M0, M1, M2, frozen};
use super::sheet::{seen, solid, top_view};
use super::{Exhibit, Figure, NoFigure, Plate};
use crate::net::Property;

pub(super) const FIGURE: Figure = Figure {
    number: 5,
    title: "i-conical meshes of rising fineness, and one fitted to a given surface",
    caption: "M0, M1 and M2: i-conical meshes of 3 by 3, 6 by 6 and 12 by 12 faces. A control mesh \
              z = f(x) + g(y) with f = 13/5, 3/10, 1/10, 3 at x = -9/2, -3/2, 3/2, 9/2 and g = -8/5, 0, 1/10, \
              -11/10 at y = -7/2, -6/5, 6/5, 7/2, the top view bent by w -> w + (3 + i)/100 w^2, was optimised \
              (fairness 1), subdivided (Catmull-Clark), optimised, and so once more. M': an i-conical mesh of \
              16 by 12 faces, made likewise near z = -x^2/24 - y^2/7 + xy/100 + x^3/400 over \
              -5 <= x <= 5, -3 <= y <= 3, from the grid of 4 by 3 faces over it; corners were kept, and \
              boundary vertices slid along its chords. The \
              principal lines do not follow the boundary, and M' is less smooth there (right: its top view). \
              The meshes of the optimisation were made exact and kept: cargo run --release --example frozen -- src/figure/frozen. Heights are scaled.",
    claims: &["thm-2-dual"],
    make,
};

/// Where the viewer stands.
const VIEWER: [f64; 3] = [3.0, -5.0, 4.0];

fn make() -> Result<Plate, NoFigure> {
    let mut scene = Scene::new(160.0, 98.0);
    let mut exhibits = Vec::new();
    for (text, name, x, label) in
        [(M0, "m0", 1.0, "M0"), (M1, "m1", 54.5, "M1"), (M2, "m2", 108.0, "M2")]
    {
        let mesh = frozen(text)?;
        scene.place(seen(solid(&mesh), VIEWER, 0.4), [x, 58.0], [51.0, 39.0]);
        scene.text([x + 25.5, 53.0], 3.0, Anchor::Middle, label);
        exhibits.push(Exhibit::new(name, mesh).is(&[Property::Planar, Property::IConical]));
    }
    let fitted = frozen(FITTED)?;
    scene.place(seen(solid(&fitted), VIEWER, 0.3), [1.0, 8.0], [78.0, 42.0]);
    scene.place(top_view(&fitted), [88.0, 8.0], [68.0, 40.0]);
    scene.text([80.0, 3.0], 3.0, Anchor::Middle, "M'");
    exhibits.push(Exhibit::new("fitted", fitted).is(&[Property::Planar, Property::IConical]));
    Ok(Plate { exhibits, scene })
}
