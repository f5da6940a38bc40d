//! `isogeo optimize`: meshes that are planar, i-circular, i-conical.

mod finish;
mod quality;
mod round;
mod wishes;

use std::path::Path;
use std::time::Instant;

use serde_json::json;

use super::arguments::{Layout, OptimizeOptions};
use super::failure::Failure;
use super::interruption::interruption;
use super::{Status, input, output};
use crate::construct::subdivision::{Sharp, catmull_clark};
use crate::figure::comparison;
use crate::mesh::Mesh;
use crate::mesh::file::write_whole;
use crate::optimise::{Ending, Goal, Step};
use crate::scalar::{Approx, Rational};
use crate::space::Point;
use quality::{Quality, defect};
use round::Round;
pub use wishes::fixed;
use wishes::target;

/// Moves the vertices, writes the mesh, and says what was done.
pub fn run(options: &OptimizeOptions, layout: Layout) -> Result<Status, Failure> {
    let mesh = doubles(&options.input.mesh, &input::read(&options.input)?.exact())?;
    let target = options.near.as_deref().map(|path| target(path, options)).transpose()?;
    let goal = Goal::from(options.to);
    finish::fits(options, goal)?;
    let interrupted = interruption();
    let start = Instant::now();
    let (mut sharp, mut start_of_last) = (Sharp { keep_corners: true, ..Sharp::default() }, mesh);
    let mut rounds = Vec::new();
    let found = loop {
        let round = Round::run(options, &start_of_last, target.clone(), &interrupted)?;
        let found = Mesh { points: round.points.clone(), ..start_of_last.clone() };
        let is_last = rounds.len() == usize::from(options.subdivide);
        let stopped = round.ending == Ending::Stopped;
        rounds.push(round);
        if is_last || stopped {
            break found;
        }
        let refined = catmull_clark(&found, &sharp);
        (start_of_last, sharp) = refined.map_err(|e| Failure::usage(e.to_string()))?;
        // Old vertices keep their numbers; those that were named stay where they are.
        let named = options.fix.iter().flat_map(|list| list.split(','));
        for v in named.filter_map(|v| v.trim().parse::<usize>().ok()) {
            start_of_last.points[v] = found.points[v];
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    let defect = defect(goal, &found);
    if let Some(path) = &options.picture {
        write_whole(path, comparison(&start_of_last, &found).as_bytes())?;
    }
    let quality = Quality::between(&start_of_last, &found);
    let Some(last) = rounds.last() else { return Ok(Status::Open) };
    let report = json!({
        "file": options.input.mesh.display().to_string(),
        "to": goal.property().name(),
        "ending": last.ending.name(),
        "seconds": seconds,
        "steps": last.steps.len().saturating_sub(1),
        "edge": last.edge,
        "defect": defect,
        "distance": last.last().map(Step::distance),
        "movement_rms": last.movement.rms,
        "movement_largest": last.movement.largest,
        "movement_at": last.movement.at.0,
        "turned_faces": quality.turned.iter().map(|f| f.0).collect::<Vec<_>>(),
        "shortest_edge": quality.shortest_edge,
        "rounds": rounds.iter().map(Round::json).collect::<Vec<_>>(),
    });
    if !layout.is_json() {
        let lines: String = rounds.iter().map(|round| round.text(options)).collect();
        output::print(&format!("{lines}{}", quality.text(defect, last.edge, seconds)))?;
    }
    let stopped = last.ending == Ending::Stopped;
    let status = finish::finish(options, goal, &found, report, layout)?;
    Ok(if stopped { Status::Interrupted } else { status })
}

/// The mesh in doubles.
fn doubles(path: &Path, mesh: &Mesh<Rational>) -> Result<Mesh<f64>, Failure> {
    let mesh = mesh.map(Approx::to_f64);
    let finite = |p: &Point<f64>| p.coordinates().into_iter().all(|c| c.is_finite());
    match mesh.points.iter().position(|p| !finite(p)) {
        None => Ok(mesh),
        Some(v) => Err(Failure::usage(format!(
            "{}: vertex {v} lies beyond the range of doubles",
            path.display()
        ))),
    }
}
