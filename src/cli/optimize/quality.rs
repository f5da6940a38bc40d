//! What became of faces and edges.

use crate::check::Observed;
use crate::cli::words;
use crate::mesh::{FaceId, Mesh};
use crate::net::Net;
use crate::optimise::Goal;
use crate::pair::twice_area;

/// The part of the mean edge below which an edge has vanished.
const VANISHED: f64 = 1.0 / 4096.0;

/// What became of the faces and edges of a mesh.
pub struct Quality {
    /// The faces whose top view runs the other way round.
    pub turned: Vec<FaceId>,
    /// The length of the shortest edge.
    pub shortest_edge: f64,
}

impl Quality {
    pub fn between(before: &Mesh<f64>, after: &Mesh<f64>) -> Quality {
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

    pub fn text(&self, defect: f64, edge: f64, seconds: f64) -> String {
        let mut text = String::new();
        if let Some(first) = self.turned.first() {
            let faces = words::count(self.turned.len(), "face");
            text += &format!(
                "  {faces} turned over or lost its area in the top view, first {}\n",
                first.0
            );
        }
        if self.shortest_edge < VANISHED * edge {
            text += "  edges have vanished: the goal was reached only by a degenerate mesh\n";
        }
        text += &format!(
            "  shortest edge {} of the mean before\n",
            words::defect(self.shortest_edge / edge)
        );
        let defect = words::defect(defect);
        text + &format!("  observed in doubles: largest defect {defect}; {seconds:.3} s\n")
    }
}

/// The largest defect of the property that was asked for.
pub fn defect(goal: Goal, mesh: &Mesh<f64>) -> f64 {
    let observed = Observed { points: &mesh.points, tolerance: 0.0 };
    let defects = Net::new(&mesh.topology, &observed).defects(goal.property());
    defects.into_iter().fold(0.0, f64::max)
}
