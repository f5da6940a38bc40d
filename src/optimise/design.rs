//! From a mesh to one of a class, near it and fair.

use std::sync::Arc;

use super::cholesky::NoFactor;
use super::compromise::Compromise;
use super::curve::OnCurve;
use super::energy::{closeness, fairness, shape};
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
    /// Closed lines of vertices that stay on the polygons that they form at the start. What moves
    /// [along a line](Mobility::Along) there is first let go along it.
    pub curves: Vec<Vec<VertexId>>,
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
            curves: Vec::new(),
            method: Method::Joint,
            steps: 50,
        }
    }

    /// Moves the vertices of a mesh.
    ///
    /// Each step is the shortest one to where the conditions hold, as far as they are linear. Where that leads
    /// some vertex farther than an edge, the compromise between conditions and closeness is tried,
    /// too, and the mesh that moved less is kept.
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
        let start = points.clone();
        let system = System::new(self.goal.conditions(topology, points));
        let wishes = self.fairness > 0.0 || self.target.is_some();
        if wishes || self.shape > 0.0 && self.is_far(&system, topology, points) {
            if self.compromise(self.shape, topology, points, frame, log)? {
                return Ok(Ending::Stopped);
            }
            return self.project(&start, topology, points, log);
        }
        let ending = self.project(&start, topology, points, log)?;
        let way = |points: &[Point<f64>]| Movement::between(&start, points);
        if ending != Ending::Converged || way(points).largest < mean_edge(topology, &start) {
            return Ok(ending);
        }
        // The shortest steps have not led along the shortest way.
        let mut nearer = start.clone();
        if let Ok(false) = self.compromise(0.0, topology, &mut nearer, frame, log)
            && let Ok(Ending::Converged) = self.project(&start, topology, &mut nearer, log)
            && way(&nearer).rms < way(points).rms
        {
            *points = nearer;
        }
        Ok(ending)
    }

    /// Moves the points along shortest steps to where the conditions hold, and those on curves to them.
    fn project(
        &self,
        start: &[Point<f64>],
        topology: &Topology,
        points: &mut Vec<Point<f64>>,
        log: &mut impl FnMut(&Step) -> bool,
    ) -> Result<Ending, NoFactor> {
        let conditions = |goal: Goal| goal.conditions(topology, points);
        let mut stages: Vec<(Stage, _, Restriction)> = Vec::new();
        if let (Method::TwoStage, Some(in_top_view)) =
            (self.method, self.goal.top_view_conditions(topology))
        {
            stages.push((Stage::TopView, in_top_view, Mobility::in_top_view));
            stages.push((Stage::Heights, conditions(Goal::Planar), Mobility::in_height));
        }
        stages.push((Stage::Projection, conditions(self.goal), Mobility::clone));
        if !self.curves.is_empty() {
            let mut on_curves = conditions(self.goal);
            on_curves.push(Box::new(OnCurve::new(&self.curves, start)));
            stages.push((Stage::Projection, on_curves, Mobility::off_line));
        }
        let mut ending = Ending::Converged;
        for (stage, conditions, part) in stages {
            let system = System::new(conditions);
            let mobility: Vec<_> = self.mobility.iter().map(part).collect();
            let mut projection = Projection::new(&system, &mobility, points)?;
            ending = projection.run(points, self.steps, stage, &mut *log);
            if ending == Ending::Stopped {
                break;
            }
        }
        Ok(ending)
    }

    /// Whether some condition is farther from holding than a part of an edge: then the shortest way to it may
    /// lead through edges that vanish and faces that turn over.
    fn is_far(&self, system: &System, topology: &Topology, points: &[Point<f64>]) -> bool {
        const PART: f64 = 1.0 / 8.0;
        let at = system.linearise(points, &self.mobility);
        let worst = system.worst(&at.residuals);
        worst.iter().any(|w| w.distance > PART * mean_edge(topology, points))
    }

    /// Moves the points to where the conditions nearly hold, with the change of edges weighed; whether somebody
    /// stopped it.
    fn compromise(
        &self,
        weight_of_shape: f64,
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
        if weight_of_shape > 0.0 {
            energies.push((shape(topology, points), Some(weight_of_shape.sqrt())));
        }
        match &self.target {
            Some(target) => {
                let distance = VerticalDistance::new(target.clone(), *frame, points.len());
                energies.push((Box::new(distance), Some(1.0)));
            }
            None => energies.push((closeness(points), Some(1.0))),
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

/// What a stage leaves of the directions in which a point may move.
type Restriction = fn(&Mobility) -> Mobility;

/// From 1 to 8^7 conditions weigh more and more.
const HARDNESSES: i32 = 8;
const STEPS_OF_A_HARDNESS: usize = 3;

/// The mean length of the edges of a mesh; 0 without edges.
pub fn mean_edge(topology: &Topology, points: &[Point<f64>]) -> f64 {
    let ends = |h| [topology.origin(h), topology.target(h)].map(|v| &points[v.index()]);
    let lengths = topology.edges().map(ends).map(|[p, q]| (p - q).length2().sqrt());
    lengths.sum::<f64>() / topology.edge_count().max(1) as f64
}
