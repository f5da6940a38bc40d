//! From a mesh to one of a class, near it and fair.

use std::sync::Arc;

use super::cholesky::NoFactor;
use super::compromise::Compromise;
use super::energy::{Closeness, Shape, fairness};
use super::frame::Frame;
use super::report::{Ending, Stage, Step};
use super::system::System;
use super::target::{Target, VerticalDistance};
use super::{Conditions, Goal, Mobility, Projection};
use crate::mesh::{Mesh, Topology, VertexId};
use crate::space::Point;

/// How the conditions are approached.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// All coordinates at once.
    #[default]
    Joint,
    /// First the top view, then the heights, for which planarity is linear.
    TwoStage,
}

/// What a mesh shall become, and what shall be kept of it.
pub struct Design {
    /// The class.
    pub goal: Goal,
    /// The weight of fairness; closeness has 1.
    pub fairness: f64,
    /// The weight of the shape, of the change of edges: it counts where the mesh is far from its goal, or
    /// where there are other wishes.
    pub shape: f64,
    /// A surface to be close to, instead of the mesh itself.
    pub target: Option<Arc<Target>>,
    /// How each vertex may move.
    pub mobility: Vec<Mobility>,
    /// How the conditions are approached.
    pub method: Method,
    /// The most steps of each stage.
    pub steps: usize,
}

/// What came of it.
#[derive(Clone, Debug)]
pub struct Designed {
    /// Where the vertices are.
    pub points: Vec<Point<f64>>,
    /// What was done.
    pub steps: Vec<Step>,
    /// How it ended.
    pub ending: Ending,
}

/// How far vertices have moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Movement {
    /// The root of the mean square.
    pub rms: f64,
    /// The largest.
    pub largest: f64,
    /// The vertex that moved farthest.
    pub at: VertexId,
}

impl Movement {
    /// The distances in space between vertices of the same number. Without vertices all is 0.
    pub fn between(before: &[Point<f64>], after: &[Point<f64>]) -> Movement {
        let squares = before.iter().zip(after).map(|(p, q)| (p - q).length2());
        let (sum, largest, at) =
            squares.zip(0..).fold((0.0, 0.0, 0), |(sum, largest, at), (d, v)| {
                let (largest, at) = if d > largest { (d, v) } else { (largest, at) };
                (sum + d, largest, at)
            });
        let rms = (sum / before.len().max(1) as f64).sqrt();
        Movement { rms, largest: largest.sqrt(), at: VertexId(at) }
    }
}

impl Design {
    /// The design without further wishes: every vertex is free, and moves as little as it may.
    pub fn new(goal: Goal, vertices: usize) -> Self {
        Design {
            goal,
            fairness: 0.0,
            shape: 10.0,
            target: None,
            mobility: vec![Mobility::Free; vertices],
            method: Method::Joint,
            steps: 50,
        }
    }

