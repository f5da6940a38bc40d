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
    /// assert_eq!(Mobility::Along(Vector3::new(0.0, 1.0, 0.0)).part(&v), Vector3::new(0.0, 2.0, 0.0));
    /// ```
    #[inline]
    pub fn part(&self, v: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Mobility::Free => *v,
            Mobility::Fixed => Vector3::new(0.0, 0.0, 0.0),
            Mobility::Vertical => Vector3::new(0.0, 0.0, v.z),
            Mobility::Horizontal => Vector3::new(v.x, v.y, 0.0),
            Mobility::Along(d) => d.scaled(&d.dot(v)),
        }
    }

    /// What is left of it in the top view.
    pub fn in_top_view(&self) -> Mobility {
        match self {
            Mobility::Free | Mobility::Horizontal => Mobility::Horizontal,
            Mobility::Fixed | Mobility::Vertical => Mobility::Fixed,
            Mobility::Along(d) => {
                Mobility::along(&Point::new(0.0, 0.0, 0.0), &Point::new(d.x, d.y, 0.0))
            }
        }
    }

    /// The same without a line to move along.
    pub fn off_line(&self) -> Mobility {
        match self {
            Mobility::Along(_) => Mobility::Free,
            other => *other,
        }
    }

    /// What is left of it over a given top view.
    pub fn in_height(&self) -> Mobility {
        match self {
            Mobility::Free | Mobility::Vertical => Mobility::Vertical,
            Mobility::Fixed | Mobility::Horizontal | Mobility::Along(_) => Mobility::Fixed,
        }
    }

    /// The part of the unit vector of an axis in the directions that are not allowed.
    pub(super) fn kept(&self, axis: usize) -> Vector3<f64> {
        let unit = |i| f64::from(u8::from(i == axis));
        let unit = Vector3::new(unit(0), unit(1), unit(2));
        &unit - &self.part(&unit)
    }

    /// Along the line from one point to another; fixed if they are the same.
    pub fn along(from: &Point<f64>, to: &Point<f64>) -> Mobility {
        let d = to - from;
        let length = d.length2().sqrt();
        if length > 0.0 { Mobility::Along(d.scaled(&(1.0 / length))) } else { Mobility::Fixed }
    }
}
