//! `isogeo certify`: a proof that an exact mesh is near.

use serde_json::{Value, json};

use super::arguments::{CertifyOptions, Layout, Reading};
use super::failure::Failure;
use super::{Status, input, optimize, output, words};
use crate::mesh::file::{Format, Options};
use crate::optimise::Goal;
use crate::optimise::existence::{Certificate, Existence, Pinned};

/// Writes the mesh with its certificate, or says why there is none: a result, not an error.
pub fn run(options: &CertifyOptions, layout: Layout) -> Result<Status, Failure> {
    if Format::from_path(&options.output) != Some(Format::IsoJson) {
        return Err(Failure::with_help(
            format!("{} cannot hold a certificate", options.output.display()),
            "write an .iso.json file",
        ));
    }
    let input = input::read_file(&options.mesh, Some(Reading::Double), &options.limits)?;
    let goal = Goal::from(options.is);
    let pinned = match options.fix.as_deref().map(str::trim) {
        None => Pinned::Nothing,
        Some("boundary") => Pinned::Boundary,
        Some(list) => Pinned::Vertices(optimize::fixed(list, input.topology())?),
    };
    let mesh = input.exact();
    let bar = output::spinner("proving");
    let made = Certificate::make(&mesh.topology, &mesh.points, goal, pinned);
    bar.finish_and_clear();
    match made {
        Ok((certificate, proved)) => {
            let claims = with(input.file.certificate, &certificate)?;
            let write = Options { certificate: Some(claims), ..Options::default() };
            let found = [("existence", in_numbers(&certificate, &proved))];
            output::write_saying(&options.output, &mesh, &write, layout, found)?;
            if !layout.is_json() {
                output::print(&format!("  {}\n", in_words(&certificate)))?;
            }
            Ok(Status::Proved)
        }
        Err(reason) => {
            let (file, property) = (&input.file.name, goal.property().name());
            if layout.is_json() {
                output::print_json(&json!({
                    "schema": "isogeo.no-proof/1",
                    "file": file,
                    "property": property,
                    "reason": reason.to_string(),
                }))?;
            } else {
                output::print(&format!(
                    "{file}: no {property} mesh is proved to be near: {reason}\n"
                ))?;
            }
            Ok(Status::Open)
        }
    }
}

/// The claim, and the bounds that prove it.
pub(super) fn in_numbers(certificate: &Certificate, proved: &Existence) -> Value {
    let mut value = certificate.json();
    for (name, bound) in [
        ("distance", proved.distance),
        ("singular_value", proved.singular_value),
        ("residual", proved.residual),
        ("deviation", proved.deviation),
        ("lipschitz", proved.lipschitz),
        ("contraction", proved.contraction),
    ] {
        value[name] = json!(bound);
    }
    value["equations"] = json!(proved.equations);
    value
}

/// The certificate of a file with one more claim.
fn with(old: Option<Value>, new: &Certificate) -> Result<Value, Failure> {
    let mut all = old.unwrap_or(json!({}));
    match all.as_object_mut() {
        Some(claims) => claims.insert(Certificate::NAME.to_owned(), new.json()),
        None => return Err(Failure::usage("the certificate of the file is no object")),
    };
    Ok(all)
}

/// "an exact planar mesh is within 3.2e-16, with the same boundary".
pub(super) fn in_words(certificate: &Certificate) -> String {
    let shared = match &certificate.pinned {
        Pinned::Nothing => String::new(),
        Pinned::Boundary => ", with the same boundary".to_owned(),
        Pinned::Vertices(list) => format!(", with {} in common", words::vertices(list.len())),
    };
    let property = certificate.goal.property().name();
    format!("an exact {property} mesh is within {}{shared}", words::radius(&certificate.radius))
}
