//! PLY: the header, and the elements as text; binary elements are in `ply_binary`.
//!
//! The mesh is the properties `x`, `y`, `z` of `vertex` and the list `vertex_indices` (or
//! `vertex_index`) of `face`, in any order among others. Other properties and elements are passed
//! over, but `tristrips` are refused, since faces would be lost. In text, the digits are the
//! number, whatever type the header gives it.

use super::source::{Cursor, Source, Token};
use super::{FileError, MeshFile, parts::Parts};
use super::{Written, write::Text};
use crate::mesh::Mesh;
use crate::scalar::RationalField;
use crate::space::Point;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    Char,
    UChar,
    Short,
    UShort,
    Int,
    UInt,
    Float,
    Double,
}

impl Scalar {
    fn from_name(name: &[u8]) -> Option<Scalar> {
        Some(match name {
            b"char" | b"int8" => Scalar::Char,
            b"uchar" | b"uint8" => Scalar::UChar,
            b"short" | b"int16" => Scalar::Short,
            b"ushort" | b"uint16" => Scalar::UShort,
            b"int" | b"int32" => Scalar::Int,
            b"uint" | b"uint32" => Scalar::UInt,
            b"float" | b"float32" => Scalar::Float,
            b"double" | b"float64" => Scalar::Double,
            _ => return None,
        })
    }

    fn is_integer(self) -> bool {
        !matches!(self, Scalar::Float | Scalar::Double)
    }
}

// Only binary data are read by their types.
#[cfg_attr(not(feature = "ply"), allow(dead_code))]
pub(super) enum Kind {
    Scalar(Scalar),
    /// The type of the length, the type of the members.
    List(Scalar, Scalar),
}

pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

pub(super) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
    /// Where it is declared.
    line: usize,
}

pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Where the data start.
    pub data: usize,
}

/// What an element is to the mesh.
pub(super) enum Role {
    /// The places of x, y and z among the properties.
    Vertex([usize; 3]),
    /// The place of the list of corners.
    Face(usize),
    Other,
}

pub(super) fn read(source: &Source<'_>) -> Result<MeshFile, FileError> {
    let mut parts = Parts::default();
    let header = read_header(source, &mut parts)?;
    parts.binary = header.encoding != Encoding::Ascii;
    let mut has_vertices = false;
    let mut cursor = Cursor::new(source.bytes).without_comments().at(header.data);
    let mut binary_at = header.data;
    for element in &header.elements {
        let role = role(source, element)?;
        has_vertices |= matches!(role, Role::Vertex(_));
        match header.encoding {
            Encoding::Ascii => read_text(source, &mut cursor, element, &role, &mut parts)?,
            encoding => binary_at = read_binary(source, encoding, binary_at, element, &mut parts)?,
        }
    }
    if !has_vertices {
        let message = "the file has no element 'vertex'";
        return Err(source.error("empty", 0..header.data, message, "expected 'element vertex'"));
    }
    let rest = match header.encoding {
        Encoding::Ascii => next_line(&mut cursor).map(|token| token.start),
        _ => (binary_at < source.bytes.len()).then_some(binary_at),
    };
    match rest {
        Some(at) if header.encoding == Encoding::Ascii => {
            let message = "more data than the header announces";
            Err(source.error(
                "trailing",
                source.rest_of_line(at),
                message,
                "expected the end of the file",
            ))
        }
        Some(at) => {
            let message = format!("more data than the header announces, from byte {at} on");
            Err(source.error_without_place("trailing", message))
        }
        None => parts.finish(source, 0),
    }
}

#[cfg(feature = "ply")]
use super::ply_binary::read as read_binary;

#[cfg(not(feature = "ply"))]
fn read_binary(
    source: &Source<'_>,
    _: Encoding,
    _: usize,
    _: &Element,
    _: &mut Parts,
) -> Result<usize, FileError> {
    let message = "binary PLY files are not read by this build";
    Err(source.error_without_place("feature", message).help("build with the feature 'ply'"))
}

