//! `.iso.json`: an exact mesh, its data and its certificate.
//!
//! ```json
//! {"format":"isogeo-mesh","version":1,"field":"QQ",
//!  "vertices":[["-1/3","0","2/7"]],"faces":[],
//!  "data":{"vertex":{"radius":["1/2"]},"face":{}},
//!  "certificate":null}
//! ```
//!
//! `data` and `certificate` may be left out. Numbers are strings `"p/q"` or `"p"`; JSON numbers
//! are refused, since most programs read them as doubles. Unknown and repeated keys are refused,
//! since what they say would be lost.

use std::collections::{BTreeMap, btree_map::Entry};
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, SeqAccess, Unexpected, Visitor};
use serde_json::value::RawValue;

use super::write::Options;
use super::{Coordinates, FileError, MeshFile, fraction, limits, parts, source::Source};
use crate::mesh::{Data, FaceList, Mesh};
use crate::scalar::{Rational, RationalField};
use crate::space::Point;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    #[serde(rename = "format", deserialize_with = "format")]
    _format: (),
    #[serde(rename = "version", deserialize_with = "version")]
    _version: (),
    #[serde(rename = "field", deserialize_with = "field")]
    _field: (),
    vertices: Vec<Vertex>,
    faces: Vec<Vec<u32>>,
    #[serde(default)]
    data: Named<Of, Named<String, Vec<Number>>>,
    certificate: Option<serde_json::Value>,
}

/// What an array of data belongs to.
#[derive(Deserialize, PartialEq, Eq, PartialOrd, Ord)]
#[serde(rename_all = "lowercase")]
enum Of {
    Vertex,
    Face,
}

struct Number(Rational);
struct Vertex(Point<Rational>);
/// An object in which no name comes twice.
struct Named<K, T>(BTreeMap<K, T>);

impl<K, T> Default for Named<K, T> {
    fn default() -> Self {
        Named(BTreeMap::new())
    }
}

pub(super) fn read(source: &Source<'_>) -> Result<MeshFile, FileError> {
    if source.bytes.trim_ascii_start().first().is_some_and(|byte| *byte != b'{') {
        // A derived reader would also take the members as an array.
        let start = source.bytes.len() - source.bytes.trim_ascii_start().len();
        let label = "expected an object {\"format\":\"isogeo-mesh\", ...}";
        return Err(source.error("syntax", start..start + 1, "not an .iso.json file", label));
    }
    if let Some(span) = source.long_number() {
        let message = format!("a number of {} digits", span.len());
        let label = format!("more than {} digits are not read", source.digits);
        return Err(source.error("limit", span, message, label).help(limits::MORE_DIGITS));
    }
    let mut document: Document =
        serde_json::from_slice(source.bytes).map_err(|error| no_document(source, &error))?;
    let mut faces = FaceList::new();
    for face in document.faces {
        faces.push(face);
    }
    let points = document.vertices.into_iter().map(|vertex| vertex.0).collect();
    let mut mesh = Mesh::new(points, faces).map_err(|error| {
        let (kind, label, help) = parts::words(&error);
        let span = error.face().and_then(|face| find_face(source.bytes, face.index()));
        let span = span.unwrap_or(0..source.bytes.len());
        FileError { help, ..source.error(kind, span, error.to_string(), label) }
    })?;
    let counts = (mesh.topology.vertex_count(), mesh.topology.face_count());
    mesh.data = Data {
        vertex: fitting(source, document.data.0.remove(&Of::Vertex), "vertex", counts.0)?,
        face: fitting(source, document.data.0.remove(&Of::Face), "face", counts.1)?,
    };
    Ok(MeshFile {
        name: source.name.to_owned(),
        format: source.format,
        coordinates: Coordinates::Rationals(mesh),
        exact: true,
        notes: BTreeMap::new(),
        certificate: document.certificate,
    })
}

