//! Planar meshes over a fixed top view: their heights solve a linear system.

use super::dyadic::rounded;
use super::linear::{Rows, solution_near};
use super::{NoExactMesh, Obstacle};
use crate::mesh::{Topology, VertexId};
use crate::scalar::{Rational, Ring};
use crate::space::{Point, TopView};

/// Points near their targets, in which all faces are planar: top views are rounded, then of the heights as
/// many as may be chosen.
///
/// # Errors
/// Where the memory does not suffice.
pub(super) fn heights(
    topology: &Topology,
    targets: &[Point<f64>],
    bits: i32,
) -> Result<Vec<Point<Rational>>, NoExactMesh> {
    let round = |c: f64| rounded(c, bits).unwrap_or_else(Rational::zero);
    let tops: Vec<_> = targets.iter().map(|p| TopView::new(round(p.x), round(p.y))).collect();
    let heights: Vec<f64> = targets.iter().map(|p| p.z).collect();
    let solution = solution_near(&heights, &planarity(topology, &tops));
    let heights = solution.map_err(|_| Obstacle::OutOfMemory.at_vertex(VertexId(0)))?;
    Ok(tops.iter().zip(heights).map(|(top, z)| top.at_height(z)).collect())
}

/// For each corner of a face beside three, `Σ aᵥ zᵥ = 0` for the four points to be coplanar.
fn planarity(topology: &Topology, tops: &[TopView<Rational>]) -> Rows {
    let twice_area = |[a, b, c]: [VertexId; 3]| {
        let [a, b, c] = [a, b, c].map(|v| &tops[v.index()]);
        (b - a).det(&(c - a))
    };
    let mut rows = Rows::new();
    for face in topology.faces().map(|f| topology.face(f)).filter(|face| face.len() > 3) {
        let n = face.len();
        let base = if n == 4 { [0, 1, 2] } else { [0, n / 3, 2 * n / 3] };
        let [a, b, c] = base.map(|i| face[i]);
        for d in (0..n).filter(|i| !base.contains(i)).map(|i| face[i]) {
            rows.push(vec![
                (a.index(), twice_area([b, c, d])),
                (b.index(), -twice_area([a, c, d])),
                (c.index(), twice_area([a, b, d])),
                (d.index(), -twice_area([a, b, c])),
            ]);
        }
    }
    rows
}
