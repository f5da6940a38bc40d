//! The two traits that generic geometry is written in: [`Ring`] (no division) and [`Field`].
//!
//! A bound `T: Ring` is all a function needs to write `&a * &d - &b * &c`: the operators on
//! references are implied by the trait itself, so no where-clause is ever repeated.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A type-level equality that lets a trait imply bounds on `&Self` (see [`Ring`]).
pub trait Same<T: ?Sized> {
    /// Always `T`.
    type Is: ?Sized;
}
impl<S: ?Sized, T: ?Sized> Same<T> for S {
    type Is = T;
}

/// The ring operators of a reference `&T`; implemented for all that have them.
pub trait RingRef<T>:
    Copy
    + Add<Output = T>
    + Sub<Output = T>
    + Mul<Output = T>
    + Neg<Output = T>
    + Add<T, Output = T>
    + Sub<T, Output = T>
    + Mul<T, Output = T>
{
}
impl<T, R> RingRef<T> for R where
    R: Copy
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Neg<Output = T>
        + Add<T, Output = T>
        + Sub<T, Output = T>
        + Mul<T, Output = T>
{
}

/// Division of references `&a / &b`; implemented for all that have it.
pub trait DivRef<T>: Copy + Div<Output = T> + Div<T, Output = T> {}
impl<T, R> DivRef<T> for R where R: Copy + Div<Output = T> + Div<T, Output = T> {}

/// A commutative ring with 1: what polynomial formulas (residuals, areas, determinants) need.
///
/// The operators take values or references in any mix. The kernels ([`det2`](Ring::det2),
/// [`dot`](Ring::dot), [`square`](Ring::square)) equal their formulas; an instance overrides them
/// where one fused step is cheaper (one reduction of a fraction instead of many).
///
/// ```
/// use isogeo::scalar::Ring;
/// fn twice_area<T: Ring>(a: &[T; 2], b: &[T; 2]) -> T {
///     &a[0] * &b[1] - &a[1] * &b[0]
/// }
/// assert_eq!(twice_area(&[1.0, 0.0], &[0.0, 2.0]), 2.0); // counter-clockwise is positive
/// ```
pub trait Ring:
    'static
    + Clone
    + Debug
    + PartialEq
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> AddAssign<&'a Self>
    + for<'a> SubAssign<&'a Self>
    + for<'a> Same<&'a Self, Is = &'a Self>
    + for<'a> Same<&'a Self, Is: RingRef<Self>>
{
    /// Whether `==` decides: `false` for types that round.
    const EXACT: bool;

    /// The image of an integer.
    fn from_i64(n: i64) -> Self;

    /// The neutral element of addition.
    fn zero() -> Self {
        Self::from_i64(0)
    }

    /// The neutral element of multiplication.
    fn one() -> Self {
        Self::from_i64(1)
    }

    /// `self == 0`, without tolerance.
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }

    /// `self * self`.
    fn square(&self) -> Self {
        self * self
    }

    /// `a d − b c`, the determinant of the rows `(a, b)` and `(c, d)`.
    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        a * d - b * c
    }

    /// `Σ aᵢ bᵢ`; the empty sum is 0.
    fn dot<const N: usize>(a: [&Self; N], b: [&Self; N]) -> Self {
        let mut terms = a.into_iter().zip(b);
        let Some((x, y)) = terms.next() else {
            return Self::zero();
        };
        terms.fold(x * y, |sum, (x, y)| sum + x * y)
    }
}

/// A field: a [`Ring`] in which every element but 0 has an inverse.
///
/// `a / b` with `b == 0` follows the type (a panic for exact rationals, an infinity for `f64`);
/// where `b` is not known to be non-zero, use [`try_inv`](Field::try_inv) or
/// [`try_div`](Field::try_div).
pub trait Field:
    Ring
    + Div<Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
    + for<'a> Same<&'a Self, Is: DivRef<Self>>
{
    /// `1 / self`, or `None` where there is none.
    fn try_inv(&self) -> Option<Self>;

    /// `self / other`, or `None` where `other` has no inverse.
    fn try_div(&self, other: &Self) -> Option<Self> {
        other.try_inv().map(|inverse| self * &inverse)
    }

    /// The fraction `p / q`; `q` must not be 0 in this field.
    fn from_ratio(p: i64, q: i64) -> Self {
        Self::from_i64(p) / Self::from_i64(q)
    }
}

/// The determinant of three rows; positive for a right-handed triple such as the unit vectors.
pub fn det3<T: Ring>(a: [&T; 3], b: [&T; 3], c: [&T; 3]) -> T {
    let minors = [
        T::det2(b[1], b[2], c[1], c[2]),
        T::det2(b[2], b[0], c[2], c[0]),
        T::det2(b[0], b[1], c[0], c[1]),
    ];
    T::dot(a, [&minors[0], &minors[1], &minors[2]])
}

/// Derives all operator combinations of a ring from `fn`s on references.
macro_rules! ring_operators {
    ([$($generics:tt)*] $type:ty, $add:expr, $sub:expr, $mul:expr, $neg:expr) => {
        $crate::scalar::ring::ring_operators!(@binary [$($generics)*] $type, Add, add, $add);
        $crate::scalar::ring::ring_operators!(@binary [$($generics)*] $type, Sub, sub, $sub);
        $crate::scalar::ring::ring_operators!(@binary [$($generics)*] $type, Mul, mul, $mul);
        impl<$($generics)*> std::ops::Neg for $type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type { $neg(&self) }
        }
        impl<$($generics)*> std::ops::Neg for &$type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type { $neg(self) }
        }
        impl<$($generics)*> std::ops::AddAssign<&$type> for $type {
            #[inline]
            fn add_assign(&mut self, other: &$type) { *self = $add(&*self, other); }
        }
        impl<$($generics)*> std::ops::SubAssign<&$type> for $type {
            #[inline]
            fn sub_assign(&mut self, other: &$type) { *self = $sub(&*self, other); }
        }
    };
    (@binary [$($generics:tt)*] $type:ty, $Trait:ident, $method:ident, $f:expr) => {
        impl<$($generics)*> std::ops::$Trait for $type {
            type Output = $type;
            #[inline]
            fn $method(self, other: $type) -> $type { $f(&self, &other) }
        }
        impl<$($generics)*> std::ops::$Trait<&$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, other: &$type) -> $type { $f(&self, other) }
        }
        impl<$($generics)*> std::ops::$Trait<$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: $type) -> $type { $f(self, &other) }
        }
        impl<$($generics)*> std::ops::$Trait for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: &$type) -> $type { $f(self, other) }
        }
    };
}

/// Derives all combinations of `/` from a `fn` on references.
macro_rules! field_operators {
    ([$($generics:tt)*] $type:ty, $div:expr) => {
        $crate::scalar::ring::ring_operators!(@binary [$($generics)*] $type, Div, div, $div);
    };
}
pub(crate) use {field_operators, ring_operators};
