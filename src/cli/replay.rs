//! `isogeo replay`: one case again, made small.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::{Layout, ReplayOptions};
use super::failure::Failure;
use super::{Status, output};
use crate::campaign::{Case, Failure as Found};
use crate::claim::{Run, Stop};
use crate::mesh::file::{self, Options};

/// Runs the case and shows it, with what fails.
pub fn run(options: &ReplayOptions, layout: Layout) -> Result<Status, Failure> {
    // A panic is a failing case, and is reported as that.
    std::panic::set_hook(Box::new(|_| {}));
    let (mut found, mut outcome) = match Path::new(&options.case).is_file() {
        true => from_file(&options.case)?,
        false => by_name(&options.case)?,
    };
    if options.shrink
        && outcome.is_err()
        && let Some(smaller) = found.case.failure(true)
    {
        outcome = Err(Stop::Failed(smaller.what.clone().into()));
        found = smaller;
    }
    let (word, status) = match &outcome {
        Ok(()) => ("holds", Status::Proved),
        Err(Stop::Excluded(_)) => ("excluded", Status::Open),
        Err(Stop::Failed(_)) => ("fails", Status::Refuted),
    };
    let test = (options.shrink && status == Status::Refuted).then(|| found.rust_test());
    let written = write_meshes(options, &found, test.is_some())?;
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.replay/1",
            "outcome": word,
            "case": found.to_json(),
            "test": test,
            "written": written,
        }))?;
    } else {
        output::print(&text(&found, word, &written, test.as_deref()))?;
    }
    Ok(status)
}

fn by_name(name: &str) -> Result<(Found, Run), Failure> {
    let case: Case = name.parse().map_err(|why| {
        Failure::with_help(format!("'{name}': {why}"), "isogeo fuzz --list lists the properties")
    })?;
    let outcome = case.run();
    Ok((Found { case, what: words(&outcome), parts: case.parts() }, outcome))
}

/// What the file holds is run, whatever would be drawn by its name.
fn from_file(path: &str) -> Result<(Found, Run), Failure> {
    let text = fs::read_to_string(path).map_err(|e| Failure::io(format!("{path}: {e}")))?;
    let unfit = |why: String| Failure::usage(format!("{path}: {why}"));
    let mut found = Found::from_json(&text).map_err(|why| unfit(why.to_string()))?;
    let outcome = found.again();
    let outcome = outcome.ok_or_else(|| unfit("these are not the parts of such a case".into()))?;
    found.what = words(&outcome);
    Ok((found, outcome))
}

/// What fails, or which hypothesis does not hold.
fn words(outcome: &Run) -> String {
    match outcome {
        Ok(()) => String::new(),
        Err(Stop::Excluded(hypothesis)) => format!("not so: {hypothesis}"),
        Err(Stop::Failed(why)) => why.to_string(),
    }
}

fn write_meshes(
    options: &ReplayOptions,
    found: &Found,
    shrunk: bool,
) -> Result<Vec<String>, Failure> {
    let name = || {
        let case = &found.case;
        PathBuf::from(format!("{}-{}.iso.json", case.property.id(), case.index))
    };
    let Some(path) = options.output.clone().or_else(|| shrunk.then(name)) else {
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

fn text(found: &Found, word: &str, written: &[String], test: Option<&str>) -> String {
    let word = if word == "fails" { "FAILS" } else { word };
    let mut text = format!("{}: {word}\n{}\n", found.case, found.case.property.says());
    // Writing to a string does not fail.
    if !found.what.is_empty() {
        let _ = writeln!(text, "  {}", found.what);
    }
    if !found.parts.numbers.is_empty() {
        let numbers: Vec<String> = found.parts.numbers.iter().map(|q| q.to_string()).collect();
        let _ = writeln!(text, "  numbers: {}", numbers.join(" "));
    }
    for (mesh, n) in found.parts.meshes.iter().zip(1..) {
        let faces = mesh.topology.face_count();
        let _ = writeln!(text, "  mesh {n}, faces and vertices:");
        for face in mesh.topology.faces().take(12) {
            let corners = mesh.topology.face(face).iter().map(|v| {
                let p = &mesh.points[v.index()];
                format!("({}, {}, {})", p.x, p.y, p.z)
            });
            let _ = writeln!(text, "    {}", corners.collect::<Vec<_>>().join(" "));
        }
        if faces > 12 {
            let _ = writeln!(text, "    ... and {} more", faces - 12);
        }
    }
    for path in written {
        let _ = writeln!(text, "  written: {path}");
    }
    if let Some(test) = test {
        let _ = write!(text, "\n{test}");
    }
    text
}
