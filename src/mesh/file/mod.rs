//! Mesh files: read without losing a digit, written whole or not at all.
//!
//! | format | read | written | numbers | data |
//! | --- | --- | --- | --- | --- |
//! | [`Obj`](Format::Obj) | yes | yes | decimals | no |
//! | [`Off`](Format::Off) | yes | yes | decimals | no |
//! | [`Ply`](Format::Ply) | text and (feature `ply`) binary | text | decimals; binary as it is | no |
//! | [`IsoJson`](Format::IsoJson) | yes | yes | fractions | yes |
//! | [`Vtu`](Format::Vtu) | no | yes | doubles | yes |
//!
//! Vertices and faces keep their order; none is merged, dropped or cut into triangles. A file that
//! is no oriented mesh is an error with its place, never a panic and never a silent repair.
//! Comments and names may be in any encoding. A comment line `# isogeo: key=value ...` (in PLY
//! `comment isogeo: ...`) is a note to us: `coords=exact` says that the decimals are the numbers.
//!
//! ```
//! use isogeo::mesh::file::{Format, Options, read_bytes, write_string};
//! use isogeo::scalar::{Field, Rational, ReadAs};
//! let text = b"v 0 0 0.1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
//! let mesh = read_bytes("m.obj", Format::Obj, text)?.to_exact(ReadAs::Decimal)?;
//! assert_eq!(mesh.points[0].z, Rational::from_ratio(1, 10));
//! let (off, _) = write_string("m.off", Format::Off, &mesh, &Options::default())?;
//! assert_eq!(off, "OFF\n# isogeo: coords=exact\n3 1 3\n0 0 0.1\n1 0 0\n0 1 0\n3 0 1 2\n");
//! # Ok::<(), isogeo::mesh::file::FileError>(())
//! ```

mod clear;
mod decimal;
mod error;
mod fraction;
mod iso_json;
mod limits;
mod obj;
mod off;
mod parts;
mod ply;
#[cfg(feature = "ply")]
mod ply_binary;
mod points;
mod source;
mod vtu;
mod write;

use std::collections::BTreeMap;
use std::path::Path;

use crate::mesh::Mesh;
use crate::scalar::{Numeral, Rational, ReadAs};

pub use clear::{Cleared, clear_denominators};
pub use error::{FileError, Place};
pub use fraction::{FractionError, MAX_DIGITS, parse_fraction};
pub use limits::Limits;
pub use points::{PointFile, read_points, read_points_bytes, read_points_within};
pub use write::{Options, STANDARD_OUTPUT, Written, write, write_string, write_whole};

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// The object file format of Geomview.
    Off,
    /// The polygon file format of Stanford.
    Ply,
    /// Our own format for exact meshes.
    IsoJson,
    /// The unstructured grids of VTK, in XML.
    Vtu,
}

impl Format {
    /// All formats.
    pub const ALL: [Format; 5] =
        [Format::Obj, Format::Off, Format::Ply, Format::IsoJson, Format::Vtu];

    /// The format that the end of a file name stands for, in capitals or not; `.json` means
    /// `.iso.json`.
    pub fn from_path(path: impl AsRef<Path>) -> Option<Format> {
        let extension = path.as_ref().extension()?.to_str()?.to_ascii_lowercase();
        Format::ALL.into_iter().find(|format| match format {
            Format::IsoJson => extension == "json",
            format => extension == format.name(),
        })
    }

    /// The short name, as in the codes of errors.
    pub fn name(self) -> &'static str {
        match self {
            Format::Obj => "obj",
            Format::Off => "off",
            Format::Ply => "ply",
            Format::IsoJson => "json",
            Format::Vtu => "vtu",
        }
    }
}

/// A mesh as a file gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The name of the file.
    pub name: String,
    /// Its format.
    pub format: Format,
    /// The mesh.
    pub coordinates: Coordinates,
    /// Whether the file says that its numbers are exact.
    pub exact: bool,
    /// The `key=value` pairs of comments `isogeo: ...`.
    pub notes: BTreeMap<String, String>,
    /// What an `.iso.json` file has under `certificate`.
    pub certificate: Option<serde_json::Value>,
}

/// The mesh of a file, in the numbers of its format.
#[derive(Clone, Debug, PartialEq)]
pub enum Coordinates {
    /// Printed numbers, or binary ones.
    Numerals(Mesh<Numeral>),
    /// Fractions.
    Rationals(Mesh<Rational>),
}

