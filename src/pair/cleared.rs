//! Pairs of polygons cleared of denominators, axis by axis.

use crate::scalar::{Rational, RationalField, Ring};
use crate::space::{Point, TopView};

/// Two polygons with integer coordinates: x over one common denominator, y over another.
///
/// Areas and mixed areas are bilinear in x and y, so they are all over the product of both, and
/// their quotients are those of the polygons themselves.
pub(super) struct Cleared<R> {
    pub f: Vec<TopView<R>>,
    pub s: Vec<TopView<R>>,
    /// The product of the common denominators of x and of y.
    pub scale: R,
}

/// Clears the denominators of the top views of two polygons; `None` where a numerator or a
/// denominator needs more than 64 bits.
pub(super) fn cleared<'q, R: Ring>(
    f: impl ExactSizeIterator<Item = &'q Point<Rational>>,
    s: impl Iterator<Item = &'q Point<Rational>>,
) -> Option<Cleared<R>> {
    let count = f.len();
    let (mut x, mut y) = (Vec::with_capacity(2 * count), Vec::with_capacity(2 * count));
    for corner in f.chain(s) {
        x.push(corner.x.small_fraction()?);
        y.push(corner.y.small_fraction()?);
    }
    let ((x, unit_x), (y, unit_y)) = (over_product(&x), over_product(&y));
    let mut corners: Vec<_> = x.into_iter().zip(y).map(|(x, y)| TopView::new(x, y)).collect();
    let s = corners.split_off(count);
    Some(Cleared { f: corners, s, scale: unit_x * unit_y })
}

/// The numerators over the product of the different denominators.
fn over_product<R: Ring>(fractions: &[(i64, i64)]) -> (Vec<R>, R) {
    let mut different: Vec<i64> = Vec::with_capacity(fractions.len());
    for &(_, q) in fractions {
        if q != 1 && !different.contains(&q) {
            different.push(q);
        }
    }
    let count = different.len();
    // after[i] = the product of those from i on.
    let mut after = vec![R::one(); count + 1];
    for i in (0..count).rev() {
        after[i] = &after[i + 1] * R::from_i64(different[i]);
    }
    let mut cofactors = Vec::with_capacity(count);
    let mut before = R::one();
    for i in 0..count {
        cofactors.push(&before * &after[i + 1]);
        before = before * R::from_i64(different[i]);
    }
    let numerator = |&(p, q): &(i64, i64)| {
        let cofactor = different.iter().position(|&d| d == q).map_or(&after[0], |i| &cofactors[i]);
        R::from_i64(p) * cofactor
    };
    (fractions.iter().map(numerator).collect(), after[0].clone())
}
