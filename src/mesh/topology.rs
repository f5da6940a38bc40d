//! Combinatorics of a mesh: who meets whom, without a coordinate.

use super::TopologyError;

/// The index of a vertex, in the order of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

/// The index of a face, in the order of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId(pub u32);

/// A half-edge: an edge seen from the face on its left. Half-edge `i` is corner `i`, counted
/// through all faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HalfEdge(pub u32);

impl VertexId {
    /// The index as `usize`.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl FaceId {
    /// The index as `usize`.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl HalfEdge {
    #[inline]
    fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a vertex is to the faces around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexKind {
    /// In no face.
    Isolated,
    /// Its faces form one closed cycle.
    Interior,
    /// Its faces form one open fan.
    Boundary,
    /// Its faces form more than one fan or cycle: the mesh is pinched there.
    Pinched,
}

/// The combinatorics of an oriented mesh with boundary, faces of any size, mixed.
///
/// Invariants: every face has at least three corners, all different; an edge belongs to one face
/// or to two that run through it in opposite directions. Vertices may be isolated or pinched.
/// Nothing here sees a coordinate, so nothing here can depend on one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    vertices: u32,
    /// `starts[f]..starts[f + 1]` are the corners of face `f`.
    starts: Vec<u32>,
    corners: Vec<VertexId>,
    face_of: Vec<u32>,
    /// The opposite half-edge or `NONE`.
    twins: Vec<u32>,
    /// An outgoing half-edge of each vertex: at a boundary vertex the one without twin.
    outgoing: Vec<u32>,
    kinds: Vec<VertexKind>,
    /// The outgoing half-edges of pinched vertices, in order: one of them does not lead to all.
    pinched: Vec<(VertexId, u32)>,
    edges: usize,
}

const NONE: u32 = u32::MAX;

/// Collects the faces of a mesh, one after the other, and becomes a [`Topology`].
#[derive(Clone, Debug, Default)]
pub struct FaceList {
    ends: Vec<usize>,
    corners: Vec<u32>,
}

impl FaceList {
    /// An empty list.
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends a face by the indices of its vertices, counted from 0.
    pub fn push(&mut self, face: impl IntoIterator<Item = u32>) {
        self.corners.extend(face);
        self.ends.push(self.corners.len());
    }

    /// The number of faces.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }
}

impl Topology {
    /// Checks that the faces form an oriented mesh on `vertices` vertices and links them.
    ///
    /// Time and memory are linear in the number of corners.
    pub fn new(vertices: usize, faces: FaceList) -> Result<Topology, TopologyError> {
        let FaceList { ends, corners } = faces;
        if corners.len() >= NONE as usize || vertices >= NONE as usize {
            return Err(TopologyError::TooLarge);
        }
        let mut starts = Vec::with_capacity(ends.len() + 1);
        starts.push(0);
        starts.extend(ends.iter().map(|&e| e as u32));
        let corners: Vec<VertexId> = corners.into_iter().map(VertexId).collect();
        let mut face_of = Vec::with_capacity(corners.len());
        let vertices = vertices as u32;
        for (f, range) in starts.windows(2).enumerate() {
            let face = FaceId(f as u32);
            check_face(face, &corners[range[0] as usize..range[1] as usize], vertices)?;
            face_of.resize(range[1] as usize, face.0);
        }
        let mut topology = Topology {
            vertices,
            starts,
            twins: Vec::new(),
            outgoing: vec![NONE; vertices as usize],
            kinds: vec![VertexKind::Isolated; vertices as usize],
            corners,
            face_of,
            pinched: Vec::new(),
            edges: 0,
        };
        (topology.twins, topology.edges) = topology.pair_half_edges()?;
        topology.classify_vertices();
        Ok(topology)
    }

    /// The twins and the number of edges: half-edges are sorted by their lower vertex, then compared by the higher.
    fn pair_half_edges(&self) -> Result<(Vec<u32>, usize), TopologyError> {
        let ends = |h: u32| {
            let (a, b) = (self.origin(HalfEdge(h)), self.target(HalfEdge(h)));
            (a.min(b), a.max(b))
        };
        let count = self.corners.len() as u32;
        let mut bucket_ends = vec![0u32; self.vertices as usize + 1];
        for h in 0..count {
            bucket_ends[ends(h).0.index() + 1] += 1;
        }
        for v in 0..self.vertices as usize {
            bucket_ends[v + 1] += bucket_ends[v];
        }
        let mut sorted = vec![(VertexId(0), 0u32); count as usize];
        // Filling from the back turns the ends of the buckets into their starts.
        let mut fill = bucket_ends.clone();
        for h in (0..count).rev() {
            let (low, high) = ends(h);
            let slot = &mut fill[low.index() + 1];
            *slot -= 1;
            sorted[*slot as usize] = (high, h);
        }
        let mut edges = 0;
        let mut twins = vec![NONE; self.corners.len()];
        for range in bucket_ends.windows(2) {
            let bucket = &mut sorted[range[0] as usize..range[1] as usize];
            bucket.sort_unstable();
            for group in bucket.chunk_by(|a, b| a.0 == b.0) {
                edges += 1;
                match *group {
                    [] | [_] => {}
                    [(_, g), (_, h)] => {
                        let (g, h) = (HalfEdge(g), HalfEdge(h));
                        if self.origin(g) == self.origin(h) {
                            return Err(TopologyError::WrongOrientation {
                                edge: (self.origin(g), self.target(g)),
                                faces: (self.face_at(g), self.face_at(h)),
                            });
                        }
                        twins[g.index()] = h.0;
                        twins[h.index()] = g.0;
                    }
                    [(_, a), (_, b), (_, c), ..] => {
                        let face = |h| self.face_at(HalfEdge(h));
                        return Err(TopologyError::NonManifoldEdge {
                            edge: ends(a),
                            faces: (face(a), face(b), face(c)),
                        });
                    }
                }
            }
        }
        Ok((twins, edges))
    }

