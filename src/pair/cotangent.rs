//! Cotangent weights: what the lift of a triangle mesh to Σ weighs its edges with.
//!
//! The gradient of the lift of a triangle is the centre of its circumcircle. Two neighbouring
//! centres lie on the bisector of the common edge, at signed distances `½ cot α` and `½ cot β` times
//! its length, α and β being the angles opposite to it. So the weight of an edge in the lift is
//!
//! ```math
//! w = ½ (cot α + cot β),   2 D(v, s) = Σ ½ (cot α_j + cot β_j) (f_j − f_v).
//! ```
//!
//! This is an equality for every star without vertical faces, obtuse and non-Delaunay ones
//! included; cotangents are rational in the coordinates. `D(s)` is the signed circumcentric area:
//! clamping it to something positive would break the equality.

use crate::mesh::{HalfEdge, Mesh};
use crate::scalar::Field;
use crate::space::TopView;

/// The cotangent of the angle at `apex` from `a` to `b`; negative for an obtuse angle, and of the
/// opposite sign if the triangle runs clockwise.
///
/// ```
/// use isogeo::pair::cotangent;
/// use isogeo::space::TopView;
/// let [apex, a, b] = [(0.0, 0.0), (1.0, 0.0), (2.0, 2.0)].map(|(x, y)| TopView::new(x, y));
/// assert_eq!(cotangent(&apex, &a, &b), Some(1.0)); // 45 degrees
/// assert_eq!(cotangent(&apex, &b, &a), Some(-1.0));
/// ```
///
/// `None` for three points on a line.
pub fn cotangent<T: Field>(apex: &TopView<T>, a: &TopView<T>, b: &TopView<T>) -> Option<T> {
    let (u, v) = (a - apex, b - apex);
    u.dot(&v).try_div(&u.det(&v))
}

/// `½ (cot α + cot β)` of an edge between two triangles, with the angles opposite to it in the top
/// view; zero iff the four vertices lie on a circle.
///
/// `None` at the boundary, where a face is no triangle, and where one is collinear in the top view.
pub fn cotangent_weight<T: Field>(mesh: &Mesh<T>, edge: HalfEdge) -> Option<T> {
    let topology = &mesh.topology;
    let opposite = |h: HalfEdge| {
        let apex = topology.next(topology.next(h));
        if topology.next(apex) != h {
            return None;
        }
        let [apex, a, b] =
            [apex, h, topology.next(h)].map(|h| mesh.points[topology.origin(h).index()].top_view());
        cotangent(&apex, &a, &b)
    };
    Some((opposite(edge)? + opposite(topology.twin(edge)?)?) * T::from_ratio(1, 2))
}