impl MeshFile {
    /// How the numbers are read if the user does not say: as they stand if the file says that it is
    /// exact, else as rounded.
    pub fn default_reading(&self) -> ReadAs {
        if self.exact { ReadAs::Decimal } else { ReadAs::Rounded }
    }

    /// The file with every printed number replaced by its nearest double. Fractions are what they
    /// are.
    ///
    /// # Errors
    /// A coordinate beyond the range of doubles.
    pub fn into_doubles(mut self) -> Result<MeshFile, FileError> {
        if let Coordinates::Numerals(mesh) = &mut self.coordinates {
            for (vertex, point) in mesh.points.iter_mut().enumerate() {
                for number in [&mut point.x, &mut point.y, &mut point.z] {
                    let Some(double) = Numeral::from_f64(number.nearest_f64()) else {
                        let message = format!(
                            "a coordinate of vertex {vertex} is beyond the range of doubles"
                        );
                        let format = self.format.name();
                        return Err(FileError::new("not-finite", format, &self.name, message)
                            .help("read the file with --read-as decimal"));
                    };
                    *number = double;
                }
            }
        }
        Ok(self)
    }

    /// The mesh in exact numbers.
    ///
    /// `Decimal` and `Rounded` give the printed value, `Double` the nearest double. Fractions are
    /// what they are.
    ///
    /// # Errors
    /// With `Double`, a coordinate beyond the range of doubles.
    pub fn to_exact(&self, read_as: ReadAs) -> Result<Mesh<Rational>, FileError> {
        match (&self.coordinates, read_as) {
            (Coordinates::Rationals(mesh), _) => Ok(mesh.clone()),
            (Coordinates::Numerals(mesh), ReadAs::Decimal | ReadAs::Rounded) => {
                Ok(mesh.map(Numeral::value))
            }
            (Coordinates::Numerals(_), ReadAs::Double) => {
                self.clone().into_doubles()?.to_exact(ReadAs::Decimal)
            }
        }
    }

    /// The combinatorics of the mesh.
    pub fn topology(&self) -> &crate::mesh::Topology {
        match &self.coordinates {
            Coordinates::Numerals(mesh) => &mesh.topology,
            Coordinates::Rationals(mesh) => &mesh.topology,
        }
    }
}

/// Reads a mesh from a file; its name says the format.
///
/// # Errors
/// A file that cannot be read, or is no mesh: see [`FileError`].
pub fn read(path: impl AsRef<Path>) -> Result<MeshFile, FileError> {
    read_within(path, &Limits::default())
}

/// Reads a mesh from a file that is not larger than some limits.
///
/// # Errors
/// As for [`read`]; what is beyond the limits has a code `isogeo::FORMAT::limit`.
pub fn read_within(path: impl AsRef<Path>, limits: &Limits) -> Result<MeshFile, FileError> {
    let path = path.as_ref();
    let format = Format::from_path(path).ok_or_else(|| unknown_format(path))?;
    let bytes = limits.read(path)?;
    read_bytes_within(&path.display().to_string(), format, &bytes, limits)
}

/// Reads a mesh from the bytes of a file; `name` is for error messages.
///
/// # Errors
/// Bytes that are no mesh: see [`FileError`].
pub fn read_bytes(name: &str, format: Format, bytes: &[u8]) -> Result<MeshFile, FileError> {
    read_bytes_within(name, format, bytes, &Limits::default())
}

/// Reads a mesh from the bytes of a file, within some limits.
///
/// # Errors
/// As for [`read_within`].
pub fn read_bytes_within(
    name: &str,
    format: Format,
    bytes: &[u8],
    limits: &Limits,
) -> Result<MeshFile, FileError> {
    let source = source::Source { name, format, bytes, digits: limits.digits };
    match format {
        Format::Obj => obj::read(&source),
        Format::Off => off::read(&source),
        Format::Ply => ply::read(&source),
        Format::IsoJson => iso_json::read(&source),
        Format::Vtu => {
            Err(FileError::new("format", "vtu", name, "VTU files are written, not read")
                .help("keep the mesh as .iso.json too"))
        }
    }
}

fn unknown_format(path: &Path) -> FileError {
    let name = path.display().to_string();
    FileError::new("format", "file", &name, "the format of the file is not known")
        .help("names end in .obj, .off, .ply, .iso.json, or for output .vtu")
}
