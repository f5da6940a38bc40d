//! A target surface: a mesh as a graph over its top view, and the vertical distance to it.

use std::sync::Arc;

use super::condition::Conditions;
use super::frame::Frame;
use crate::mesh::{Mesh, VertexId};
use crate::space::{Point, TopView, Vector2, Vector3};

/// A mesh as a graph: heights over its top view, by triangles.
///
/// The vertical distance is that of isotropic geometry, and needs no foot point. Beyond its boundary the
/// nearest triangle is continued as a plane.
pub struct Target {
    triangles: Vec<[Point<f64>; 3]>,
    low: TopView<f64>,
    /// The edge of a cell.
    cell: f64,
    cells: [usize; 2],
    /// The triangles whose bounding boxes meet each cell.
    inside: Vec<Vec<u32>>,
}

impl Target {
    /// The graph of a mesh; faces that are vertical or have no area are left out. `None` if all are.
    pub fn new(mesh: &Mesh<f64>) -> Option<Self> {
        let mut triangles = Vec::new();
        for face in mesh.topology.faces() {
            let corners = mesh.topology.face(face);
            let fan = corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]]);
            triangles.extend(fan.map(|at| at.map(|v| mesh.points[v.index()])));
        }
        triangles.retain(|t| twice_area(t) != 0.0 && twice_area(t).is_finite());
        let all = || triangles.iter().flatten();
        let low = |f: fn(&Point<f64>) -> f64| all().map(f).fold(f64::INFINITY, f64::min);
        let high = |f: fn(&Point<f64>) -> f64| all().map(f).fold(f64::NEG_INFINITY, f64::max);
        let corner = TopView::new(low(|p| p.x), low(|p| p.y));
        let size = [high(|p| p.x) - corner.x, high(|p| p.y) - corner.y];
        if triangles.is_empty() {
            return None;
        }
        // About one triangle in a cell.
        let cell = (size[0] * size[1] / triangles.len() as f64).sqrt();
        let count = |size: f64| ((size / cell).ceil() as usize).clamp(1, triangles.len());
        let cells = size.map(count);
        let mut target = Target {
            triangles,
            low: corner,
            cell,
            cells,
            inside: vec![Vec::new(); cells[0] * cells[1]],
        };
        for (i, triangle) in (0..).zip(&target.triangles) {
            let [from, to] = [f64::min, f64::max].map(|choose| {
                let reach = |f: fn(&Point<f64>) -> f64| {
                    triangle.iter().map(f).reduce(choose).unwrap_or(0.0)
                };
                target.cell_of(&TopView::new(reach(|p| p.x), reach(|p| p.y)))
            });
            for y in from[1]..=to[1] {
                for x in from[0]..=to[0] {
                    target.inside[y * cells[0] + x].push(i);
                }
            }
        }
        Some(target)
    }

    fn cell_of(&self, at: &TopView<f64>) -> [usize; 2] {
        let number = |x: f64, count: usize| ((x / self.cell) as usize).min(count - 1);
        [number(at.x - self.low.x, self.cells[0]), number(at.y - self.low.y, self.cells[1])]
    }

    /// The height over a top view and its derivatives.
    pub fn height(&self, at: &TopView<f64>) -> (f64, Vector2<f64>) {
        let [x, y] = self.cell_of(at);
        let mut nearest: Option<(f64, u32)> = None;
        // Rings of cells about the own one; a triangle that is found may be beaten from the next ring.
        let mut rings_left = usize::MAX;
        for ring in 0..self.cells[0].max(self.cells[1]) {
            if rings_left == 0 {
                break;
            }
            rings_left -= 1;
            let span = |c: usize, count: usize| c.saturating_sub(ring)..=(c + ring).min(count - 1);
            for v in span(y, self.cells[1]) {
                for u in span(x, self.cells[0]) {
                    if u.abs_diff(x).max(v.abs_diff(y)) != ring {
                        continue;
                    }
                    for &i in &self.inside[v * self.cells[0] + u] {
                        let outside = self.outside(i, at);
                        if nearest.is_none_or(|(least, _)| outside < least) {
                            nearest = Some((outside, i));
                        }
                    }
                }
            }
            match nearest {
                Some((0.0, _)) => break,
                Some(_) if rings_left > 1 => rings_left = 1,
                _ => {}
            }
        }
        let triangle = nearest.map_or(0, |(_, i)| i as usize);
        let [a, b, c] = &self.triangles[triangle];
        let (u, v) = (b - a, c - a);
        let normal = u.cross(&v);
        let slope = Vector2 { x: -normal.x / normal.z, y: -normal.y / normal.z };
        let from = at - &a.top_view();
        (a.z + slope.dot(&from), slope)
    }

    /// How far a top view lies outside of a triangle: the squared distance, 0 inside.
    fn outside(&self, triangle: u32, at: &TopView<f64>) -> f64 {
        let t = &self.triangles[triangle as usize];
        let turn = twice_area(t).signum();
        let mut least = f64::INFINITY;
        let mut inside = true;
        for i in 0..3 {
            let (a, b) = (t[i].top_view(), t[(i + 1) % 3].top_view());
            let (edge, to) = (&b - &a, at - &a);
            inside &= turn * edge.det(&to) >= 0.0;
            let along = (edge.dot(&to) / edge.length2()).clamp(0.0, 1.0);
            let foot = &a + &edge.scaled(&along);
            least = least.min(at.distance2(&foot));
        }
        if inside { 0.0 } else { least }
    }
}

fn twice_area(triangle: &[Point<f64>; 3]) -> f64 {
    let [a, b, c] = triangle.each_ref().map(Point::top_view);
    (&b - &a).det(&(&c - &a))
}

/// The vertical distance of vertices to a target.
pub struct VerticalDistance {
    target: Arc<Target>,
    /// The frame of the vertices; the target has the coordinates of the mesh.
    frame: Frame,
    places: Vec<VertexId>,
}

impl VerticalDistance {
    /// The distance of the first `count` vertices, whose coordinates are those of a frame.
    pub fn new(target: Arc<Target>, frame: Frame, count: usize) -> Self {
        VerticalDistance { target, frame, places: (0..count as u32).map(VertexId).collect() }
    }
}

impl VerticalDistance {
    /// The height over the target, in the frame, and the slope of the target.
    fn over(&self, p: &Point<f64>) -> (f64, Vector2<f64>) {
        let (height, slope) = self.target.height(&self.frame.top_view(&p.top_view()));
        (p.z - (height - self.frame.middle.z) / self.frame.unit, slope)
    }
}

impl Conditions for VerticalDistance {
    fn name(&self) -> &'static str {
        "vertical distance"
    }

    fn len(&self) -> usize {
        self.places.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        std::slice::from_ref(&self.places[condition])
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        self.over(&points[condition]).0
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let p = &points[condition];
        p.z.abs() + (p.z - self.over(p).0).abs()
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        let (distance, slope) = self.over(&points[condition]);
        gradient[0] = Vector3::new(-slope.x, -slope.y, 1.0);
        distance
    }
}
