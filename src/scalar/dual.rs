//! Dual numbers: a value and its first partial derivatives, exact wherever the scalar is.

use std::array::from_fn;

use super::ring::{field_operators, ring_operators};
use super::{Field, Ring};

/// `value + Σ partialsᵢ εᵢ` with `εᵢ εⱼ = 0`: a value and its derivatives by `N` variables.
///
/// A generic formula evaluated on dual numbers gives its gradient beside its value; the value is
/// the very same that `T` gives, in `f64` to the last bit. Nested, `Dual<Dual<T, N>, N>` gives the
/// Hessian:
///
/// ```
/// use isogeo::scalar::Dual;
/// let x = Dual::<f64, 2>::variable(3.0, 0);
/// let y = Dual::<f64, 2>::variable(5.0, 1);
/// assert_eq!((x * x * y).partials, [30.0, 9.0]);
///
/// let x = Dual::<Dual<f64, 1>, 1>::variable(Dual::variable(2.0, 0), 0);
/// assert_eq!((x * x * x).partials[0].partials[0], 12.0); // (x³)″ = 6 x
/// ```
///
/// `==` compares all parts, so `is_zero` says that the value *and* every derivative vanish. Beyond
/// 0 itself the elements of value 0 have no inverse either (`ε ε = 0`), so [`Field`] is meant with
/// that exception: `a / b` behaves as division by `b.value` does in `T`. There is no order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const N: usize> {
    /// The value.
    pub value: T,
    /// The derivatives by the variables 0, …, N − 1.
    pub partials: [T; N],
}

impl<T: Ring, const N: usize> Dual<T, N> {
    /// A number that depends on no variable.
    #[inline]
    pub fn constant(value: T) -> Self {
        Dual { value, partials: from_fn(|_| T::zero()) }
    }

    /// The variable of the given index, which is below `N`; any other is a constant.
    #[inline]
    pub fn variable(value: T, index: usize) -> Self {
        Dual { value, partials: from_fn(|i| T::from_i64((i == index).into())) }
    }

    /// All variables at once, at a point.
    ///
    /// ```
    /// use isogeo::scalar::Dual;
    /// let [x, y] = Dual::variables([3.0, 4.0]);
    /// assert_eq!((x / y).partials, [0.25, -0.1875]); // 1/y, −x/y²
    /// ```
    #[inline]
    pub fn variables(point: [T; N]) -> [Self; N] {
        let mut index = 0..;
        point.map(|value| Self::variable(value, index.next().unwrap_or(N)))
    }

    /// The chain rule: `f(self)`, where `value` is `f` at `self.value` and `slope` its derivative.
    ///
    /// ```
    /// use isogeo::scalar::Dual;
    /// let x = Dual::<f64, 1>::variable(4.0, 0);
    /// let root = x.value.sqrt();
    /// assert_eq!(x.chain(root, &(0.5 / root)).partials, [0.25]);
    /// ```
    #[inline]
    pub fn chain(&self, value: T, slope: &T) -> Self {
        Dual { value, partials: from_fn(|i| slope * &self.partials[i]) }
    }
}

#[inline]
fn add<T: Ring, const N: usize>(a: &Dual<T, N>, b: &Dual<T, N>) -> Dual<T, N> {
    Dual { value: &a.value + &b.value, partials: from_fn(|i| &a.partials[i] + &b.partials[i]) }
}

#[inline]
fn subtract<T: Ring, const N: usize>(a: &Dual<T, N>, b: &Dual<T, N>) -> Dual<T, N> {
    Dual { value: &a.value - &b.value, partials: from_fn(|i| &a.partials[i] - &b.partials[i]) }
}

#[inline]
fn negate<T: Ring, const N: usize>(a: &Dual<T, N>) -> Dual<T, N> {
    Dual { value: -&a.value, partials: from_fn(|i| -&a.partials[i]) }
}

/// `(a b)′ = a′ b + a b′`.
#[inline]
fn multiply<T: Ring, const N: usize>(a: &Dual<T, N>, b: &Dual<T, N>) -> Dual<T, N> {
    let partials = from_fn(|i| T::dot([&a.partials[i], &a.value], [&b.value, &b.partials[i]]));
    Dual { value: &a.value * &b.value, partials }
}

/// `(a / b)′ = (a′ − (a/b) b′) / b`.
#[inline]
fn divide<T: Field, const N: usize>(a: &Dual<T, N>, b: &Dual<T, N>) -> Dual<T, N> {
    let value = &a.value / &b.value;
    let inverse = T::one() / &b.value;
    let partials = from_fn(|i| (&a.partials[i] - &value * &b.partials[i]) * &inverse);
    Dual { value, partials }
}

ring_operators!([T: Ring, const N: usize] Dual<T, N>, add, subtract, multiply, negate);
field_operators!([T: Field, const N: usize] Dual<T, N>, divide);

impl<T: Ring, const N: usize> Ring for Dual<T, N> {
    const EXACT: bool = T::EXACT;

    #[inline]
    fn from_i64(n: i64) -> Self {
        Dual::constant(T::from_i64(n))
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.partials.iter().all(T::is_zero)
    }

    fn square(&self) -> Self {
        let slope = &self.value + &self.value;
        self.chain(self.value.square(), &slope)
    }

    #[inline]
    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        let partials = from_fn(|i| {
            T::det2(&a.partials[i], &b.partials[i], &c.value, &d.value)
                + T::det2(&a.value, &b.value, &c.partials[i], &d.partials[i])
        });
        Dual { value: T::det2(&a.value, &b.value, &c.value, &d.value), partials }
    }

    #[inline]
    fn dot<const M: usize>(a: [&Self; M], b: [&Self; M]) -> Self {
        let (u, v) = (a.map(|x| &x.value), b.map(|x| &x.value));
        let partials = from_fn(|i| {
            T::dot(a.map(|x| &x.partials[i]), v) + T::dot(u, b.map(|x| &x.partials[i]))
        });
        Dual { value: T::dot(u, v), partials }
    }
}

impl<T: Field, const N: usize> Field for Dual<T, N> {
    /// `1/a`, with `(1/a)′ = −a′ / a²`; `None` where the *value* has no inverse.
    fn try_inv(&self) -> Option<Self> {
        let inverse = self.value.try_inv()?;
        let slope = -inverse.square();
        Some(self.chain(inverse, &slope))
    }

    fn try_div(&self, other: &Self) -> Option<Self> {
        other.value.try_inv().map(|_| divide(self, other))
    }
}
