//! Integers without heap: as many words as the value needs, up to a fixed number.

use num_bigint::BigInt;

use super::ring::ring_operators;
use super::{Bounded, Ordered, Ring, Sign};

/// An integer of at most `64 W` bits, or the knowledge that one was larger.
///
/// What overflows is remembered: a result that depends on it is no integer any more, `to_big`
/// answers `None`, and the caller starts again with [`BigInt`]. So no bound has to be known
/// beforehand. The cost of an operation is that of the words in use.
///
/// ```
/// use isogeo::scalar::{BigInt, Bounded, Ring, Wide};
/// let n = Wide::<2>::from(i128::MAX);
/// assert_eq!((&n - &n * Wide::from(3)).to_big(), None); // 129 bits
/// assert_eq!((&n - Wide::from(3)).to_big(), Some(BigInt::from(i128::MAX - 3)));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wide<const W: usize> {
    /// The size, lowest word first; zero from `length` on.
    words: [u64; W],
    /// Words in use; the highest of them is not zero.
    length: usize,
    negative: bool,
    overflown: bool,
}

impl<const W: usize> From<i128> for Wide<W> {
    #[inline]
    fn from(n: i128) -> Self {
        const { assert!(W >= 2, "there is room for an i128") };
        let size = n.unsigned_abs();
        let mut words = [0; W];
        words[0] = size as u64;
        words[1] = (size >> 64) as u64;
        Wide { words, length: used(&words, 2), negative: n < 0, overflown: false }
    }
}

impl<const W: usize> Wide<W> {
    /// The integer of that sign and size, lowest word first.
    pub(super) fn from_words(negative: bool, size: &[u64]) -> Self {
        let length = used(size, size.len());
        let mut words = [0; W];
        for (word, &own) in words.iter_mut().zip(&size[..length]) {
            *word = own;
        }
        Wide { words, length: used(&words, length.min(W)), negative, overflown: length > W }
    }

    /// The same, overflown in any case if `overflown`.
    pub(super) fn or_overflown(self, overflown: bool) -> Self {
        Wide { overflown: self.overflown || overflown, ..self }
    }

    /// `self + other` or `self − other`.
    #[inline]
    fn sum(&self, other: &Self, minus: bool) -> Self {
        let other_negative = other.negative != minus;
        let mut overflown = self.overflown || other.overflown;
        let mut words = [0; W];
        if self.negative == other_negative {
            let (long, short) =
                if self.length < other.length { (other, self) } else { (self, other) };
            let (low, high) = long.words[..long.length].split_at(short.length);
            let mut carry = false;
            for ((word, &a), &b) in words.iter_mut().zip(low).zip(&short.words) {
                let (s, c1) = a.overflowing_add(b);
                let (s, c2) = s.overflowing_add(u64::from(carry));
                (*word, carry) = (s, c1 || c2);
            }
            for (word, &a) in words[short.length..].iter_mut().zip(high) {
                (*word, carry) = a.overflowing_add(u64::from(carry));
            }
            let mut length = long.length;
            if carry {
                match words.get_mut(length) {
                    Some(word) => (*word, length) = (1, length + 1),
                    None => overflown = true,
                }
            }
            return Wide { words, length, negative: self.negative, overflown };
        }
        let (large, small, negative) = if self.is_smaller_than(other) {
            (other, self, other_negative)
        } else {
            (self, other, self.negative)
        };
        let (low, high) = large.words[..large.length].split_at(small.length);
        let mut borrow = false;
        for ((word, &a), &b) in words.iter_mut().zip(low).zip(&small.words) {
            let (d, b1) = a.overflowing_sub(b);
            let (d, b2) = d.overflowing_sub(u64::from(borrow));
            (*word, borrow) = (d, b1 || b2);
        }
        for (word, &a) in words[small.length..].iter_mut().zip(high) {
            (*word, borrow) = a.overflowing_sub(u64::from(borrow));
        }
        Wide { words, length: used(&words, large.length), negative, overflown }
    }

