//! Subdivision of meshes: Catmull-Clark on points, and the same on face planes.
//!
//! Both are rational, so that they run over every field; neither keeps planarity, circles or cones: a
//! subdivided mesh is where an optimisation starts from.

mod catmull_clark;
mod planes;

pub use catmull_clark::{NoSubdivision, Sharp, catmull_clark};
pub use planes::{NoPlaneSubdivision, subdivide_planes};

use crate::scalar::Field;
use crate::space::Point;

/// `Σ wᵢ Pᵢ / weight` for integer weights `wᵢ`, which add up to `weight` and are not all 0.
fn mix<'a, T: Field>(
    weight: i64,
    terms: impl IntoIterator<Item = (i64, &'a Point<T>)>,
) -> Point<T> {
    let mut sum = [T::zero(), T::zero(), T::zero()];
    for (weight, point) in terms {
        let weight = T::from_i64(weight);
        for (sum, c) in sum.iter_mut().zip(point.coordinates()) {
            *sum += &(c * &weight);
        }
    }
    let scale = T::from_ratio(1, weight);
    let [x, y, z] = sum.map(|c| c * &scale);
    Point { x, y, z }
}

/// The sum of the points with the weights of a cubic B-spline at its knots, `(a + 6v + b)/8`.
fn spline<T: Field>(a: &Point<T>, v: &Point<T>, b: &Point<T>) -> Point<T> {
    mix(8, [(1, a), (6, v), (1, b)])
}
