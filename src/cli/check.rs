//! `isogeo check`: verdicts.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::arguments::{CheckOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::check::{Element, Reason, Report, Verdict};
use crate::net::{Net, Property};
use crate::scalar::{Rational, ReadAs};

/// Properties of the interface that are not there yet.
const TO_COME: [&str; 10] = [
    "i-isothermic",
    "koenigs",
    "i-minimal",
    "edge-offset",
    "parallel",
    "f-parallel",
    "v-parallel",
    "christoffel-dual",
    "cmc",
    "constant-k",
];

/// Judges the mesh and prints the report.
pub fn run(options: &CheckOptions, layout: Layout) -> Result<Status, Failure> {
    let properties = properties(&options.is)?;
    if options.tolerance.is_some_and(|t| !t.is_finite() || t < 0.0) {
        return Err(Failure::usage(
            "a tolerance is a finite number that is not negative, such as 1e-9",
        ));
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
        output::print_json(&as_json(&input, options, &reports))?;
    } else {
        output::print(&as_text(&input, options, &reports))?;
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
    let mut properties = Vec::new();
    for name in names {
        let property = property(name)?;
        if !properties.contains(&property) {
            properties.push(property);
        }
    }
    Ok(properties)
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
        "{}: {} ({} interior), {}; {}\n",
        input.file.name,
        words::vertices(topology.vertex_count()),
        topology.interior_vertices().count(),
        words::count(topology.face_count(), "face"),
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
                Some(value) => format!(" residual {},", words::exact(value)),
                None => String::new(),
            };
            let _ = writeln!(
                text,
                "{:29}worst: {}, {}:{residual} defect {}",
                "",
                witness.element,
                failure.condition,
                words::defect(failure.defect)
            );
        }
        if let Some((element, reason)) = report.undefined.first() {
            let _ = writeln!(text, "{:29}undefined first at {element}: {reason}", "");
        }
    }
    if options.input.read_as.is_none() && reports.iter().any(|r| r.consistent > 0) {
        text.push_str(WITHIN_THE_DIGITS);
    }
    text
}

const WITHIN_THE_DIGITS: &str = "  \
  Within the digits: not exactly zero as printed, but zero for other numbers that are printed
  alike, element by element. With --read-as decimal the printed numbers themselves are judged.
";

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
            n => format!("nothing to check: it holds by itself on {}", words::count(n, "element")),
        };
    }
    let failed = report.failures.len();
    if failed > 0 {
        parts.push(format!("{failed} of {total} fail: {}", list(&report.failures)));
    } else {
        let zero = report.checked - report.consistent - report.undecided;
        parts.push(format!("{zero} of {total} exactly zero"));
    }
    if report.consistent > 0 {
        parts.push(format!("{} possible within the digits", report.consistent));
    }
    if report.undecided > 0 {
        let tolerance = options.tolerance.unwrap_or(0.0);
        parts.push(format!("{} within the tolerance {tolerance:?}", report.undecided));
    }
    if !report.undefined.is_empty() {
        parts.push(format!("{} undefined", report.undefined.len()));
    }
    parts.join("; ")
}

/// The first elements of a list, every kind named once: "faces 0 1 2, edge 0-3 and 7 more".
fn list(elements: &[Element]) -> String {
    const MOST: usize = 8;
    let (shown, rest) = elements.split_at(elements.len().min(MOST));
    let alike = |a: &Element, b: &Element| noun(a) == noun(b);
    let group = |group: &[Element]| match group {
        [one] => one.to_string(),
        _ => {
            let names: Vec<String> = group.iter().map(short).collect();
            format!("{} {}", group.first().map_or("", noun), names.join(" "))
        }
    };
    let groups: Vec<String> = shown.chunk_by(alike).map(group).collect();
    let more = if rest.is_empty() { String::new() } else { format!(" and {} more", rest.len()) };
    format!("{}{more}", groups.join(", "))
}

fn noun(element: &Element) -> &'static str {
    match element {
        Element::Face(_) => "faces",
        Element::Vertex(_) => "vertices",
        Element::Edge(..) => "edges",
    }
}

fn short(element: &Element) -> String {
    match element {
        Element::Face(f) => f.0.to_string(),
        Element::Vertex(v) => v.0.to_string(),
        Element::Edge(a, b) => format!("{}-{}", a.0, b.0),
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