    #[inline]
    fn is_smaller_than(&self, other: &Self) -> bool {
        if self.length != other.length {
            return self.length < other.length;
        }
        let (own, others) = (&self.words[..self.length], &other.words[..self.length]);
        own.iter().rev().lt(others.iter().rev())
    }

    #[inline]
    fn product(&self, other: &Self) -> Self {
        let mut words = [0; W];
        let mut overflown = self.overflown || other.overflown;
        let factor = &other.words[..other.length];
        for (i, &own) in self.words[..self.length].iter().enumerate() {
            let (row, mut carry) = (&mut words[i..], 0);
            for (word, &theirs) in row.iter_mut().zip(factor) {
                let t = u128::from(own) * u128::from(theirs) + u128::from(*word) + carry;
                (*word, carry) = (t as u64, t >> 64);
            }
            match row.get_mut(factor.len()) {
                Some(word) => *word = carry as u64,
                // A word that is not zero lies beyond the room.
                None => overflown |= carry != 0 || factor.len() > row.len(),
            }
        }
        let length = used(&words, (self.length + other.length).min(W));
        Wide { words, length, negative: self.negative != other.negative, overflown }
    }
}

/// The number of words up to the highest that is not zero, at most `length`.
#[inline]
fn used(words: &[u64], mut length: usize) -> usize {
    while length > 0 && words[length - 1] == 0 {
        length -= 1;
    }
    length
}

fn add<const W: usize>(a: &Wide<W>, b: &Wide<W>) -> Wide<W> {
    a.sum(b, false)
}

fn subtract<const W: usize>(a: &Wide<W>, b: &Wide<W>) -> Wide<W> {
    a.sum(b, true)
}

fn multiply<const W: usize>(a: &Wide<W>, b: &Wide<W>) -> Wide<W> {
    a.product(b)
}

fn negate<const W: usize>(a: &Wide<W>) -> Wide<W> {
    Wide { negative: !a.negative && a.length > 0, ..*a }
}

ring_operators!([const W: usize] Wide<W>, add, subtract, multiply, negate);

/// What has overflown equals nothing, not even itself.
impl<const W: usize> PartialEq for Wide<W> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        !(self.overflown || other.overflown)
            && self.length == other.length
            && self.words[..self.length] == other.words[..other.length]
            && (self.negative == other.negative || self.length == 0)
    }
}

impl<const W: usize> PartialOrd for Wide<W> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(match (self - other).certain_sign()? {
            Sign::Negative => std::cmp::Ordering::Less,
            Sign::Zero => std::cmp::Ordering::Equal,
            Sign::Positive => std::cmp::Ordering::Greater,
        })
    }
}

impl<const W: usize> Ring for Wide<W> {
    const EXACT: bool = true;

    #[inline]
    fn from_i64(n: i64) -> Self {
        i128::from(n).into()
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.length == 0 && !self.overflown
    }
}

impl<const W: usize> Bounded for Wide<W> {
    #[inline]
    fn is_overflown(&self) -> bool {
        self.overflown
    }

    fn to_big(&self) -> Option<BigInt> {
        let digits = self.words[..self.length].iter();
        let digits = digits.flat_map(|w| [*w as u32, (*w >> 32) as u32]).collect();
        let sign = if self.negative { num_bigint::Sign::Minus } else { num_bigint::Sign::Plus };
        (!self.overflown).then(|| BigInt::new(sign, digits))
    }

    fn to_wide<const V: usize>(&self) -> Wide<V> {
        Wide::from_words(self.negative, &self.words[..self.length]).or_overflown(self.overflown)
    }
}

impl<const W: usize> Ordered for Wide<W> {
    fn certain_sign(&self) -> Option<Sign> {
        (!self.overflown).then_some(match (self.length, self.negative) {
            (0, _) => Sign::Zero,
            (_, true) => Sign::Negative,
            (_, false) => Sign::Positive,
        })
    }
}
