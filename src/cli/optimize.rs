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
use crate::figure::comparison;
use crate::mesh::file::{Options, write_whole};
use crate::mesh::{Mesh, Topology, VertexId, VertexKind};
use crate::net::Net;
use crate::optimise::{Design, Ending, Goal, Method, Mobility, Movement, Step, Target};
use crate::scalar::{Approx, Numeral, Rational};
use crate::space::Point;

/// Moves the vertices, writes the mesh, and says what was done.
pub fn run(options: &OptimizeOptions, layout: Layout) -> Result<Status, Failure> {
    let mesh = doubles(&options.input.mesh, &input::read(&options.input)?.exact())?;
    let target = options.near.as_deref().map(|path| target(path, options)).transpose()?;
    let goal = Goal::from(options.to);
    let interrupted = interruption();
    let start = Instant::now();
    let round = Round::run(options, &mesh, target, &interrupted)?;
    let seconds = start.elapsed().as_secs_f64();
    let found = Mesh { points: round.points.clone(), ..mesh.clone() };
    let defect = defect(goal, &found);
    if let Some(path) = &options.picture {
        write_whole(path, comparison(&mesh, &found).as_bytes())?;
    }
    let report = json!({
        "file": options.input.mesh.display().to_string(),
        "to": goal.property().name(),
        "ending": round.ending.name(),
        "seconds": seconds,
        "edge": round.edge,
        "defect": defect,
        "distance": round.last().map(Step::distance),
        "movement_rms": round.movement.rms,
        "movement_largest": round.movement.largest,
        "movement_at": round.movement.at.0,
        "steps": round.steps.iter().map(step).collect::<Vec<_>>(),
    });
    if !layout.is_json() {
        output::print(&round.text(options, seconds, defect))?;
    }
    write(&options.output.output, &found, report, layout)?;
    Ok(if round.ending == Ending::Stopped { Status::Interrupted } else { Status::Open })
}

/// What was done to a mesh.
struct Round {
    points: Vec<Point<f64>>,
    steps: Vec<Step>,
    ending: Ending,
    movement: Movement,
    /// The mean length of an edge before.
    edge: f64,
}

impl Round {
    fn run(
        options: &OptimizeOptions,
        mesh: &Mesh<f64>,
        target: Option<Arc<Target>>,
        interrupted: &AtomicBool,
    ) -> Result<Round, Failure> {
        let design = Design {
            fairness: options.fairness.unwrap_or(0.0),
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
        let edge = mean_edge(mesh);
        Ok(Round { points: found.points, steps: found.steps, ending: found.ending, movement, edge })
    }

    fn last(&self) -> Option<&Step> {
        self.steps.last()
    }

    fn text(&self, options: &OptimizeOptions, seconds: f64, defect: f64) -> String {
        let steps = words::count(self.steps.len().saturating_sub(1), "step");
        let edges =
            |length: f64| words::defect(if self.edge > 0.0 { length / self.edge } else { 0.0 });
        let mut text = format!(
            "{}: {} after {steps}, {seconds:.3} s\n",
            options.input.mesh.display(),
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
        text += &format!("  observed in doubles: largest defect {}\n", words::defect(defect));
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
    for what in options.fix.iter().flat_map(|list| list.split(',')) {
        match what.trim() {
            "boundary" => {
                for v in topology.boundary_loops().concat() {
                    mobility[v.index()] = Mobility::Fixed;
                }
            }
            "corners" => {
                for v in topology.vertices().filter(|&v| is_corner(topology, v)) {
                    mobility[v.index()] = Mobility::Fixed;
                }
            }
            number => {
                let vertex = number.parse().ok().and_then(|v: usize| mobility.get_mut(v));
                *vertex.ok_or_else(|| {
                    Failure::with_help(
                        format!("--fix: '{number}' is no vertex"),
                        format!(
                            "expected boundary, corners, or numbers below {}",
                            topology.vertex_count()
                        ),
                    )
                })? = Mobility::Fixed;
            }
        }
    }
    Ok(mobility)
}

/// A boundary vertex in one face.
fn is_corner(topology: &Topology, v: VertexId) -> bool {
    topology.kind(v) == VertexKind::Boundary && topology.star(v).count() == 1
}

fn mean_edge(mesh: &Mesh<f64>) -> f64 {
    let topology = &mesh.topology;
    let ends = |h| [topology.origin(h), topology.target(h)].map(|v| &mesh.points[v.index()]);
    let lengths = topology.edges().map(ends).map(|[p, q]| (p - q).length2().sqrt());
    lengths.sum::<f64>() / topology.edge_count().max(1) as f64
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