    /// Moves the vertices of a mesh.
    ///
    /// Coordinates are taken from the middle of the mesh in a unit of its size: nothing depends on either. `go_on` sees every
    /// step, and ends the work where it says no: then the best points so far are returned.
    ///
    /// # Errors
    /// Where the memory does not suffice.
    ///
    /// ```
    /// use isogeo::construct::quad_patch;
    /// use isogeo::mesh::Mesh;
    /// use isogeo::optimise::{Design, Ending, Goal};
    /// use isogeo::space::Point;
    /// let points = (0..9).map(|i| (f64::from(i % 3), f64::from(i / 3)));
    /// let points = points.map(|(x, y)| Point::new(x, y, 0.1 * x * x * y)).collect();
    /// let mesh = Mesh::new(points, quad_patch(2, 2))?;
    /// let design = Design::new(Goal::Planar, mesh.points.len());
    /// let found = design.run(&mesh, |_| true)?;
    /// assert_eq!(found.ending, Ending::Converged);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(
        &self,
        mesh: &Mesh<f64>,
        mut go_on: impl FnMut(&Step) -> bool,
    ) -> Result<Designed, NoFactor> {
        let frame = Frame::of(&mesh.points);
        let mut points: Vec<_> = mesh.points.iter().map(|p| frame.inside(p)).collect();
        let mut steps = Vec::new();
        let mut log = |step: &Step| {
            let step = step.times(frame.unit);
            let more = go_on(&step);
            steps.push(step);
            more
        };
        let ending = self.approach(&mesh.topology, &mut points, &frame, &mut log)?;
        points.iter_mut().for_each(|p| *p = frame.outside(p));
        // What may not move has its own coordinates, not those that came back from the shift.
        for ((p, old), mobility) in points.iter_mut().zip(&mesh.points).zip(&self.mobility) {
            match mobility {
                Mobility::Fixed => *p = *old,
                Mobility::Vertical => (p.x, p.y) = (old.x, old.y),
                Mobility::Horizontal => p.z = old.z,
                Mobility::Free | Mobility::Along(_) => {}
            }
        }
        Ok(Designed { points, steps, ending })
    }

    fn approach(
        &self,
        topology: &Topology,
        points: &mut Vec<Point<f64>>,
        frame: &Frame,
        log: &mut impl FnMut(&Step) -> bool,
    ) -> Result<Ending, NoFactor> {
        let mut system = System::new(self.goal.conditions(topology, points));
        let wishes = self.fairness > 0.0 || self.target.is_some();
        if wishes || self.shape > 0.0 && self.is_far(&system, topology, points) {
            let stopped = self.compromise(topology, points, frame, log)?;
            if stopped {
                return Ok(Ending::Stopped);
            }
            system = System::new(self.goal.conditions(topology, points));
        }
        if let (Method::TwoStage, Some(conditions)) =
            (self.method, self.goal.top_view_conditions(topology))
        {
            let stages = [
                (Stage::TopView, System::new(conditions), Mobility::in_top_view as fn(&_) -> _),
                (
                    Stage::Heights,
                    System::new(Goal::Planar.conditions(topology, points)),
                    Mobility::in_height,
                ),
            ];
            for (stage, system, part) in stages {
                let mobility: Vec<_> = self.mobility.iter().map(part).collect();
                let ending =
                    Projection::new(&system, &mobility)?.run(points, self.steps, stage, &mut *log);
                if ending == Ending::Stopped {
                    return Ok(ending);
                }
            }
        }
        let mut projection = Projection::new(&system, &self.mobility)?;
        Ok(projection.run(points, self.steps, Stage::Projection, log))
    }

    /// Whether some condition is farther from holding than a part of an edge: then the shortest way to it may
    /// lead through edges that vanish and faces that turn over.
    fn is_far(&self, system: &System, topology: &Topology, points: &[Point<f64>]) -> bool {
        const PART: f64 = 1.0 / 8.0;
        let at = system.linearise(points, &self.mobility);
        let worst = system.worst(&at.residuals);
        worst.iter().any(|w| w.distance > PART * mean_edge(topology, points))
    }

    /// Whether somebody stopped it.
    fn compromise(
        &self,
        topology: &Topology,
        points: &mut Vec<Point<f64>>,
        frame: &Frame,
        log: &mut impl FnMut(&Step) -> bool,
    ) -> Result<bool, NoFactor> {
        let mut energies: Vec<(Box<dyn Conditions>, Option<f64>)> = Vec::new();
        if self.fairness > 0.0 {
            let weight = self.fairness.sqrt();
            energies.extend(fairness(topology).into_iter().map(|kind| (kind, Some(weight))));
        }
        if self.shape > 0.0 {
            energies.push((Box::new(Shape::new(topology, points)), Some(self.shape.sqrt())));
        }
        match &self.target {
            Some(target) => {
                let distance = VerticalDistance::new(target.clone(), *frame, points.len());
                energies.push((Box::new(distance), Some(1.0)));
            }
            None => energies.push((Box::new(Closeness::new(points)), Some(1.0))),
        }
        let soft = System::weighted(energies);
        let edge = mean_edge(topology, points);
        let hard = System::weighted(self.goal.far_conditions(topology, points, edge));
        let mut compromise = Compromise::new(&hard, &soft, &self.mobility)?;
        let mut number = 0;
        for level in 0..HARDNESSES {
            let hardness = 8f64.powi(level);
            for _ in 0..STEPS_OF_A_HARDNESS {
                let step = compromise.state(points, number);
                if !log(&step) {
                    return Ok(true);
                }
                number += 1;
                if !compromise.step(points, hardness) {
                    break;
                }
            }
        }
        Ok(false)
    }
}

/// From 1 to 8^7 conditions weigh more and more.
const HARDNESSES: i32 = 8;
const STEPS_OF_A_HARDNESS: usize = 3;

/// The mean length of the edges of a mesh; 0 without edges.
pub fn mean_edge(topology: &Topology, points: &[Point<f64>]) -> f64 {
    let ends = |h| [topology.origin(h), topology.target(h)].map(|v| &points[v.index()]);
    let lengths = topology.edges().map(ends).map(|[p, q]| (p - q).length2().sqrt());
    lengths.sum::<f64>() / topology.edge_count().max(1) as f64
}
