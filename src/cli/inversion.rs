//! `isogeo invert`: inversions at i-spheres.

use serde_json::json;

use super::arguments::{InvertOptions, Inverted, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::numbers::numbers;
use super::{Status, output, words};
use crate::construct::{NoIncircleImage, incircle_image, moebius_image};
use crate::mesh::file::Options;
use crate::mesh::{Mesh, NoPlane};
use crate::scalar::{Rational, Ring};
use crate::space::{Circle, CylindricalSphere, MoebiusSphere, MoebiusTransformation, TopView};

/// Inverts the mesh and writes it.
pub fn run(options: &InvertOptions, layout: Layout) -> Result<Status, Failure> {
    let map = inversion(options)?;
    let input = input::read(&options.input)?;
    let mesh = input.exact();
    if options.by == Inverted::Incircles {
        return by_incircles(&mesh, &map, &input, options, layout);
    }
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

/// The image of an i-isothermic mesh with its radii, or why there is none: a result, not an error.
fn by_incircles(
    mesh: &Mesh<Rational>,
    map: &MoebiusTransformation<Rational>,
    input: &Input,
    options: &InvertOptions,
    layout: Layout,
) -> Result<Status, Failure> {
    let reason = match incircle_image(mesh, map) {
        Ok(image) => {
            let write = Options { rounded: input.is_rounded(), ..Options::default() };
            output::write_saying(&options.output.output, &image, &write, layout, None)?;
            return Ok(Status::Proved);
        }
        Err(NoIncircleImage::NoRadii) => {
            return Err(Failure::with_help(
                "--by incircles needs the radii of the vertex circles",
                "they are data on the vertices of an .iso.json file, under the name \"radius\"",
            ));
        }
        Err(
            reason @ (NoIncircleImage::Vertex(_)
            | NoIncircleImage::Face(_)
            | NoIncircleImage::NotAnIsometry),
        ) => {
            return Err(Failure::with_help(
                format!("{}: {reason}", input.file.name),
                "choose a centre off the circles of all vertices and faces",
            ));
        }
        Err(reason) => reason,
    };
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-image/1",
            "file": input.file.name,
            "reason": reason.to_string(),
        }))?;
    } else {
        let (name, reason) = (&input.file.name, reason.map(words::exact));
        output::print(&format!("{name}: no image: {reason}\n"))?;
    }
    Ok(match reason {
        NoIncircleImage::Plane(NoPlane::NotPlanar { .. }) => Status::Refuted,
        NoIncircleImage::Plane(_) => Status::Open,
        _ => Status::Refuted,
    })
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
