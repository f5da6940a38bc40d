//! The fast way to decide: fractions cleared, polynomials evaluated in integers of fixed width.
//!
//! One mechanism serves all residuals. A floating-point evaluation with a rigorous error bound
//! comes first: if it excludes zero, the sign is known. Otherwise it has shown that the value is
//! *small*, smaller than its terms by some 45 bits; and a small integer is determined by its
//! lowest bits. So the polynomial is evaluated once more modulo 2^128, 2^192, ..., as few words as
//! the bound asks for, and the residue *is* the value.

use num_bigint::BigInt;

use super::residual::{Residual, RootSum};
use crate::scalar::{Approx, Ball, Magnitude, Ordered, Residue, Ring, Sign, ratio_to_f64};
use crate::space::Point;

/// Integers that cleared coordinates are kept in.
pub(super) trait Integer: Clone {
    fn ball(&self) -> Ball<f64>;
    fn residue<const W: usize>(&self) -> Residue<W>;
    fn big(&self) -> BigInt;
    fn bits(&self) -> u64;
    /// The integer over 2^bits, which is larger.
    fn ball_over(&self, bits: u64) -> Ball<f64>;
    fn minus(&self, other: &Self) -> Self;
}

impl Integer for i128 {
    #[inline]
    fn ball(&self) -> Ball<f64> {
        let mid = *self as f64;
        // Integers of up to 53 bits are exact in f64.
        let radius = if mid.abs() < (1u64 << 53) as f64 { 0.0 } else { mid.abs() * f64::EPSILON };
        Ball { mid, radius }
    }

    #[inline]
    fn residue<const W: usize>(&self) -> Residue<W> {
        Residue::from_i128(*self)
    }

    fn big(&self) -> BigInt {
        BigInt::from(*self)
    }

    fn bits(&self) -> u64 {
        u64::from(i128::BITS - self.unsigned_abs().leading_zeros())
    }

    /// Exact, as only the exponent changes.
    fn ball_over(&self, bits: u64) -> Ball<f64> {
        let Ball { mid, radius } = self.ball();
        let scale = f64::powi(0.5, bits.min(127) as i32);
        Ball { mid: mid * scale, radius: radius * scale }
    }

    /// Coordinates have at most 126 bits, so nothing overflows.
    #[inline]
    fn minus(&self, other: &i128) -> i128 {
        self.wrapping_sub(*other)
    }
}

impl Integer for BigInt {
    fn ball(&self) -> Ball<f64> {
        let mid = self.to_f64();
        Ball { mid, radius: mid.abs() * 2.0 * f64::EPSILON }
    }

    fn residue<const W: usize>(&self) -> Residue<W> {
        Residue::from_big(self)
    }

    fn big(&self) -> BigInt {
        self.clone()
    }

    fn bits(&self) -> u64 {
        self.bits()
    }

    /// Its first 64 bits.
    fn ball_over(&self, bits: u64) -> Ball<f64> {
        let cut = self.bits().saturating_sub(64);
        let exponent = bits.saturating_sub(cut);
        if exponent > 900 {
            return Ball { mid: 0.0, radius: f64::powi(0.5, 800) };
        }
        let mid = (self >> cut).to_f64() * f64::powi(0.5, exponent as i32);
        Ball { mid, radius: mid.abs() * 2.0 * f64::EPSILON }
    }

    fn minus(&self, other: &BigInt) -> BigInt {
        self - other
    }
}

/// The points of one element as integers, with the integer that stands for the length 1.
pub(super) struct Cleared<I, const K: usize> {
    pub points: [Point<I>; K],
    /// Further places; the value of a residual is the sum over all.
    pub more: Vec<[Point<I>; K]>,
    pub unit: I,
}

impl<I: Integer, const K: usize> Cleared<I, K> {
    /// Moves the first point of each block to the origin.
    #[inline]
    pub fn translated(mut self, block: usize) -> Self {
        for points in std::iter::once(&mut self.points).chain(&mut self.more) {
            for start in (0..K).step_by(block.max(1)) {
                let o = points[start].clone();
                for p in points.iter_mut().skip(start).take(block) {
                    *p = Point::new(p.x.minus(&o.x), p.y.minus(&o.y), p.z.minus(&o.z));
                }
            }
        }
        self
    }

