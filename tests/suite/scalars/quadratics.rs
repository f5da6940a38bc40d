//! Quadratic fields against enclosures, norms and known angles.

use isogeo::scalar::{
    Approx, Ball, BigInt, BigRational, Field, Ordered, Quadratic, Rational, RationalField, Ring,
    Sign,
};
use proptest::prelude::*;

use super::laws::{equal, holds, that};
use super::samples::{fractions, quadratics, small_fractions};

type K<const D: i64> = Quadratic<Rational, D>;

/// `√D` rounded down to a multiple of `2^-600`.
fn root<const D: i64>() -> Rational {
    let root = (BigInt::from(D) << 1200u32).sqrt();
    Rational::from_fraction(root, BigInt::from(1) << 600u32).expect("not over 0")
}

#[test]
fn the_norm_is_multiplicative_and_the_conjugate_an_automorphism() -> Result<(), String> {
    let numbers = quadratics::<_, 3>(fractions::<Rational>());
    holds((numbers.clone(), numbers), |(x, y): (K<3>, K<3>)| {
        equal("N(x y) = N(x) N(y)", (&x * &y).norm(), x.norm() * y.norm())?;
        equal("N(x) = x x'", K::new(x.norm(), Ring::zero()), &x * x.conjugate())?;
        equal("(x y)' = x' y'", (&x * &y).conjugate(), x.conjugate() * y.conjugate())?;
        equal("(x + y)' = x' + y'", (&x + &y).conjugate(), x.conjugate() + y.conjugate())?;
        equal("x'' = x", x.conjugate().conjugate(), x)
    })
}

#[test]
fn signs_and_doubles_are_those_of_a_close_rational() -> Result<(), String> {
    fn compare<const D: i64>() -> Result<(), String> {
        let small = quadratics::<_, D>(small_fractions::<Rational>());
        let numbers = prop_oneof![
            small.clone(),
            (0u32..12, small).prop_map(|(n, x)| {
                // High powers of a small number nearly cancel.
                let step = K::<D>::from_i64(D.isqrt()) - K::sqrt_d();
                (0..n).fold(x, |x, _| x * &step)
            }),
        ];
        let root = root::<D>();
        holds(numbers, |x: K<D>| {
            let (a, b) = x.parts();
            let close = a + b * &root;
            equal("the sign", x.certain_sign(), close.certain_sign())?;
            let error = (exact(x.to_f64()) - &close).magnitude();
            let unit = close.magnitude() * Rational::from_ratio(1, 1 << 52);
            that("four units in the last place", error <= unit * Rational::from_i64(4))
        })
    }
    compare::<2>()?;
    compare::<3>()?;
    compare::<99>()
}

fn exact(x: f64) -> Rational {
    isogeo::scalar::Numeral::from_f64(x).expect("finite").value()
}

#[test]
fn an_enclosure_of_the_root_never_contradicts_the_sign() -> Result<(), String> {
    holds(quadratics::<_, 2>(fractions::<Rational>()), |x: K<2>| {
        let (a, b) = x.parts();
        let root = Ball::from_i64(2).sqrt().expect("2 is positive");
        let ball = Ball::around(a) + Ball::around(b) * root;
        that("the signs agree", ball.certain_sign().is_none_or(|s| Some(s) == x.certain_sign()))
    })
}

/// Pell: `p² − 2 q² = ±1`, so `p − q√2` is tiny and its sign alternates.
#[test]
fn signs_are_decided_where_doubles_see_nothing() {
    let (mut p, mut q) = (BigInt::from(1), BigInt::from(1));
    for k in 0..200 {
        let number = Quadratic::<BigInt, 2>::new(p.clone(), -&q);
        let expected = if k % 2 == 0 { Sign::Negative } else { Sign::Positive };
        assert_eq!(number.certain_sign(), Some(expected), "p = {p}, q = {q}");
        assert_eq!(number.norm(), BigInt::from(if k % 2 == 0 { -1 } else { 1 }));
        (p, q) = (&p + &q * 2, p + q);
    }
}

