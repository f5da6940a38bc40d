//! `isogeo info`: what a file holds.

use std::collections::{BTreeMap, HashSet};
use std::fmt::Write as _;

use serde_json::json;

use super::arguments::{InfoOptions, Layout};
use super::failure::Failure;
use super::input::{self, Input};
use super::{Status, output, words};
use crate::mesh::file::Coordinates;
use crate::mesh::{Mesh, VertexKind};
use crate::scalar::{Base, Rational, RationalField};

/// Describes the mesh.
pub fn run(options: &InfoOptions, layout: Layout) -> Result<Status, Failure> {
    let input = input::read(&options.input)?;
    let facts = Facts::of(&input);
    if layout.is_json() {
        output::print_json(&facts.json(&input))?;
    } else {
        output::print(&facts.text(&input))?;
    }
    Ok(Status::Proved)
}

struct Facts {
    vertices: usize,
    edges: usize,
    faces: usize,
    kinds: [usize; 4],
    face_sizes: BTreeMap<usize, usize>,
    valences: BTreeMap<usize, usize>,
    boundary_loops: Vec<usize>,
    components: usize,
    euler: i64,
    coincident: usize,
    digits: String,
    bounds: Option<[[Rational; 3]; 2]>,
}

impl Facts {
    fn of(input: &Input) -> Facts {
        let topology = input.topology();
        let mesh = input.exact();
        let mut kinds = [0; 4];
        let mut valences = BTreeMap::new();
        for v in topology.vertices() {
            let kind = topology.kind(v);
            kinds[index(kind)] += 1;
            if kind == VertexKind::Interior {
                *valences.entry(topology.star(v).count()).or_default() += 1;
            }
        }
        let mut face_sizes = BTreeMap::new();
        for f in topology.faces() {
            *face_sizes.entry(topology.face(f).len()).or_default() += 1;
        }
        let different: HashSet<_> = mesh.points.iter().collect();
        Facts {
            vertices: topology.vertex_count(),
            edges: topology.edge_count(),
            faces: topology.face_count(),
            kinds,
            face_sizes,
            valences,
            boundary_loops: topology.boundary_loops().iter().map(Vec::len).collect(),
            components: topology.component_count(),
            euler: topology.euler_characteristic(),
            coincident: mesh.points.len() - different.len(),
            digits: digits(&input.file.coordinates),
            bounds: bounds(&mesh),
        }
    }

