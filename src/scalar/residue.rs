//! The ring ℤ/2^(64 W): integers of which only the lowest `64 W` bits are kept.

use std::array::from_fn;

use num_bigint::BigInt;

use super::ring::ring_operators;
use super::{Ring, Sign};

/// An integer modulo `2^(64 W)`, lowest word first.
///
/// Sums and products drop what overflows, and still: an integer `r` with `|r| < 2^(64 W)` is zero
/// if and only if its residue is. So a bound on the *result* alone makes the zero test of a
/// polynomial rigorous, whatever happens to the terms on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Residue<const W: usize>(pub [u64; W]);

impl<const W: usize> Residue<W> {
    /// The sign of the integer of least size with this residue.
    #[inline]
    pub fn centred_sign(&self) -> Sign {
        if (self.0[W - 1] as i64) < 0 {
            Sign::Negative
        } else if self.0 == [0; W] {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }

    /// The integer of least size with this residue, rounded to a double within two units in the
    /// last place.
    pub fn centred_f64(&self) -> f64 {
        let negative = self.centred_sign() == Sign::Negative;
        let size = if negative { negate(self) } else { *self };
        let value = size.0.iter().rev().fold(0.0, |v, &word| v * 2f64.powi(64) + word as f64);
        if negative { -value } else { value }
    }

    /// The residue of an `i128`.
    #[inline]
    pub fn from_i128(n: i128) -> Self {
        const { assert!(W > 0, "a residue has at least one word") };
        let fill = if n < 0 { u64::MAX } else { 0 };
        let mut words = [fill; W];
        words[0] = n as u64;
        if W > 1 {
            words[1] = (n >> 64) as u64;
        }
        Residue(words)
    }

    /// The residue of an integer of any size.
    pub fn from_big(n: &BigInt) -> Self {
        let (sign, digits) = n.to_u64_digits();
        let mut words = [0; W];
        for (word, digit) in words.iter_mut().zip(digits) {
            *word = digit;
        }
        let residue = Residue(words);
        if sign == num_bigint::Sign::Minus { negate(&residue) } else { residue }
    }
}

#[inline]
fn add<const W: usize>(a: &Residue<W>, b: &Residue<W>) -> Residue<W> {
    let mut carry = false;
    Residue(from_fn(|i| {
        let (s, c1) = a.0[i].overflowing_add(b.0[i]);
        let (s, c2) = s.overflowing_add(carry as u64);
        carry = c1 | c2;
        s
    }))
}

#[inline]
fn subtract<const W: usize>(a: &Residue<W>, b: &Residue<W>) -> Residue<W> {
    let mut borrow = false;
    Residue(from_fn(|i| {
        let (d, b1) = a.0[i].overflowing_sub(b.0[i]);
        let (d, b2) = d.overflowing_sub(borrow as u64);
        borrow = b1 | b2;
        d
    }))
}

#[inline]
fn multiply<const W: usize>(a: &Residue<W>, b: &Residue<W>) -> Residue<W> {
    let mut product = [0u64; W];
    for i in 0..W {
        let mut carry = 0u64;
        for j in 0..W - i {
            let t = a.0[i] as u128 * b.0[j] as u128 + product[i + j] as u128 + carry as u128;
            product[i + j] = t as u64;
            carry = (t >> 64) as u64;
        }
    }
    Residue(product)
}

#[inline]
fn negate<const W: usize>(a: &Residue<W>) -> Residue<W> {
    subtract(&Residue([0; W]), a)
}

ring_operators!([const W: usize] Residue<W>, add, subtract, multiply, negate);

impl<const W: usize> Ring for Residue<W> {
    const EXACT: bool = true;

    #[inline]
    fn from_i64(n: i64) -> Self {
        Residue::from_i128(n.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_residue_of_a_sum_of_products_is_that_of_the_integers() {
        // Products far beyond 128 bits whose sum is small: the residue still tells 7 from 0.
        let (a, b) = (i128::MAX / 3, i128::MIN / 5);
        let r = |n| Residue::<2>::from_i128(n);
        let sum = r(a) * r(b) - r(b) * r(a) + r(7);
        assert_eq!(sum, r(7));
        assert_eq!(r(-1) * r(-1), r(1));
        assert_eq!(Residue::<3>::from_big(&BigInt::from(-5)), Residue::from_i128(-5));
    }
}
