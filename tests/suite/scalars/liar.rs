//! Negative controls: integers with one false law each, and the checker that has to notice.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use isogeo::scalar::{BigRational, Field, Ordered, RationalField, Ring, Sign};
use proptest::strategy::Strategy;

use super::laws::{field, order, ring};
use super::samples::small_fractions;

const HONEST: u8 = 0;
const PRODUCT_DROPS_SIGN: u8 = 1;
const SUM_SHIFTED: u8 = 2;
const ADD_ASSIGN_SUBTRACTS: u8 = 3;
const DET2_FLIPPED: u8 = 4;
const ORDER_REVERSED: u8 = 5;
const ZERO_INVERTIBLE: u8 = 6;
const OWNED_DIFFERENCE_SWAPPED: u8 = 7;
const SQUARE_DOUBLED: u8 = 8;

/// The rational numbers, but for one lie.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
struct Liar<const LIE: u8>(BigRational);

impl<const LIE: u8> Liar<LIE> {
    fn sum(&self, other: &Self) -> Self {
        let sum = &self.0 + &other.0;
        Liar(if LIE == SUM_SHIFTED && self.0 > other.0 { sum + BigRational::one() } else { sum })
    }

    fn difference(&self, other: &Self) -> Self {
        Liar(&self.0 - &other.0)
    }

    fn product(&self, other: &Self) -> Self {
        let product = &self.0 * &other.0;
        Liar(if LIE == PRODUCT_DROPS_SIGN { product.magnitude() } else { product })
    }

    fn quotient(&self, other: &Self) -> Self {
        Liar(&self.0 / &other.0)
    }
}

macro_rules! operator {
    ($Trait:ident, $method:ident, $f:ident) => {
        impl<const LIE: u8> $Trait for Liar<LIE> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                if LIE == OWNED_DIFFERENCE_SWAPPED && stringify!($f) == "difference" {
                    return other.$f(&self);
                }
                self.$f(&other)
            }
        }
        impl<const LIE: u8> $Trait<&Liar<LIE>> for Liar<LIE> {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                self.$f(other)
            }
        }
        impl<const LIE: u8> $Trait<Liar<LIE>> for &Liar<LIE> {
            type Output = Liar<LIE>;
            fn $method(self, other: Liar<LIE>) -> Liar<LIE> {
                self.$f(&other)
            }
        }
        impl<const LIE: u8> $Trait for &Liar<LIE> {
            type Output = Liar<LIE>;
            fn $method(self, other: Self) -> Liar<LIE> {
                self.$f(other)
            }
        }
    };
}
operator!(Add, add, sum);
operator!(Sub, sub, difference);
operator!(Mul, mul, product);
operator!(Div, div, quotient);

impl<const LIE: u8> Neg for Liar<LIE> {
    type Output = Self;
    fn neg(self) -> Self {
        Liar(-self.0)
    }
}
impl<const LIE: u8> Neg for &Liar<LIE> {
    type Output = Liar<LIE>;
    fn neg(self) -> Liar<LIE> {
        Liar(-&self.0)
    }
}
impl<const LIE: u8> AddAssign<&Self> for Liar<LIE> {
    fn add_assign(&mut self, other: &Self) {
        *self = if LIE == ADD_ASSIGN_SUBTRACTS { self.difference(other) } else { self.sum(other) };
    }
}
impl<const LIE: u8> SubAssign<&Self> for Liar<LIE> {
    fn sub_assign(&mut self, other: &Self) {
        *self = self.difference(other);
    }
}

impl<const LIE: u8> Ring for Liar<LIE> {
    const EXACT: bool = true;

    fn from_i64(n: i64) -> Self {
        Liar(BigRational::from_i64(n))
    }

    fn square(&self) -> Self {
        if LIE == SQUARE_DOUBLED { self.sum(self) } else { self.product(self) }
    }

    fn det2(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        let det = a * d - b * c;
        if LIE == DET2_FLIPPED { -det } else { det }
    }
}

impl<const LIE: u8> Field for Liar<LIE> {
    fn try_inv(&self) -> Option<Self> {
        if LIE == ZERO_INVERTIBLE && self.is_zero() {
            return Some(Self::zero());
        }
        self.0.try_inv().map(Liar)
    }
}

impl<const LIE: u8> Ordered for Liar<LIE> {
    fn certain_sign(&self) -> Option<Sign> {
        match self.0.certain_sign() {
            Some(Sign::Negative) if LIE == ORDER_REVERSED => Some(Sign::Positive),
            sign => sign,
        }
    }
}

fn liars<const LIE: u8>() -> impl Strategy<Value = Liar<LIE>> + Clone {
    small_fractions::<BigRational>().prop_map(Liar)
}

fn not_zero<T: Ring>(x: &T) -> bool {
    !x.is_zero()
}

#[track_caller]
fn caught(verdict: Result<(), String>, law: &str) {
    match verdict {
        Ok(()) => panic!("nobody noticed the lie against {law:?}"),
        Err(message) => assert!(message.contains(law), "{law:?} expected, but {message}"),
    }
}

#[test]
fn an_honest_number_passes() -> Result<(), String> {
    ring(liars::<HONEST>())?;
    field(liars::<HONEST>(), not_zero)?;
    order(liars::<HONEST>())
}

#[test]
fn a_product_that_drops_the_sign_is_caught() {
    caught(ring(liars::<PRODUCT_DROPS_SIGN>()), "(-a) b = -(a b)");
}

#[test]
fn a_sum_that_does_not_commute_is_caught() {
    caught(ring(liars::<SUM_SHIFTED>()), "a + b = b + a");
}

#[test]
fn an_assignment_that_differs_from_its_operator_is_caught() {
    caught(ring(liars::<ADD_ASSIGN_SUBTRACTS>()), "+= is +");
}

#[test]
fn a_form_of_an_operator_that_differs_from_the_others_is_caught() {
    caught(ring(liars::<OWNED_DIFFERENCE_SWAPPED>()), "all forms of - agree");
}

#[test]
fn a_kernel_that_differs_from_its_formula_is_caught() {
    // Shrinking may end at det3, which is made of det2.
    caught(ring(liars::<DET2_FLIPPED>()), "det");
    caught(ring(liars::<SQUARE_DOUBLED>()), "square");
}

#[test]
fn an_inverse_of_zero_is_caught() {
    caught(field(liars::<ZERO_INVERTIBLE>(), not_zero), "0 has an inverse");
}

#[test]
fn a_sign_against_the_order_is_caught() {
    caught(order(liars::<ORDER_REVERSED>()), "the order is the sign of the difference");
}

/// The unit predicate is checked too: a field that pretends to invert fewer elements fails.
#[test]
fn a_missing_inverse_is_caught() {
    let odd = |x: &BigRational| x.numerator().bit(0);
    caught(field(small_fractions::<BigRational>(), odd), "exactly the units have an inverse");
}
