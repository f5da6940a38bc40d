//! Reading the mesh that a command is about.

use std::path::Path;

use super::arguments::{InputOptions, LimitOptions, Reading};
use super::failure::Failure;
use super::output;
use crate::check::Decider;
use crate::construct::ENCLOSURE;
use crate::mesh::file::{self, Coordinates, MeshFile};
use crate::mesh::{Mesh, Topology};
use crate::net::RADIUS;
use crate::pair::Misfit;
use crate::scalar::{Numeral, Rational, ReadAs, Ring};
use crate::space::Point;

/// A mesh file and the reading of its numbers.
pub struct Input {
    /// The file.
    pub file: MeshFile,
    /// How its numbers are understood.
    pub read_as: ReadAs,
}

/// Reads the file that the options name.
pub fn read(options: &InputOptions) -> Result<Input, Failure> {
    read_file(&options.mesh, options.read_as, &options.limits)
}

/// Reads the second mesh of a pair with the mesh that was read by these options; without an option
/// its reading is its own.
///
/// That the meshes do not have the same faces is an error that says where.
pub fn read_image(path: &Path, options: &InputOptions, mesh: &Input) -> Result<Input, Failure> {
    let image = read_file(path, options.read_as, &options.limits)?;
    Misfit::<Rational>::of_topologies(mesh.topology(), image.topology()).map_err(|misfit| {
        Failure::with_help(
            format!("{} and {} are no pair: {misfit}", mesh.file.name, image.file.name),
            "the meshes of a pair have the same faces, with their vertices in the same order",
        )
    })?;
    Ok(image)
}

/// Reads a file; without a reading, in its own.
pub fn read_file(
    path: &Path,
    reading: Option<Reading>,
    limits: &LimitOptions,
) -> Result<Input, Failure> {
    let bytes = std::fs::metadata(path).map_or(0, |m| m.len() as usize);
    let bar = output::progress(bytes / 50, "reading");
    let mut file = file::read_within(path, &limits.limits())?;
    bar.finish_and_clear();
    let read_as = match &file.coordinates {
        Coordinates::Rationals(_) => ReadAs::Decimal,
        Coordinates::Numerals(_) => reading.map_or(file.default_reading(), ReadAs::from),
    };
    if read_as == ReadAs::Double {
        file = file.into_doubles()?;
    }
    Ok(Input { file, read_as })
}

impl Input {
    /// The combinatorics.
    pub fn topology(&self) -> &Topology {
        self.file.topology()
    }

    /// Whether the numbers stand for boxes.
    pub fn is_rounded(&self) -> bool {
        self.read_as == ReadAs::Rounded
    }

    /// Whether the file says that its numbers enclose those of another mesh.
    pub fn encloses(&self) -> bool {
        self.file.certificate.as_ref().is_some_and(|c| c.get(ENCLOSURE).is_some())
    }

    /// Whether the numbers are not those of the mesh that is meant, so that no file made of them may
    /// call itself exact.
    pub fn is_inexact(&self) -> bool {
        self.is_rounded() || self.encloses()
    }

    /// The mesh in exact numbers; a rounded number is taken as it is printed.
    pub fn exact(&self) -> Mesh<Rational> {
        match &self.file.coordinates {
            Coordinates::Numerals(mesh) => mesh.map(Numeral::value),
            Coordinates::Rationals(mesh) => mesh.clone(),
        }
    }

    /// The signed radii of the vertices as x-coordinates of points, if the file has them.
    pub fn radii(&self) -> Option<Vec<Point<Rational>>> {
        let Coordinates::Rationals(mesh) = &self.file.coordinates else { return None };
        let radii = mesh.data.vertex.get(RADIUS)?;
        let at = |radius: &Rational| Point::new(radius.clone(), Rational::zero(), Rational::zero());
        Some(radii.iter().map(at).collect())
    }

    /// The way to decide on the points of the mesh in this reading.
    pub fn decider(&self) -> Decider<'_> {
        match (&self.file.coordinates, self.read_as) {
            (Coordinates::Rationals(mesh), _) => Decider::of_rationals(&mesh.points),
            (Coordinates::Numerals(mesh), _) if self.is_rounded() => {
                Decider::over_boxes(&mesh.points)
            }
            (Coordinates::Numerals(mesh), _) => Decider::new(&mesh.points),
        }
    }
}
