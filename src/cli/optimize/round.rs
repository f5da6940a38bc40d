//! A round: one optimisation of a mesh.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::{Value, json};

use super::wishes::{curves, mobility};
use crate::cli::arguments::{Approach, OptimizeOptions};
use crate::cli::failure::Failure;
use crate::cli::{output, words};
use crate::mesh::Mesh;
use crate::optimise::{Design, Ending, Method, Movement, Step, Target, mean_edge};
use crate::space::Point;

/// What was done to a mesh.
pub struct Round {
    pub points: Vec<Point<f64>>,
    pub steps: Vec<Step>,
    pub ending: Ending,
    pub movement: Movement,
    /// The mean length of an edge before.
    pub edge: f64,
    faces: usize,
}

impl Round {
    pub fn run(
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
            curves: curves(options, &mesh.topology),
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

    pub fn last(&self) -> Option<&Step> {
        self.steps.last()
    }

    pub fn json(&self) -> Value {
        json!({
            "faces": self.faces,
            "ending": self.ending.name(),
            "movement_rms": self.movement.rms,
            "movement_largest": self.movement.largest,
            "movement_at": self.movement.at.0,
            "steps": self.steps.iter().map(step).collect::<Vec<_>>(),
        })
    }

    pub fn text(&self, options: &OptimizeOptions) -> String {
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
