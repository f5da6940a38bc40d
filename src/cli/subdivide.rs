//! `isogeo subdivide`: Catmull-Clark on vertices or on planes.

use std::collections::BTreeSet;

use serde_json::json;

use super::arguments::{Layout, Scheme, SubdivideOptions};
use super::failure::Failure;
use super::{Status, input, output};
use crate::construct::subdivision::{NoPlaneSubdivision, Sharp, catmull_clark, subdivide_planes};
use crate::mesh::VertexId;
use crate::mesh::file::Options;

/// Refines the mesh and writes it.
pub fn run(options: &SubdivideOptions, layout: Layout) -> Result<Status, Failure> {
    let creases = creases(&options.crease)?;
    if options.scheme == Scheme::Dual && !creases.is_empty() {
        return Err(Failure::with_help(
            "--crease does not go with --scheme dual",
            "planes have no creases; --scheme catmull-clark refines vertices",
        ));
    }
    let input = input::read(&options.input)?;
    let coarse = input.exact();
    let mut mesh = coarse.clone();
    let mut sharp = Sharp { creases, keep_corners: options.keep_corners };
    let bar = output::progress(mesh.topology.face_count() << (2 * options.steps), "subdividing");
    for _ in 0..options.steps {
        mesh = match options.scheme {
            Scheme::CatmullClark => {
                let refined = catmull_clark(&mesh, &sharp)
                    .map_err(|error| Failure::usage(format!("{}: {error}", input.file.name)))?;
                sharp = refined.1;
                refined.0
            }
            Scheme::Dual => match subdivide_planes(&mesh, options.keep_corners) {
                Ok(mesh) => mesh,
                Err(reason) => return refuse(&reason, &input.file.name, layout),
            },
        };
    }
    bar.finish_and_clear();
    let write = Options { rounded: input.is_inexact(), ..Options::default() };
    let dropped = coarse.data != Default::default();
    let said = dropped.then_some(("data_kept", json!(false)));
    output::write_saying(&options.output.output, &mesh, &write, layout, said)?;
    if dropped && !layout.is_json() {
        output::print("  the data on elements are left out: they do not belong to the new ones\n")?;
    }
    Ok(Status::Proved)
}

/// The edges of chains such as `0-4-8`.
fn creases(chains: &[String]) -> Result<BTreeSet<[VertexId; 2]>, Failure> {
    let mut edges = BTreeSet::new();
    for chain in chains {
        let vertices: Option<Vec<u32>> = chain.split('-').map(|v| v.trim().parse().ok()).collect();
        let vertices = vertices.filter(|v| v.len() >= 2).ok_or_else(|| {
            Failure::with_help(
                format!("--crease takes chains of vertices, not '{chain}'"),
                "such as 0-4-8,1-5: the edges from 0 to 4, from 4 to 8 and from 1 to 5",
            )
        })?;
        edges.extend(vertices.windows(2).map(|pair| [VertexId(pair[0]), VertexId(pair[1])]));
    }
    Ok(edges)
}

/// Says why planes are not refined: a result, not an error.
fn refuse(reason: &NoPlaneSubdivision, file: &str, layout: Layout) -> Result<Status, Failure> {
    if layout.is_json() {
        output::print_json(&json!({
            "schema": "isogeo.no-subdivision/1",
            "file": file,
            "reason": reason.to_string(),
        }))?;
    } else {
        output::print(&format!("{file}: not subdivided: {reason}\n"))?;
    }
    Ok(Status::Open)
}
