//! A value carried from element to neighbouring element through a whole mesh.

use crate::mesh::{HalfEdge, Topology};

/// The neighbours of every element, with the edge between them.
pub(super) type Neighbours = Vec<Vec<(usize, HalfEdge)>>;

/// The vertices joined by edges.
pub(super) fn joined_vertices(topology: &Topology) -> Neighbours {
    let ends = |h| (topology.origin(h).index(), topology.target(h).index(), h);
    collect(topology.vertex_count(), topology.edges().map(ends))
}

/// The faces joined by edges.
pub(super) fn joined_faces(topology: &Topology) -> Neighbours {
    let sides =
        |h| Some((topology.face_at(h).index(), topology.face_at(topology.twin(h)?).index(), h));
    collect(topology.face_count(), topology.edges().filter_map(sides))
}

fn collect(count: usize, pairs: impl Iterator<Item = (usize, usize, HalfEdge)>) -> Neighbours {
    let mut neighbours = vec![Vec::new(); count];
    for (a, b, h) in pairs {
        neighbours[a].push((b, h));
        neighbours[b].push((a, h));
    }
    neighbours
}

/// Values on all elements and the element that each came from.
pub(super) struct Spread<X> {
    pub values: Vec<X>,
    parents: Vec<usize>,
}

/// Carries `start` from the element `first` to all others, breadth first, by
/// `step(value, from, to, edge)`; further components start from their first elements. Of no elements
/// there is nothing to carry.
pub(super) fn spread<X: Clone, E>(
    neighbours: &Neighbours,
    first: usize,
    start: &X,
    step: impl Fn(&X, usize, usize, HalfEdge) -> Result<X, E>,
) -> Result<Spread<X>, E> {
    let mut values: Vec<Option<X>> = vec![None; neighbours.len()];
    let mut parents: Vec<usize> = (0..neighbours.len()).collect();
    let mut queue = std::collections::VecDeque::new();
    let first = Some(first).filter(|&first| first < neighbours.len());
    for root in first.into_iter().chain(0..neighbours.len()) {
        if values[root].is_none() {
            values[root] = Some(start.clone());
            queue.push_back((root, start.clone()));
        }
        while let Some((from, value)) = queue.pop_front() {
            for &(to, edge) in &neighbours[from] {
                if values[to].is_none() {
                    let next = step(&value, from, to, edge)?;
                    values[to] = Some(next.clone());
                    parents[to] = from;
                    queue.push_back((to, next));
                }
            }
        }
    }
    let values = values.into_iter().map(|v| v.unwrap_or_else(|| start.clone())).collect();
    Ok(Spread { values, parents })
}

impl<X> Spread<X> {
    /// The cycle that a further edge from `a` to `b` closes.
    pub(super) fn cycle(&self, a: usize, b: usize) -> Vec<usize> {
        let path = |end: usize| {
            let parent = |&x: &usize| (self.parents[x] != x).then(|| self.parents[x]);
            std::iter::successors(Some(end), parent).collect::<Vec<_>>()
        };
        let (mut left, mut right) = (path(a), path(b));
        while left.len() > 1 && right.len() > 1 && left[left.len() - 2] == right[right.len() - 2] {
            left.pop();
            right.pop();
        }
        // Both end in the last common element.
        right.pop();
        left.extend(right.into_iter().rev());
        left
    }
}
