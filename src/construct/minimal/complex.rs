//! The arithmetic of complex numbers, as far as discrete holomorphic functions need it.

use crate::scalar::{Field, Ring};
use crate::space::Vector2;

/// `a b`.
pub(super) fn product<T: Ring>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(T::det2(&a.x, &a.y, &b.y, &b.x), T::dot([&a.x, &a.y], [&b.y, &b.x]))
}

/// `t / conj(a)`, which is `t a / |a|²`; `None` for 0.
pub(super) fn over_conjugate<T: Field>(t: &T, a: &Vector2<T>) -> Option<Vector2<T>> {
    Some(a.scaled(&t.try_div(&a.length2())?))
}

/// `a / b`; `None` for `b = 0`.
pub(super) fn quotient<T: Field>(a: &Vector2<T>, b: &Vector2<T>) -> Option<Vector2<T>> {
    let conjugate = Vector2::new(b.x.clone(), -&b.y);
    Some(product(a, &conjugate).scaled(&b.length2().try_inv()?))
}

/// `a − b`.
pub(super) fn difference<T: Ring>(a: &Vector2<T>, b: &Vector2<T>) -> Vector2<T> {
    Vector2::new(&a.x - &b.x, &a.y - &b.y)
}
