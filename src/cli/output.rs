//! Printing: results to standard output, notes and progress to standard error.

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::Layout;
use super::failure::Failure;
use crate::mesh::Mesh;
use crate::mesh::file::{self, Options, Written};
use crate::scalar::Rational;

/// Prints a text; a reader that has gone away is no error.
pub fn print(text: &str) {
    print_bytes(text.as_bytes());
}

/// Prints bytes; a reader that has gone away is no error.
pub fn print_bytes(bytes: &[u8]) {
    let mut out = io::stdout().lock();
    let _ = out.write_all(bytes).and_then(|()| out.flush());
}

/// Prints a JSON value on lines of its own.
pub fn print_json(value: &serde_json::Value) {
    print(&format!("{value:#}\n"));
}

/// Writes a mesh and says what was written.
pub fn write(
    path: &Path,
    mesh: &Mesh<Rational>,
    options: &Options,
    layout: Layout,
) -> Result<(), Failure> {
    write_saying(path, mesh, options, layout, None)
}

/// The same, with one more field for programs.
pub fn write_saying(
    path: &Path,
    mesh: &Mesh<Rational>,
    options: &Options,
    layout: Layout,
    extra: Option<(&str, serde_json::Value)>,
) -> Result<(), Failure> {
    let written = file::write(path, mesh, options)?;
    let exact = written == Written::Exact;
    let (vertices, faces) = (mesh.topology.vertex_count(), mesh.topology.face_count());
    if layout.is_json() {
        let mut report = serde_json::json!({
            "schema": "isogeo.written/1",
            "file": path.display().to_string(),
            "vertices": vertices,
            "faces": faces,
            "exact": exact,
        });
        if let Some((key, value)) = extra {
            report[key] = value;
        }
        print_json(&report);
    } else {
        let how = if exact { "exactly" } else { "rounded; .iso.json would be exact" };
        print(&format!("{}: {vertices} vertices, {faces} faces, written {how}\n", path.display()));
    }
    Ok(())
}

/// A sign of life on a terminal while something large is done; silent elsewhere.
pub fn progress(size: usize, what: &'static str) -> ProgressBar {
    const LARGE: usize = 200_000;
    if size < LARGE || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new_spinner().with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}
