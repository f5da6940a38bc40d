//! The instances agree: one random formula, evaluated in each, gives images of one number.

use isogeo::scalar::{
    Approx, Ball, BigInt, BigRational, Bounded, Dual, Field, Fraction, Narrow, Ordered, Prime61,
    Quadratic, Rational, RationalField, Residue, Ring, Wide,
};
use proptest::array::uniform4;
use proptest::prelude::*;

use super::balls::contains;
use super::expression::{polynomials, quotients};
use super::laws::{equal, holds, that};
use super::samples::{fractions, integers, small_fractions};

#[test]
fn both_rational_types_give_the_same_fraction() -> Result<(), String> {
    holds((quotients(5), uniform4(small_fractions::<BigRational>())), |(f, at)| {
        let ours = f.rational(&at.each_ref().map(RationalField::convert::<Rational>));
        let theirs = f.rational(&at);
        equal("the value", ours.as_ref().map(Rational::convert), theirs.clone())?;
        let texts = (ours.map(|x| x.to_string()), theirs.map(|x| x.to_string()));
        equal("its text", texts.0, texts.1)
    })
}

#[test]
fn reduction_modulo_the_prime_commutes_with_every_formula() -> Result<(), String> {
    holds((quotients(5), uniform4(fractions::<Rational>())), |(f, at)| {
        let residues = at.each_ref().map(|x| Prime61::reduce(x).unwrap_or_else(Prime61::zero));
        match (f.rational(&at), f.rational(&residues)) {
            (Some(exact), Some(residue)) => {
                equal("the residue", Prime61::reduce(&exact), Some(residue))
            }
            // A division by 0 stays one; the converse may fail where p divides a numerator.
            (None, residue) => equal("0 stays 0", residue, None),
            (Some(_), None) => Ok(()),
        }
    })
}

#[test]
fn residues_are_those_of_the_integers() -> Result<(), String> {
    fn compare<const W: usize>() -> Result<(), String> {
        holds((polynomials(4), uniform4(integers())), |(f, at)| {
            let residue = f.polynomial(&at.each_ref().map(Residue::<W>::from_big));
            let exact = f.polynomial(&at);
            equal("the residue", &residue, &Residue::from_big(&exact))?;
            let words = residue.0.iter().rev().fold(BigInt::ZERO, |n, w| (n << 64) + *w);
            let modulus = BigInt::from(1) << (64 * W);
            that("it is congruent to the integer", ((exact - words) % modulus).is_zero())
        })
    }
    compare::<1>()?;
    compare::<2>()?;
    compare::<3>()?;
    compare::<4>()
}

/// The integer or the knowledge that there was not room for it, whatever happens on the way.
#[test]
fn bounded_integers_are_right_or_overflown() -> Result<(), String> {
    fn compare<R: Bounded>(of: fn(&BigInt) -> Option<R>) -> Result<(), String> {
        holds((polynomials(4), uniform4(integers())), |(f, at)| {
            let exact = f.polynomial(&at);
            let [Some(a), Some(b), Some(c), Some(d)] = at.each_ref().map(of) else {
                return Ok(());
            };
            let found = f.polynomial(&[a, b, c, d]);
            equal("it says so", found.to_big().is_none(), found.is_overflown())?;
            equal("as in another size", found.to_wide::<9>().to_big(), found.to_big())?;
            match found.to_big() {
                Some(found) => equal("the value", found, exact),
                None => that("what is too large is not 0", !found.is_zero() && found != R::zero()),
            }
        })
    }
    compare(|n| Some(Narrow::from(i128::try_from(n).ok()?)))?;
    compare(|n| Some(n.to_wide::<2>()))?;
    compare(|n| Some(n.to_wide::<3>()))?;
    compare(|n| Some(n.to_wide::<8>()))
}

#[test]
fn small_formulas_fit_and_large_ones_do_not() {
    let (n, bits) = (Narrow::from(i128::MAX), Wide::<2>::from(i128::MIN));
    assert_eq!((n - Narrow::from(1) + Narrow::from(1)).to_big(), Some(i128::MAX.into()));
    assert!((n + Narrow::from(1)).is_overflown());
    assert!((-Narrow::from(i128::MIN)).is_overflown());
    assert_eq!((bits + bits).to_big(), None);
    assert_eq!((-&bits - Wide::from(1)).to_big(), Some(i128::MAX.into()));
    assert!((bits * bits).is_overflown());
    assert_eq!(BigInt::from(-7).to_wide::<2>(), Wide::from(-7));
    assert!((BigInt::from(1) << 128u32).to_wide::<2>().is_overflown());
}

#[test]
fn unreduced_fractions_stand_for_the_same_numbers() -> Result<(), String> {
    holds((quotients(4), uniform4(small_fractions::<Rational>())), |(f, at)| {
        let raw = |x: &Rational| Fraction::new(x.numerator() * -6, x.denominator() * -6);
        let found = f.rational(&at.each_ref().map(raw));
        let exact = f.rational(&at);
        let signs =
            (found.as_ref().map(Ordered::certain_sign), exact.as_ref().map(Ordered::certain_sign));
        equal("the sign", signs.0, signs.1)?;
        let doubles = (found.as_ref().map(Approx::to_f64), exact.as_ref().map(Approx::to_f64));
        equal("the nearest double", doubles.0, doubles.1)?;
        equal("the value", found.and_then(|x| x.reduced::<Rational>()), exact)
    })
}

