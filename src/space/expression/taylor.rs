//! A value with its first and second derivatives by x and y.

use super::{Function, Number, Rational, Value};

/// The 2-jet of a function of x and y.
#[derive(Clone, Debug)]
pub(super) struct Taylor<T> {
    pub value: T,
    pub x: T,
    pub y: T,
    pub xx: T,
    pub xy: T,
    pub yy: T,
}

impl<T: Number> Taylor<T> {
    fn linear(value: T, x: i64, y: i64) -> Self {
        let (x, y) = (T::from_i64(x), T::from_i64(y));
        Taylor { value, x, y, xx: T::zero(), xy: T::zero(), yy: T::zero() }
    }

    /// The coordinate x.
    pub fn x(at: &T) -> Self {
        Taylor::linear(at.clone(), 1, 0)
    }

    /// The coordinate y.
    pub fn y(at: &T) -> Self {
        Taylor::linear(at.clone(), 0, 1)
    }

    /// `φ(self)` from value, first and second derivative of φ there.
    fn composed(&self, [value, first, second]: [T; 3]) -> Self {
        let curved = |own: &T, u: &T, v: &T| &first * own + &second * (u * v);
        Taylor {
            value,
            x: &first * &self.x,
            y: &first * &self.y,
            xx: curved(&self.xx, &self.x, &self.x),
            xy: curved(&self.xy, &self.x, &self.y),
            yy: curved(&self.yy, &self.y, &self.y),
        }
    }
}

impl<T: Number> Value for Taylor<T> {
    fn number(number: &Rational) -> Self {
        Taylor::linear(T::of(number), 0, 0)
    }

    fn plus(&self, o: &Self) -> Self {
        Taylor {
            value: &self.value + &o.value,
            x: &self.x + &o.x,
            y: &self.y + &o.y,
            xx: &self.xx + &o.xx,
            xy: &self.xy + &o.xy,
            yy: &self.yy + &o.yy,
        }
    }

    fn times(&self, o: &Self) -> Self {
        let (f, g) = (&self.value, &o.value);
        let two = T::from_i64(2);
        Taylor {
            value: f * g,
            x: T::dot([f, g], [&o.x, &self.x]),
            y: T::dot([f, g], [&o.y, &self.y]),
            xx: T::dot([f, g], [&o.xx, &self.xx]) + two.clone() * (&self.x * &o.x),
            xy: T::dot([f, g, &self.x, &self.y], [&o.xy, &self.xy, &o.y, &o.x]),
            yy: T::dot([f, g], [&o.yy, &self.yy]) + two * (&self.y * &o.y),
        }
    }

    fn negative(&self) -> Self {
        self.times(&Taylor::linear(T::from_i64(-1), 0, 0))
    }

    fn over(&self, other: &Self) -> Option<Self> {
        let inverse = other.value.try_inv()?;
        let first = -inverse.square();
        let second = T::from_i64(-2) * (&first * &inverse);
        Some(self.times(&other.composed([inverse, first, second])))
    }

    fn call(&self, function: Function) -> Option<Self> {
        self.value.function(function).map(|derivatives| self.composed(derivatives))
    }
}
