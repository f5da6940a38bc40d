//! A spanning forest of the edges, and the cycles that no faces fill.

use std::collections::VecDeque;

use crate::mesh::{HalfEdge, Topology, VertexId};

/// A half-edge and whether it is run through from its target to its origin.
pub(super) type Step = (HalfEdge, bool);

/// A forest that spans every component of a mesh, roots first.
#[derive(Clone, Debug)]
pub(super) struct Forest {
    /// The step from its parent to each vertex; `None` at roots.
    parents: Vec<Option<Step>>,
    /// The root of the tree of each vertex.
    pub roots: Vec<VertexId>,
    /// All vertices, parents before children.
    pub order: Vec<VertexId>,
}

/// Where a step comes from.
fn from(topology: &Topology, (h, backwards): Step) -> VertexId {
    if backwards { topology.target(h) } else { topology.origin(h) }
}

impl Forest {
    /// The forest of shortest paths from the first vertex of every component.
    pub fn new(topology: &Topology) -> Self {
        let mut neighbours: Vec<Vec<Step>> = vec![Vec::new(); topology.vertex_count()];
        for h in topology.edges() {
            neighbours[topology.origin(h).index()].push((h, false));
            neighbours[topology.target(h).index()].push((h, true));
        }
        let mut parents = vec![None; topology.vertex_count()];
        let mut roots: Vec<Option<VertexId>> = vec![None; topology.vertex_count()];
        let mut order = Vec::with_capacity(topology.vertex_count());
        for root in topology.vertices() {
            let mut queue = VecDeque::new();
            if roots[root.index()].is_none() {
                roots[root.index()] = Some(root);
                queue.push_back(root);
            }
            while let Some(v) = queue.pop_front() {
                order.push(v);
                for &(h, backwards) in &neighbours[v.index()] {
                    let next = from(topology, (h, !backwards));
                    if roots[next.index()].is_none() {
                        roots[next.index()] = Some(root);
                        parents[next.index()] = Some((h, backwards));
                        queue.push_back(next);
                    }
                }
            }
        }
        let roots = roots.into_iter().zip(topology.vertices()).map(|(r, v)| r.unwrap_or(v));
        Forest { parents, roots: roots.collect(), order }
    }

    /// The parent of a vertex and the step from it.
    pub fn parent(&self, topology: &Topology, v: VertexId) -> Option<(VertexId, Step)> {
        self.parents[v.index()].map(|step| (from(topology, step), step))
    }

    /// Cycles that, with the boundaries of the faces, span all closed chains of edges: two for
    /// every handle, one for every hole but the first, and those through pinched vertices.
    ///
    /// Faces are joined over edges outside the forest into trees (a component with boundary has
    /// one more node, outside). From the leaves inwards each face then says what the edge to its
    /// parent is, so that only the edges neither in the forest nor crossed by these trees are left.
    pub fn unfilled_cycles(&self, topology: &Topology) -> Vec<Vec<Step>> {
        let faces = topology.face_count();
        let mut sheets = Partition::new(faces);
        for h in topology.edges() {
            if let Some(twin) = topology.twin(h) {
                sheets.join(topology.face_at(h).index(), topology.face_at(twin).index());
            }
        }
        let mut in_forest = vec![false; topology.corner_count()];
        for (h, _) in self.parents.iter().flatten() {
            in_forest[h.0 as usize] = true;
        }
        let mut joined = Partition::new(2 * faces);
        let mut cycles = Vec::new();
        for h in topology.edges().filter(|h| !in_forest[h.0 as usize]) {
            let face = topology.face_at(h).index();
            let other = match topology.twin(h) {
                Some(twin) => topology.face_at(twin).index(),
                None => faces + sheets.representative(face),
            };
            if !joined.join(face, other) {
                cycles.push(self.cycle(topology, h));
            }
        }
        cycles
    }

    /// The edge and the ways from its target to the root and from the root to its origin; the
    /// common part is run through in both directions.
    fn cycle(&self, topology: &Topology, edge: HalfEdge) -> Vec<Step> {
        let mut cycle = vec![(edge, false)];
        for (end, backwards) in [(topology.origin(edge), false), (topology.target(edge), true)] {
            let mut at = end;
            while let Some((parent, (h, against))) = self.parent(topology, at) {
                cycle.push((h, against != backwards));
                at = parent;
            }
        }
        cycle
    }
}

/// A partition into classes that are joined one by one.
struct Partition(Vec<usize>);

impl Partition {
    fn new(elements: usize) -> Self {
        Partition((0..elements).collect())
    }

    fn representative(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    /// Joins two classes; `false` if they were one.
    fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.representative(a), self.representative(b));
        self.0[a] = b;
        a != b
    }
}
