//! Arithmetic modulo primes just below 2^62, in Montgomery's form.

use num_bigint::{BigInt, Sign};

/// A prime below 2^62 with the constants of Montgomery's reduction.
///
/// A class `n` is kept as `n · 2^64 mod p`; sums and products of such numbers cost a few machine
/// instructions and no division (P. Montgomery, *Modular multiplication without trial division*,
/// 1985).
#[derive(Clone, Copy, Debug)]
pub(super) struct Modulus {
    prime: u64,
    /// `−1 / p` modulo 2^64.
    negative_inverse: u64,
    /// `2^128 mod p`: the form of 2^64.
    shift: u64,
}

impl Modulus {
    /// The constants of an odd `p < 2^62`.
    pub fn new(prime: u64) -> Self {
        // Newton: each step doubles the number of correct bits, from 3 to 96.
        let inverse =
            (0..5).fold(prime, |x, _| x.wrapping_mul(2u64.wrapping_sub(prime.wrapping_mul(x))));
        let shift = ((u128::MAX % u128::from(prime) + 1) % u128::from(prime)) as u64;
        Modulus { prime, negative_inverse: inverse.wrapping_neg(), shift }
    }

    pub fn prime(&self) -> u64 {
        self.prime
    }

    /// `t / 2^64 mod p` for `t < 2^64 p`.
    #[inline]
    fn reduce(&self, t: u128) -> u64 {
        let multiple = (t as u64).wrapping_mul(self.negative_inverse);
        let sum = (t + u128::from(multiple) * u128::from(self.prime)) >> 64;
        self.once(sum as u64)
    }

    /// Subtracts `p` where a number below `2p` reaches it.
    #[inline]
    fn once(&self, n: u64) -> u64 {
        if n >= self.prime { n - self.prime } else { n }
    }

    #[inline]
    pub fn add(&self, a: u64, b: u64) -> u64 {
        self.once(a + b)
    }

    #[inline]
    pub fn negate(&self, a: u64) -> u64 {
        self.once(self.prime - a)
    }

    #[inline]
    pub fn multiply(&self, a: u64, b: u64) -> u64 {
        self.reduce(u128::from(a) * u128::from(b))
    }

    /// The class of an unsigned integer.
    #[inline]
    pub fn class(&self, n: u64) -> u64 {
        self.multiply(n, self.shift)
    }

    /// The class of an integer of any size.
    pub fn class_of(&self, n: &BigInt) -> u64 {
        let digits = n.iter_u64_digits().rev();
        let size = digits.fold(0, |sum, d| self.add(self.multiply(sum, self.shift), self.class(d)));
        if n.sign() == Sign::Minus { self.negate(size) } else { size }
    }

    /// The representative in `0..p` of a class.
    #[inline]
    pub fn value(&self, class: u64) -> u64 {
        self.reduce(class.into())
    }

    fn power(&self, base: u64, exponent: u64) -> u64 {
        let bits = (0..u64::BITS - exponent.leading_zeros()).rev();
        bits.fold(self.class(1), |power, bit| {
            let square = self.multiply(power, power);
            if exponent >> bit & 1 == 1 { self.multiply(square, base) } else { square }
        })
    }

    /// `1 / a` for a class that is not 0 (Fermat: `a^(p−2)`).
    pub fn inverse(&self, a: u64) -> u64 {
        self.power(a, self.prime - 2)
    }

    /// Whether the modulus is prime: Miller and Rabin's test to the first twelve prime bases,
    /// which decides below 3.3 · 10^24 (J. Sorenson, J. Webster, 2015).
    fn is_prime(&self) -> bool {
        let (one, minus_one) = (self.class(1), self.negate(self.class(1)));
        let twos = (self.prime - 1).trailing_zeros();
        [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37].into_iter().all(|base| {
            let mut x = self.power(self.class(base), (self.prime - 1) >> twos);
            x == one
                || (0..twos).any(|_| {
                    let found = x == minus_one;
                    x = self.multiply(x, x);
                    found
                })
        })
    }
}

/// The primes below 2^62, downwards: always the same list.
pub(super) fn primes() -> impl Iterator<Item = Modulus> + Send {
    let odd = (0..).map(|i| (1u64 << 62) - 1 - 2 * i).take_while(|&n| n > 1 << 61);
    odd.map(Modulus::new).filter(Modulus::is_prime)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first primes below 2^62 are 2^62 − 57, − 87, − 117, ... (tables of primes near powers
    /// of two).
    #[test]
    fn the_list_begins_as_in_the_tables() {
        let gaps: Vec<u64> = primes().take(4).map(|m| (1 << 62) - m.prime()).collect();
        assert_eq!(gaps, [57, 87, 117, 143]);
    }

    #[test]
    fn arithmetic_agrees_with_the_division_of_machine_integers() {
        let mut seed = 1u64;
        for m in primes().take(3) {
            for _ in 0..200 {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
                let (a, b) = (seed, seed.rotate_left(31));
                let p = u128::from(m.prime());
                let (x, y) = (m.class(a), m.class(b));
                let expect = |n: u128| (n % p) as u64;
                assert_eq!(m.value(m.multiply(x, y)), expect(u128::from(a) % p * u128::from(b)));
                assert_eq!(m.value(m.add(x, y)), expect(u128::from(a) + u128::from(b)));
                assert_eq!(m.value(m.multiply(x, m.inverse(x))), 1);
                let long = (BigInt::from(a) << 64) + BigInt::from(b);
                let wide = (u128::from(a) << 64) + u128::from(b);
                assert_eq!(m.value(m.class_of(&long)), expect(wide));
                assert_eq!(m.add(m.class_of(&-long), expect(0)), m.negate(m.class(expect(wide))));
            }
        }
    }
}
