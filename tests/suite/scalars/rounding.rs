//! Fractions to doubles, and fractions to fractions, at the edges.

use isogeo::scalar::{Approx, BigInt, BigRational, Field, Numeral, Rational, RationalField, Ring};
use proptest::prelude::*;

use super::laws::{equal, holds};
use super::samples::{fractions, integers};

fn exact(x: f64) -> BigRational {
    Numeral::from_f64(x).expect("finite").value()
}

/// Between two neighbours the middle goes to the even one, and anything else to the nearer.
#[test]
fn the_nearest_double_is_chosen() -> Result<(), String> {
    let subnormal = (0u64..1 << 53).prop_map(f64::from_bits);
    let positive =
        any::<f64>().prop_map(f64::abs).prop_filter("finite", |x| x.next_up().is_finite());
    holds((prop_oneof![subnormal, positive], 1u32..300), |(x, k)| {
        let up = x.next_up();
        let even = if x.to_bits() & 1 == 0 { x } else { up };
        let middle = (exact(x) + exact(up)) * BigRational::from_ratio(1, 2);
        let little = (exact(up) - exact(x)) / BigRational::from_integer(BigInt::from(3).pow(k));
        for (name, q, nearest) in [
            ("the middle", middle.clone(), even),
            ("above the middle", &middle + &little, up),
            ("below the middle", &middle - &little, x),
        ] {
            equal(name, q.to_f64(), nearest)?;
            equal(name, (-&q).to_f64(), -nearest)?;
            equal(name, q.convert::<Rational>().to_f64(), nearest)?;
        }
        Ok(())
    })
}

#[test]
fn integers_round_as_casts_do() -> Result<(), String> {
    holds((any::<i128>(), 0u32..128), |(n, shift)| {
        let n = n >> shift;
        equal("BigInt", BigInt::from(n).to_f64(), n as f64)?;
        let q = Rational::from_fraction(n.into(), 1.into()).map(|q| q.to_f64());
        equal("Rational", q, Some(n as f64))
    })
}

/// Found: a quotient was truncated, and a subnormal result rounded once more: what lies just above
/// the middle of the two least doubles went down.
#[test]
fn a_subnormal_number_is_rounded_once() {
    let above: Numeral = "2.4703282292062327208828439643411068618253e-324".parse().expect("one");
    let below: Numeral = "2.4703282292062327208828439643411068618252e-324".parse().expect("one");
    assert_eq!(above.value::<BigRational>().to_f64(), f64::from_bits(1));
    assert_eq!(below.value::<BigRational>().to_f64(), 0.0);
    let x = exact(f64::from_bits(1)) * BigRational::from_ratio(1, 2);
    assert_eq!(x.to_f64(), 0.0);
    assert_eq!((&x * BigRational::from_ratio(3, 1)).to_f64(), f64::from_bits(2));
}

/// Found: the lowest word of a quotient was rounded, and then the sum of the words once more.
#[test]
fn an_integer_of_two_words_is_rounded_once() {
    let n = 624_099_614_113_043_964_724_483_956_985_036_800i128;
    assert_eq!(BigInt::from(n).to_f64(), n as f64);
}

#[test]
fn the_greatest_double_and_the_next_are_told_apart() {
    let top = exact(f64::MAX);
    let half_step = exact(2f64.powi(970));
    assert_eq!(top.to_f64(), f64::MAX);
    let below = &top + &half_step - BigRational::one();
    assert_eq!((below.to_f64(), (-below).to_f64()), (f64::MAX, -f64::MAX));
    assert_eq!((&top + &half_step).to_f64(), f64::INFINITY);
}

/// Found: malachite's version had no small fraction for the least `i64`, the other had.
#[test]
fn both_types_have_the_same_small_fractions() -> Result<(), String> {
    fn pair<Q: RationalField>(p: &BigInt, q: &BigInt) -> Option<(i64, i64)> {
        Q::from_fraction(p.clone(), q.clone())?.small_fraction()
    }
    let least = BigInt::from(i64::MIN);
    assert_eq!(pair::<Rational>(&least, &1.into()), Some((i64::MIN, 1)));
    assert_eq!(pair::<BigRational>(&least, &1.into()), Some((i64::MIN, 1)));
    assert_eq!(pair::<Rational>(&1.into(), &least), None);
    holds((integers(), integers()), |(p, q)| {
        equal("the pair", pair::<Rational>(&p, &q), pair::<BigRational>(&p, &q))
    })
}

#[test]
fn a_fraction_is_in_lowest_terms_with_a_positive_denominator() -> Result<(), String> {
    fn check<Q: RationalField>(p: i64, q: i64) -> Result<(), proptest::test_runner::TestCaseError> {
        let Some(x) = Q::from_fraction(p.into(), q.into()) else {
            return equal("only 0 is refused", q, 0);
        };
        let gcd = gcd(p.unsigned_abs(), q.unsigned_abs()).max(1);
        let sign = i128::from(q.signum());
        let lowest = |n: i64| BigInt::from(sign * i128::from(n) / i128::from(gcd));
        equal("p", x.numerator(), lowest(p))?;
        equal("q", x.denominator(), lowest(q))?;
        let text = if x.denominator() == 1.into() {
            lowest(p).to_string()
        } else {
            format!("{}/{}", lowest(p), lowest(q))
        };
        equal("the text", x.to_string(), text)
    }
    let numbers = prop_oneof![-20i64..20, any::<i64>(), Just(i64::MIN)];
    holds((numbers.clone(), numbers), |(p, q)| {
        check::<Rational>(p, q)?;
        check::<BigRational>(p, q)
    })
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The kernels leave no common factor, also where the sizes are far apart.
#[test]
fn kernels_give_lowest_terms() -> Result<(), String> {
    holds((fractions::<BigRational>(), fractions::<BigRational>(), 0u32..200), |(a, b, k)| {
        let scale = BigRational::from_integer(BigInt::from(6).pow(k));
        let (u, v) = (&a * &scale, &b / &scale);
        let results =
            [BigRational::det2(&u, &b, &v, &a), BigRational::dot([&u, &b], [&v, &a]), u.square()];
        for fused in results {
            let reduced = BigRational::new(fused.numer().clone(), fused.denom().clone());
            equal("p", fused.numer(), reduced.numer())?;
            equal("q", fused.denom(), reduced.denom())?;
        }
        equal("a b - b a", BigRational::det2(&u, &v, &u, &v), BigRational::zero())
    })
}
