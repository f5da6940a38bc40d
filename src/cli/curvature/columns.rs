//! Curvatures as the data of a mesh file.

use std::collections::BTreeMap;
use std::path::Path;

use super::row::Row;
use crate::cli::arguments::Layout;
use crate::cli::failure::Failure;
use crate::cli::input::Input;
use crate::cli::output;
use crate::mesh::file::{self, Format, Options};
use crate::net::{Net, Property};
use crate::pair::element::At;
use crate::scalar::{Numeral, Rational, Ring};

/// H, K and whether they are defined, of every element.
#[derive(Default)]
pub struct Columns {
    mean: Vec<Rational>,
    gauss: Vec<Rational>,
    defined: Vec<Rational>,
}

impl Columns {
    /// Adds one more element; where H and K are undefined, or beyond the range of doubles in a file
    /// of doubles, all three are 0.
    pub fn add(&mut self, row: Row) {
        let (mean, gauss, defined) = match (row.found, row.exact) {
            (Ok(_), Some(exact)) => (exact.mean, exact.gauss, Rational::one()),
            (Ok(short), None) if short.values.iter().all(|x| x.is_finite()) => {
                let [mean, gauss] = short.values.map(double);
                (mean, gauss, Rational::one())
            }
            _ => (Rational::zero(), Rational::zero(), Rational::zero()),
        };
        self.mean.push(mean);
        self.gauss.push(gauss);
        self.defined.push(defined);
    }

    /// Writes the mesh with the columns; in VTU also by how much faces miss to be planar, and what
    /// the canonical Gauss image asks for: i-circular faces, or i-conical vertices.
    pub fn write(self, path: &Path, input: &Input, at: At, layout: Layout) -> Result<(), Failure> {
        let mut mesh = input.exact();
        let Columns { mean, gauss, defined } = self;
        let named = [("H", mean), ("K", gauss), ("defined", defined)];
        let named = named.map(|(name, values)| (name.to_owned(), values));
        match at {
            At::Faces => mesh.data.face.extend(named),
            At::Vertices => mesh.data.vertex.extend(named),
        }
        let topology = input.topology();
        let triangles = topology.corner_count() == 3 * topology.face_count();
        if Format::from_path(path) == Some(Format::Vtu) && !triangles {
            let decider = input.decider();
            let net = Net::new(topology, &decider);
            let add = |property: Property, data: &mut BTreeMap<String, Vec<Rational>>| {
                let defects = net.defects(property).into_iter().map(double).collect();
                data.insert(format!("{} defect", property.name()), defects);
            };
            add(Property::Planar, &mut mesh.data.face);
            match at {
                At::Vertices => add(Property::ICircular, &mut mesh.data.face),
                At::Faces => add(Property::IConical, &mut mesh.data.vertex),
            }
        }
        let options = Options { rounded: input.is_inexact(), ..Options::default() };
        if layout.is_json() {
            file::write(path, &mesh, &options)?;
            Ok(())
        } else {
            output::write(path, &mesh, &options, layout)
        }
    }
}

/// A double as a number; what is beyond their range as 0.
fn double(x: f64) -> Rational {
    Numeral::from_f64(x).map_or_else(Rational::zero, |x| x.value())
}
