//! The discrete power map z^γ: an i-Koebe mesh with a given angle at its corner (Sec. 3.4).

use super::quad_patch;
use crate::mesh::{Data, Mesh, TopologyError};
use crate::scalar::Field;
use crate::space::{Point, TopView, Vector2};

/// The i-Koebe mesh of `n × n` faces over the circle pattern of z^γ in a quadrant; `corner` is
/// `e^{iγπ/2}`, a unit vector. `Ok(None)` where the recursion divides by 0.
///
/// The map f on the lattice has the cross-ratio −1 on every square, `f(0) = 0`, `f(1) = 1`,
/// `f(i) = corner`, and on the axes (Agafonov and Bobenko, *Discrete z^γ and Painlevé equations*,
/// 2000)
///
/// ```math
/// γ f_k = 2k (f_{k+1} − f_k)(f_k − f_{k−1}) / (f_{k+1} − f_{k−1}).
/// ```
///
/// Points with two even coordinates are the centres of the vertex circles, those with two odd ones
/// the centres of the face circles, and the others are where circles touch. Row `i` runs along the
/// first axis. Every unit vector for `corner` gives an i-Koebe mesh; for `e^{iγπ/2}` its circles are
/// those of z^γ, without overlaps for 0 < γ < 2. The field has to contain it: ℚ(√2) for γ = 1/2,
/// ℚ(√3) for 2/3 and 4/3; γ = 1 is the square grid. In `f64` errors grow away from the axes.
///
/// ```
/// use isogeo::construct::discrete_power;
/// use isogeo::scalar::{Field, Rational, Ring};
/// let q = |n| Rational::from_i64(n);
/// let grid = discrete_power(&q(1), (&q(0), &q(1)), 2)?.expect("no division by 0");
/// assert_eq!((&grid.points[4].x, &grid.points[4].y), (&q(2), &q(2)));
/// assert_eq!(grid.points[4].z, Rational::from_ratio(7, 2)); // (|x'|² − r²)/2 with r = 1
/// # Ok::<(), isogeo::mesh::TopologyError>(())
/// ```
///
/// # Errors
/// A mesh that is too large.
pub fn discrete_power<T: Field>(
    gamma: &T,
    corner: (&T, &T),
    n: usize,
) -> Result<Option<Mesh<T>>, TopologyError> {
    let side = 2 * n + 2;
    let Some(f) = lattice(gamma, corner, side) else { return Ok(None) };
    let at = |i: usize, j: usize| &f[i * side + j];
    let half = T::from_ratio(1, 2);
    let mut points = Vec::with_capacity((n + 1) * (n + 1));
    for i in 0..=n {
        for j in 0..=n {
            let centre = at(2 * i, 2 * j);
            let radius2 = (at(2 * i + 1, 2 * j) - centre).length2();
            let height = (centre.norm2() - radius2) * &half;
            points.push(Point::new(centre.x.clone(), centre.y.clone(), height));
        }
    }
    let topology = crate::mesh::Topology::new(points.len(), quad_patch(n, n))?;
    Ok(Some(Mesh { topology, points, data: Data::default() }))
}

/// The values of f at the points `(i, j)`, `0 ≤ i, j < side`, row by row.
fn lattice<T: Field>(gamma: &T, (c, s): (&T, &T), side: usize) -> Option<Vec<TopView<T>>> {
    // On the first axis f is real; on the second it is the same, turned.
    let mut axis = vec![T::zero(), T::one()];
    for k in 1..side.saturating_sub(1) {
        let (before, own) = (&axis[k - 1], &axis[k]);
        let twice = T::from_i64(2 * k as i64) * (own - before);
        let denominator = gamma * own - &twice;
        let next = own * (gamma * before - twice).try_div(&denominator)?;
        axis.push(next);
    }
    let mut f: Vec<TopView<T>> = Vec::with_capacity(side * side);
    for (i, x) in axis.iter().enumerate() {
        f.push(TopView::new(x.clone(), T::zero()));
        for (j, y) in axis.iter().enumerate().skip(1) {
            let value = if i == 0 {
                TopView::new(c * y, s * y)
            } else {
                let from = |i: usize, j: usize| &f[i * side + j];
                fourth(from(i - 1, j - 1), from(i, j - 1), from(i - 1, j))?
            };
            f.push(value);
        }
    }
    Some(f)
}

/// The point d with the cross-ratio `(a − b)(d − c) / ((b − d)(c − a)) = −1`: from a it lies at
/// `2uv/(u + v)` for complex `u = b − a` and `v = c − a`.
fn fourth<T: Field>(a: &TopView<T>, b: &TopView<T>, c: &TopView<T>) -> Option<TopView<T>> {
    let (u, v) = (b - a, c - a);
    let product = times(&u, &v);
    let sum = &u + &v;
    let inverse = sum.length2().try_inv()?;
    let conjugate = Vector2::new(sum.x, -sum.y);
    Some(a + &times(&product, &conjugate).scaled(&(inverse * T::from_i64(2))))
}

/// The product of complex numbers.
fn times<T: Field>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(&a.x * &b.x - &a.y * &b.y, &a.x * &b.y + &a.y * &b.x)
}