fn read_header(source: &Source<'_>, parts: &mut Parts) -> Result<Header, FileError> {
    let mut cursor = Cursor::new(source.bytes).without_comments();
    let magic = cursor.token().filter(|token| token.bytes == b"ply");
    if magic.is_none() || cursor.token().is_some() {
        return Err(source.error(
            "header",
            source.rest_of_line(0),
            "not a PLY file",
            "expected ply",
        ));
    }
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    loop {
        if !cursor.next_line() {
            let end = source.bytes.len();
            let message = "the header does not end";
            return Err(source.error("truncated", end..end, message, "expected end_header"));
        }
        let start = cursor.position();
        let line = source.rest_of_line(start);
        let mut words = std::iter::from_fn(|| cursor.token()).map(|token| token.bytes);
        let wrong =
            |message: &str, label: &str| source.error("header", line.clone(), message, label);
        match words.next() {
            None => return Err(wrong("an empty line in the header", "expected end_header")),
            Some(b"comment") => {
                let text = source.bytes[line].trim_ascii();
                parts.note(text.strip_prefix(b"comment").unwrap_or_default());
                continue;
            }
            Some(b"obj_info") => continue,
            Some(b"format") => {
                encoding = match [words.next(), words.next()] {
                    _ if encoding.is_some() => {
                        return Err(wrong("a second format", "expected one"));
                    }
                    [Some(b"ascii"), Some(b"1.0")] => Some(Encoding::Ascii),
                    [Some(b"binary_little_endian"), Some(b"1.0")] => Some(Encoding::LittleEndian),
                    [Some(b"binary_big_endian"), Some(b"1.0")] => Some(Encoding::BigEndian),
                    _ => {
                        let label =
                            "expected ascii, binary_little_endian or binary_big_endian, and 1.0";
                        return Err(wrong("an unknown format", label));
                    }
                }
            }
            Some(b"element") => {
                let (name, count) = (words.next(), words.next());
                let count = count.and_then(super::source::integer).map(usize::try_from);
                let (Some(name), Some(Ok(count))) = (name, count) else {
                    return Err(wrong("an unreadable element", "expected 'element NAME COUNT'"));
                };
                let name = String::from_utf8_lossy(name).into_owned();
                if elements.iter().any(|element| element.name == name) {
                    return Err(wrong(
                        "an element of that name is there already",
                        "expected another",
                    ));
                }
                elements.push(Element { name, count, properties: Vec::new(), line: start });
            }
            Some(b"property") => {
                let property = property([words.next(), words.next(), words.next(), words.next()])
                    .ok_or_else(|| {
                    wrong(
                        "an unreadable property",
                        "expected 'property TYPE NAME' or 'property list TYPE TYPE NAME'",
                    )
                })?;
                let Some(element) = elements.last_mut() else {
                    return Err(wrong("a property of no element", "expected an element first"));
                };
                element.properties.push(property);
            }
            Some(b"end_header") => {
                let Some(encoding) = encoding else {
                    return Err(wrong("the header has no format", "expected 'format ascii 1.0'"));
                };
                cursor.next_line();
                return Ok(Header { encoding, elements, data: cursor.position() });
            }
            Some(_) => {
                let label = "expected comment, element, property or end_header";
                return Err(wrong("an unknown line in the header", label));
            }
        }
        if cursor.token().is_some() {
            return Err(source.error("header", line, "more words than this line may have", ""));
        }
    }
}

fn property(words: [Option<&[u8]>; 4]) -> Option<Property> {
    let (name, kind) = match words {
        [Some(b"list"), Some(length), Some(member), Some(name)] => {
            let length = Scalar::from_name(length).filter(|length| length.is_integer())?;
            (name, Kind::List(length, Scalar::from_name(member)?))
        }
        [Some(scalar), Some(name), None, None] => (name, Kind::Scalar(Scalar::from_name(scalar)?)),
        _ => return None,
    };
    Some(Property { name: String::from_utf8_lossy(name).into_owned(), kind })
}