    fn classify_vertices(&mut self) {
        let mut valence = vec![0u32; self.vertices as usize];
        for h in 0..self.corners.len() as u32 {
            let v = self.corners[h as usize].index();
            valence[v] += 1;
            if self.outgoing[v] == NONE || self.twins[h as usize] == NONE {
                self.outgoing[v] = h;
            }
        }
        for v in 0..self.vertices {
            let first = self.outgoing[v as usize];
            if first == NONE {
                continue;
            }
            let seen = self.fan(HalfEdge(first)).count() as u32;
            self.kinds[v as usize] = if seen < valence[v as usize] {
                VertexKind::Pinched
            } else if self.twins[first as usize] == NONE {
                VertexKind::Boundary
            } else {
                VertexKind::Interior
            };
        }
        let origins = self.corners.iter().copied().zip(0u32..);
        self.pinched = origins.filter(|&(v, _)| self.kind(v) == VertexKind::Pinched).collect();
        self.pinched.sort_unstable();
    }

    /// The outgoing half-edges of a vertex counter-clockwise from `first`, until they close or end.
    fn fan(&self, first: HalfEdge) -> impl Iterator<Item = HalfEdge> + '_ {
        std::iter::successors(Some(first), move |&h| {
            self.twin(self.prev(h)).filter(|&h| h != first)
        })
    }

    /// The number of vertices, isolated ones included.
    pub fn vertex_count(&self) -> usize {
        self.vertices as usize
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.edges
    }

    /// The number of corners, which is the number of half-edges.
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The vertices of a face in its cyclic order, from the first in the file.
    #[inline]
    pub fn face(&self, face: FaceId) -> &[VertexId] {
        let f = face.index();
        &self.corners[self.starts[f] as usize..self.starts[f + 1] as usize]
    }

    /// All faces in the order of the file.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceId> + Clone + use<> {
        (0..self.face_count() as u32).map(FaceId)
    }

    /// All vertices in the order of the file.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + Clone + use<> {
        (0..self.vertices).map(VertexId)
    }

    /// One half-edge for each edge: the one of the lower index.
    pub fn edges(&self) -> impl Iterator<Item = HalfEdge> + '_ {
        (0..self.corners.len() as u32)
            .filter(|&h| self.twins[h as usize] == NONE || h < self.twins[h as usize])
            .map(HalfEdge)
    }

    /// The half-edge from `a` to `b`, or the one from `b` to `a` if only that exists.
    ///
    /// Costs a walk around the end with fewer faces.
    pub fn edge(&self, a: VertexId, b: VertexId) -> Option<HalfEdge> {
        let joins = |h: HalfEdge| {
            let ends = (self.origin(h), self.target(h));
            ends == (a, b) || ends == (b, a)
        };
        let (mut around_a, mut around_b) = (self.around(a), self.around(b));
        let found = loop {
            let h = around_a.next()?;
            if joins(h) {
                break h;
            }
            let h = around_b.next()?;
            if joins(h) {
                break h;
            }
        };
        if self.origin(found) == a { Some(found) } else { self.twin(found).or(Some(found)) }
    }

    /// The other ends of all edges at a vertex, pinched or not, in ascending order.
    pub fn neighbours(&self, v: VertexId) -> Vec<VertexId> {
        let ends = self
            .around(v)
            .map(|h| if self.origin(h) == v { self.target(h) } else { self.origin(h) });
        let mut ends: Vec<VertexId> = ends.collect();
        ends.sort_unstable();
        ends.dedup();
        ends
    }

    /// All half-edges that start or end at a vertex, pinched or not.
    fn around(&self, v: VertexId) -> impl Iterator<Item = HalfEdge> + '_ {
        let pinched = self.kind(v) == VertexKind::Pinched;
        // Not pinched, the vertex is not in the list.
        let first = self.pinched.partition_point(|p| p.0 < v);
        let here = self.pinched[first..].iter().take_while(move |p| p.0 == v);
        let fans = here.map(|p| HalfEdge(p.1));
        let star = (!pinched).then(|| self.star(v)).into_iter().flatten();
        star.chain(fans).flat_map(|h| [h, self.prev(h)])
    }

    /// The half-edges of a face, from the first corner.
    pub fn half_edges(&self, face: FaceId) -> impl ExactSizeIterator<Item = HalfEdge> + use<> {
        (self.starts[face.index()]..self.starts[face.index() + 1]).map(HalfEdge)
    }

    /// The vertex that a half-edge starts from.
    #[inline]
    pub fn origin(&self, h: HalfEdge) -> VertexId {
        self.corners[h.index()]
    }

    /// The vertex that a half-edge goes to.
    #[inline]
    pub fn target(&self, h: HalfEdge) -> VertexId {
        self.corners[self.next(h).index()]
    }

    /// The face on the left of a half-edge.
    #[inline]
    pub fn face_at(&self, h: HalfEdge) -> FaceId {
        FaceId(self.face_of[h.index()])
    }

    /// The next half-edge of the same face.
    #[inline]
    pub fn next(&self, h: HalfEdge) -> HalfEdge {
        let f = self.face_of[h.index()] as usize;
        HalfEdge(if h.0 + 1 == self.starts[f + 1] { self.starts[f] } else { h.0 + 1 })
    }

    /// The previous half-edge of the same face.
    #[inline]
    pub fn prev(&self, h: HalfEdge) -> HalfEdge {
        let f = self.face_of[h.index()] as usize;
        HalfEdge(if h.0 == self.starts[f] { self.starts[f + 1] - 1 } else { h.0 - 1 })
    }

    /// The same edge seen from the other side; `None` at the boundary.
    #[inline]
    pub fn twin(&self, h: HalfEdge) -> Option<HalfEdge> {
        let twin = self.twins[h.index()];
        (twin != NONE).then_some(HalfEdge(twin))
    }

    /// What the vertex is to the faces around it.
    #[inline]
    pub fn kind(&self, v: VertexId) -> VertexKind {
        self.kinds[v.index()]
    }

    /// The vertices whose faces form one closed cycle.
    pub fn interior_vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        self.vertices().filter(|&v| self.kind(v) == VertexKind::Interior)
    }

    /// The outgoing half-edges of a vertex, counter-clockwise.
    ///
    /// At an interior vertex they form a cycle; at a boundary vertex a fan that starts at the edge
    /// with no face on its right. At a pinched vertex only one of the fans is seen.
    pub fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdge> + '_ {
        let first = self.outgoing[v.index()];
        (first != NONE).then_some(HalfEdge(first)).into_iter().flat_map(|h| self.fan(h))
    }

    /// The boundary as cyclic lists of vertices; the faces lie on the left of each.
    pub fn boundary_loops(&self) -> Vec<Vec<VertexId>> {
        let mut seen = vec![false; self.corners.len()];
        let mut loops = Vec::new();
        for h in 0..self.corners.len() as u32 {
            let mut at = HalfEdge(h);
            let mut boundary = Vec::new();
            while self.twins[at.index()] == NONE && !seen[at.index()] {
                seen[at.index()] = true;
                boundary.push(self.origin(at));
                // Turn about the target, through its faces, to the next edge without twin.
                at = self.next(at);
                while let Some(twin) = self.twin(at) {
                    at = self.next(twin);
                }
            }
            if !boundary.is_empty() {
                loops.push(boundary);
            }
        }
        loops
    }

    /// The number of connected components, isolated vertices counted.
    pub fn component_count(&self) -> usize {
        let mut parent: Vec<u32> = (0..self.vertices).collect();
        fn root(parent: &mut [u32], mut v: u32) -> u32 {
            while parent[v as usize] != v {
                parent[v as usize] = parent[parent[v as usize] as usize];
                v = parent[v as usize];
            }
            v
        }
        let mut components = self.vertices as usize;
        for h in (0..self.corners.len() as u32).map(HalfEdge) {
            let (a, b) = (self.origin(h).0, self.target(h).0);
            let (a, b) = (root(&mut parent, a), root(&mut parent, b));
            if a != b {
                parent[a as usize] = b;
                components -= 1;
            }
        }
        components
    }

    /// Vertices − edges + faces.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edges as i64 + self.face_count() as i64
    }
}

fn check_face(face: FaceId, corners: &[VertexId], vertices: u32) -> Result<(), TopologyError> {
    if corners.len() < 3 {
        return Err(TopologyError::FaceTooSmall { face, corners: corners.len() });
    }
    if let Some(v) = corners.iter().find(|v| v.0 >= vertices) {
        return Err(TopologyError::NoSuchVertex { face, vertex: v.0, vertices });
    }
    let repeated = if corners.len() <= 16 {
        (1..corners.len()).find(|&i| corners[..i].contains(&corners[i])).map(|i| corners[i])
    } else {
        let mut sorted = corners.to_vec();
        sorted.sort_unstable();
        sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
    };
    match repeated {
        Some(vertex) => Err(TopologyError::RepeatedVertex { face, vertex }),
        None => Ok(()),
    }
}
