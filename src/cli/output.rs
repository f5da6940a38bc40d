//! Printing: results to standard output, notes and progress to standard error.

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::Layout;
use super::failure::Failure;
use super::words;
use crate::mesh::Mesh;
use crate::mesh::file::{self, Format, Options, STANDARD_OUTPUT, Written};
use crate::scalar::Rational;

/// Prints a text; a reader that has gone away is no error, a full disk is.
pub fn print(text: &str) -> Result<(), Failure> {
    print_bytes(text.as_bytes())
}

/// Prints bytes, as [`print`] does.
pub fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::io(format!("the report cannot be printed: {e}")))
        }
        _ => Ok(()),
    }
}

/// Prints a JSON value on lines of its own.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    print(&format!("{value:#}\n"))
}

/// Prints to standard error; where that is not possible there is nobody left to tell.
pub fn complain(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Writes a mesh and says what was written, on standard error if the mesh is on standard output.
pub fn write(
    path: &Path,
    mesh: &Mesh<Rational>,
    options: &Options,
    layout: Layout,
) -> Result<(), Failure> {
    write_saying(path, mesh, options, layout, None)
}

/// The same, with more fields for programs.
pub fn write_saying<'a>(
    path: &Path,
    mesh: &Mesh<Rational>,
    options: &Options,
    layout: Layout,
    extra: impl IntoIterator<Item = (&'a str, serde_json::Value)>,
) -> Result<(), Failure> {
    let written = file::write(path, mesh, options)?;
    let exact = written == Written::Exact;
    let (vertices, faces) = (mesh.topology.vertex_count(), mesh.topology.face_count());
    let report = if layout.is_json() {
        let mut report = serde_json::json!({
            "schema": "isogeo.written/1",
            "file": path.display().to_string(),
            "vertices": vertices,
            "faces": faces,
            "exact": exact,
            "data_kept": keeps_data(path, mesh),
        });
        for (key, value) in extra {
            report[key] = value;
        }
        format!("{report:#}\n")
    } else {
        let is_json = Format::from_path(path) == Some(Format::IsoJson);
        let how = match (exact, options.rounded) {
            (true, true) if is_json => "exactly: the printed decimals as they stand",
            (true, true) => "as printed; the numbers stay rounded",
            (true, false) => "exactly",
            (false, _) => "rounded; .iso.json would be exact",
        };
        let size = format!("{}, {}", words::vertices(vertices), words::count(faces, "face"));
        let kept = if keeps_data(path, mesh) { "" } else { "; its data are left out" };
        format!("{}: {size}, written {how}{kept}\n", path.display())
    };
    if path == Path::new(STANDARD_OUTPUT) {
        complain(&report);
        return Ok(());
    }
    print(&report)
}

/// Whether the format holds all that the mesh has beside its geometry.
fn keeps_data(path: &Path, mesh: &Mesh<Rational>) -> bool {
    let has_none = mesh.data.vertex.is_empty() && mesh.data.face.is_empty();
    has_none || matches!(Format::from_path(path), Some(Format::IsoJson | Format::Vtu))
}

/// How far something large has come, on a terminal; silent elsewhere.
pub fn steps(count: usize, what: &'static str) -> ProgressBar {
    const LARGE: usize = 50_000;
    if count < LARGE { ProgressBar::hidden() } else { slow_steps(count, what) }
}

/// How far a few slow steps have come, on a terminal; silent elsewhere.
pub fn slow_steps(count: usize, what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(count as u64).with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent}% {eta}") {
        bar.set_style(style);
    }
    bar
}

/// A sign of life on a terminal while something large is done; silent elsewhere.
pub fn progress(size: usize, what: &'static str) -> ProgressBar {
    const LARGE: usize = 200_000;
    if size < LARGE { ProgressBar::hidden() } else { spinner(what) }
}

/// A sign of life on a terminal; silent elsewhere.
pub fn spinner(what: &'static str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new_spinner().with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}
