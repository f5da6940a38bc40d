//! `isogeo figure`: the figures of the paper.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::{FigureKind, FigureOptions, Layout};
use super::failure::Failure;
use super::{Status, output};
use crate::figure::{Figure, Kind, gallery, index};
use crate::mesh::file::write_whole;

/// Makes figures and writes or compares their files.
pub fn run(options: &FigureOptions, layout: Layout) -> Result<Status, Failure> {
    let figures = asked(&options.id)?;
    let kinds: Vec<Kind> = options.kinds.iter().map(|kind| (*kind).into()).collect();
    let built = Kind::ALL.into_iter().filter(|kind| kind.is_built());
    let kinds = if kinds.is_empty() { built.collect() } else { kinds };
    let bar = output::slow_steps(figures.len(), "figures");
    let mut text = String::new();
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    let mut plates = Vec::new();
    for figure in figures {
        let plate = figure.plate().map_err(|why| {
            Failure::usage(format!("figure {} cannot be drawn: {why}", figure.number))
        })?;
        for &kind in &kinds {
            let own = figure.files(&plate, kind)?.into_iter();
            files.extend(own.map(|(name, text)| (Path::new(&figure.folder()).join(name), text)));
        }
        plates.push((figure, plate));
        bar.inc(1);
        // Writing to a string does not fail.
        let _ = writeln!(text, "Fig. {}: {}", figure.number, figure.title);
    }
    bar.finish_and_clear();
    if options.id == "all" && kinds.contains(&Kind::Svg) {
        files.push(("README.md".into(), gallery(&plates).into_bytes()));
    }
    if options.id == "all" && kinds.contains(&Kind::Html) {
        files.push(("index.html".into(), index(&plates).into_bytes()));
    }
    let (mut drifted, mut written) = (Vec::new(), Vec::new());
    for (name, contents) in files {
        let path = options.out.join(name);
        let name = path.display().to_string();
        if !options.check {
            let folder = path.parent().unwrap_or(&options.out);
            fs::create_dir_all(folder)
                .map_err(|e| Failure::io(format!("{}: {e}", folder.display())))?;
            write_whole(&path, &contents)?;
            written.push(name);
        } else if let Some(place) = difference(&fs::read(&path).ok(), &contents) {
            let _ = writeln!(text, "{name}: {place}");
            drifted.push(json!({ "file": name, "place": place }));
        }
    }
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.figures/1",
            "figures": plates.iter().map(|(f, _)| f.number).collect::<Vec<_>>(),
            "written": written,
            "drifted": drifted,
        }))?;
    } else {
        output::print(&text)?;
    }
    Ok(if drifted.is_empty() { Status::Proved } else { Status::Refuted })
}

fn asked(id: &str) -> Result<Vec<&'static Figure>, Failure> {
    let figures: Vec<&Figure> =
        Figure::ALL.iter().filter(|f| id == "all" || id == f.number.to_string()).collect();
    if figures.is_empty() {
        let numbers: Vec<String> = Figure::ALL.iter().map(|f| f.number.to_string()).collect();
        return Err(Failure::with_help(
            format!("'{id}' is no figure"),
            format!("there are {} and all", numbers.join(", ")),
        ));
    }
    Ok(figures)
}

/// Where a file differs from what it should be; `None` where it does not.
fn difference(found: &Option<Vec<u8>>, expected: &[u8]) -> Option<String> {
    let Some(found) = found else { return Some("is not there".into()) };
    if found == expected {
        return None;
    }
    let at = found.iter().zip(expected).position(|(a, b)| a != b);
    let at = at.unwrap_or_else(|| found.len().min(expected.len()));
    let line = 1 + expected[..at].iter().filter(|byte| **byte == b'\n').count();
    Some(format!("differs from line {line} on"))
}

impl From<FigureKind> for Kind {
    fn from(kind: FigureKind) -> Kind {
        match kind {
            FigureKind::Json => Kind::Json,
            FigureKind::Svg => Kind::Svg,
            FigureKind::Pdf => Kind::Pdf,
            FigureKind::Png => Kind::Png,
            FigureKind::Tikz => Kind::Tikz,
            FigureKind::Vtu => Kind::Vtu,
            FigureKind::Html => Kind::Html,
        }
    }
}
