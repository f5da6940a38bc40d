//! Signed area (15) and mixed area (16) of polygons in a plane: of top views, or of gradients.
//!
//! `area(F) = ½ Σ det(v_j, v_{j+1})` is a quadratic form on polygons with k corners, and
//! `area(F, S) = ¼ Σ [det(v_j, s_{j+1}) + det(s_j, v_{j+1})]` is its polar form: bilinear,
//! symmetric, `area(F, F) = area(F)`, and
//!
//! ```math
//! area(F + dS) = area(F) + 2d area(F, S) + d² area(S).
//! ```
//!
//! Both stay if either polygon is translated. Nothing is assumed of the polygons: they may be
//! crossed, degenerate or turned over, and need not be parallel.

use crate::scalar::Ring;
use crate::space::{Gradient, TopView, Vector2};

/// A corner of a plane polygon: a top view or a gradient; the two do not mix.
pub trait Corner<T> {
    /// The vector to this corner from another one.
    fn seen_from(&self, origin: &Self) -> Vector2<T>;
}

impl<T: Ring> Corner<T> for TopView<T> {
    fn seen_from(&self, origin: &Self) -> Vector2<T> {
        self - origin
    }
}

impl<T: Ring> Corner<T> for Gradient<T> {
    fn seen_from(&self, origin: &Self) -> Vector2<T> {
        self - origin
    }
}

/// `2 area(F)` of a polygon of top views or of gradients; positive if counter-clockwise (15).
///
/// ```
/// use isogeo::pair::twice_area;
/// use isogeo::space::TopView;
/// let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| TopView::new(x, y));
/// assert_eq!(twice_area(&square), 2.0);
/// ```
///
/// A bow-tie has the difference of the areas of its loops; fewer than three corners give 0.
pub fn twice_area<T: Ring, P: Corner<T>>(polygon: &[P]) -> T {
    let mut corners = from_the_first(polygon);
    let Some(mut last) = corners.next() else {
        return T::zero();
    };
    corners.fold(T::zero(), |sum, corner| {
        let sum = sum + last.det(&corner);
        last = corner;
        sum
    })
}

/// `4 area(F, S)` of two polygons with the same number of corners (16).
///
/// ```
/// use isogeo::pair::{four_mixed_areas, twice_area};
/// use isogeo::space::TopView;
/// let at = |list: [(f64, f64); 3]| list.map(|(x, y)| TopView::new(x, y));
/// let (f, s) = (at([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), at([(0.0, 0.0), (3.0, 0.0), (0.0, 3.0)]));
/// assert_eq!(four_mixed_areas(&f, &s), 6.0); // S = 3F: area(F, S) = 3 area(F) = 3/2
/// assert_eq!(four_mixed_areas(&f, &f), 2.0 * twice_area(&f));
/// ```
///
/// Corners that the other polygon does not have are not looked at.
pub fn four_mixed_areas<T: Ring, P: Corner<T>>(f: &[P], s: &[P]) -> T {
    let mut corners = from_the_first(f).zip(from_the_first(s));
    let Some((mut v, mut w)) = corners.next() else {
        return T::zero();
    };
    corners.fold(T::zero(), |sum, (next_v, next_w)| {
        let sum = sum + v.det(&next_w) + w.det(&next_v);
        (v, w) = (next_v, next_w);
        sum
    })
}

/// The corners after the first, seen from the first: the terms with the first itself vanish.
fn from_the_first<T, P: Corner<T>>(polygon: &[P]) -> impl Iterator<Item = Vector2<T>> {
    let (first, rest) = match polygon.split_first() {
        Some((first, rest)) => (Some(first), rest),
        None => (None, polygon),
    };
    rest.iter().filter_map(move |corner| first.map(|first| corner.seen_from(first)))
}
