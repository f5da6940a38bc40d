//! VTU, the XML format of VTK: polygons with named values, as ParaView, pyvista and meshio read it.
//!
//! It is only written. Numbers are doubles, printed as short as they read back; triangles and
//! quadrilaterals have their own cell types, since meshio wants these.

use super::write::{Text, Written};
use super::{FileError, decimal::push_shortest};
use crate::mesh::Mesh;
use crate::scalar::{Numeral, RationalField};

/// The numbers of VTK for a cell with so many corners.
fn cell_type(corners: usize) -> u8 {
    match corners {
        3 => 5,
        4 => 9,
        _ => 7,
    }
}

pub(super) fn write<Q: RationalField>(
    mesh: &Mesh<Q>,
    text: &Text<'_>,
) -> Result<(String, Written), FileError> {
    let topology = &mesh.topology;
    let mut doubles = Doubles { text, exact: true };
    let points = mesh.points.iter().map(|point| point.coordinates());
    let points = doubles.lines(points, "vertex")?;
    let corners = topology.faces().map(|face| topology.face(face));
    let connectivity = corners.clone().map(|face| {
        let words: Vec<String> = face.iter().map(|vertex| vertex.0.to_string()).collect();
        words.join(" ") + "\n"
    });
    let offsets = corners.clone().scan(0, |end, face| {
        *end += face.len();
        Some(format!("{end}\n"))
    });
    let types = corners.clone().map(|face| format!("{}\n", cell_type(face.len())));
    let mut out = format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        mesh.points.len(),
        topology.face_count()
    );
    out.push_str("<Points>\n");
    push_array(&mut out, "Float64", "Points", " NumberOfComponents=\"3\"", &points);
    out.push_str("</Points>\n<Cells>\n");
    push_array(&mut out, "Int64", "connectivity", "", &connectivity.collect::<String>());
    push_array(&mut out, "Int64", "offsets", "", &offsets.collect::<String>());
    push_array(&mut out, "UInt8", "types", "", &types.collect::<String>());
    out.push_str("</Cells>\n");
    for (tag, of, arrays) in
        [("PointData", "vertex", &mesh.data.vertex), ("CellData", "face", &mesh.data.face)]
    {
        out.push_str(&format!("<{tag}>\n"));
        for (name, values) in arrays {
            let values = doubles.lines(values.iter().map(|value| [value]), of)?;
            push_array(&mut out, "Float64", &escaped(text, name)?, "", &values);
        }
        out.push_str(&format!("</{tag}>\n"));
    }
    out.push_str("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    Ok((out, if doubles.exact { Written::Exact } else { Written::Rounded }))
}

/// Turns numbers into doubles and remembers whether one was rounded.
struct Doubles<'a> {
    text: &'a Text<'a>,
    exact: bool,
}

impl Doubles<'_> {
    fn lines<'q, Q: RationalField, const N: usize>(
        &mut self,
        rows: impl Iterator<Item = [&'q Q; N]>,
        of: &str,
    ) -> Result<String, FileError> {
        let mut out = String::new();
        for (index, row) in rows.enumerate() {
            for (column, value) in row.into_iter().enumerate() {
                let double = self.text.double(value, of, index)?;
                self.exact = self.exact
                    && Numeral::from_f64(double).is_some_and(|d| d.value::<Q>() == *value);
                out.push_str(if column > 0 { " " } else { "" });
                push_shortest(&mut out, double);
            }
            out.push('\n');
        }
        Ok(out)
    }
}

fn push_array(out: &mut String, kind: &str, name: &str, more: &str, values: &str) {
    out.push_str(&format!("<DataArray type=\"{kind}\" Name=\"{name}\"{more} format=\"ascii\">\n"));
    out.push_str(values);
    out.push_str("</DataArray>\n");
}

/// A name as the value of an XML attribute.
fn escaped(text: &Text<'_>, name: &str) -> Result<String, FileError> {
    if name.is_empty()
        || name.chars().any(|c| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'))
    {
        return Err(text.error("data", format!("XML cannot hold the name {name:?}")));
    }
    let replaced = [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;")];
    Ok(replaced.iter().fold(name.to_owned(), |name, (from, to)| name.replace(from, to)))
}
