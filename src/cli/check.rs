//! `isogeo check`: verdicts.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::arguments::{CheckOptions, Layout};
use super::existence::{Existence, Verified};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::check::{Decide, Decider, Element, Reason, Report, Verdict};
use crate::mesh::VertexId;
use crate::net::{Net, Property};
use crate::pair::{Couple, PairProperty};
use crate::scalar::{Rational, ReadAs};

/// A property of the mesh, or of the pair.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Asked {
    Mesh(Property),
    Pair(PairProperty),
}

/// A report, and what a certificate says where the numbers refute the property.
struct Judged {
    report: Report<Rational>,
    existence: Option<Verified>,
}

impl Judged {
    fn verdict(&self) -> Verdict {
        match self.existence {
            Some(Ok(_)) => Verdict::Exists,
            _ => self.report.verdict(),
        }
    }
}

/// Judges the mesh and prints the report.
pub fn run(options: &CheckOptions, layout: Layout) -> Result<Status, Failure> {
    let asked = asked(&options.is, options.with.is_some())?;
    if options.tolerance.is_some_and(|t| !t.is_finite() || t < 0.0) {
        return Err(Failure::usage(
            "a tolerance is a finite number that is not negative, such as 1e-9",
        ));
    }
    let input = input::read(&options.input)?;
    let image = options.with.as_ref();
    let image = image.map(|path| input::read_image(path, &options.input, &input)).transpose()?;
    let bar = output::progress(input.topology().face_count(), "clearing denominators");
    let mut decider = input.decider().within(options.tolerance);
    if let Some(image) = &image {
        decider = decider.followed_by(image.decider());
    }
    let radii = input.radii();
    let meshes = 1 + image.iter().len();
    if let Some(radii) = &radii {
        decider = decider.followed_by(Decider::of_rationals(radii));
    }
    let mut net = Net::new(input.topology(), &decider);
    if radii.is_some() {
        net = net.with_radii(VertexId((meshes * input.topology().vertex_count()) as u32));
    }
    let couple = couple(&input, image.as_ref(), &decider)?;
    let certificate = Existence::new(&input);
    let reports = asked.into_iter().filter_map(|asked| {
        bar.set_message(asked.name());
        match asked {
            Asked::Mesh(property) => {
                let report = net.check(property);
                let is_refuted = report.verdict() == Verdict::Refuted;
                let existence = if is_refuted { certificate.of(property) } else { None };
                Some(Judged { report, existence })
            }
            Asked::Pair(property) => {
                let report = couple.as_ref()?.check(property);
                Some(Judged { report, existence: None })
            }
        }
    });
    let reports: Vec<_> = reports.collect();
    bar.finish_and_clear();
    if layout.is_json() {
        output::print_json(&as_json(&input, image.as_ref(), options, &reports))?;
    } else {
        output::print(&as_text(&input, image.as_ref(), options, &reports))?;
    }
    Ok(status(options, &reports))
}

fn couple<'a, D: Decide>(
    input: &'a Input,
    image: Option<&Input>,
    decide: &'a D,
) -> Result<Option<Couple<'a, D>>, Failure> {
    let couple = |image: &Input| Couple::new(input.topology(), image.topology(), decide);
    image.map(couple).transpose().map_err(|misfit| Failure::usage(misfit.to_string()))
}

impl Asked {
    fn name(self) -> &'static str {
        match self {
            Asked::Mesh(property) => property.name(),
            Asked::Pair(property) => property.name(),
        }
    }

    fn from_name(name: &str, with: bool) -> Result<Asked, Failure> {
        let pair = PairProperty::from_name(name);
        if let Some(property) = pair.filter(|_| with) {
            return Ok(Asked::Pair(property));
        }
        if let Some(property) = Property::from_name(name) {
            return Ok(Asked::Mesh(property));
        }
        let known = Property::ALL.map(Property::name).join(", ");
        let pairs = PairProperty::ALL.map(PairProperty::name).join(", ");
        let (message, help) = match pair {
            Some(_) => (
                format!("the property '{name}' is that of a pair of meshes"),
                "add --with S, the second mesh".to_owned(),
            ),
            None => (
                format!("there is no property '{name}'"),
                format!("the properties are {known}; of a pair, with --with S, {pairs}"),
            ),
        };
        Err(Failure::with_help(message, help))
    }
}

