//! What the options ask of the vertices of a mesh.

use std::path::Path;
use std::sync::Arc;

use super::doubles;
use crate::cli::arguments::{InputOptions, OptimizeOptions, Slide, Wish};
use crate::cli::failure::Failure;
use crate::cli::input;
use crate::mesh::{Mesh, Topology, VertexId, VertexKind};
use crate::optimise::{Goal, Mobility, Target};

/// The surface to be near to.
pub fn target(path: &Path, options: &OptimizeOptions) -> Result<Arc<Target>, Failure> {
    let InputOptions { read_as, limits, .. } = &options.input;
    let mesh = doubles(path, &input::read_file(path, *read_as, limits)?.exact())?;
    let target = Target::new(&mesh);
    target.map(Arc::new).ok_or_else(|| {
        Failure::usage(format!("{} has no face that is not vertical", path.display()))
    })
}

/// How each vertex may move.
pub fn mobility(options: &OptimizeOptions, mesh: &Mesh<f64>) -> Result<Vec<Mobility>, Failure> {
    let topology = &mesh.topology;
    let mut mobility = vec![Mobility::Free; topology.vertex_count()];
    if options.slide == Some(Slide::Boundary) {
        for loop_of in topology.boundary_loops() {
            let n = loop_of.len();
            for (i, v) in loop_of.iter().enumerate() {
                let [before, after] = [loop_of[(i + n - 1) % n], loop_of[(i + 1) % n]];
                mobility[v.index()] = if is_corner(topology, *v) {
                    Mobility::Fixed
                } else {
                    Mobility::along(&mesh.points[before.index()], &mesh.points[after.index()])
                };
            }
        }
    }
    if let Some(list) = &options.fix {
        fixed(list, topology)?.iter().for_each(|v| mobility[v.index()] = Mobility::Fixed);
    }
    Ok(mobility)
}

/// The lines of vertices that stay on their polygons.
pub fn curves(options: &OptimizeOptions, topology: &Topology) -> Vec<Vec<VertexId>> {
    let slides = options.slide == Some(Slide::Boundary);
    if slides { topology.boundary_loops() } else { Vec::new() }
}

/// The vertices that --fix names.
pub fn fixed(list: &str, topology: &Topology) -> Result<Vec<VertexId>, Failure> {
    let mut fixed = Vec::new();
    for what in list.split(',') {
        match what.trim() {
            "boundary" => fixed.extend(topology.boundary_loops().concat()),
            "corners" => fixed.extend(topology.vertices().filter(|&v| is_corner(topology, v))),
            number => {
                let vertex = number
                    .parse()
                    .ok()
                    .filter(|&v: &u32| VertexId(v).index() < topology.vertex_count());
                fixed.push(VertexId(vertex.ok_or_else(|| {
                    Failure::with_help(
                        format!("--fix: '{number}' is no vertex"),
                        format!(
                            "expected boundary, corners, or numbers below {}",
                            topology.vertex_count()
                        ),
                    )
                })?));
            }
        }
    }
    Ok(fixed)
}

/// A boundary vertex in one face.
fn is_corner(topology: &Topology, v: VertexId) -> bool {
    topology.kind(v) == VertexKind::Boundary && topology.star(v).count() == 1
}

impl From<Wish> for Goal {
    fn from(wish: Wish) -> Goal {
        match wish {
            Wish::Planar => Goal::Planar,
            Wish::ICircular => Goal::ICircular,
            Wish::IConical => Goal::IConical,
            Wish::Circular => Goal::Circular,
            Wish::Conical => Goal::Conical,
        }
    }
}
