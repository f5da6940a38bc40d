//! Random objects of isotropic space over any rational field.

use isogeo::scalar::{RationalField, Ring};
use isogeo::space::*;
use proptest::prelude::*;

/// What a law returns.
pub type Verdict = Result<(), TestCaseError>;

/// The numerators and denominators that one case is made from.
pub fn numbers() -> impl Strategy<Value = Vec<(i64, i64)>> {
    proptest::collection::vec((-9i64..=9, 1i64..=4), 64)
}

/// A source of random objects; it hands out the fractions in order, and then again.
pub struct Draw<Q> {
    fractions: Vec<Q>,
    next: usize,
}

impl<Q: RationalField> Draw<Q> {
    pub fn new(numbers: Vec<(i64, i64)>) -> Self {
        let fractions = numbers.into_iter().map(|(p, q)| Q::from_ratio(p, q)).collect();
        Draw { fractions, next: 0 }
    }

    pub fn number(&mut self) -> Q {
        let number = self.fractions[self.next % self.fractions.len()].clone();
        self.next += 1;
        number
    }

    pub fn non_zero(&mut self) -> Q {
        let number = self.number();
        if number.is_zero() { Q::one() } else { number }
    }

    /// An index below `n`, from the digits of a number.
    pub fn index(&mut self, n: usize) -> usize {
        let number = self.number();
        let digits = number.numerator() * 7 + number.denominator() + 70;
        usize::try_from(digits).map_or(0, |i| i % n)
    }

    pub fn top_view(&mut self) -> TopView<Q> {
        TopView::new(self.number(), self.number())
    }

    pub fn point(&mut self) -> Point<Q> {
        Point::new(self.number(), self.number(), self.number())
    }

    pub fn vector(&mut self) -> Vector2<Q> {
        Vector2::new(self.number(), self.number())
    }

    pub fn gradient(&mut self) -> Gradient<Q> {
        Gradient::new(self.number(), self.number())
    }

    pub fn plane(&mut self) -> Plane<Q> {
        Plane::new(self.gradient(), self.number())
    }

    pub fn isotropic_plane(&mut self) -> IsotropicPlane<Q> {
        let direction = Vector2::new(self.non_zero(), self.number());
        IsotropicPlane::new(self.top_view(), direction).unwrap()
    }

    pub fn contact(&mut self) -> ContactElement<Q> {
        ContactElement::new(self.point(), self.gradient())
    }

    pub fn sphere(&mut self) -> ParabolicSphere<Q> {
        ParabolicSphere::new(self.non_zero(), self.number(), self.number(), self.number()).unwrap()
    }

    pub fn circle(&mut self) -> Circle<Q> {
        Circle::new(self.top_view(), self.non_zero())
    }

    pub fn cylinder(&mut self) -> CylindricalSphere<Q> {
        CylindricalSphere::new(self.circle()).unwrap()
    }

    pub fn rotation(&mut self) -> Rotation<Q> {
        Rotation::from_parameter(&self.number()).unwrap()
    }

    pub fn motion(&mut self) -> Motion<Q> {
        Motion {
            rotation: self.rotation(),
            shear: self.vector(),
            translation: Vector3::new(self.number(), self.number(), self.number()),
        }
    }

    pub fn scaling(&mut self) -> Scaling<Q> {
        Scaling::new(self.non_zero(), self.non_zero()).unwrap()
    }

    /// An i-M-transformation from generators of every kind.
    pub fn moebius(&mut self) -> MoebiusTransformation<Q> {
        let inversion = |draw: &mut Self| {
            MoebiusTransformation::inversion_at_cylinder(&draw.cylinder(), &draw.number())
        };
        inversion(self)
            .then(&(&self.motion()).into())
            .then(&MoebiusTransformation::inversion_at(&self.sphere()))
            .then(&(&self.scaling()).into())
            .then(&inversion(self))
    }

    /// A polynomial of degree 3.
    pub fn polynomial(&mut self) -> Polynomial<Q> {
        let degrees = (0..=3).flat_map(|n| (0..=n).map(move |i| (i, n - i)));
        Polynomial::new(degrees.map(|(i, j)| (i, j, self.number())))
    }

    /// A harmonic polynomial of degree 4: a combination of the real and imaginary parts of `wᵏ`.
    pub fn harmonic(&mut self) -> Polynomial<Q> {
        let (x, y) = (Polynomial::x(), Polynomial::y());
        let (mut re, mut im, mut sum) = (x.clone(), y.clone(), Polynomial::zero());
        for _ in 1..=4 {
            sum += &(Polynomial::constant(&self.number()) * &re);
            sum += &(Polynomial::constant(&self.number()) * &im);
            (re, im) = (&re * &x - &im * &y, &re * &y + &im * &x);
        }
        sum
    }
}

/// Runs laws for both exact scalars; `in 20 cases:` in front for slow ones.
macro_rules! laws {
    (in $cases:literal cases: $($law:ident)*) => {
        $( $crate::space::laws!(@ (proptest::prelude::ProptestConfig::with_cases($cases)) $law); )*
    };
    (@ ($config:expr) $law:ident) => {
        mod $law {
            use isogeo::scalar::{BigRational, Rational};
            use $crate::space::{Draw, numbers};

            proptest::proptest! {
                #![proptest_config($config)]

                #[test]
                fn rational(numbers in numbers()) {
                    super::$law::<Rational>(&mut Draw::new(numbers))?;
                }

                #[test]
                fn big_rational(numbers in numbers()) {
                    super::$law::<BigRational>(&mut Draw::new(numbers))?;
                }
            }
        }
    };
    ($($law:ident)*) => {
        $( $crate::space::laws!(@ (proptest::prelude::ProptestConfig::default()) $law); )*
    };
}
pub(crate) use laws;
