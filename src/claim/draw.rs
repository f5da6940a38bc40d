//! Random rational numbers from a seed that is printed.

use std::fmt;
use std::str::FromStr;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use num_bigint::{BigInt, Sign};

use crate::scalar::RationalField;

/// 256 bits from which all that is random in a run follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seed([u8; 32]);

impl Seed {
    /// A seed that nobody knew before, from the operating system; from 0 where it has none to give.
    pub fn fresh() -> Self {
        let mut bytes = [0; 32];
        let _ = getrandom::fill(&mut bytes);
        Seed(bytes)
    }

    /// The seed of a number; the numbers that people type.
    pub fn of(n: u64) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&n.to_le_bytes());
        Seed(bytes)
    }

    /// 32 bytes of their own for every purpose and index, to seed another generator with.
    pub fn bytes(self, purpose: &str, index: u64) -> [u8; 32] {
        let mut bytes = [0; 32];
        self.source(purpose, index).0.fill_bytes(&mut bytes);
        bytes
    }

    /// A stream of its own for every purpose and index.
    pub(super) fn source(self, purpose: &str, index: u64) -> Source {
        // FNV-1a: which stream it is matters to nobody, only that they differ.
        let bytes = purpose.bytes().chain(index.to_le_bytes());
        let stream = bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
        let mut source = ChaCha8Rng::from_seed(self.0);
        source.set_stream(stream);
        Source(source)
    }
}

/// A number, or the 64 hexadecimal digits of a [fresh](Seed::fresh) seed.
impl FromStr for Seed {
    type Err = NoSeed;

    fn from_str(text: &str) -> Result<Self, NoSeed> {
        if let Ok(number) = text.parse() {
            return Ok(Seed::of(number));
        }
        let mut bytes = [0; 32];
        if text.len() != 64 || !text.is_ascii() {
            return Err(NoSeed);
        }
        for (n, byte) in bytes.iter_mut().rev().enumerate() {
            *byte = u8::from_str_radix(&text[2 * n..2 * n + 2], 16).map_err(|_| NoSeed)?;
        }
        Ok(Seed(bytes))
    }
}

/// The text is no seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoSeed;

impl fmt::Display for NoSeed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a seed is a number, or 64 hexadecimal digits")
    }
}

impl std::error::Error for NoSeed {}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = self.0.split_at(8);
        if high.iter().all(|b| *b == 0) {
            let number = low.iter().rev().fold(0, |n, b| n << 8 | u64::from(*b));
            return write!(f, "{number}");
        }
        self.0.iter().rev().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// A stream of random numbers.
#[derive(Debug)]
pub(super) struct Source(ChaCha8Rng);

impl Source {
    /// An integer of `0..n`; `n` is small.
    fn below(&mut self, n: u64) -> i64 {
        (self.0.next_u64() % n) as i64
    }

    /// A number of the kind on which constructions break: mostly small, often equal to another,
    /// sometimes 0, sometimes with many digits.
    pub(super) fn fraction<Q: RationalField>(&mut self) -> Q {
        match self.below(8) {
            0..=3 => Q::from_i64(self.below(9) - 4),
            4..=5 => Q::from_ratio(self.below(41) - 20, self.below(9) + 1),
            _ => Q::from_ratio(self.below(1 << 17) - (1 << 16), self.below(1 << 12) + 1),
        }
    }

    /// A small integer that is not 0.
    pub(super) fn small<Q: RationalField>(&mut self) -> Q {
        let size = self.below(5) + 1;
        Q::from_i64(if self.below(2) == 0 { size } else { -size })
    }

    /// An integer of 256 bits, each value as probable as each other.
    pub(super) fn wide<Q: RationalField>(&mut self) -> Q {
        let mut bytes = [0; 32];
        self.0.fill_bytes(&mut bytes);
        let integer = BigInt::from_bytes_le(Sign::Plus, &bytes);
        Q::from_fraction(integer, 1.into()).unwrap_or_else(Q::zero)
    }

    /// A fraction of 16 bits that is hardly ever 0: the shadow of an unknown.
    pub(super) fn shadow<Q: RationalField>(&mut self) -> Q {
        Q::from_ratio(self.below(1 << 16) + 3, 2 * self.below(64) + 1)
    }
}
