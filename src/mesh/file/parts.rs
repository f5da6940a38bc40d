//! A mesh while it is being read, and the step from there to a checked mesh.

use std::collections::BTreeMap;

use super::source::{Cursor, Source, integer};
use super::write::is_note;
use super::{Coordinates, FileError, MeshFile};
use crate::mesh::{FaceList, Mesh, TopologyError};
use crate::scalar::Numeral;
use crate::space::Point;

/// What a text file has given so far.
#[derive(Default)]
pub(super) struct Parts {
    pub points: Vec<Point<Numeral>>,
    faces: FaceList,
    /// Where each face starts in the file.
    face_starts: Vec<usize>,
    /// Whether the file is no text, so that places in it mean nothing.
    pub binary: bool,
    names_vertex_0: bool,
    highest: u32,
    notes: BTreeMap<String, String>,
}

impl Parts {
    /// Appends a face that starts at byte `start`, by indices that count from 0.
    pub fn push_face(&mut self, start: usize, corners: &[u32]) {
        for &corner in corners {
            self.names_vertex_0 |= corner == 0;
            self.highest = self.highest.max(corner);
        }
        self.faces.push(corners.iter().copied());
        self.face_starts.push(start);
    }

    /// Takes the `key=value` pairs of a comment `isogeo: key=value ...`, in printable ASCII; other
    /// words are no notes.
    pub fn note(&mut self, comment: &[u8]) {
        let Some(pairs) = comment.trim_ascii().strip_prefix(b"isogeo:") else {
            return;
        };
        let pairs = String::from_utf8_lossy(pairs);
        let pairs = pairs.split_ascii_whitespace().filter_map(|pair| pair.split_once('='));
        for (key, value) in pairs.filter(|(key, value)| is_note(key, value)) {
            self.notes.insert(key.to_owned(), value.to_owned());
        }
    }

    /// The mesh, if the faces form one; `base` is the number of the first vertex in this format.
    pub fn finish(mut self, source: &Source<'_>, base: u32) -> Result<MeshFile, FileError> {
        let points = std::mem::take(&mut self.points);
        let faces = std::mem::take(&mut self.faces);
        let mesh = Mesh::new(points, faces).map_err(|error| self.no_mesh(source, base, &error))?;
        Ok(MeshFile {
            name: source.name.to_owned(),
            format: source.format,
            coordinates: Coordinates::Numerals(mesh),
            exact: self.notes.get("coords").is_some_and(|value| value == "exact"),
            notes: self.notes,
            certificate: None,
        })
    }

    fn no_mesh(&self, source: &Source<'_>, base: u32, error: &TopologyError) -> FileError {
        let (kind, label, help) = words(error);
        let start = error.face().and_then(|face| self.face_starts.get(face.index()));
        let Some(&start) = start.filter(|_| !self.binary) else {
            return FileError { help, ..source.error_without_place(kind, error.to_string()) };
        };
        let TopologyError::NoSuchVertex { vertex, vertices, .. } = *error else {
            let error = source.error(kind, source.rest_of_line(start), error.to_string(), label);
            return FileError { help, ..error };
        };
        let number = u64::from(vertex) + u64::from(base);
        let span = find_index(source, start, number).unwrap_or_else(|| source.rest_of_line(start));
        let message = format!("there is no vertex {number}, the file has {vertices} vertices");
        if vertices == 0 {
            return source.error(kind, span, message, "expected no face");
        }
        let label = format!("expected an index from {base} to {}", vertices - 1 + base);
        let error = source.error(kind, span, message, label);
        if base == 0 && !self.names_vertex_0 && self.highest == vertices {
            error.help("no face names vertex 0, so these indices seem to count from 1; subtract 1")
        } else {
            error
        }
    }
}

/// The word in the statement at `start` that is the index `number`.
fn find_index(source: &Source<'_>, start: usize, number: u64) -> Option<std::ops::Range<usize>> {
    let mut cursor = Cursor::new(source.bytes).with_continuations().at(start);
    // The first word is `f` or the number of corners.
    cursor.token()?;
    std::iter::from_fn(|| cursor.token())
        .find(|token| {
            let index = token.bytes.split(|b| *b == b'/').next().and_then(integer);
            index.is_some_and(|i| u64::try_from(i) == Ok(number))
        })
        .map(|token| token.span())
}

/// The kind of an error about faces, what was expected, and what to do.
pub(super) fn words(error: &TopologyError) -> (&'static str, &'static str, Option<String>) {
    const COUNTING: &str = "faces and vertices are counted from 0 here";
    let (kind, label, help) = match error {
        TopologyError::FaceTooSmall { .. } => ("face-size", "expected at least 3 corners", ""),
        TopologyError::NoSuchVertex { .. } => ("index", "expected the index of a vertex", ""),
        TopologyError::RepeatedVertex { .. } => {
            ("repeated-vertex", "expected corners that differ", "")
        }
        TopologyError::WrongOrientation { .. } => (
            "orientation",
            "expected the opposite direction",
            "; neighbours run through their common edge in opposite directions: turn one face round",
        ),
        TopologyError::NonManifoldEdge { .. } => {
            ("non-manifold", "expected at most two faces at an edge", "")
        }
        TopologyError::TooLarge => return ("too-large", "", None),
    };
    (kind, label, Some(format!("{COUNTING}{help}")))
}
