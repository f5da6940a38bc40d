//! Fig. 2: parallel meshes.

use super::draw::{Anchor, Color, Model, Paint, Scene, Stroke};
use super::nets::{inverted_net, polynomial, profile};
use super::sheet::{EDGE, SURFACE, seen};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::{inscribed_f_parallel, mean_gradient};
use crate::mesh::{FaceId, VertexId};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Rational};

pub(super) const FIGURE: Figure = Figure {
    number: 2,
    title: "parallel meshes",
    caption: "Left: an i-circular mesh, the image of the net z = -x^2/6 + y^2/5 over 7 by 6 lines at \
              distance 1 about 0 under the inversion at (0, -8, 0) with r^2 = 64. Right: the mesh minus \
              an f-parallel mesh that is inscribed to the unit i-sphere. Corresponding edges are \
              parallel, as the marked ones, and so are the planes of corresponding faces. Heights are \
              scaled, the same in both.",
    claims: &["parallel-linear", "thm-1-f"],
    make,
};

/// The vertex whose image lies over the mean gradient of its faces.
const MIDDLE: VertexId = VertexId(21);

fn make() -> Result<Plate, NoFigure> {
    let q = Rational::from_ratio;
    let f = profile(6, &q(1, 1), polynomial(&[(0, 1), (0, 1), (-1, 6)]));
    let g = profile(5, &q(1, 1), polynomial(&[(0, 1), (0, 1), (1, 5)]));
    let mesh = inverted_net(&f, &g, [(0, 1), (-8, 1), (0, 1)], 64)?;
    let start = mean_gradient(&mesh, MIDDLE).map_err(NoFigure::of)?;
    let start = start.ok_or(NoFigure::Construction("a vertex without faces".into()))?;
    let image = inscribed_f_parallel(&mesh, MIDDLE, &start).map_err(NoFigure::of)?;
    let image = image.into_image();
    let mut parallel = mesh.clone();
    for (p, s) in parallel.points.iter_mut().zip(&image.points) {
        let weight = q(-1, 1);
        p.x += &(&s.x * &weight);
        p.y += &(&s.y * &weight);
        p.z += &(&s.z * &weight);
    }
    let mut scene = Scene::new(160.0, 58.0);
    let mut model = marked(&mesh);
    let moved = marked(&parallel).map(|[x, y, z]| [x + 14.0, y + 4.4, z]);
    model.pieces.extend(moved.pieces);
    scene.place(seen(model, [1.0, -5.0, 4.0], 0.2), [2.0, 9.0], [156.0, 47.0]);
    scene.text([40.0, 3.0], 3.0, Anchor::Middle, "M");
    scene.text([120.0, 3.0], 3.0, Anchor::Middle, "M'");
    let exhibits = vec![
        Exhibit::new("mesh", mesh)
            .is(&[Property::Planar, Property::ICircular])
            .with("parallel", &[PairProperty::Parallel, PairProperty::FParallel])
            .gauss("inscribed", &[PairProperty::Parallel, PairProperty::FParallel]),
        Exhibit::new("parallel", parallel).is(&[Property::Planar, Property::ICircular]),
        Exhibit::new("inscribed", image).is(&[Property::Planar, Property::Inscribed]),
    ];
    Ok(Plate { exhibits, scene })
}

/// A mesh with one face and one edge of it marked.
fn marked(mesh: &Surface) -> Model {
    const MARKED: FaceId = FaceId(16);
    const MARK: Stroke = Stroke::new(Color::CIRCLE, 0.7);
    let mut model = Model::default();
    let paint = |face| if face == MARKED { Paint::Flat(Color::CIRCLE.lit(1.6)) } else { SURFACE };
    model.add_mesh(mesh, EDGE, paint);
    let corners = mesh.topology.face(MARKED).iter().take(2);
    let points = corners.map(|v| mesh.points[v.index()].coordinates().map(Approx::to_f64));
    model.add_line(points, MARK);
    model
}
