//! Vertices that stay on a curve.

use super::condition::Conditions;
use crate::mesh::VertexId;
use crate::space::{Point, Vector3};

/// Vertices that shall lie on the closed polygons that they form at the start: each has two conditions,
/// its distances from the line of the nearest side in two directions at right angles to it.
///
/// The side is looked for wherever the vertex goes, so a vertex may pass by the place of another one.
/// Polygons in which all vertices coincide are left out.
pub struct OnCurve {
    sides: Vec<Vec<Side>>,
    /// The vertices with their polygons.
    places: Vec<(VertexId, u32)>,
}

struct Side {
    from: Point<f64>,
    to: Point<f64>,
    normals: [Vector3<f64>; 2],
}

impl OnCurve {
    /// The polygons of some closed lines of vertices.
    pub fn new(lines: &[Vec<VertexId>], points: &[Point<f64>]) -> Self {
        let (mut sides, mut places) = (Vec::new(), Vec::new());
        for line in lines {
            let ends = line.iter().zip(line.iter().cycle().skip(1));
            let ends = ends.map(|(a, b)| [a, b].map(|v| points[v.index()]));
            let polygon: Vec<Side> = ends.filter_map(|[a, b]| Side::new(a, b)).collect();
            if !polygon.is_empty() {
                places.extend(line.iter().map(|v| (*v, sides.len() as u32)));
                sides.push(polygon);
            }
        }
        OnCurve { sides, places }
    }

    /// The side that is nearest to a vertex.
    fn nearest(&self, condition: usize, points: &[Point<f64>]) -> Option<&Side> {
        let (v, polygon) = self.places[condition / 2];
        let distance = |side: &&Side| side.distance2(&points[v.index()]);
        let sides = self.sides[polygon as usize].iter();
        sides.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

impl Side {
    /// `None` for a side without length.
    fn new(from: Point<f64>, to: Point<f64>) -> Option<Self> {
        let along = unit(&(&to - &from))?;
        let sizes = [along.x.abs(), along.y.abs(), along.z.abs()];
        let axis = (0..3).min_by(|&i, &j| sizes[i].total_cmp(&sizes[j]))?;
        let at = |i| if i == axis { 1.0 } else { 0.0 };
        let first = unit(&along.cross(&Vector3::new(at(0), at(1), at(2))))?;
        let second = along.cross(&first);
        Some(Side { from, to, normals: [first, second] })
    }

    /// The square of the distance of a point from the side.
    fn distance2(&self, p: &Point<f64>) -> f64 {
        let (along, seen) = (&self.to - &self.from, p - &self.from);
        let part = (along.dot(&seen) / along.length2()).clamp(0.0, 1.0);
        (&seen - &along.scaled(&part)).length2()
    }
}

fn unit(v: &Vector3<f64>) -> Option<Vector3<f64>> {
    let length = v.length2().sqrt();
    (length > 0.0 && length.is_finite()).then(|| v.scaled(&(1.0 / length)))
}

impl Conditions for OnCurve {
    fn name(&self) -> &'static str {
        "on the curve"
    }

    fn len(&self) -> usize {
        2 * self.places.len()
    }

    fn points(&self, condition: usize) -> &[VertexId] {
        std::slice::from_ref(&self.places[condition / 2].0)
    }

    fn value(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let seen = |side: &Side| &points[self.places[condition / 2].0.index()] - &side.from;
        let side = self.nearest(condition, points);
        side.map_or(0.0, |side| seen(side).dot(&side.normals[condition % 2]))
    }

    fn scale(&self, condition: usize, points: &[Point<f64>]) -> f64 {
        let size = |p: &Point<f64>| p.coordinates().map(|c| c.abs()).iter().sum::<f64>();
        let p = &points[self.places[condition / 2].0.index()];
        self.nearest(condition, points).map_or(0.0, |side| size(p) + size(&side.from))
    }

    fn linearise(
        &self,
        condition: usize,
        points: &[Point<f64>],
        gradient: &mut [Vector3<f64>],
    ) -> f64 {
        if let Some(side) = self.nearest(condition, points) {
            gradient[0] = side.normals[condition % 2];
        }
        self.value(condition, points)
    }
}
