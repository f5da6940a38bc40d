//! The frame in which is computed: the middle of a mesh, and a unit of its size.

use crate::space::{Point, TopView, Vector3};

/// An origin and a unit of length, a power of two, so that nothing is rounded by it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The middle of the bounding box.
    pub middle: Vector3<f64>,
    /// The unit: coordinates of the mesh lie within 1 of its middle, and not all within 1/4.
    pub unit: f64,
}

impl Frame {
    /// The frame of some points; without points, or if all are the same, the unit is that of the numbers.
    pub fn of(points: &[Point<f64>]) -> Frame {
        let reach = |f: fn(&Point<f64>) -> f64| {
            let ends = (f64::INFINITY, f64::NEG_INFINITY);
            let (low, high) = points.iter().map(f).fold(ends, |(l, h), x| (l.min(x), h.max(x)));
            if low <= high { (0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low) } else { (0.0, 0.0) }
        };
        let [x, y, z] = [reach(|p| p.x), reach(|p| p.y), reach(|p| p.z)];
        let size = x.1.max(y.1).max(z.1);
        // Of the powers of two whose inverses are doubles, too.
        let exponent =
            if size > 0.0 { size.log2().ceil().clamp(-1000.0, 1000.0) as i32 } else { 0 };
        Frame { middle: Vector3::new(x.0, y.0, z.0), unit: 2f64.powi(exponent) }
    }

    /// A point of the mesh in the frame.
    pub fn inside(&self, p: &Point<f64>) -> Point<f64> {
        let inverse = 1.0 / self.unit;
        let part = |c: f64, middle: f64| (c - middle) * inverse;
        Point::new(part(p.x, self.middle.x), part(p.y, self.middle.y), part(p.z, self.middle.z))
    }

    /// The point of the mesh of a point in the frame.
    pub fn outside(&self, p: &Point<f64>) -> Point<f64> {
        &p.map(|c| c * self.unit) + &self.middle
    }

    /// The same for top views.
    pub fn top_view(&self, p: &TopView<f64>) -> TopView<f64> {
        TopView::new(p.x * self.unit + self.middle.x, p.y * self.unit + self.middle.y)
    }
}