fn role(source: &Source<'_>, element: &Element) -> Result<Role, FileError> {
    let wrong = |message: String, label: &str| {
        Err(source.error("header", source.rest_of_line(element.line), message, label))
    };
    let mut names: Vec<&str> = element.properties.iter().map(|p| p.name.as_str()).collect();
    names.sort_unstable();
    if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        return wrong(format!("two properties {:?}", pair[0]), "expected names that differ");
    }
    let find = |name: &str, list: bool| {
        element.properties.iter().position(|property| {
            property.name == name
                && match property.kind {
                    Kind::List(_, member) => list && member.is_integer(),
                    Kind::Scalar(_) => !list,
                }
        })
    };
    match element.name.as_str() {
        "vertex" => match [find("x", false), find("y", false), find("z", false)] {
            [Some(x), Some(y), Some(z)] => Ok(Role::Vertex([x, y, z])),
            _ => {
                wrong("the vertices lack a coordinate".to_owned(), "expected properties x, y and z")
            }
        },
        "face" => match (find("vertex_indices", true), find("vertex_index", true)) {
            (Some(list), None) if !names.contains(&"vertex_index") => Ok(Role::Face(list)),
            (None, Some(list)) if !names.contains(&"vertex_indices") => Ok(Role::Face(list)),
            (None, None) if element.count == 0 => Ok(Role::Other),
            _ => wrong(
                "the faces lack a list of their corners".to_owned(),
                "expected one property 'list TYPE TYPE vertex_indices' of whole numbers",
            ),
        },
        "tristrips" if element.count > 0 => {
            wrong("strips of triangles are not read".to_owned(), "expected 'element face'")
        }
        _ => Ok(Role::Other),
    }
}

/// The first word of the next line that has one.
fn next_line<'a>(cursor: &mut Cursor<'a>) -> Option<Token<'a>> {
    loop {
        if let Some(token) = cursor.token() {
            return Some(token);
        }
        if !cursor.next_line() {
            return None;
        }
    }
}

fn read_text<'a>(
    source: &Source<'a>,
    cursor: &mut Cursor<'a>,
    element: &Element,
    role: &Role,
    parts: &mut Parts,
) -> Result<(), FileError> {
    let mut numbers: Vec<Token<'a>> = Vec::new();
    let mut corners = Vec::new();
    for row in 0..element.count {
        if element.properties.is_empty() {
            break;
        }
        let Some(first) = next_line(cursor) else {
            let (end, name, count) = (source.bytes.len(), &element.name, element.count);
            let label = format!("expected {name} {row} of the {count} announced");
            return Err(source.error("truncated", end..end, "the file ends too early", label));
        };
        let mut words = std::iter::once(first).chain(std::iter::from_fn(|| cursor.token()));
        let mut next = |property: &Property| {
            words.next().ok_or_else(|| {
                let message = format!("{} {row} has too few numbers", element.name);
                let span = source.rest_of_line(first.start);
                source.error("coordinates", span, message, format!("expected {}", property.name))
            })
        };
        numbers.clear();
        corners.clear();
        for (p, property) in element.properties.iter().enumerate() {
            let number = next(property)?;
            numbers.push(number);
            if let Kind::List(..) = property.kind {
                let is_face = matches!(role, Role::Face(list) if *list == p);
                for _ in 0..source.count(number, "the length of a list")? {
                    let member = next(property)?;
                    if is_face {
                        corners.push(source.index(member)?);
                    }
                }
            }
        }
        if let Some(word) = words.next() {
            let message = format!("{} is too much on this line", word.show());
            let label = format!("expected the next {}", element.name);
            return Err(source.error("trailing", word.span(), message, label));
        }
        match *role {
            Role::Vertex([x, y, z]) => {
                let numeral = |p: usize| source.numeral(numbers[p]);
                parts.points.push(Point::new(numeral(x)?, numeral(y)?, numeral(z)?));
            }
            // From the length on, so that the corners are found again.
            Role::Face(list) => parts.push_face(numbers[list].start, &corners),
            Role::Other => {}
        }
        cursor.next_line();
    }
    Ok(())
}

pub(super) fn write<Q: RationalField>(
    mesh: &Mesh<Q>,
    text: &Text<'_>,
) -> Result<(String, Written), FileError> {
    let (points, written) = text.points(mesh, "")?;
    let faces = mesh.topology.faces();
    let largest = faces.clone().map(|face| mesh.topology.face(face).len()).max();
    let length = if largest > Some(255) { "int" } else { "uchar" };
    let mut out = format!(
        "ply\nformat ascii 1.0\n{}element vertex {}\nproperty double x\nproperty double y\n\
         property double z\nelement face {}\nproperty list {length} int vertex_indices\nend_header\n",
        text.note("comment ", written)?,
        mesh.points.len(),
        faces.len(),
    );
    out.push_str(&points);
    super::write::push_faces(&mut out, &mesh.topology);
    Ok((out, written))
}
