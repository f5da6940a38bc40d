//! What was looked at, in 32 bytes that do not depend on the order.

use std::fmt;
use std::str::FromStr;

use sha2::{Digest as _, Sha256};

/// The sum, modulo 2^256, of the SHA-256 hashes of cases.
///
/// ```
/// use isogeo::campaign::Digest;
/// let [mut a, mut b] = [Digest::default(); 2];
/// for case in ["one", "two"] { a.add(&Digest::of(case.as_bytes())); }
/// for case in ["two", "one"] { b.add(&Digest::of(case.as_bytes())); }
/// assert_eq!(a, b);
/// assert_eq!(a.to_string().parse(), Ok(a));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digest([u64; 4]);

impl Digest {
    /// The hash of some bytes.
    pub fn of(bytes: &[u8]) -> Self {
        let hash: [u8; 32] = Sha256::digest(bytes).into();
        let word = |n: usize| {
            hash[8 * n..8 * n + 8].iter().rev().fold(0, |word, b| word << 8 | u64::from(*b))
        };
        Digest(std::array::from_fn(word))
    }

    /// Adds another one, modulo 2^256.
    pub fn add(&mut self, other: &Digest) {
        let mut carry = false;
        for (word, more) in self.0.iter_mut().zip(other.0) {
            let (sum, first) = word.overflowing_add(more);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            (*word, carry) = (sum, first || second);
        }
    }
}

/// 64 hexadecimal digits.
impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().rev().try_for_each(|word| write!(f, "{word:016x}"))
    }
}

impl FromStr for Digest {
    type Err = std::num::ParseIntError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let word = |n: usize| u64::from_str_radix(text.get(16 * n..16 * n + 16).unwrap_or(""), 16);
        Ok(Digest([word(3)?, word(2)?, word(1)?, word(0)?]))
    }
}