#[test]
fn a_fraction_over_zero_equals_nothing() {
    let over_zero = Fraction::from_ratio(1, 2) / Fraction::<BigInt>::zero();
    assert!(over_zero != over_zero && !over_zero.is_zero());
    assert_eq!(over_zero.reduced::<Rational>(), None);
    assert_eq!(over_zero.certain_sign(), None);
    assert_eq!(Fraction::<BigInt>::zero().try_inv(), None);
}

#[test]
fn enclosures_in_doubles_contain_the_exact_value() -> Result<(), String> {
    let numbers = prop_oneof![fractions::<BigRational>(), small_fractions::<BigRational>()];
    holds((polynomials(5), uniform4(numbers)), |(f, at)| {
        let ball = f.polynomial(&at.each_ref().map(Ball::around));
        let exact = f.polynomial(&at);
        that("the ball contains it", contains(&ball, &exact))?;
        match ball.certain_sign() {
            Some(sign) => equal("its sign", Some(sign), exact.certain_sign()),
            None => Ok(()),
        }
    })
}

#[test]
fn enclosures_in_integers_contain_every_value() -> Result<(), String> {
    // A midpoint, a radius and a point of the ball.
    let balls = (integers(), 0i64..1000, -1000i64..=1000).prop_map(|(mid, radius, at)| {
        (Ball::new(mid.clone(), radius.into()), mid + at * radius / 1000)
    });
    holds((polynomials(4), uniform4(balls)), |(f, at)| {
        let ball = f.polynomial(&at.each_ref().map(|(ball, _)| ball.clone()));
        let exact = f.polynomial(&at.map(|(_, point)| point));
        that("the ball contains it", Ordered::magnitude(&(&exact - &ball.mid)) <= ball.radius)?;
        match ball.certain_sign() {
            Some(sign) => equal("its sign", Some(sign), exact.certain_sign()),
            None => Ok(()),
        }
    })
}

/// `√2` is `2^31` modulo `2^61 − 1`: a homomorphism from ℚ(√2) that shares no code with it.
#[test]
fn the_root_of_2_has_an_image_modulo_the_prime() -> Result<(), String> {
    let image = |x: &Quadratic<Rational, 2>| {
        let (a, b) = x.parts();
        Some(Prime61::reduce(a)? + Prime61::reduce(b)? * Prime61::from_u64(1 << 31))
    };
    let parts = (small_fractions::<Rational>(), small_fractions::<Rational>());
    let numbers = parts.prop_map(|(a, b)| Quadratic::<Rational, 2>::new(a, b));
    holds((quotients(4), uniform4(numbers)), |(f, at)| {
        let images = at.each_ref().map(|x| image(x).unwrap_or_else(Prime61::zero));
        match (f.rational(&at), f.rational(&images)) {
            (Some(exact), Some(residue)) => equal("the image", image(&exact), Some(residue)),
            (None, residue) => equal("0 stays 0", residue, None),
            (Some(_), None) => Ok(()),
        }
    })
}

#[test]
fn a_dual_number_carries_the_value_of_its_scalar() -> Result<(), String> {
    holds((quotients(5), uniform4(-9.0..9.0f64)), |(f, at)| {
        // In f64 to the last bit; the infinities and NaN of a division by a rounded 0 left out.
        let dual = f.rational(&Dual::variables(at)).map(|d| d.value);
        match f.rational(&at) {
            Some(value) if value.is_finite() => equal("the value", dual, Some(value)),
            _ => Ok(()),
        }
    })
}

/// A non-zero polynomial has no more zeros than its degree allows; an identity vanishes always.
#[test]
fn an_identity_test_tells_an_identity_from_its_neighbour() -> Result<(), String> {
    let point = || any::<u64>().prop_map(Prime61::from_u64);
    holds([point(), point(), point(), point()], |[a, b, c, d]| {
        // Lagrange: (a² + b²)(c² + d²) = (ac + bd)² + (ad − bc)².
        let norm = |x: &Prime61, y: &Prime61| x.square() + y.square();
        let residual = norm(&a, &b) * norm(&c, &d)
            - norm(&Prime61::dot([&a, &b], [&c, &d]), &Prime61::det2(&a, &b, &c, &d));
        that("the identity vanishes", residual.is_zero())?;
        let wrong = norm(&a, &b) * norm(&c, &d) - norm(&(a * c), &(b * d));
        that("a wrong one does not", !wrong.is_zero())
    })
}

#[test]
fn a_fraction_without_residue_is_refused() {
    let p = BigInt::from(Prime61::MODULUS);
    let q = BigRational::from_fraction(1.into(), p.clone() * 6).expect("not over 0");
    assert_eq!(Prime61::reduce(&q), None);
    assert_eq!(Prime61::reduce(&q.try_inv().expect("not 0")), Some(Prime61::zero()));
    assert_eq!(Prime61::reduce(&q.convert::<Rational>()), None);
}