fn fitting(
    source: &Source<'_>,
    arrays: Option<Named<String, Vec<Number>>>,
    of: &str,
    count: usize,
) -> Result<BTreeMap<String, Vec<Rational>>, FileError> {
    let fit = |(name, values): (String, Vec<Number>)| {
        if values.len() == count {
            return Ok((name, values.into_iter().map(|number| number.0).collect()));
        }
        let message = format!("the {of} array {name:?} has {} values", values.len());
        let span = find_array(source.bytes, of, &name).unwrap_or(0..source.bytes.len());
        Err(source.error("data", span, message, format!("expected {count}, one for every {of}")))
    };
    arrays.unwrap_or_default().0.into_iter().map(fit).collect()
}

/// The error of the parser with its place, which is the last byte or string it has taken.
fn no_document(source: &Source<'_>, error: &serde_json::Error) -> FileError {
    let kind = match error.classify() {
        serde_json::error::Category::Eof => "truncated",
        serde_json::error::Category::Data => "data",
        _ => "syntax",
    };
    let text = error.to_string();
    let suffix = format!(" at line {} column {}", error.line(), error.column());
    let message = text.strip_suffix(suffix.as_str()).unwrap_or(&text);
    let lines = source.bytes.split_inclusive(|byte| *byte == b'\n');
    let line_start: usize = lines.take(error.line().saturating_sub(1)).map(<[u8]>::len).sum();
    let end = (line_start + error.column()).min(source.bytes.len());
    let start = match source.bytes[..end] {
        [ref before @ .., b'"'] => before.iter().rposition(|byte| *byte == b'"'),
        _ => None,
    };
    let error = source.error(kind, start.unwrap_or(end.saturating_sub(1))..end, message, "");
    if message.starts_with("invalid type: integer") || message.starts_with("invalid type: float") {
        error.help("exact numbers are strings: \"1/3\", \"-2\"")
    } else if message == "recursion limit exceeded" {
        error.help("brackets may be nested 127 deep")
    } else if message.starts_with("unknown ") {
        error.help("other information belongs under \"certificate\"")
    } else {
        error
    }
}

/// Where a face stands. Only errors need it, so the text is read again.
fn find_face(bytes: &[u8], face: usize) -> Option<Range<usize>> {
    #[derive(Deserialize)]
    struct Faces<'a> {
        #[serde(borrow)]
        faces: Vec<&'a RawValue>,
    }
    let document: Faces<'_> = serde_json::from_slice(bytes).ok()?;
    document.faces.get(face).map(|raw| span_in(bytes, raw))
}

/// Where an array of data stands.
fn find_array(bytes: &[u8], of: &str, name: &str) -> Option<Range<usize>> {
    #[derive(Deserialize)]
    struct Document<'a> {
        #[serde(borrow)]
        data: BTreeMap<String, BTreeMap<String, &'a RawValue>>,
    }
    let document: Document<'_> = serde_json::from_slice(bytes).ok()?;
    document.data.get(of)?.get(name).map(|raw| span_in(bytes, raw))
}

fn span_in(bytes: &[u8], raw: &RawValue) -> Range<usize> {
    let start = raw.get().as_ptr().addr() - bytes.as_ptr().addr();
    start..start + raw.get().len()
}

fn format<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(), D::Error> {
    deserializer.deserialize_str(Only("isogeo-mesh"))
}

fn field<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(), D::Error> {
    deserializer.deserialize_str(Only("QQ"))
}

fn version<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(), D::Error> {
    deserializer.deserialize_u64(Version1)
}

/// Takes one string and no other.
struct Only(&'static str);

impl Visitor<'_> for Only {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.0)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<(), E> {
        if text == self.0 { Ok(()) } else { Err(E::invalid_value(Unexpected::Str(text), &self)) }
    }
}

struct Version1;

