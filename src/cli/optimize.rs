//! `isogeo optimize`: meshes that are planar, i-circular, i-conical.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde_json::{Value, json};

use super::arguments::{Approach, Layout, OptimizeOptions, Slide, Wish};
use super::failure::Failure;
use super::{Status, input, output, words};
use crate::check::Observed;
use crate::construct::subdivision::{Sharp, catmull_clark};
use crate::figure::comparison;
use crate::mesh::file::{Options, write_whole};
use crate::mesh::{FaceId, Mesh, Topology, VertexId, VertexKind};
use crate::net::Net;
use crate::optimise::{Design, Ending, Goal, Method, Mobility, Movement, Step, Target, mean_edge};
use crate::pair::twice_area;
use crate::scalar::{Approx, Numeral, Rational};
use crate::space::Point;

/// Moves the vertices, writes the mesh, and says what was done.
pub fn run(options: &OptimizeOptions, layout: Layout) -> Result<Status, Failure> {
    let mesh = doubles(&options.input.mesh, &input::read(&options.input)?.exact())?;
    let target = options.near.as_deref().map(|path| target(path, options)).transpose()?;
    let goal = Goal::from(options.to);
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
        for v in options
            .fix
            .iter()
            .flat_map(|list| list.split(','))
            .filter_map(|v| v.trim().parse().ok())
        {
            let v: usize = v;
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
    write(&options.output.output, &found, report, layout)?;
    Ok(if stopped { Status::Interrupted } else { Status::Open })
}

/// What became of the faces and edges of a mesh.
struct Quality {
    /// The faces whose top view runs the other way round.
    turned: Vec<FaceId>,
    /// The length of the shortest edge.
    shortest_edge: f64,
}

impl Quality {
    fn between(before: &Mesh<f64>, after: &Mesh<f64>) -> Quality {
        let topology = &after.topology;
        let area = |mesh: &Mesh<f64>, f: FaceId| {
            let corners = topology.face(f).iter().map(|v| mesh.points[v.index()].top_view());
            twice_area(&corners.collect::<Vec<_>>())
        };
        let turned =
            topology.faces().filter(|&f| area(before, f) * area(after, f) <= 0.0).collect();
        let ends = |h| [topology.origin(h), topology.target(h)].map(|v| &after.points[v.index()]);
        let lengths = topology.edges().map(ends).map(|[p, q]| (p - q).length2().sqrt());
        Quality { turned, shortest_edge: lengths.fold(f64::INFINITY, f64::min) }
    }

    fn text(&self, defect: f64, edge: f64, seconds: f64) -> String {
        let mut text = String::new();
        if let Some(first) = self.turned.first() {
            let faces = words::count(self.turned.len(), "face");
            text += &format!(
                "  {faces} turned over or lost its area in the top view, first {}\n",
                first.0
            );
        }
        text += &format!(
            "  shortest edge {} of the mean before\n",
            words::defect(self.shortest_edge / edge)
        );
        let defect = words::defect(defect);
        text + &format!("  observed in doubles: largest defect {defect}; {seconds:.3} s\n")
    }
}

/// What was done to a mesh.
struct Round {
    points: Vec<Point<f64>>,
    steps: Vec<Step>,
    ending: Ending,
    movement: Movement,
    /// The mean length of an edge before.
    edge: f64,
    faces: usize,
}

impl Round {
    fn run(
        options: &OptimizeOptions,
        mesh: &Mesh<f64>,
        target: Option<Arc<Target>>,
        interrupted: &AtomicBool,
    ) -> Result<Round, Failure> {
        let design = Design {
            fairness: options.fairness,
            shape: options.shape,
            target,
            mobility: mobility(options, mesh)?,
            method: match options.method {
                Approach::Joint => Method::Joint,
                Approach::TwoStage => Method::TwoStage,
            },
            steps: options.steps,
            ..Design::new(options.to.into(), mesh.points.len())
        };
        let bar = output::spinner("optimising");
        let found = design.run(mesh, |step| {
            bar.set_message(format!(
                "{}: step {}, distance {:.1e}",
                step.stage.name(),
                step.number,
                step.distance()
            ));
            !interrupted.load(Ordering::Relaxed)
        });
        bar.finish_and_clear();
        let found = found.map_err(|_| Failure::io("there is not enough memory for this mesh"))?;
        let movement = Movement::between(&mesh.points, &found.points);
        let edge = mean_edge(&mesh.topology, &mesh.points);
        let faces = mesh.topology.face_count();
        let (steps, ending) = (found.steps, found.ending);
        Ok(Round { points: found.points, steps, ending, movement, edge, faces })
    }

    fn last(&self) -> Option<&Step> {
        self.steps.last()
    }

    fn json(&self) -> Value {
        json!({
            "faces": self.faces,
            "ending": self.ending.name(),
            "movement_rms": self.movement.rms,
            "movement_largest": self.movement.largest,
            "movement_at": self.movement.at.0,
            "steps": self.steps.iter().map(step).collect::<Vec<_>>(),
        })
    }

    fn text(&self, options: &OptimizeOptions) -> String {
        let steps = words::count(self.steps.len().saturating_sub(1), "step");
        let edges =
            |length: f64| words::defect(if self.edge > 0.0 { length / self.edge } else { 0.0 });
        let mut text = format!(
            "{}, {}: {} after {steps}\n",
            options.input.mesh.display(),
            words::count(self.faces, "face"),
            self.ending.name(),
        );
        for worst in self.last().iter().flat_map(|step| &step.worst) {
            let at: Vec<String> = worst.at.iter().map(|v| v.0.to_string()).collect();
            text += &format!(
                "  {:<24} {} edge lengths from holding at most, at vertices {}\n",
                worst.name,
                edges(worst.distance),
                at.join(" ")
            );
        }
        text += &format!(
            "  moved {} edge lengths (rms), {} at most, vertex {}\n",
            edges(self.movement.rms),
            edges(self.movement.largest),
            self.movement.at.0
        );
        text
    }
}

fn step(step: &Step) -> Value {
    let worst = step.worst.iter().map(|worst| {
        json!({
            "condition": worst.name,
            "vertices": worst.at.iter().map(|v| v.0).collect::<Vec<_>>(),
            "distance": worst.distance,
        })
    });
    json!({
        "stage": step.stage.name(),
        "number": step.number,
        "energy": step.energy,
        "damping": step.damping,
        "worst": worst.collect::<Vec<_>>(),
    })
}

/// The largest defect of the property that was asked for.
fn defect(goal: Goal, mesh: &Mesh<f64>) -> f64 {
    let observed = Observed { points: &mesh.points, tolerance: 0.0 };
    let defects = Net::new(&mesh.topology, &observed).defects(goal.property());
    defects.into_iter().fold(0.0, f64::max)
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

/// Writes a mesh of doubles, printed as short as possible.
fn write(path: &Path, mesh: &Mesh<f64>, report: Value, layout: Layout) -> Result<(), Failure> {
    let exact = mesh.map(|c| Numeral::from_f64(*c).map(|n| n.value()).unwrap_or_default());
    let options = Options { rounded: true, ..Options::default() };
    output::write_saying(path, &exact, &options, layout, [("optimize", report)])
}

fn target(path: &Path, options: &OptimizeOptions) -> Result<Arc<Target>, Failure> {
    let mesh = doubles(path, &input::read_file(path, options.input.read_as)?.exact())?;
    let target = Target::new(&mesh);
    target.map(Arc::new).ok_or_else(|| {
        Failure::usage(format!("{} has no face that is not vertical", path.display()))
    })
}

/// How each vertex may move.
fn mobility(options: &OptimizeOptions, mesh: &Mesh<f64>) -> Result<Vec<Mobility>, Failure> {
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

/// The vertices that --fix names.
pub(super) fn fixed(list: &str, topology: &Topology) -> Result<Vec<VertexId>, Failure> {
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

/// Whether Ctrl-C was pressed; a second time ends the program.
fn interruption() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let seen = flag.clone();
    // Without a handler Ctrl-C ends the program at once: nothing is lost but the best mesh so far.
    let _ = ctrlc::set_handler(move || {
        if seen.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    flag
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
