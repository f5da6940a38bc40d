//! The forms of a vertex from its neighbours alone, without a division.
//!
//! With the edges `e_j` of a star in the top view, `d_j = det(e_j, e_{j+1})`, and the volumes
//! `V_j = det(e_{j−1}, e_j, e_{j+1})` of the edges in space, the weight of an edge is
//! `w_j = V_j / (d_{j−1} d_j)`. So
//!
//! ```math
//! 2 D(v) = Σ f_j V_j(f) / (d_{j−1} d_j),   2 D(v, s) = Σ g_j V_j(f) / (d_{j−1} d_j),   2 D(s) = Σ g_j V_j(g) / (d_{j−1} d_j)
//! ```
//!
//! with the rises f of M and g of S. Over the common denominator `Π d_j` all are polynomials.

use super::Forms;
use crate::scalar::Ring;
use crate::space::Vector2;

/// An edge leaving a vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray<R> {
    /// Its top view.
    pub edge: Vector2<R>,
    /// How far it rises in M and in S.
    pub rise: [R; 2],
}

/// `4 D(v)`, `4 D(v, s)`, `4 D(s)` of an interior vertex, times the product that is returned with
/// them (21).
///
/// The rays are the edges in counter-clockwise order; faces may have any number of corners. If the
/// heights of M are integers over m and those of S over s, the forms are to be divided by `m²`,
/// `ms`, `s²`; the unit of the top view is that of `1/D`, squared.
///
/// `None` if two consecutive rays are collinear in the top view: then they do not span the plane of
/// their face. Fewer than three rays are no star.
///
/// ```
/// use isogeo::pair::{Forms, Ray, star_forms};
/// use isogeo::space::Vector2;
/// // A pyramid of height 3 over the square (±1, 0), (0, ±1), and one of height 1.
/// let ring = [(1, 0), (0, 1), (-1, 0), (0, -1)];
/// let rays = ring.map(|(x, y)| Ray { edge: Vector2::new(x as f64, y as f64), rise: [3.0, 1.0] });
/// let forms = Forms { first: 144.0, mixed: 48.0, second: 16.0 };
/// assert_eq!(star_forms(&rays), Some((forms, 1.0)));
/// ```
pub fn star_forms<R: Ring>(rays: &[Ray<R>]) -> Option<(Forms<R>, R)> {
    star_forms_widened(rays, R::clone)
}

/// The same, where the numbers become larger on the way: sines and volumes of the rays are
/// computed in N, the products of many in R.
pub(super) fn star_forms_widened<N: Ring, R: Ring>(
    rays: &[Ray<N>],
    widen: impl Fn(&N) -> R,
) -> Option<(Forms<R>, R)> {
    let n = rays.len();
    if n < 3 {
        return None;
    }
    let around = |j: usize| &rays[if j < n { j } else { j - n }];
    let narrow: Vec<N> = (0..n).map(|j| rays[j].edge.det(&around(j + 1).edge)).collect();
    if narrow.iter().any(N::is_zero) {
        return None;
    }
    let sine: Vec<R> = narrow.iter().map(&widen).collect();
    // after[j] = d_j ⋯ d_{n−1}
    let mut after = vec![R::one(); n + 1];
    after[n - 1] = sine[n - 1].clone();
    for j in (1..n - 1).rev() {
        after[j] = &after[j + 1] * &sine[j];
    }
    // before = d_0 ⋯ d_{j−2}, and the same without d_0
    let mut before = R::one();
    let mut middle = R::one();
    let mut forms = Forms::<R>::zero();
    for j in 1..=n {
        let (a, b, c) = (&rays[j - 1], around(j), around(j + 1));
        let (left, right) = (&narrow[j - 1], &narrow[if j < n { j } else { 0 }]);
        let across = a.edge.det(&c.edge);
        let volume = |i: usize| &a.rise[i] * right - &b.rise[i] * &across + &c.rise[i] * left;
        let [f, g] = [volume(0), volume(1)];
        let others = match j {
            1 => after[2].clone(),
            _ if j == n => middle.clone(),
            _ if j == n - 1 => before.clone(),
            _ => &before * &after[j + 1],
        };
        forms.first += &(widen(&(&b.rise[0] * &f)) * &others);
        forms.mixed += &(widen(&(&b.rise[1] * f)) * &others);
        forms.second += &(widen(&(&b.rise[1] * g)) * others);
        if j < n - 1 {
            before = &before * &sine[j - 1];
        }
        if (2..n).contains(&j) {
            middle = &middle * &sine[j - 1];
        }
    }
    let two = R::from_i64(2);
    let forms =
        Forms { first: forms.first * &two, mixed: forms.mixed * &two, second: forms.second * two };
    Some((forms, &after[1] * &sine[0]))
}
