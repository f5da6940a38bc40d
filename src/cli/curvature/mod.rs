//! `isogeo curvature`: H and K at faces (17) or at vertices (22), exactly.

mod columns;
mod report;
mod row;
mod summary;

use std::path::Path;

use rayon::prelude::*;
use serde_json::json;

use super::arguments::{self, CurvatureOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::check::{self, Verdict};
use crate::construct::{NoGaussImage, circumscribed_f_parallel};
use crate::mesh::ExactPoints;
use crate::mesh::file::{Coordinates, Format};
use crate::net::{Net, Property};
use crate::pair::element::{At, Elements};
use crate::pair::{Couple, ExactPair, PairProperty};
use crate::scalar::Rational;
use columns::Columns;
use report::Report;
use row::{Row, entry};

/// Computes, prints the report, writes the mesh with its curvatures.
pub fn run(options: &CurvatureOptions, layout: Layout) -> Result<Status, Failure> {
    let holds_data =
        |path: &Path| matches!(Format::from_path(path), Some(Format::IsoJson | Format::Vtu));
    if options.output.as_deref().is_some_and(|path| !holds_data(path)) {
        return Err(Failure::with_help(
            "this format has no room for curvatures",
            "write .vtu for ParaView and pyvista, or .iso.json, which is exact",
        ));
    }
    let input = input::read(&options.input)?;
    match (&options.gauss, options.at.into()) {
        (Some(path), at) => {
            let image = input::read_image(path, &options.input, &input)?;
            let pair = ExactPair::new(input.topology(), points(&input), points(&image));
            let remark = misfit(&input, &image, at);
            let elements = Elements { pair, at, determined: Vec::new() };
            judge(options, layout, &input, &elements, &image.file.name, remark)
        }
        (None, At::Vertices) => {
            let pair = ExactPair::lifted(input.topology(), points(&input));
            let elements = Elements { pair, at: At::Vertices, determined: Vec::new() };
            let remark = not_i_circular(&input);
            judge(options, layout, &input, &elements, "the lift to the unit i-sphere", remark)
        }
        (None, At::Faces) => {
            let mesh = input.exact();
            let bar = output::progress(mesh.topology.face_count(), "making the Gauss image");
            let found = circumscribed_f_parallel(&mesh);
            bar.finish_and_clear();
            match found {
                Ok(found) => {
                    let image = found.pair.image().points.as_slice().into();
                    let pair = ExactPair::new(&mesh.topology, points(&input), image);
                    let determined = found.determined;
                    let elements = Elements { pair, at: At::Faces, determined };
                    let image = "circumscribed to the unit i-sphere";
                    judge(options, layout, &input, &elements, image, None)
                }
                Err(reason) => refuse(&input, &reason, layout),
            }
        }
    }
}

fn points(input: &Input) -> ExactPoints<'_> {
    match &input.file.coordinates {
        Coordinates::Numerals(mesh) => mesh.points.as_slice().into(),
        Coordinates::Rationals(mesh) => mesh.points.as_slice().into(),
    }
}

/// What the lift of a mesh that is not i-circular stands for: its faces are not planar.
fn not_i_circular(input: &Input) -> Option<String> {
    let topology = input.topology();
    if topology.corner_count() == 3 * topology.face_count() {
        return None;
    }
    let decider = input.decider();
    let report = Net::new(topology, &decider).check(Property::ICircular);
    match report.verdict() {
        Verdict::Refuted => Some(format!(
            "the mesh is not i-circular{}: H and K are those of the triangles between consecutive \
             edges at a vertex",
            first_of(&report)
        )),
        Verdict::Consistent => Some("the mesh is i-circular within its digits only".into()),
        _ => None,
    }
}

fn first_of(report: &check::Report<Rational>) -> String {
    report.failures.first().map_or(String::new(), |element| format!(", see {element}"))
}

/// What the pair is not, though it should be for curvatures of this kind.
fn misfit(input: &Input, image: &Input, at: At) -> Option<String> {
    let property = match at {
        At::Faces => PairProperty::FParallel,
        At::Vertices => PairProperty::VParallel,
    };
    let decider = input.decider().followed_by(image.decider());
    let couple = Couple::new(input.topology(), image.topology(), &decider).ok()?;
    let report = couple.check(property);
    let name = property.name();
    match report.verdict() {
        Verdict::Refuted => {
            let first = first_of(&report);
            Some(format!("the pair is not {name}{first}: H and K are those of the formula only"))
        }
        Verdict::Consistent => Some(format!("the pair is {name} within its digits only")),
        _ => None,
    }
}

/// Says why there is no circumscribed Gauss image: a result, not an error.
fn refuse(
    input: &Input,
    reason: &NoGaussImage<Rational>,
    layout: Layout,
) -> Result<Status, Failure> {
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-curvature/1",
            "file": input.file.name,
            "reason": reason.to_string(),
        }))?;
    } else {
        output::print(&format!(
            "{}: it has no circumscribed Gauss image: {}\n  curvatures at faces belong to a mesh and \
             a Gauss image: `isogeo gauss` makes some, --gauss takes any\n",
            input.file.name,
            reason.map(words::exact),
        ))?;
    }
    let decider = input.decider();
    match Net::new(input.topology(), &decider).check(Property::IConical).verdict() {
        Verdict::Refuted => Ok(Status::Refuted),
        _ => Ok(Status::Open),
    }
}

/// Goes through all elements, in parallel and in order.
fn judge(
    options: &CurvatureOptions,
    layout: Layout,
    input: &Input,
    elements: &Elements<'_>,
    image: &str,
    remark: Option<String>,
) -> Result<Status, Failure> {
    const CHUNK: usize = 8192;
    let file = options.output.as_deref();
    let exact = file.and_then(Format::from_path) == Some(Format::IsoJson);
    let row = |index: usize| {
        let found = elements.find(index);
        let json = layout.is_json().then(|| entry(elements, index, &found, options.integrated));
        Row::new(found, json, exact)
    };
    let mut report = Report::new(elements.at, remark);
    let mut columns = file.map(|_| Columns::default());
    if layout.is_json() {
        output::print(&report.json_head(input, image, file))?;
    }
    let count = elements.count();
    let bar = output::steps(count, "curvatures");
    for start in (0..count).step_by(CHUNK) {
        let end = count.min(start + CHUNK);
        let rows: Vec<Row> = (start..end).into_par_iter().map(row).collect();
        bar.inc((end - start) as u64);
        for (index, row) in (start..).zip(rows) {
            if let Some(json) = &row.json {
                output::print(&format!("{}\n{json}", if index == 0 { "" } else { "," }))?;
            }
            report.add(index, &row.found);
            if let Some(columns) = &mut columns {
                columns.add(row);
            }
        }
    }
    bar.finish_and_clear();
    output::print(&if layout.is_json() { "\n]}\n".into() } else { report.text(input, image) })?;
    if let (Some(columns), Some(path)) = (columns, file) {
        columns.write(path, input, elements.at, layout)?;
    }
    Ok(Status::Proved)
}

impl From<arguments::At> for At {
    fn from(at: arguments::At) -> At {
        match at {
            arguments::At::Faces => At::Faces,
            arguments::At::Vertices => At::Vertices,
        }
    }
}