    fn text(&self, input: &Input) -> String {
        let list = |counts: &BTreeMap<usize, usize>, of: &str| {
            let parts = counts.iter().map(|(size, n)| format!("{n} {of} {size}"));
            parts.collect::<Vec<_>>().join(", ")
        };
        let mut text = format!("{}\n", input.file.name);
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "  {name:<18}{value}");
        };
        let [isolated, interior, boundary, pinched] = self.kinds;
        line(
            "vertices",
            format!(
                "{}: {interior} interior, {boundary} on the boundary, {pinched} pinched, {isolated} isolated",
                self.vertices
            ),
        );
        line("edges", self.edges.to_string());
        line(
            "faces",
            match self.faces {
                0 => "none".into(),
                n => format!("{n}: {}", list(&self.face_sizes, "of size")),
            },
        );
        line(
            "valences",
            match self.valences.len() {
                0 => "no interior vertex".into(),
                _ => list(&self.valences, "of valence"),
            },
        );
        let loops: Vec<String> = self.boundary_loops.iter().map(usize::to_string).collect();
        line(
            "boundary loops",
            match loops.len() {
                0 if self.faces == 0 => "none".into(),
                0 => "none: closed".into(),
                n => format!("{n}, of {} edges", loops.join(", ")),
            },
        );
        line("components", self.components.to_string());
        line("Euler number", self.euler.to_string());
        line("orientation", "consistent".into());
        line(
            "coincident",
            match self.coincident {
                0 => "none: no vertex lies at the place of another".into(),
                n => format!("{} at the place of another", words::vertices(n)),
            },
        );
        line("digits", self.digits.clone());
        line("reading", input.read_as.name().into());
        if let Some([low, high]) = &self.bounds {
            for (axis, (low, high)) in ["x", "y", "z"].iter().zip(low.iter().zip(high)) {
                line(axis, format!("{} to {}", words::coordinate(low), words::coordinate(high)));
            }
        }
        text
    }

    fn json(&self, input: &Input) -> serde_json::Value {
        let [isolated, interior, boundary, pinched] = self.kinds;
        let counts = |map: &BTreeMap<usize, usize>| {
            map.iter().map(|(k, n)| (k.to_string(), json!(n))).collect::<serde_json::Map<_, _>>()
        };
        let bounds = self.bounds.as_ref().map(|[low, high]| {
            let strings = |p: &[Rational; 3]| p.iter().map(Rational::to_string).collect::<Vec<_>>();
            json!({ "min": strings(low), "max": strings(high) })
        });
        json!({
            "schema": "isogeo.info/1",
            "file": input.file.name,
            "vertices": self.vertices,
            "interior_vertices": interior,
            "boundary_vertices": boundary,
            "pinched_vertices": pinched,
            "isolated_vertices": isolated,
            "edges": self.edges,
            "faces": self.faces,
            "faces_by_size": counts(&self.face_sizes),
            "vertices_by_valence": counts(&self.valences),
            "boundary_loops": self.boundary_loops,
            "components": self.components,
            "euler_characteristic": self.euler,
            "oriented": true,
            "coincident_vertices": self.coincident,
            "digits": self.digits,
            "exact": input.file.exact,
            "read_as": input.read_as.name(),
            "bounding_box": bounds,
        })
    }
}

fn index(kind: VertexKind) -> usize {
    match kind {
        VertexKind::Isolated => 0,
        VertexKind::Interior => 1,
        VertexKind::Boundary => 2,
        VertexKind::Pinched => 3,
    }
}

/// How precisely the coordinates are given.
fn digits(coordinates: &Coordinates) -> String {
    match coordinates {
        Coordinates::Numerals(mesh) => {
            let numbers = mesh.points.iter().flat_map(|p| p.coordinates());
            let units = numbers.map(|n| n.unit_exponent());
            let range =
                units.fold(None, |range: Option<(Base, i32, i32)>, (base, e)| match range {
                    None => Some((base, e, e)),
                    Some((_, low, high)) => Some((base, low.min(e), high.max(e))),
                });
            match range {
                None => "no numbers".into(),
                Some((Base::Ten, low, high)) if low == high => {
                    format!("decimals, last digit 1e{low}")
                }
                Some((Base::Two, low, high)) if low == high => format!("binary, last bit 2^{low}"),
                Some((Base::Ten, low, high)) => {
                    format!("decimals, last digit from 1e{low} to 1e{high}")
                }
                Some((Base::Two, low, high)) => {
                    format!("binary, last bit from 2^{low} to 2^{high}")
                }
            }
        }
        Coordinates::Rationals(mesh) => {
            let numbers = mesh.points.iter().flat_map(|p| p.coordinates());
            let bits = numbers.map(|c| c.denominator().bits()).max().unwrap_or(0);
            format!("fractions, denominators of at most {bits} bits")
        }
    }
}

fn bounds(mesh: &Mesh<Rational>) -> Option<[[Rational; 3]; 2]> {
    let first = mesh.points.first()?.coordinates().map(Rational::clone);
    let mut bounds = [first.clone(), first];
    for point in &mesh.points {
        for (axis, c) in point.coordinates().into_iter().enumerate() {
            if *c < bounds[0][axis] {
                bounds[0][axis] = c.clone();
            } else if *c > bounds[1][axis] {
                bounds[1][axis] = c.clone();
            }
        }
    }
    Some(bounds)
}
