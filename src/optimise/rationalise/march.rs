//! The order in which the vertices of quads are placed, each by the edges to those before it.

use std::collections::VecDeque;

use super::{NoExactMesh, Obstacle};
use crate::mesh::{HalfEdge, Topology, VertexId};

/// What a vertex is placed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Nothing.
    Free(VertexId),
    /// One edge, from the second.
    Along(VertexId, VertexId),
    /// The two edges of a face whose other vertices are there: the vertex is the origin of the
    /// half-edge.
    Close(HalfEdge),
}

/// An order in which every vertex, when it comes, has at most two edges to those before it, and two only
/// as the last vertex of a face.
///
/// It is the reverse of taking vertices away from the rim, from all sides at the same pace, so that the
/// first ones lie in the middle.
///
/// # Errors
/// A face that is no quad; a vertex that is left when no more can be taken away.
pub(super) fn march(topology: &Topology) -> Result<Vec<Step>, NoExactMesh> {
    if let Some(f) = topology.faces().find(|&f| topology.face(f).len() != 4) {
        return Err(Obstacle::NoQuad.at_face(f));
    }
    let neighbours: Vec<_> = topology.vertices().map(|v| topology.neighbours(v)).collect();
    let mut degrees: Vec<usize> = neighbours.iter().map(Vec::len).collect();
    let mut corners = vec![Vec::new(); neighbours.len()];
    for h in topology.faces().flat_map(|f| topology.half_edges(f)) {
        corners[topology.origin(h).index()].push(h);
    }
    let mut gone = vec![false; neighbours.len()];
    let mut queue: VecDeque<_> = topology.vertices().filter(|v| degrees[v.index()] <= 2).collect();
    let mut steps = Vec::with_capacity(neighbours.len());
    while let Some(v) = queue.pop_front() {
        if gone[v.index()] || degrees[v.index()] > 2 {
            continue;
        }
        let is_here = |w: &VertexId| !gone[w.index()];
        let is_whole = |h: &HalfEdge| topology.face(topology.face_at(*h)).iter().all(is_here);
        let rest: Vec<_> = neighbours[v.index()].iter().copied().filter(is_here).collect();
        let step = match rest[..] {
            [] => Step::Free(v),
            [from] => Step::Along(v, from),
            _ => match corners[v.index()].iter().copied().find(is_whole) {
                Some(h) => Step::Close(h),
                // It comes back when it has lost an edge.
                None => continue,
            },
        };
        steps.push(step);
        gone[v.index()] = true;
        for w in rest {
            degrees[w.index()] -= 1;
            queue.push_back(w);
        }
    }
    if let Some(v) = topology.vertices().find(|v| !gone[v.index()]) {
        return Err(Obstacle::Stuck.at_vertex(v));
    }
    steps.reverse();
    Ok(steps)
}