impl Visitor<'_> for Version1 {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "1, the only version so far")
    }

    fn visit_u64<E: de::Error>(self, n: u64) -> Result<(), E> {
        if n == 1 { Ok(()) } else { Err(E::invalid_value(Unexpected::Unsigned(n), &self)) }
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Fraction;
        impl Visitor<'_> for Fraction {
            type Value = Number;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a string such as \"-1/3\" or \"2\"")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
                // Longer ones are found before.
                fraction::parse(text, usize::MAX).map(Number).map_err(|error| {
                    let shown: String = text.chars().take(40).collect();
                    E::custom(format!("cannot read {shown:?} as a fraction: {error}"))
                })
            }
        }
        deserializer.deserialize_str(Fraction)
    }
}

impl<'de> Deserialize<'de> for Vertex {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Three;
        impl<'de> Visitor<'de> for Three {
            type Value = Vertex;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "three coordinates")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vertex, A::Error> {
                let mut coordinate = |before| {
                    let number = seq.next_element::<Number>()?;
                    number.map(|n| n.0).ok_or_else(|| de::Error::invalid_length(before, &self))
                };
                let point = Point::new(coordinate(0)?, coordinate(1)?, coordinate(2)?);
                match seq.next_element::<de::IgnoredAny>()? {
                    None => Ok(Vertex(point)),
                    Some(_) => Err(de::Error::invalid_length(4, &self)),
                }
            }
        }
        deserializer.deserialize_seq(Three)
    }
}

impl<'de, K, T> Deserialize<'de> for Named<K, T>
where
    K: Deserialize<'de> + Ord,
    T: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Unique<K, T>(PhantomData<(K, T)>);
        impl<'de, K, T> Visitor<'de> for Unique<K, T>
        where
            K: Deserialize<'de> + Ord,
            T: Deserialize<'de>,
        {
            type Value = Named<K, T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut named = BTreeMap::new();
                while let Some(name) = map.next_key()? {
                    match named.entry(name) {
                        Entry::Vacant(entry) => entry.insert(map.next_value()?),
                        Entry::Occupied(_) => {
                            return Err(de::Error::custom("a name that was there before"));
                        }
                    };
                }
                Ok(Named(named))
            }
        }
        deserializer.deserialize_map(Unique(PhantomData))
    }
}

/// The text of an `.iso.json` file: one line for every vertex, face and array.
pub(super) fn write<Q: RationalField>(mesh: &Mesh<Q>, options: &Options) -> String {
    let vertices = mesh.points.iter().map(|point| strings(point.coordinates()));
    let faces = mesh
        .topology
        .faces()
        .map(|face| list(mesh.topology.face(face).iter().map(|vertex| vertex.0.to_string()), ""));
    let mut members = vec![
        r#""format":"isogeo-mesh","version":1,"field":"QQ""#.to_owned(),
        format!("\"vertices\":{}", list(vertices, "\n")),
        format!("\"faces\":{}", list(faces, "\n")),
    ];
    let data = [("vertex", &mesh.data.vertex), ("face", &mesh.data.face)]
        .into_iter()
        .filter(|(_, arrays)| !arrays.is_empty())
        .map(|(of, arrays)| {
            let arrays = arrays.iter().map(|(name, values)| {
                format!("{}:{}", serde_json::Value::from(name.as_str()), strings(values))
            });
            format!("\"{of}\":{{\n{}\n}}", arrays.collect::<Vec<_>>().join(",\n"))
        })
        .collect::<Vec<_>>();
    if !data.is_empty() {
        members.push(format!("\"data\":{{{}}}", data.join(",")));
    }
    if let Some(certificate) = &options.certificate {
        members.push(format!("\"certificate\":{certificate}"));
    }
    format!("{{{}}}\n", members.join(",\n"))
}

fn strings<'a, Q: RationalField>(values: impl IntoIterator<Item = &'a Q>) -> String {
    list(values.into_iter().map(|value| format!("\"{value}\"")), "")
}

/// A JSON array; `end` is put around every member.
fn list(members: impl Iterator<Item = String>, end: &str) -> String {
    let mut out = String::from("[");
    for (i, member) in members.enumerate() {
        out.push_str(if i > 0 { "," } else { "" });
        out.push_str(end);
        out.push_str(&member);
    }
    out.push_str(if out.len() > 1 { end } else { "" });
    out.push(']');
    out
}
