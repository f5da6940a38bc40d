//! OFF: the header, the counts, a line for every vertex, a line for every face.
//!
//! Colours after the corners of a face are not kept. The variants with more numbers for every
//! vertex (`COFF`, `NOFF`, `4OFF`, ...) and the binary one are refused.

use super::source::{Cursor, Source, Token};
use super::{FileError, MeshFile, parts::Parts};
use super::{
    Written,
    write::{Text, push_faces},
};
use crate::mesh::Mesh;
use crate::scalar::RationalField;
use crate::space::Point;

pub(super) fn read(source: &Source<'_>) -> Result<MeshFile, FileError> {
    let mut parts = Parts::default();
    let mut reader = Reader { source, cursor: Cursor::new(source.bytes), parts: &mut parts };
    let (vertices, faces) = reader.header()?;
    for v in 0..vertices {
        reader.vertex(v, vertices)?;
    }
    let mut corners = Vec::new();
    for f in 0..faces {
        reader.face(f, faces, &mut corners)?;
    }
    if let Some(token) = reader.next_line() {
        let message = format!("more than the {vertices} vertices and {faces} faces announced");
        let span = source.rest_of_line(token.start);
        return Err(source.error("trailing", span, message, "expected the end of the file"));
    }
    parts.finish(source, 0)
}

struct Reader<'a, 'p> {
    source: &'a Source<'a>,
    cursor: Cursor<'a>,
    parts: &'p mut Parts,
}

impl<'a> Reader<'a, '_> {
    /// The first word of the next line that has one. The rest of the line before is not looked at.
    fn next_line(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(comment) = self.cursor.comment() {
                self.parts.note(comment);
            } else if let Some(token) = self.cursor.token() {
                return Some(token);
            }
            if !self.cursor.next_line() {
                return None;
            }
        }
    }

    fn end(&self, what: String) -> FileError {
        let end = self.source.bytes.len();
        self.source.error(
            "truncated",
            end..end,
            "the file ends too early",
            format!("expected {what}"),
        )
    }

    /// The numbers of vertices and faces.
    fn header(&mut self) -> Result<(usize, usize), FileError> {
        let Some(magic) = self.next_line() else {
            return Err(self.end("the header OFF".to_owned()));
        };
        if magic.bytes != b"OFF" {
            let variant = magic.bytes.ends_with(b"OFF") && magic.bytes.len() <= 8;
            let (kind, message) = if variant {
                ("variant", format!("the variant {} of OFF is not read", magic.show()))
            } else {
                ("header", "not an OFF file".to_owned())
            };
            return Err(self.source.error(kind, magic.span(), message, "expected OFF"));
        }
        // The counts may stand on the same line.
        let first =
            self.next_line().ok_or_else(|| self.end("the number of vertices".to_owned()))?;
        if first.bytes == b"BINARY" {
            let message = "binary OFF files are not read";
            return Err(self.source.error("variant", first.span(), message, "expected text"));
        }
        let vertices = self.source.count(first, "the number of vertices")?;
        let faces = self.count_after(first, "the number of faces")?;
        // The number of edges says nothing, and is often 0 or left out.
        if let Some(token) = self.cursor.token() {
            self.source.count(token, "the number of edges")?;
        }
        self.end_of_line("expected the numbers of vertices, faces and edges")?;
        Ok((vertices, faces))
    }

    fn count_after(&mut self, first: Token<'a>, what: &str) -> Result<usize, FileError> {
        match self.cursor.token() {
            Some(token) => self.source.count(token, what),
            None => {
                let span = self.source.rest_of_line(first.start);
                let label = format!("expected {what} on the same line");
                Err(self.source.error("header", span, "a count is missing", label))
            }
        }
    }

    fn end_of_line(&mut self, label: &str) -> Result<(), FileError> {
        match self.cursor.token() {
            Some(token) => {
                let message = format!("{} is too much on this line", token.show());
                Err(self.source.error("trailing", token.span(), message, label))
            }
            None => {
                self.cursor.next_line();
                Ok(())
            }
        }
    }

    fn vertex(&mut self, v: usize, of: usize) -> Result<(), FileError> {
        let Some(x) = self.next_line() else {
            return Err(self.end(format!("vertex {v} of the {of} announced")));
        };
        let wrong = |source: &Source<'_>| {
            let span = source.rest_of_line(x.start);
            let message = format!("the line of vertex {v} does not have three numbers");
            source
                .error("coordinates", span, message, "expected three coordinates")
                .help(format!("the header announces {of} vertices"))
        };
        let [Some(y), Some(z), None] = std::array::from_fn(|_| self.cursor.token()) else {
            return Err(wrong(self.source));
        };
        let numeral = |token| self.source.numeral(token);
        let point = Point::new(numeral(x)?, numeral(y)?, numeral(z)?);
        self.parts.points.push(point);
        self.cursor.next_line();
        Ok(())
    }

    fn face(&mut self, f: usize, of: usize, corners: &mut Vec<u32>) -> Result<(), FileError> {
        let Some(size) = self.next_line() else {
            return Err(self.end(format!("face {f} of the {of} announced")));
        };
        corners.clear();
        let count = self.source.count(size, "the number of corners")?;
        for _ in 0..count {
            let Some(token) = self.cursor.token() else {
                let span = self.source.rest_of_line(size.start);
                let message = format!("face {f} has only {} of {count} corners", corners.len());
                return Err(self.source.error("face-size", span, message, "expected more indices"));
            };
            corners.push(self.source.index(token)?);
        }
        for _ in 0..4 {
            if let Some(colour) = self.cursor.token() {
                self.source.numeral(colour)?;
            }
        }
        self.end_of_line("expected nothing after the corners and a colour")?;
        self.parts.push_face(size.start, corners);
        Ok(())
    }
}

pub(super) fn write<Q: RationalField>(
    mesh: &Mesh<Q>,
    text: &Text<'_>,
) -> Result<(String, Written), FileError> {
    let (points, written) = text.points(mesh, "")?;
    let topology = &mesh.topology;
    let mut out = format!(
        "OFF\n{}{} {} {}\n",
        text.note("# ", written)?,
        mesh.points.len(),
        topology.face_count(),
        topology.edge_count()
    );
    out.push_str(&points);
    push_faces(&mut out, topology);
    Ok((out, written))
}
