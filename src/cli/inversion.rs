//! `isogeo invert`: inversions at i-spheres.

use serde_json::json;

use super::arguments::{InvertOptions, Layout};
use super::failure::Failure;
use super::numbers::numbers;
use super::{Status, input, output};
use crate::construct::moebius_image;
use crate::mesh::file::Options;
use crate::scalar::{Rational, Ring};
use crate::space::{Circle, CylindricalSphere, MoebiusSphere, MoebiusTransformation, TopView};

/// Inverts the mesh and writes it.
pub fn run(options: &InvertOptions, layout: Layout) -> Result<Status, Failure> {
    let map = inversion(options)?;
    let input = input::read(&options.input)?;
    let mesh = input.exact();
    let image = moebius_image(&mesh, &map).map_err(|error| {
        Failure::with_help(
            format!("{}: {error}", input.file.name),
            "choose a centre off all vertices and off the circles of all faces",
        )
    })?;
    let write = Options { rounded: input.is_inexact(), ..Options::default() };
    let dropped = mesh.data.vertex.len() + mesh.data.face.len() > 0;
    let said = dropped.then_some(("data_kept", json!(false)));
    output::write_saying(&options.output.output, &image, &write, layout, said)?;
    if dropped && !layout.is_json() {
        output::print("  the data on elements are left out: they do not belong to the image\n")?;
    }
    Ok(Status::Proved)
}

fn inversion(options: &InvertOptions) -> Result<MoebiusTransformation<Rational>, Failure> {
    if let Some(text) = &options.sphere {
        let coefficients: [Rational; 4] = numbers("--sphere", text)?;
        return Ok(MoebiusTransformation::inversion_at(&MoebiusSphere::from(coefficients)));
    }
    // The parser asks for one of the two.
    let [x, y] = numbers("--at", options.at.as_deref().unwrap_or_default())?;
    let [radius2] = numbers("--radius2", &options.radius2)?;
    let sphere = CylindricalSphere::new(Circle::new(TopView::new(x, y), radius2));
    let sphere = sphere.map_err(|error| Failure::usage(format!("--radius2: {error}")))?;
    Ok(MoebiusTransformation::inversion_at_cylinder(&sphere, &Rational::zero()))
}
