//! Fig. 11: curvatures at the vertices of a triangle mesh, beside the true ones.

use super::draw::{Anchor, Color, Model, Paint, Scene, Stroke};
use super::sheet::{seen, solid};
use super::{Exhibit, Figure, NoFigure, Plate, Surface};
use crate::construct::accuracy::vertex_curvatures;
use crate::construct::lift;
use crate::mesh::{FaceList, Mesh, VertexId};
use crate::net::Property;
use crate::pair::PairProperty;
use crate::scalar::{Approx, Field, Ordered, Rational};
use crate::space::{Graph, Jet2, Point, Polynomial, TopView};

pub(super) const FIGURE: Figure = Figure {
    number: 11,
    title: "curvatures at vertices of a triangle mesh",
    caption: "Samples of z = (x^3 - 3xy^2)/12 + (x^4 + y^4)/32 - x^2/4 in the points of a triangular \
              lattice, 15 rows of 13 points at distance 1/3, 13/45 apart and shifted by half a step. \
              Beside it the graphs of H and K at the inner vertices, from formula (22) with the lift to the \
              unit i-sphere, and under them those of the true values. Blue is negative, red positive; \
              computed and true values have one scale. H differs by less than 1/100, K by less \
              than 1/20.",
    claims: &["fig-11-accuracy", "eq-22-cotan"],
    make,
};

/// Points in a row, and rows.
const SIZE: [usize; 2] = [13, 15];

fn make() -> Result<Plate, NoFigure> {
    let mesh = samples()?;
    let [mean, gauss] =
        [0, 1].map(|i| diagram(&mesh, |v| vertex_curvatures(&mesh, v).map(|c| c[i].clone())));
    let [true_mean, true_gauss] =
        [0, 1].map(|i| diagram(&mesh, |v| true_curvatures(&mesh, v).map(|c| c[i].clone())));
    let [mean, gauss, true_mean, true_gauss] = [mean?, gauss?, true_mean?, true_gauss?];
    let mut scene = Scene::new(160.0, 84.0);
    scene.place(seen(solid(&mesh), VIEWER, 0.4), [2.0, 20.0], [54.0, 54.0]);
    scene.text([29.0, 12.0], 3.0, Anchor::Middle, "M");
    for (x, pair, label) in [(58.0, [&mean, &true_mean], "H"), (110.0, [&gauss, &true_gauss], "K")]
    {
        for (mesh, y, what) in [(pair[0], 46.0, "(22)"), (pair[1], 5.0, "true")] {
            scene.place(seen(colored(mesh, pair[1]), VIEWER, 0.35), [x, y], [48.0, 36.0]);
            scene.text([x + 2.0, y + 1.0], 2.8, Anchor::Start, format!("{label}, {what}"));
        }
    }
    let lifted = lift(&mesh);
    let exhibits = vec![
        Exhibit::new("samples", mesh)
            .gauss("lift", &[PairProperty::VParallel])
            .shows("H within 1/100", |mesh| close(mesh, 0, 100))
            .shows("K within 1/20", |mesh| close(mesh, 1, 20)),
        Exhibit::new("lift", lifted).is(&[Property::Inscribed]),
        Exhibit::new("mean-curvature", mean),
        Exhibit::new("curvature", gauss),
        Exhibit::new("true-mean-curvature", true_mean),
        Exhibit::new("true-curvature", true_gauss),
    ];
    Ok(Plate { exhibits, scene })
}

const VIEWER: [f64; 3] = [2.0, -5.0, 4.0];

fn height() -> Polynomial<Rational> {
    let q = Rational::from_ratio;
    let terms =
        [(3, 0, q(1, 12)), (1, 2, q(-1, 4)), (4, 0, q(1, 32)), (0, 4, q(1, 32)), (2, 0, q(-1, 4))];
    Polynomial::new(terms)
}

fn samples() -> Result<Surface, NoFigure> {
    let (height, [width, rows]) = (height(), SIZE);
    let q = |p: usize, shift: i64, d: i64| Rational::from_ratio(p as i64 + shift, d);
    let point = |index: usize| {
        let (j, i) = (index / width, index % width);
        let x = q(2 * i + j % 2, -(width as i64), 6);
        let y = q(2 * j, 1 - rows as i64, 1) * Rational::from_ratio(13, 90);
        let at = TopView::new(x, y);
        let z = height.value_at(&at);
        at.at_height(z)
    };
    let mut faces = FaceList::new();
    for j in 0..rows - 1 {
        for i in 0..width - 1 {
            let [a, c] = [j * width + i, (j + 1) * width + i].map(|n| n as u32);
            let (b, d) = (a + 1, c + 1);
            let both = if j % 2 == 0 { [[a, b, c], [b, d, c]] } else { [[a, d, c], [a, b, d]] };
            both.into_iter().for_each(|face| faces.push(face));
        }
    }
    Ok(Mesh::new((0..width * rows).map(point).collect(), faces)?)
}

fn true_curvatures(mesh: &Surface, v: VertexId) -> Option<[Rational; 2]> {
    let jet: Jet2<Rational> = height().jet(&mesh.points[v.index()].top_view())?;
    Some([jet.mean_curvature(), jet.curvature()])
}

/// Whether curvature `i` is nearer than `1/parts` to the true one at all inner vertices.
fn close(mesh: &Surface, i: usize, parts: i64) -> bool {
    mesh.topology.interior_vertices().all(|v| {
        let pair = vertex_curvatures(mesh, v).zip(true_curvatures(mesh, v));
        pair.is_some_and(|(found, truth)| {
            (&found[i] - &truth[i]).magnitude() < Rational::from_ratio(1, parts)
        })
    })
}

/// The graph of a value at the inner vertices, over the faces between them.
fn diagram(
    mesh: &Surface,
    value: impl Fn(VertexId) -> Option<Rational>,
) -> Result<Surface, NoFigure> {
    let mut numbers = vec![None; mesh.points.len()];
    let mut points: Vec<Point<Rational>> = Vec::new();
    for v in mesh.topology.interior_vertices() {
        let value = value(v).ok_or(NoFigure::Construction("a vertex without curvatures".into()))?;
        numbers[v.index()] = Some(points.len() as u32);
        points.push(mesh.points[v.index()].top_view().at_height(value));
    }
    let mut faces = FaceList::new();
    for face in mesh.topology.faces() {
        let corners = mesh.topology.face(face).iter().map(|v| numbers[v.index()]);
        if let Some(corners) = corners.collect::<Option<Vec<u32>>>() {
            faces.push(corners);
        }
    }
    Ok(Mesh::new(points, faces)?)
}

/// A diagram with the colours of its values, full where another has its greatest.
fn colored(mesh: &Surface, scale: &Surface) -> Model {
    let size = scale.points.iter().fold(0.0_f64, |m, p| m.max(p.z.to_f64().abs()));
    let mut model = Model::default();
    let stroke = Stroke::new(Color::INK, 0.08);
    model.add_mesh(mesh, stroke, |face| {
        let corners = mesh.topology.face(face);
        let sum: f64 = corners.iter().map(|v| mesh.points[v.index()].z.to_f64()).sum();
        Paint::Flat(Color::signed(sum / (corners.len() as f64 * size)))
    });
    model
}
