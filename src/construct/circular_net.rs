//! i-circular nets with the combinatorics of the square grid, from Cauchy data.

use super::quad_patch;
use crate::mesh::{Mesh, TopologyError};
use crate::scalar::Field;
use crate::space::{Point, Vector2};

/// The i-circular net with two given polygons and one free ratio for every face.
///
/// `rows[0]` and `columns[0]` are the common corner. In each face with known vertices `a`, `b`
/// (along the rows) and `c` (along the columns) the fourth lies on the circle through their top
/// views: it is `a + x*/|x*|²` with `x* = (1 − λ) b* + λ c*`, where `b*`, `c*` are the inverses of
/// `b − a`, `c − a`; its height is that of their plane. For `0 < λ < 1` the order on the circle is
/// convex. All i-circular nets over ℤ² arise so, and all is rational in the data.
///
/// `ratio(i, j)` is λ of the face in row `i` and column `j`.
///
/// Returns `None` where the construction meets a degenerate face: two of the known vertices with
/// the same top view, three with collinear top views, or a fourth at infinity. Numbers of digits
/// grow exponentially along the diagonal: small nets only.
pub fn circular_net<T: Field>(
    rows: &[Point<T>],
    columns: &[Point<T>],
    ratio: impl Fn(usize, usize) -> T,
) -> Option<Result<Mesh<T>, TopologyError>> {
    let width = columns.len();
    let mut points: Vec<Point<T>> = columns.to_vec();
    for (i, start) in rows.iter().enumerate().skip(1) {
        points.push(start.clone());
        for j in 1..width {
            let (a, b, c) = (
                &points[(i - 1) * width + j - 1],
                &points[i * width + j - 1],
                &points[(i - 1) * width + j],
            );
            let fourth = fourth_vertex(a, b, c, &ratio(i - 1, j - 1))?;
            points.push(fourth);
        }
    }
    Some(Mesh::new(points, quad_patch(rows.len().saturating_sub(1), width.saturating_sub(1))))
}

fn fourth_vertex<T: Field>(
    a: &Point<T>,
    b: &Point<T>,
    c: &Point<T>,
    ratio: &T,
) -> Option<Point<T>> {
    let (u, v) = (b - a, c - a);
    let (u2, v2) = (u.top_view(), v.top_view());
    let (b_star, c_star) = (inverse(&u2)?, inverse(&v2)?);
    let mix = |p: &T, q: &T| (T::one() - ratio) * p + ratio * q;
    let x = inverse(&Vector2 { x: mix(&b_star.x, &c_star.x), y: mix(&b_star.y, &c_star.y) })?;
    // x = α u + β v in the top view, hence in space.
    let area = u2.det(&v2).try_inv()?;
    let (alpha, beta) = (x.det(&v2) * &area, u2.det(&x) * &area);
    let z = alpha * &u.z + beta * &v.z;
    Some(Point::new(&a.x + &x.x, &a.y + &x.y, &a.z + z))
}

/// The image `v / |v|²` under the inversion at the unit circle.
fn inverse<T: Field>(v: &Vector2<T>) -> Option<Vector2<T>> {
    let factor = v.length2().try_inv()?;
    Some(Vector2 { x: &v.x * &factor, y: &v.y * &factor })
}