    /// All places.
    pub fn places(&self) -> impl Iterator<Item = &[Point<I>; K]> {
        std::iter::once(&self.points).chain(&self.more)
    }

    #[inline]
    pub fn over<R>(&self, f: impl Fn(&I) -> R) -> ([Point<R>; K], R) {
        (std::array::from_fn(|i| self.points[i].map(&f)), f(&self.unit))
    }

    #[inline]
    fn eval<R: Ring>(&self, residual: impl Residual<K>, f: impl Fn(&I) -> R) -> R {
        let (points, unit) = self.over(&f);
        self.more.iter().fold(residual.eval(&points, &unit), |sum, place| {
            sum + residual.eval(&std::array::from_fn(|i| place[i].map(&f)), &unit)
        })
    }

    /// The points divided by a power of 2, so that their coordinates are at most 1.
    pub fn scaled(&self) -> [Point<Ball<f64>>; K] {
        let largest = self.largest();
        self.points.each_ref().map(|p| p.map(|i| i.ball_over(largest)))
    }

    /// The number of bits of the largest coordinate.
    fn largest(&self) -> u64 {
        self.points.iter().flat_map(|p| p.coordinates()).map(I::bits).max().unwrap_or(0)
    }

    /// The exact sign of the residual.
    #[inline]
    pub fn sign(&self, residual: impl Residual<K>) -> Sign {
        let ball = self.eval(residual, I::ball);
        match ball.certain_sign() {
            Some(sign) => sign,
            None => self.exact(residual, ball.bound()).0,
        }
    }

    /// `|residual| / scale` where the scale is the residual with every sign taken positive.
    pub fn defect(&self, residual: impl Residual<K>) -> f64 {
        let value = self.value(residual).abs();
        let scale = self.eval(residual, |i| Magnitude::of(&i.ball().mid)).0;
        if scale.is_normal() && value.is_normal() {
            return value / scale;
        }
        // Beyond the range of doubles: the same in integers.
        let value = self.eval(residual, I::big);
        let scale = self.eval(residual, |i| Magnitude::of(&i.big())).0;
        if value.is_zero() { 0.0 } else { ratio_to_f64(&value, &scale).abs() }
    }

    /// The same for a sum of roots, in doubles; coordinates are divided by the largest first.
    pub fn root_defect<const TERMS: usize>(&self, sum: impl RootSum<K, TERMS>) -> f64 {
        let unit = BigInt::one() << self.largest();
        let (points, _) = self.over(|i| ratio_to_f64(&i.big(), &unit));
        let value: f64 = sum.eval(&points).iter().map(|(c, q)| c * q.sqrt()).sum();
        let sizes = points.map(|p| p.map(Magnitude::of));
        let scale: f64 = sum.eval(&sizes).iter().map(|(c, q)| c.0 * q.0.sqrt()).sum();
        if value == 0.0 { 0.0 } else { value.abs() / scale }
    }

    /// The exact residual, rounded to a double within a few units in the last place.
    pub fn value(&self, residual: impl Residual<K>) -> f64 {
        self.exact(residual, self.eval(residual, I::ball).bound()).1
    }

    /// Sign and rounded value of the residual, which is known to be at most `bound` in size.
    fn exact(&self, residual: impl Residual<K>, bound: f64) -> (Sign, f64) {
        const WORDS_2: f64 = (1u128 << 126) as f64;
        const WORDS_3: f64 = WORDS_2 * (1u128 << 64) as f64;
        const WORDS_4: f64 = WORDS_3 * (1u128 << 64) as f64;
        const WORDS_8: f64 = WORDS_4 * WORDS_4 * 4.0;
        if bound < WORDS_2 {
            self.in_words::<2>(residual)
        } else if bound < WORDS_3 {
            self.in_words::<3>(residual)
        } else if bound < WORDS_4 {
            self.in_words::<4>(residual)
        } else if bound < WORDS_8 {
            self.in_words::<8>(residual)
        } else {
            let value = self.eval(residual, I::big);
            (value.certain_sign().unwrap_or(Sign::Zero), value.to_f64())
        }
    }

    #[inline]
    fn in_words<const W: usize>(&self, residual: impl Residual<K>) -> (Sign, f64) {
        let residue = self.eval(residual, I::residue::<W>);
        (residue.centred_sign(), residue.centred_f64())
    }
}
