//! The elements of a binary PLY file, through `ply-rs-bw`.
//!
//! The header is read by `ply`, which also looks after what the crate would take on trust: names
//! that come twice, and numbers of elements that the file is too short for.

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{
    Addable, ElementDef, Property as Value, PropertyAccess, PropertyAccessResult, PropertyDef,
    PropertyType, ScalarType,
};

use super::ply::{Element, Encoding, Kind, Scalar};
use super::{FileError, parts::Parts, source::Source};
use crate::scalar::Numeral;
use crate::space::Point;

/// Reads one kind of element from byte `at` on; returns the byte after the last.
pub(super) fn read(
    source: &Source<'_>,
    encoding: Encoding,
    at: usize,
    element: &Element,
    parts: &mut Parts,
) -> Result<usize, FileError> {
    let mut rest = &source.bytes[at..];
    let least: usize = element.properties.iter().map(|property| least_size(&property.kind)).sum();
    if least == 0 {
        return Ok(at);
    }
    let (name, count) = (&element.name, element.count);
    if count.checked_mul(least).is_none_or(|size| size > rest.len()) {
        let message = format!(
            "the file ends too early: {count} of {name} need at least {least} bytes each, {} are left",
            rest.len()
        );
        return Err(source.error_without_place("truncated", message));
    }
    let definition = definition(element);
    let parser = Parser::<Row>::new();
    for index in 0..count {
        let start = source.bytes.len() - rest.len();
        let row = match encoding {
            Encoding::BigEndian => parser.read_big_endian_element(&mut rest, &definition),
            _ => parser.read_little_endian_element(&mut rest, &definition),
        };
        let wrong = |kind: &str, message: &str| {
            let message = format!("{name} {index}, at byte {start}: {message}");
            Err(source.error_without_place(kind, message))
        };
        match (row, name.as_str()) {
            (Err(error), _) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
                return wrong("truncated", "the file ends too early");
            }
            (Err(error), _) => return wrong("integer", &error.to_string()),
            (Ok(Row { point: [Some(x), Some(y), Some(z)], .. }), "vertex") => {
                parts.points.push(Point::new(x, y, z));
            }
            (Ok(_), "vertex") => {
                return wrong("not-finite", "a coordinate is NaN or infinite");
            }
            (Ok(Row { corners: Some(corners), .. }), "face") => parts.push_face(start, &corners),
            (Ok(_), "face") => return wrong("index", "an index is less than 0 or too large"),
            _ => {}
        }
    }
    Ok(source.bytes.len() - rest.len())
}

/// The least number of bytes that a property takes.
fn least_size(kind: &Kind) -> usize {
    let (Kind::Scalar(scalar) | Kind::List(scalar, _)) = kind;
    match scalar {
        Scalar::Char | Scalar::UChar => 1,
        Scalar::Short | Scalar::UShort => 2,
        Scalar::Int | Scalar::UInt | Scalar::Float => 4,
        Scalar::Double => 8,
    }
}

fn definition(element: &Element) -> ElementDef {
    let mut definition = ElementDef::new(element.name.clone());
    for property in &element.properties {
        let data_type = match property.kind {
            Kind::Scalar(scalar) => PropertyType::Scalar(scalar_type(scalar)),
            Kind::List(length, member) => {
                PropertyType::List(scalar_type(length), scalar_type(member))
            }
        };
        definition.properties.add(PropertyDef::new(property.name.clone(), data_type));
    }
    definition
}

fn scalar_type(scalar: Scalar) -> ScalarType {
    match scalar {
        Scalar::Char => ScalarType::Char,
        Scalar::UChar => ScalarType::UChar,
        Scalar::Short => ScalarType::Short,
        Scalar::UShort => ScalarType::UShort,
        Scalar::Int => ScalarType::Int,
        Scalar::UInt => ScalarType::UInt,
        Scalar::Float => ScalarType::Float,
        Scalar::Double => ScalarType::Double,
    }
}

/// What is kept of an element.
#[derive(Default)]
struct Row {
    point: [Option<Numeral>; 3],
    corners: Option<Vec<u32>>,
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Row::default()
    }

    fn set_property(&mut self, name: &str, value: Value) -> PropertyAccessResult {
        match name {
            "x" => self.point[0] = numeral(value),
            "y" => self.point[1] = numeral(value),
            "z" => self.point[2] = numeral(value),
            "vertex_indices" | "vertex_index" => self.corners = corners(value),
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

fn numeral(value: Value) -> Option<Numeral> {
    match value {
        Value::Char(n) => Some(Numeral::from_i64(n.into())),
        Value::UChar(n) => Some(Numeral::from_i64(n.into())),
        Value::Short(n) => Some(Numeral::from_i64(n.into())),
        Value::UShort(n) => Some(Numeral::from_i64(n.into())),
        Value::Int(n) => Some(Numeral::from_i64(n.into())),
        Value::UInt(n) => Some(Numeral::from_i64(n.into())),
        Value::Float(x) => Numeral::from_f32(x),
        Value::Double(x) => Numeral::from_f64(x),
        _ => None,
    }
}

fn corners(value: Value) -> Option<Vec<u32>> {
    fn indices<T: TryInto<u32>>(list: Vec<T>) -> Option<Vec<u32>> {
        list.into_iter().map(|index| index.try_into().ok()).collect()
    }
    match value {
        Value::ListChar(list) => indices(list),
        Value::ListUChar(list) => indices(list),
        Value::ListShort(list) => indices(list),
        Value::ListUShort(list) => indices(list),
        Value::ListInt(list) => indices(list),
        Value::ListUInt(list) => Some(list),
        _ => None,
    }
}
