//! The centres of a circle pattern, placed face by face.

use std::collections::{BTreeMap, VecDeque};

use super::CirclePattern;
use crate::mesh::{FaceId, HalfEdge, VertexId};
use crate::space::TopView;

/// The centres of all circles, and how well they close.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The centres of the vertex circles.
    pub vertices: Vec<TopView<f64>>,
    /// The centres of the face circles.
    pub faces: Vec<TopView<f64>>,
    /// For vertices whose circle is a line, a point on it and another one.
    pub lines: BTreeMap<VertexId, [TopView<f64>; 2]>,
    /// The largest distance between two places of one vertex that two faces find for it, as a part
    /// of its radius.
    pub gap: f64,
}

impl CirclePattern<'_> {
    /// Places the circles in the plane: the first edge of the first face of each component begins at
    /// the origin and runs along x; every other face follows from a neighbour. Lines have no centre:
    /// their coordinates are not numbers.
    pub fn layout(&self) -> Layout {
        let topology = self.topology();
        let nowhere = TopView::new(f64::NAN, f64::NAN);
        let mut layout = Layout {
            vertices: vec![nowhere; topology.vertex_count()],
            faces: vec![nowhere; topology.face_count()],
            lines: BTreeMap::new(),
            gap: 0.0,
        };
        let mut placed = vec![false; topology.vertex_count()];
        let mut seen = vec![false; topology.face_count()];
        let mut queue = VecDeque::new();
        for root in topology.faces() {
            let Some(first) = topology.half_edges(root).find(|&h| self.is_finite(h)) else {
                continue;
            };
            if seen[root.index()] {
                continue;
            }
            let (v, w) = (topology.origin(first), topology.target(first));
            if !placed[v.index()] && !placed[w.index()] {
                layout.vertices[v.index()] = TopView::new(0.0, 0.0);
                let length = self.vertex_radii[v.index()] + self.vertex_radii[w.index()];
                layout.vertices[w.index()] = TopView::new(length, 0.0);
                (placed[v.index()], placed[w.index()]) = (true, true);
            }
            seen[root.index()] = true;
            queue.push_back(first);
            while let Some(h) = queue.pop_front() {
                self.place(h, &mut layout, &mut placed);
                for side in topology.half_edges(topology.face_at(h)) {
                    if let Some(twin) = topology.twin(side)
                        && self.is_finite(twin)
                        && !seen[topology.face_at(twin).index()]
                    {
                        seen[topology.face_at(twin).index()] = true;
                        queue.push_back(twin);
                    }
                }
            }
        }
        layout
    }

    /// Whether the face and both ends of a half-edge have circles.
    fn is_finite(&self, h: HalfEdge) -> bool {
        let topology = self.topology();
        let (v, w) = (topology.origin(h), topology.target(h));
        self.vertex_radii[v.index()].is_finite()
            && self.vertex_radii[w.index()].is_finite()
            && self.face_radii[topology.face_at(h).index()].is_finite()
    }

    /// Places a face on the left of an edge that is placed, and its other vertices.
    fn place(&self, first: HalfEdge, layout: &mut Layout, placed: &mut [bool]) {
        let topology = self.topology();
        let face = topology.face_at(first);
        let radius = self.face_radii[face.index()];
        let (v, w) = (topology.origin(first), topology.target(first));
        let [a, b] = [v, w].map(|v| layout.vertices[v.index()]);
        let (r, s) = (self.vertex_radii[v.index()], self.vertex_radii[w.index()]);
        let edge = &b - &a;
        let length = edge.length2().sqrt();
        // Both circles touch at this point, and the face circle touches the edge there.
        let touch = &a + &edge.scaled(&(r / (r + s)));
        let centre = &touch + &edge.turned().scaled(&(radius / length));
        layout.faces[face.index()] = centre;
        let begin = (touch.y - centre.y).atan2(touch.x - centre.x);
        let side = |direction: f64, distance: f64| {
            let (sine, cosine) = direction.sin_cos();
            TopView::new(centre.x + distance * cosine, centre.y + distance * sine)
        };
        // Counter-clockwise from the edge to its target, and on; if a line is in the way, also
        // clockwise from the edge to its origin, and on.
        for turn in [1.0, -1.0] {
            let mut direction = begin;
            let mut h = first;
            loop {
                let next = if turn > 0.0 { topology.next(h) } else { topology.prev(h) };
                let vertex = if turn > 0.0 { topology.target(h) } else { topology.origin(h) };
                let own = self.vertex_radii[vertex.index()];
                if !own.is_finite() {
                    // It meets the face circle in its centre and where it touches this edge.
                    layout.lines.entry(vertex).or_insert([centre, side(direction, radius)]);
                    break;
                }
                // Half of the kite to the vertex, the other half to the next touching point.
                let half = turn * (own / radius).atan();
                direction += half;
                let place = side(direction, own.hypot(radius));
                if placed[vertex.index()] {
                    let gap = (&place - &layout.vertices[vertex.index()]).length2().sqrt() / own;
                    layout.gap = layout.gap.max(gap);
                } else {
                    (layout.vertices[vertex.index()], placed[vertex.index()]) = (place, true);
                }
                direction += half;
                h = next;
                if h == first {
                    return;
                }
            }
        }
    }

    /// The radius of a vertex circle.
    pub fn vertex_radius(&self, v: VertexId) -> f64 {
        self.vertex_radii[v.index()]
    }

    /// The radius of a face circle.
    pub fn face_radius(&self, f: FaceId) -> f64 {
        self.face_radii[f.index()]
    }
}
