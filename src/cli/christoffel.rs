//! `isogeo christoffel`: the Christoffel dual.

use serde_json::json;

use super::arguments::{ChristoffelOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::check::Verdict;
use crate::construct::{
    ChristoffelDual, NoChristoffelDual, christoffel_by_diagonals, christoffel_by_radii,
};
use crate::mesh::Mesh;
use crate::mesh::file::Options;
use crate::net::{Net, Property, RADIUS};
use crate::scalar::Rational;

/// Writes the dual with what proves that it closes, or says where it does not: a result.
pub fn run(options: &ChristoffelOptions, layout: Layout) -> Result<Status, Failure> {
    let input = input::read(&options.input)?;
    let mesh = input.exact();
    let bar = output::progress(mesh.topology.face_count(), "closing the dual");
    let (rule, found) = match mesh.data.vertex.get(RADIUS) {
        Some(radii) => ("radii", christoffel_by_radii(&mesh, radii)),
        None => ("diagonals", christoffel_by_diagonals(&mesh)),
    };
    bar.finish_and_clear();
    let found = match found {
        Ok(found) => found,
        Err(reason) => return refuse(&reason, rule, &input, layout),
    };
    let certificate = certificate(rule, &mesh, &found);
    let written =
        Options { certificate: Some(json!({ "christoffel": certificate })), ..Options::default() };
    let path = &options.output.output;
    output::write_saying(
        path,
        &found.mesh,
        &written,
        layout,
        [("christoffel", certificate.clone())],
    )?;
    if !layout.is_json() {
        let (faces, cycles) = (&certificate["faces_closed"], &certificate["cycles_closed"]);
        output::print(&format!("  by {rule}; {faces} faces and {cycles} further cycles close\n"))?;
    }
    Ok(Status::Proved)
}

/// The factors `1/ν` of the dual and how many conditions were found to hold.
fn certificate(
    rule: &str,
    mesh: &Mesh<Rational>,
    found: &ChristoffelDual<Rational>,
) -> serde_json::Value {
    let topology = &mesh.topology;
    let tree = topology.vertex_count() - topology.component_count();
    // Every edge beyond a tree closes a cycle; those of the faces are among them.
    let cycles = (topology.edge_count() - tree).saturating_sub(topology.face_count());
    json!({
        "rule": rule,
        "factors": found.factors.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "faces_closed": topology.face_count(),
        "cycles_closed": cycles,
    })
}

fn refuse(
    reason: &NoChristoffelDual<Rational>,
    rule: &str,
    input: &Input,
    layout: Layout,
) -> Result<Status, Failure> {
    let status = match reason.is_undefined() {
        false if is_refuted(input) => Status::Refuted,
        _ => Status::Open,
    };
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-christoffel-dual/1",
            "file": input.file.name,
            "rule": rule,
            "reason": reason.to_string(),
            "cycle": reason.cycle(),
        }))?;
    } else {
        let hint = match status {
            Status::Open if !reason.is_undefined() => {
                "\n  it may exist within the digits; it is made from the numbers as they are printed"
            }
            _ => "",
        };
        let reason = reason.map(words::exact);
        output::print(&format!("{}: no Christoffel dual: {reason}{hint}\n", input.file.name))?;
    }
    Ok(status)
}

/// Whether there is no dual, whatever the unprinted digits were.
fn is_refuted(input: &Input) -> bool {
    if !input.is_rounded() {
        return true;
    }
    let decider = input.decider();
    Net::new(input.topology(), &decider).check(Property::Koenigs).verdict() == Verdict::Refuted
}
