//! Meshes into files: whole, or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write as _};
use std::num::NonZeroU16;
use std::path::{Path, PathBuf};

use super::{FileError, Format, decimal};
use crate::mesh::{Mesh, Topology};
use crate::scalar::RationalField;

/// How a mesh is written.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Decimals with so many significant digits, where the format has decimals.
    pub digits: Option<NonZeroU16>,
    /// Whether the numbers of the mesh are themselves rounded, as those of a file from the world are:
    /// then the file does not say that they are exact, however exactly they are written.
    pub rounded: bool,
    /// `key=value` pairs for the header line of OBJ, OFF and PLY; `coords` is set by the writer.
    pub notes: BTreeMap<String, String>,
    /// What stands under `certificate` in an `.iso.json` file.
    pub certificate: Option<serde_json::Value>,
}

/// The path that stands for the standard output of the process.
pub const STANDARD_OUTPUT: &str = "/dev/stdout";

/// Whether the coordinates in a file are those of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// Every coordinate was written exactly, and the file says so where the format lets it and the
    /// numbers are not rounded themselves.
    Exact,
    /// At least one coordinate was rounded.
    Rounded,
}

/// Writes a mesh in the format that the name asks for.
///
/// OBJ, OFF and PLY hold decimals, and say that these are exact where every coordinate is a
/// decimal of at most 40 digits; else all are rounded to the nearest double and printed as short
/// as possible. VTU holds doubles. `data` go into `.iso.json` and VTU, the other formats hold
/// geometry only. The file appears whole or not at all: see [`write_whole`]. [`STANDARD_OUTPUT`], and a
/// device or pipe whose name says no format, is sent an `.iso.json` file.
///
/// # Errors
/// An unknown format, a coordinate beyond the range of doubles, a name that the format cannot
/// hold, and whatever the file system says.
pub fn write<Q: RationalField>(
    path: impl AsRef<Path>,
    mesh: &Mesh<Q>,
    options: &Options,
) -> Result<Written, FileError> {
    let path = path.as_ref();
    let format = format(path)?;
    let name = path.display().to_string();
    let (bytes, written) = write_string(&name, format, mesh, options)?;
    write_whole(path, bytes.as_bytes())?;
    Ok(written)
}

/// The format in which a mesh is written to a path.
fn format(path: &Path) -> Result<Format, FileError> {
    let is_special = || {
        path == Path::new(STANDARD_OUTPUT)
            || fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir())
    };
    let format = Format::from_path(path).or_else(|| is_special().then_some(Format::IsoJson));
    format.ok_or_else(|| super::unknown_format(path))
}

/// The text of the file that [`write()`] makes; `name` is for error messages.
///
/// # Errors
/// As for [`write()`], without the file system.
pub fn write_string<Q: RationalField>(
    name: &str,
    format: Format,
    mesh: &Mesh<Q>,
    options: &Options,
) -> Result<(String, Written), FileError> {
    let text = Text { name, format, options };
    match format {
        Format::Obj => super::obj::write(mesh, &text),
        Format::Off => super::off::write(mesh, &text),
        Format::Ply => super::ply::write(mesh, &text),
        Format::IsoJson => Ok((super::iso_json::write(mesh, options), Written::Exact)),
        Format::Vtu => super::vtu::write(mesh, &text),
    }
}

/// Writes a file through a temporary one beside it, so that it appears whole or not at all.
///
/// A file that is there stays as it is until then, and keeps its permissions; one that may not be
/// written to is not replaced. A symbolic link stays one. What is there and is no regular file (a
/// device, a pipe), and [`STANDARD_OUTPUT`] whatever it is, is written to as it is.
///
/// # Errors
/// What the file system says; then there is no temporary file left.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    let name = path.display().to_string();
    let failed = |e: io::Error| {
        FileError::new("io", "file", &name, format!("the file cannot be written: {e}"))
    };
    if path == Path::new(STANDARD_OUTPUT) {
        let mut out = io::stdout().lock();
        return out.write_all(bytes).and_then(|()| out.flush()).map_err(failed);
    }
    let old = fs::metadata(path).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return fs::write(path, bytes).map_err(failed);
    }
    if old.as_ref().is_some_and(|old| old.permissions().readonly()) {
        let message = "the file is read-only and is not replaced";
        return Err(FileError::new("io", "file", &name, message));
    }
    let target = destination(path);
    let (temporary, mut file) = temporary_beside(&target).map_err(failed)?;
    let permissions = |file: &fs::File| match &old {
        Some(old) => file.set_permissions(old.permissions()),
        None => Ok(()),
    };
    let result = permissions(&file)
        .and_then(|()| file.write_all(bytes))
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&temporary, &target));
    result.map_err(|error| {
        // The first error is the one to report.
        let _ = fs::remove_file(&temporary);
        failed(error)
    })
}

