//! Wavefront OBJ: the vertices and polygons of it.
//!
//! Read: `v` with three coordinates, or with colours after them, which are not kept; `f` with
//! corners `4`, `4/1`, `4//`, `4//7`, `4/1/2`, also counted back from the last vertex (`-1`).
//! Passed over: normals, texture coordinates, names, groups, materials, points and lines (`p`,
//! `l`). Refused: a fourth coordinate (a weight), curves and surfaces, and every other keyword,
//! since what they say would be lost. A comment may also follow data, though not all programs can
//! read that. `\` joins lines, but not after a name, where it may end a path.

use super::source::{Cursor, Source, Token, integer};
use super::{FileError, MeshFile, parts::Parts};
use super::{Written, write::Text};
use crate::mesh::Mesh;
use crate::scalar::{Numeral, RationalField};
use crate::space::Point;

pub(super) fn read(source: &Source<'_>) -> Result<MeshFile, FileError> {
    let mut cursor = Cursor::new(source.bytes).with_continuations();
    let mut parts = Parts::default();
    let mut corners = Vec::new();
    loop {
        if let Some(comment) = cursor.comment() {
            parts.note(comment);
        } else if let Some(keyword) = cursor.token() {
            match keyword.bytes {
                b"v" => parts.points.push(vertex(source, &mut cursor, keyword)?),
                b"f" => {
                    corners.clear();
                    while let Some(token) = cursor.token() {
                        corners.push(corner(source, token, parts.points.len())?);
                    }
                    parts.push_face(keyword.start, &corners);
                }
                b"vn" | b"vt" | b"vp" | b"p" | b"l" | b"s" | b"mg" | b"lod" | b"bevel"
                | b"c_interp" | b"d_interp" => while cursor.token().is_some() {},
                b"o" | b"g" | b"mtllib" | b"usemtl" | b"maplib" | b"usemap" | b"shadow_obj"
                | b"trace_obj" => {}
                _ => return Err(unknown(source, keyword)),
            }
        }
        if !cursor.next_line() {
            break;
        }
    }
    if parts.points.is_empty() {
        let end = source.bytes.len();
        let (message, label) = ("the file has no vertices", "expected lines 'v x y z'");
        return Err(source.error("empty", end..end, message, label));
    }
    parts.finish(source, 1)
}

fn vertex(
    source: &Source<'_>,
    cursor: &mut Cursor<'_>,
    keyword: Token<'_>,
) -> Result<Point<Numeral>, FileError> {
    let wrong = |message: &str| {
        let span = source.rest_of_line(keyword.start);
        source.error("coordinates", span, message, "expected three coordinates")
    };
    let mut coordinate = || match cursor.token() {
        Some(token) => source.numeral(token),
        None => Err(wrong("a vertex with less than three coordinates")),
    };
    let point = Point::new(coordinate()?, coordinate()?, coordinate()?);
    let mut more = 0;
    while let Some(token) = cursor.token() {
        source.numeral(token)?;
        more += 1;
    }
    match more {
        1 => Err(wrong("a vertex with four numbers: weights (x y z w) are not read")
            .help("divide x, y and z by the weight and leave it out")),
        2 => Err(wrong("a vertex with five numbers")),
        _ => Ok(point),
    }
}

/// The vertex of a corner, counted from 0.
#[inline]
fn corner(source: &Source<'_>, token: Token<'_>, vertices: usize) -> Result<u32, FileError> {
    let mut fields = token.bytes.split(|byte| *byte == b'/');
    let index = fields.next().and_then(integer);
    let others = fields.take(3).try_fold(0, |n, field| {
        (n < 2 && (field.is_empty() || integer(field).is_some())).then_some(n + 1)
    });
    let (Some(index), Some(_)) = (index, others) else {
        let message = format!("cannot read {} as a corner of a face", token.show());
        let label = "expected an index, as in 4, 4/1, 4//7 or 4/1/7";
        return Err(source.error("index", token.span(), message, label));
    };
    let from_0 = if index < 0 { index + vertices as i64 } else { index - 1 };
    u32::try_from(from_0).map_err(|_| {
        let (message, label) = if index == 0 {
            ("there is no vertex 0".to_owned(), "expected an index that counts from 1".to_owned())
        } else if index < 0 {
            let message = format!("there is no vertex {index}: only {vertices} come before");
            (message, "expected one that comes before".to_owned())
        } else {
            (format!("there is no vertex {index}"), "expected the index of a vertex".to_owned())
        };
        source.error("index", token.span(), message, label)
    })
}

fn unknown(source: &Source<'_>, keyword: Token<'_>) -> FileError {
    let message = format!("an OBJ statement {} that is not read", keyword.show());
    source
        .error("statement", keyword.span(), message, "expected v, f or another known keyword")
        .help(
            "only vertices and polygons are read; names, groups, materials, normals, texture \
         coordinates, points and lines are passed over",
        )
}

pub(super) fn write<Q: RationalField>(
    mesh: &Mesh<Q>,
    text: &Text<'_>,
) -> Result<(String, Written), FileError> {
    let (points, written) = text.points(mesh, "v ")?;
    let mut out = text.note("# ", written)?;
    out.push_str(&points);
    for face in mesh.topology.faces() {
        out.push('f');
        for vertex in mesh.topology.face(face) {
            out.push(' ');
            out.push_str(&(vertex.0 + 1).to_string());
        }
        out.push('\n');
    }
    Ok((out, written))
}
