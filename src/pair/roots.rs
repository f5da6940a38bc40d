//! Roots of quadratic equations over ℚ: principal curvatures and critical distances.

use crate::scalar::{BigInt, RationalField, Sign};

/// The solutions of `a x² + 2b x + c = 0`: rational if they are, else rounded and said to be.
#[derive(Clone, Debug, PartialEq)]
pub enum Roots<T> {
    /// All coefficients are 0.
    Every,
    /// Rational solutions in ascending order: none, one, or two; a double one is there twice.
    Exact(Vec<T>),
    /// Two irrational solutions in ascending order, in `f64`: correct up to a few roundings.
    Rounded([f64; 2]),
    /// None, since the discriminant `b² − a c` is this negative number.
    Complex(T),
}

impl<T> Roots<T> {
    /// The solutions if all are rational.
    pub fn exact(&self) -> Option<&[T]> {
        match self {
            Roots::Exact(roots) => Some(roots),
            _ => None,
        }
    }
}

impl<T: RationalField> Roots<T> {
    /// The solutions of `a x² + 2b x + c = 0`.
    ///
    /// ```
    /// use isogeo::pair::Roots;
    /// use isogeo::scalar::{Rational, Ring};
    /// let roots = |a, b, c| Roots::of(&Rational::from_i64(a), &Rational::from_i64(b), &Rational::from_i64(c));
    /// assert_eq!(roots(1, -2, 3), Roots::Exact(vec![Rational::from_i64(1), Rational::from_i64(3)]));
    /// assert_eq!(roots(1, 0, -2), Roots::Rounded([-f64::sqrt(2.0), f64::sqrt(2.0)]));
    /// assert_eq!(roots(1, 0, 2), Roots::Complex(Rational::from_i64(-2)));
    /// assert_eq!(roots(0, 0, 2), Roots::Exact(vec![]));
    /// ```
    pub fn of(a: &T, b: &T, c: &T) -> Self {
        let Some(inverse) = a.try_inv() else {
            return match (-c).try_div(&(T::from_i64(2) * b)) {
                Some(root) => Roots::Exact(vec![root]),
                None if c.is_zero() => Roots::Every,
                None => Roots::Exact(Vec::new()),
            };
        };
        let discriminant = b.square() - a * c;
        if discriminant.certain_sign() == Some(Sign::Negative) {
            return Roots::Complex(discriminant);
        }
        if let Some(root) = square_root(&discriminant) {
            let mut roots = vec![(-b - &root) * &inverse, (root - b) * inverse];
            if roots[1] < roots[0] {
                roots.swap(0, 1);
            }
            return Roots::Exact(roots);
        }
        // Scaled by the leading coefficient, so that ranges stay; first the root without
        // cancellation, then the other from the product c/a.
        let (half, product) = (-(b * &inverse), c * &inverse);
        let root = (discriminant * inverse.square()).to_f64().sqrt();
        let (half, product) = (half.to_f64(), product.to_f64());
        if half == 0.0 {
            return Roots::Rounded([-root, root]);
        }
        let large = if half < 0.0 { half - root } else { half + root };
        let small = product / large;
        Roots::Rounded([large.min(small), large.max(small)])
    }

    /// The solutions in `f64`, if they are real and two.
    pub fn rounded(&self) -> Option<[f64; 2]> {
        match self {
            Roots::Rounded(roots) => Some(*roots),
            Roots::Exact(roots) => match roots.as_slice() {
                [a, b] => Some([a.to_f64(), b.to_f64()]),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The root of the square of a rational number, in lowest terms a square over a square.
fn square_root<T: RationalField>(square: &T) -> Option<T> {
    let root = |n: BigInt| {
        let root = n.sqrt();
        (&root * &root == n).then_some(root)
    };
    T::from_fraction(root(square.numerator())?, root(square.denominator())?)
}
