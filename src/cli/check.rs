//! `isogeo check`: verdicts.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::arguments::{CheckOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output};
use crate::check::{Element, Reason, Report, Verdict};
use crate::net::{Net, Property};
use crate::scalar::{Rational, ReadAs};

/// Properties of the interface that are not there yet.
const TO_COME: [&str; 9] = [
    "i-isothermic",
    "koenigs",
    "i-minimal",
    "edge-offset",
    "parallel",
    "f-parallel",
    "v-parallel",
    "christoffel-dual",
    "cmc",
];

/// Judges the mesh and prints the report.
pub fn run(options: &CheckOptions, layout: Layout) -> Result<Status, Failure> {
    let properties = properties(&options.is)?;
    if options.tolerance.is_some_and(|t| t.is_nan() || t < 0.0) {
        return Err(Failure::usage("a tolerance is a number that is not negative"));
    }
    let input = input::read(&options.input)?;
    let bar = output::progress(input.topology().face_count(), "clearing denominators");
    let decider = input.decider().within(options.tolerance);
    let net = Net::new(input.topology(), &decider);
    let reports: Vec<_> = properties
        .iter()
        .map(|&property| {
            bar.set_message(property.name());
            net.check(property)
        })
        .collect();
    bar.finish_and_clear();
    if layout.is_json() {
        output::print_json(&as_json(&input, options, &reports));
    } else {
        output::print(&as_text(&input, options, &reports));
    }
    Ok(status(options, &reports))
}

fn properties(names: &[String]) -> Result<Vec<Property>, Failure> {
    if names.is_empty() {
        return Ok(Property::ALL.to_vec());
    }
    let property = |name: &String| {
        Property::from_name(name).ok_or_else(|| {
            let known = Property::ALL.map(Property::name).join(", ");
            let message = if TO_COME.contains(&name.as_str()) {
                format!("the property '{name}' is not there yet")
            } else {
                format!("there is no property '{name}'")
            };
            Failure::with_help(message, format!("the properties are {known}"))
        })
    };
    names.iter().map(property).collect()
}

fn status(options: &CheckOptions, reports: &[Report<Rational>]) -> Status {
    let verdicts = || reports.iter().map(Report::verdict);
    if options.is.is_empty() || verdicts().all(|v| v == Verdict::Proved) {
        Status::Proved
    } else if verdicts().any(|v| v == Verdict::Refuted) {
        Status::Refuted
    } else {
        Status::Open
    }
}

fn as_text(input: &Input, options: &CheckOptions, reports: &[Report<Rational>]) -> String {
    let topology = input.topology();
    let mut text = format!(
        "{}: {} vertices ({} interior), {} faces; {}\n",
        input.file.name,
        topology.vertex_count(),
        topology.interior_vertices().count(),
        topology.face_count(),
        reading(input),
    );
    for report in reports {
        let verdict = match report.verdict() {
            Verdict::Refuted => "REFUTED".to_owned(),
            verdict => verdict.to_string(),
        };
        let _ =
            writeln!(text, "  {:<15}{verdict:<12}{}", report.property, details(report, options));
        if let Some(witness) = &report.worst {
            let failure = &witness.failure;
            let residual = match &failure.residual {
                Some(value) => format!(" residual {}", shortened(&value.to_string())),
                None => String::new(),
            };
            let _ = writeln!(
                text,
                "{:29}worst: {}, {}:{residual} (defect {:.1e})",
                "", witness.element, failure.condition, failure.defect
            );
        }
        if let Some((element, reason)) = report.undefined.first() {
            let _ = writeln!(text, "{:29}undefined first at {element}: {reason}", "");
        }
    }
    text
}

fn reading(input: &Input) -> &'static str {
    match input.read_as {
        _ if input.file.exact && input.read_as != ReadAs::Double => "numbers are exact",
        ReadAs::Decimal => "decimals are read as the numbers themselves",
        ReadAs::Rounded => "a decimal stands for ± half a unit of its last digit",
        ReadAs::Double => "a decimal stands for its nearest double",
    }
}

/// Elements of a property, in words.
fn details(report: &Report<Rational>, options: &CheckOptions) -> String {
    let total = report.checked + report.undefined.len();
    let mut parts = Vec::new();
    if total == 0 {
        return match report.trivial {
            0 => "nothing to check".into(),
            n => format!("nothing to check: it holds by itself on {n} elements"),
        };
    }
    let failed = report.failures.len();
    if failed > 0 {
        let list: Vec<String> = report.failures.iter().take(8).map(short).collect();
        let more = if failed > 8 { format!(" and {} more", failed - 8) } else { String::new() };
        parts.push(format!("{failed} of {total} fail: {}{more}", list.join(" ")));
    } else {
        let zero = report.checked - report.consistent - report.undecided;
        parts.push(format!("{zero} of {total} exactly zero"));
    }
    if report.consistent > 0 {
        parts.push(format!("{} possible within the digits", report.consistent));
    }
    if report.undecided > 0 {
        let tolerance = options.tolerance.unwrap_or(0.0);
        parts.push(format!("{} within the tolerance {tolerance:e}", report.undecided));
    }
    if !report.undefined.is_empty() {
        parts.push(format!("{} undefined", report.undefined.len()));
    }
    parts.join(", ")
}

fn short(element: &Element) -> String {
    match element {
        Element::Face(f) => f.0.to_string(),
        Element::Vertex(v) => v.0.to_string(),
        Element::Edge(a, b) => format!("{}-{}", a.0, b.0),
    }
}

/// Long numbers are cut for people.
fn shortened(number: &str) -> String {
    const MOST: usize = 60;
    if number.len() <= MOST {
        number.to_owned()
    } else {
        format!("{}... ({} characters)", &number[..MOST - 20], number.len())
    }
}

fn as_json(input: &Input, options: &CheckOptions, reports: &[Report<Rational>]) -> Value {
    let topology = input.topology();
    let properties: Vec<Value> = reports.iter().map(report_json).collect();
    json!({
        "schema": "isogeo.check/1",
        "file": input.file.name,
        "mesh": {
            "vertices": topology.vertex_count(),
            "faces": topology.face_count(),
            "interior_vertices": topology.interior_vertices().count(),
            "read_as": input.read_as.name(),
        },
        "tolerance": options.tolerance,
        "properties": properties,
    })
}

fn report_json(report: &Report<Rational>) -> Value {
    let worst = report.worst.as_ref().map(|witness| {
        let mut value = element_json(&witness.element);
        value["condition"] = json!(witness.failure.condition);
        value["residual"] = json!(witness.failure.residual.as_ref().map(Rational::to_string));
        value["defect"] = json!(witness.failure.defect);
        value
    });
    let undefined = report.undefined.iter().map(|(element, reason): &(Element, Reason)| {
        let mut value = element_json(element);
        value["reason"] = json!(reason.to_string());
        value
    });
    json!({
        "property": report.property,
        "verdict": report.verdict().name(),
        "checked": report.checked,
        "failed": report.failures.len(),
        "undefined": report.undefined.len(),
        "undecided": report.undecided + report.consistent,
        "consistent": report.consistent,
        "trivial": report.trivial,
        "worst": worst,
        "failures": report.failures.iter().map(element_json).collect::<Vec<_>>(),
        "undefined_at": undefined.collect::<Vec<_>>(),
    })
}

fn element_json(element: &Element) -> Value {
    match element {
        Element::Face(f) => json!({ "face": f.0 }),
        Element::Vertex(v) => json!({ "vertex": v.0 }),
        Element::Edge(a, b) => json!({ "edge": [a.0, b.0] }),
    }
}
