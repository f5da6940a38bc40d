//! The centres of a circle pattern, placed face by face.

use std::collections::VecDeque;

use super::CirclePattern;
use crate::mesh::{Data, FaceId, HalfEdge, Mesh, VertexId};
use crate::space::{Point, TopView};

/// The centres of all circles, and how well they close.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The centres of the vertex circles.
    pub vertices: Vec<TopView<f64>>,
    /// The centres of the face circles.
    pub faces: Vec<TopView<f64>>,
    /// The largest distance between two places of one vertex that two faces find for it, as a part
    /// of its radius.
    pub gap: f64,
}

impl CirclePattern<'_> {
    /// Places the circles in the plane: the first edge of the first face of each component begins at
    /// the origin and runs along x; every other face follows from a neighbour. Lines have no centre
    /// and faces beside them are not placed: their coordinates are not numbers.
    pub fn layout(&self) -> Layout {
        let topology = self.topology();
        let nowhere = TopView::new(f64::NAN, f64::NAN);
        let mut layout = Layout {
            vertices: vec![nowhere; topology.vertex_count()],
            faces: vec![nowhere; topology.face_count()],
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
        let mut direction = (touch.y - centre.y).atan2(touch.x - centre.x);
        let mut h = first;
        loop {
            // From the touching point of this edge to the next vertex, and on to the next point.
            let next = topology.next(h);
            let vertex = topology.origin(next);
            let own = self.vertex_radii[vertex.index()];
            if !own.is_finite() {
                break;
            }
            let half = (own / radius).atan();
            direction += half;
            let distance = own.hypot(radius);
            let (sine, cosine) = direction.sin_cos();
            let place = TopView::new(centre.x + distance * cosine, centre.y + distance * sine);
            if placed[vertex.index()] {
                let gap = (&place - &layout.vertices[vertex.index()]).length2().sqrt() / own;
                layout.gap = layout.gap.max(gap);
            } else {
                (layout.vertices[vertex.index()], placed[vertex.index()]) = (place, true);
            }
            direction += half;
            h = next;
            if h == first {
                break;
            }
        }
    }

    /// The i-Koebe mesh over a layout: the vertices are the poles of the planes of their circles,
    /// `z = (|x'|² − r²)/2`, with the radii as data `radius`.
    pub fn lifted(&self, layout: &Layout) -> Mesh<f64> {
        let point = |(centre, r): (&TopView<f64>, &f64)| {
            Point::new(centre.x, centre.y, (centre.norm2() - r * r) / 2.0)
        };
        let points = layout.vertices.iter().zip(&self.vertex_radii).map(point).collect();
        let mut data = Data::default();
        data.vertex.insert("radius".into(), self.vertex_radii.clone());
        Mesh { topology: self.topology().clone(), points, data }
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
