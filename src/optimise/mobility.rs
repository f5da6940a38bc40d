//! How a vertex may move.

use crate::space::{Point, Vector3};

/// The directions in which a point may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mobility {
    /// Everywhere.
    Free,
    /// Nowhere.
    Fixed,
    /// Up and down: the top view is kept.
    Vertical,
    /// Horizontally: the height is kept.
    Horizontal,
    /// Along a line, by its direction of length 1.
    Along(Vector3<f64>),
}

impl Mobility {
    /// The part of a vector in the directions that are allowed.
    ///
    /// ```
    /// use isogeo::optimise::Mobility;
    /// use isogeo::space::Vector3;
    /// let v = Vector3::new(1.0, 2.0, 3.0);
    /// assert_eq!(Mobility::Vertical.part(&v), Vector3::new(0.0, 0.0, 3.0));
    /// assert_eq!(Mobility::Along(Vector3::new(0.6, 0.8, 0.0)).part(&v), Vector3::new(1.32, 1.76, 0.0));
    /// ```
    #[inline]
    pub fn part(&self, v: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Mobility::Free => *v,
            Mobility::Fixed => Vector3::new(0.0, 0.0, 0.0),
            Mobility::Vertical => Vector3::new(0.0, 0.0, v.z),
            Mobility::Horizontal => Vector3::new(v.x, v.y, 0.0),
            Mobility::Along(d) => {
                let length = d.dot(v);
                Vector3::new(d.x * length, d.y * length, d.z * length)
            }
        }
    }

    /// Along the line from one point to another; fixed if they are the same.
    pub fn along(from: &Point<f64>, to: &Point<f64>) -> Mobility {
        let d = to - from;
        let length = d.length2().sqrt();
        if length > 0.0 {
            Mobility::Along(Vector3::new(d.x / length, d.y / length, d.z / length))
        } else {
            Mobility::Fixed
        }
    }
}