/// Where a path leads: the end of symbolic links, whether there is a file or not.
fn destination(path: &Path) -> PathBuf {
    const LONGEST: usize = 40;
    if let Ok(whole) = fs::canonicalize(path) {
        return whole;
    }
    let mut path = path.to_owned();
    for _ in 0..LONGEST {
        let Ok(link) = fs::read_link(&path) else { break };
        path = path.parent().map_or_else(|| link.clone(), |folder| folder.join(&link));
    }
    path
}

fn temporary_beside(path: &Path) -> io::Result<(PathBuf, fs::File)> {
    let mut attempt = 0u32;
    loop {
        // Not with the name of the file, which may be as long as names can be.
        let hidden = format!(".isogeo-{}-{attempt}.tmp", std::process::id());
        let temporary = path.with_file_name(hidden);
        match fs::OpenOptions::new().write(true).create_new(true).open(&temporary) {
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists && attempt < 1000 => attempt += 1,
            result => return result.map(|file| (temporary, file)),
        }
    }
}

/// What the writers of decimal formats have in common.
pub(super) struct Text<'a> {
    pub name: &'a str,
    pub format: Format,
    pub options: &'a Options,
}

impl Text<'_> {
    pub fn error(&self, kind: &str, message: impl Into<String>) -> FileError {
        FileError::new(kind, self.format.name(), self.name, message)
    }

    /// One line `x y z` for every vertex, each after `prefix`.
    pub fn points<Q: RationalField>(
        &self,
        mesh: &Mesh<Q>,
        prefix: &str,
    ) -> Result<(String, Written), FileError> {
        if let Some(digits) = self.options.digits {
            let mut exact = true;
            let lines = lines(mesh, prefix, |out, _, x| {
                exact &= decimal::push_rounded(out, x, digits.get().into());
                Ok(())
            })?;
            return Ok((lines, if exact { Written::Exact } else { Written::Rounded }));
        }
        let exact =
            |out: &mut String, _, x: &Q| decimal::push_exact(out, x).then_some(()).ok_or(());
        if let Ok(lines) = lines(mesh, prefix, exact) {
            return Ok((lines, Written::Exact));
        }
        let lines = lines(mesh, prefix, |out, vertex, x| {
            decimal::push_shortest(out, self.double(x, "vertex", vertex)?);
            Ok(())
        })?;
        Ok((lines, Written::Rounded))
    }

    /// The nearest double, if there is one.
    pub fn double<Q: RationalField>(
        &self,
        x: &Q,
        of: &str,
        index: usize,
    ) -> Result<f64, FileError> {
        let value = x.to_f64();
        if value.is_finite() {
            return Ok(value);
        }
        let message = format!("a number of {of} {index} is beyond the range of doubles");
        Err(self.error("not-finite", message).help("write an .iso.json file"))
    }

    /// The comment that says whether the coordinates are exact, and the notes of the options; after
    /// `prefix`, or nothing if there is nothing to say.
    pub fn note(&self, prefix: &str, written: Written) -> Result<String, FileError> {
        let mut line = String::new();
        if written == Written::Exact && !self.options.rounded {
            line.push_str(" coords=exact");
        }
        for (key, value) in self.options.notes.iter().filter(|(key, _)| *key != "coords") {
            if !is_note(key, value) {
                let message = format!("the note {key:?}={value:?} does not fit the header line");
                return Err(self.error("data", message));
            }
            line.push_str(&format!(" {key}={value}"));
        }
        Ok(if line.is_empty() { line } else { format!("{prefix}isogeo:{line}\n") })
    }
}

/// Whether `key=value` is one word of printable ASCII, as notes in header lines are.
pub(super) fn is_note(key: &str, value: &str) -> bool {
    let is_word = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_graphic());
    is_word(key) && is_word(value) && !key.contains('=')
}

fn lines<Q, E>(
    mesh: &Mesh<Q>,
    prefix: &str,
    mut push: impl FnMut(&mut String, usize, &Q) -> Result<(), E>,
) -> Result<String, E> {
    let mut out = String::new();
    for (vertex, point) in mesh.points.iter().enumerate() {
        out.push_str(prefix);
        for (x, end) in point.coordinates().into_iter().zip([' ', ' ', '\n']) {
            push(&mut out, vertex, x)?;
            out.push(end);
        }
    }
    Ok(out)
}

/// One line for every face: its number of corners, and these, counted from 0.
pub(super) fn push_faces(out: &mut String, topology: &Topology) {
    for face in topology.faces() {
        let corners = topology.face(face);
        out.push_str(&corners.len().to_string());
        for vertex in corners {
            out.push(' ');
            out.push_str(&vertex.0.to_string());
        }
        out.push('\n');
    }
}
