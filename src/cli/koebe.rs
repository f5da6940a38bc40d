//! `isogeo make koebe`: the i-Koebe mesh with the combinatorics of a given mesh, in doubles.

use std::path::Path;

use serde_json::json;

use super::arguments::Layout;
use super::failure::Failure;
use super::{Status, output, words};
use crate::construct::{CircleCondition, CirclePattern, Koebe, NoPattern};
use crate::mesh::file::{self, Coordinates, Limits, Options};
use crate::mesh::{FaceId, Mesh, Topology, VertexKind};
use crate::net::RADIUS;
use crate::scalar::{Approx, Numeral, Rational, Ring};

/// The parameters that there are.
const HELP: &str = "mesh=FILE gives the combinatorics; with a boundary its radii are the data \
    'radius' of the file, or 1; a closed mesh takes outer=N, the face that closes it from above";

/// Finds the circle pattern, writes the mesh.
pub fn run(
    parameters: &[(String, String)],
    directory: &Path,
    limits: &Limits,
    layout: Layout,
) -> Result<Status, Failure> {
    let [mut mesh, mut outer] = [None, None];
    for (name, value) in parameters {
        match name.as_str() {
            "mesh" => mesh = Some(value),
            "outer" => outer = Some(value),
            _ => return Err(Failure::with_help(format!("koebe: no parameter '{name}'"), HELP)),
        }
    }
    let path = mesh.ok_or_else(|| Failure::with_help("koebe: which mesh?", HELP))?;
    let file = file::read_within(path, limits)?;
    if let Some(reason) = no_disc(file.topology()) {
        let reason = format!("no i-Koebe mesh is sought: {reason}");
        return refuse(&file.name, &reason, Status::Open, layout);
    }
    let bar = output::progress(file.topology().face_count(), "finding the circle pattern");
    let found = match &file.coordinates {
        Coordinates::Numerals(mesh) => koebe(&mesh.topology, None, outer)?,
        Coordinates::Rationals(mesh) => koebe(&mesh.topology, mesh.data.vertex.get(RADIUS), outer)?,
    };
    bar.finish_and_clear();
    let koebe = match found {
        Ok(koebe) => koebe,
        Err(reason) => {
            let status = match reason {
                NoPattern::Stopped(_) => Status::Open,
                _ => Status::Refuted,
            };
            let reason = format!("no circle pattern: {reason}");
            return refuse(&file.name, &reason, status, layout);
        }
    };
    std::fs::create_dir_all(directory).map_err(|e| {
        Failure::io(format!("the folder {} cannot be made: {e}", directory.display()))
    })?;
    let surface = directory.join("surface.iso.json");
    let mesh = exact(&koebe.mesh).ok_or_else(|| {
        Failure::usage("koebe: a circle is beyond the range of doubles, or has no place")
    })?;
    file::write(&surface, &mesh, &Options::default())?;
    let (vertices, faces) = (mesh.topology.vertex_count(), mesh.topology.face_count());
    let file = surface.display().to_string();
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.made/1",
            "family": "koebe",
            "files": [{ "file": file, "vertices": vertices, "faces": faces }],
            "observed": { "angle_defect": koebe.defect, "gap": koebe.gap },
        }))?;
    } else {
        let size = format!("{}, {}", words::vertices(vertices), words::count(faces, "face"));
        output::print(&format!(
            "{file}: {size}, in doubles\n  observed: angles within {:.1e}, circles close within \
             {:.1e} of their radii\n",
            koebe.defect, koebe.gap
        ))?;
    }
    Ok(Status::Proved)
}

fn koebe(
    topology: &Topology,
    radii: Option<&Vec<Rational>>,
    outer: Option<&String>,
) -> Result<Result<Koebe, NoPattern>, Failure> {
    let faces = topology.face_count();
    let face = match outer {
        None => Some(0),
        Some(text) => text.parse().ok().filter(|&f: &u32| (f as usize) < faces),
    };
    let face = face.ok_or_else(|| Failure::with_help("koebe: there is no such face", HELP))?;
    let closed = topology.vertices().all(|v| topology.kind(v) == VertexKind::Interior);
    if closed && faces > 0 {
        return Ok(Koebe::closed(topology, FaceId(face)));
    }
    if outer.is_some() {
        return Err(Failure::with_help("koebe: the mesh is not closed", HELP));
    }
    let radius = |v: crate::mesh::VertexId| radii.map_or(1.0, |r| r[v.index()].to_f64());
    let pattern = CirclePattern::disc(topology, |v| CircleCondition::Radius(radius(v)));
    Ok(pattern.map(|pattern| pattern.koebe()))
}

/// The doubles as the numbers that they are.
fn exact(mesh: &Mesh<f64>) -> Option<Mesh<Rational>> {
    let finite = |x: &f64| x.is_finite();
    let numbers = mesh.points.iter().flat_map(|p| p.coordinates());
    let all = numbers.chain(mesh.data.vertex.values().flatten()).all(finite);
    let exact = |x: &f64| Numeral::from_f64(*x).map_or_else(Rational::zero, |x| x.value());
    all.then(|| mesh.map(exact))
}

/// Why radii at the boundary do not determine how the circles lie: a component with boundary is no
/// disc.
fn no_disc(topology: &Topology) -> Option<&'static str> {
    let is = |kind| topology.vertices().any(|v| topology.kind(v) == kind);
    if is(VertexKind::Pinched) {
        return Some("the mesh is pinched at a vertex");
    }
    let has_holes = topology.euler_characteristic() < topology.component_count() as i64;
    (is(VertexKind::Boundary) && has_holes)
        .then_some("the mesh is not simply connected: around a hole the circles need not close")
}

/// Says why there is no mesh: a result, not an error.
fn refuse(file: &str, reason: &str, status: Status, layout: Layout) -> Result<Status, Failure> {
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-koebe/1",
            "file": file,
            "reason": reason,
        }))?;
    } else {
        output::print(&format!("{file}: {reason}\n"))?;
    }
    Ok(status)
}