/// The properties of these names, each once; all of them, if there are no names.
fn asked(names: &[String], with: bool) -> Result<Vec<Asked>, Failure> {
    if names.is_empty() {
        let pairs = PairProperty::ALL.into_iter().filter(|_| with).map(Asked::Pair);
        // 'i-minimal' is one name: that of the pair, if there is one.
        let of_pair = |p: &Property| with && PairProperty::from_name(p.name()).is_some();
        let alone = Property::ALL.into_iter().filter(|p| !of_pair(p)).map(Asked::Mesh);
        return Ok(alone.chain(pairs).collect());
    }
    let mut all = Vec::new();
    for name in names {
        let asked = Asked::from_name(name, with)?;
        if !all.contains(&asked) {
            all.push(asked);
        }
    }
    Ok(all)
}

fn status(options: &CheckOptions, reports: &[Judged]) -> Status {
    let verdicts = || reports.iter().map(Judged::verdict);
    if options.is.is_empty() || verdicts().all(|v| v == Verdict::Proved) {
        Status::Proved
    } else if verdicts().any(|v| v == Verdict::Refuted) {
        Status::Refuted
    } else {
        Status::Open
    }
}

fn as_text(
    input: &Input,
    image: Option<&Input>,
    options: &CheckOptions,
    reports: &[Judged],
) -> String {
    let topology = input.topology();
    let mut text = format!(
        "{}: {} ({} interior), {}; {}\n",
        input.file.name,
        words::vertices(topology.vertex_count()),
        topology.interior_vertices().count(),
        words::count(topology.face_count(), "face"),
        reading(input),
    );
    if let Some(image) = image {
        let _ = writeln!(text, "with {}; {}", image.file.name, reading(image));
    }
    let width = reports.iter().map(|r| r.report.property.len() + 1).fold(15, usize::max);
    let indent = width + 14;
    for judged in reports {
        let report = &judged.report;
        let verdict = match judged.verdict() {
            Verdict::Refuted => "REFUTED".to_owned(),
            verdict => verdict.to_string(),
        };
        let mut details = details(report, options);
        if let Some(Ok((_, words))) = &judged.existence {
            details = format!("verified again: {words}\n{:indent$}as printed {details}", "");
        }
        let _ = writeln!(text, "  {:<width$}{verdict:<12}{details}", report.property);
        if let Some(witness) = &report.worst {
            let failure = &witness.failure;
            let residual = match &failure.residual {
                Some(value) => format!(" residual {},", words::exact(value)),
                None => String::new(),
            };
            let _ = writeln!(
                text,
                "{:indent$}worst: {}, {}:{residual} defect {}",
                "",
                witness.element,
                failure.condition,
                words::defect(failure.defect)
            );
        }
        if let Some(Err(why)) = &judged.existence {
            let _ = writeln!(text, "{:indent$}the certificate is not verified: {why}", "");
        }
        if let Some((element, reason)) = report.undefined.first() {
            let _ = writeln!(text, "{:indent$}undefined first at {element}: {reason}", "");
        }
    }
    if options.input.read_as.is_none() && reports.iter().any(|r| r.report.consistent > 0) {
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
        _ if input.encloses() => "exact numbers that enclose another mesh: see the certificate",
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

fn as_json(
    input: &Input,
    image: Option<&Input>,
    options: &CheckOptions,
    reports: &[Judged],
) -> Value {
    let topology = input.topology();
    let properties: Vec<Value> = reports.iter().map(report_json).collect();
    let mut report = json!({
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
    });
    if let Some(image) = image {
        report["with"] = json!(image.file.name);
        report["with_read_as"] = json!(image.read_as.name());
    }
    report
}

fn report_json(judged: &Judged) -> Value {
    let report = &judged.report;
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
    let mut value = json!({
        "property": report.property,
        "verdict": judged.verdict().name(),
        "checked": report.checked,
        "failed": report.failures.len(),
        "undefined": report.undefined.len(),
        "undecided": report.undecided + report.consistent,
        "consistent": report.consistent,
        "trivial": report.trivial,
        "worst": worst,
        "failures": report.failures.iter().map(element_json).collect::<Vec<_>>(),
        "undefined_at": undefined.collect::<Vec<_>>(),
    });
    match &judged.existence {
        Some(Ok((radius, _))) => value["radius"] = json!(radius.to_string()),
        Some(Err(why)) => value["not_verified"] = json!(why),
        None => {}
    }
    value
}

fn element_json(element: &Element) -> Value {
    match element {
        Element::Face(f) => json!({ "face": f.0 }),
        Element::Vertex(v) => json!({ "vertex": v.0 }),
        Element::Edge(a, b) => json!({ "edge": [a.0, b.0] }),
    }
}
