//! `isogeo replay`: one case again, made small.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::{Layout, ReplayOptions};
use super::failure::Failure;
use super::{Status, output};
use crate::campaign::{Campaign, Case, Failure as Found};
use crate::claim::Stop;
use crate::mesh::file::{self, Options};

/// Runs the case and shows what fails.
pub fn run(options: &ReplayOptions, layout: Layout) -> Result<Status, Failure> {
    // A panic is a failing case, and is reported as that.
    std::panic::set_hook(Box::new(|_| {}));
    let (found, outcome) = if Path::new(&options.case).is_file() {
        from_file(&options.case, options.shrink)?
    } else {
        by_name(&options.case, options.shrink)?
    };
    let Some(found) = found else {
        let word = if outcome == Status::Open { "excluded" } else { "holds" };
        report(layout, &options.case, word, None, &[])?;
        return Ok(outcome);
    };
    let written = write_meshes(options, &found)?;
    report(layout, &options.case, "fails", Some((&found, options.shrink)), &written)?;
    Ok(Status::Refuted)
}

type Outcome = Result<(Option<Found>, Status), Failure>;

fn by_name(name: &str, shrink: bool) -> Outcome {
    let case: Case = name.parse().map_err(|why| {
        Failure::with_help(format!("'{name}': {why}"), "isogeo fuzz --list lists the properties")
    })?;
    if let Some(found) = case.failure(shrink) {
        return Ok((Some(found), Status::Refuted));
    }
    let Case { property, seed, index } = case;
    let end = index.checked_add(1).ok_or_else(|| Failure::usage("there is no such index"))?;
    let tally = Campaign { property, seed, cases: end }.tally(index..end, &|| false);
    let holds = tally.is_some_and(|tally| tally.holds == 1);
    Ok((None, if holds { Status::Proved } else { Status::Open }))
}

/// What the file holds is run; it is made small by its name, if that still makes a failing case.
fn from_file(path: &str, shrink: bool) -> Outcome {
    let text = fs::read_to_string(path).map_err(|e| Failure::io(format!("{path}: {e}")))?;
    let unfit = |why: String| Failure::usage(format!("{path}: {why}"));
    let mut found = Found::from_json(&text).map_err(|why| unfit(why.to_string()))?;
    match found.again() {
        None => Err(unfit("these are not the parts of such a case".into())),
        Some(Ok(())) => Ok((None, Status::Proved)),
        Some(Err(Stop::Excluded(_))) => Ok((None, Status::Open)),
        Some(Err(Stop::Failed(why))) => {
            found.what = why.into_owned();
            let smaller = found.case.failure(true).filter(|_| shrink);
            Ok((Some(smaller.unwrap_or(found)), Status::Refuted))
        }
    }
}

fn write_meshes(options: &ReplayOptions, found: &Found) -> Result<Vec<String>, Failure> {
    let name = || {
        let case = &found.case;
        PathBuf::from(format!("{}-{}.iso.json", case.property.id(), case.index))
    };
    let Some(path) = options.output.clone().or_else(|| options.shrink.then(name)) else {
        return Ok(Vec::new());
    };
    let mut written = Vec::new();
    for (n, mesh) in found.parts.meshes.iter().enumerate() {
        let path = if n == 0 { path.clone() } else { numbered(&path, n + 1) };
        file::write(&path, mesh, &Options::default())?;
        written.push(path.display().to_string());
    }
    Ok(written)
}

/// `a.iso.json` becomes `a-2.iso.json`.
fn numbered(path: &Path, n: usize) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let (stem, end) = name.split_once('.').unwrap_or((&name, ""));
    path.with_file_name(format!("{stem}-{n}.{end}"))
}

fn report(
    layout: Layout,
    case: &str,
    word: &str,
    found: Option<(&Found, bool)>,
    written: &[String],
) -> Result<(), Failure> {
    if layout.is_json() {
        return output::print_json(&json!({
            "schema": "isogeo.replay/1",
            "case": case,
            "outcome": word,
            "failure": found.map(|(found, _)| found.to_json()),
            "test": found.filter(|(_, shrunk)| *shrunk).map(|(found, _)| found.rust_test()),
            "written": written,
        }));
    }
    let Some((found, shrunk)) = found else {
        return output::print(&format!("{case}: {word}\n"));
    };
    let mut text =
        format!("{}: FAILS\n{}\n  {}\n", found.case, found.case.property.says(), found.what);
    if !found.parts.numbers.is_empty() {
        let numbers: Vec<String> = found.parts.numbers.iter().map(|q| q.to_string()).collect();
        text.push_str(&format!("  numbers: {}\n", numbers.join(" ")));
    }
    for mesh in &found.parts.meshes {
        for face in mesh.topology.faces().take(12) {
            let corners = mesh.topology.face(face).iter().map(|v| {
                let p = &mesh.points[v.index()];
                format!("({}, {}, {})", p.x, p.y, p.z)
            });
            text.push_str(&format!(
                "  face {}: {}\n",
                face.0,
                corners.collect::<Vec<_>>().join(" ")
            ));
        }
    }
    for path in written {
        text.push_str(&format!("  written: {path}\n"));
    }
    if shrunk {
        text.push_str(&format!("\n{}", found.rust_test()));
    }
    output::print(&text)
}