/// `(cos + i sin)^k` is 1 for `k = n` and for no smaller `k`, and the first is the least turn.
#[test]
fn rotations_have_the_order_they_claim() {
    fn orders<const D: i64>() -> Vec<u32> {
        let close = |x: &K<D>, y: f64| (x.to_f64() - y).abs() < 1e-14;
        let exist = |n: &u32| {
            let Some((cos, sin)) = K::<D>::regular_polygon(*n) else { return false };
            let angle = std::f64::consts::TAU / f64::from(*n);
            assert!(close(&cos, angle.cos()) && close(&sin, angle.sin()), "n = {n}");
            assert_eq!(cos.square() + sin.square(), K::one(), "n = {n}");
            let turn = |(x, y): (K<D>, K<D>)| (&x * &cos - &y * &sin, &x * &sin + &y * &cos);
            let mut power = (K::one(), K::zero());
            for k in 1..=*n {
                power = turn(power);
                assert_eq!(power == (K::one(), K::zero()), k == *n, "n = {n}, k = {k}");
            }
            true
        };
        (0..50).filter(exist).collect()
    }
    assert_eq!(orders::<2>(), [1, 2, 4, 8]);
    assert_eq!(orders::<3>(), [1, 2, 3, 4, 6, 12]);
    assert_eq!(orders::<5>(), [1, 2, 4]);
    assert_eq!(orders::<12>(), orders::<3>());
    assert_eq!(orders::<18>(), orders::<2>());
    assert_eq!(orders::<6>(), [1, 2, 4]);
}

/// `cos π/12 = (√6 + √2)/4` in the tower, by the double angle.
#[test]
fn the_cosine_of_15_degrees_lies_in_the_tower() {
    type L = Quadratic<Quadratic<BigRational, 2>, 3>;
    let root_2 = Quadratic::<BigRational, 2>::sqrt_d();
    let quarter = root_2 * Quadratic::from_ratio(1, 4);
    let cos = L::new(quarter.clone(), quarter); // (√2 + √2 √3)/4
    let cos_30 = L::sqrt_d() * L::from_ratio(1, 2);
    assert_eq!(cos.square() * L::from_i64(2) - L::one(), cos_30);
    assert_eq!(cos.to_string(), "1/4·√2 + 1/4·√2·√3");
    assert!((cos.to_f64() - (std::f64::consts::PI / 12.0).cos()).abs() < 1e-15);
    assert_eq!((&cos - L::one()).certain_sign(), Some(Sign::Negative));
}

/// Outside the legal towers the norm tells: `√8 − 2√2` is 0 in ℝ, has norm 0, and no inverse.
#[test]
fn a_root_adjoined_twice_makes_zero_divisors() {
    type Twice = Quadratic<Quadratic<BigRational, 2>, 8>;
    let root_8 = Twice::new(Quadratic::from_i64(-2) * Quadratic::sqrt_d(), Quadratic::one());
    assert!(!root_8.is_zero() && root_8.norm().is_zero());
    assert_eq!(root_8.try_inv(), None);
    assert_eq!(root_8.certain_sign(), Some(Sign::Zero));
}

#[test]
fn numbers_print_without_the_terms_that_vanish() {
    let print = |a: (i64, i64), b: (i64, i64)| {
        K::<3>::new(Rational::from_ratio(a.0, a.1), Rational::from_ratio(b.0, b.1)).to_string()
    };
    assert_eq!(print((0, 1), (0, 1)), "0");
    assert_eq!(print((-1, 2), (0, 1)), "-1/2");
    assert_eq!(print((0, 1), (1, 1)), "√3");
    assert_eq!(print((0, 1), (-1, 1)), "-√3");
    assert_eq!(print((1, 2), (-1, 3)), "1/2 - 1/3·√3");
    assert_eq!(print((-2, 1), (5, 1)), "-2 + 5·√3");
    let sum = Quadratic::<Rational, 2>::from_i64(1) + Quadratic::sqrt_d();
    assert_eq!(Quadratic::<_, 3>::new(sum.clone(), -sum).to_string(), "1 + √2 - (1 + √2)·√3");
}
