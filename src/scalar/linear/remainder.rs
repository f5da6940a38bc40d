//! From residues back to fractions: Chinese remainders and rational reconstruction.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::modular::Modulus;

/// What Chinese remaindering over a list of primes needs to know once.
pub(super) struct Chinese {
    /// `1 / (M / p)` modulo each prime `p`, in Montgomery's form.
    weights: Vec<(Modulus, u64)>,
    /// Products of neighbours: primes, pairs, fours, ...; the last one is `M` alone.
    levels: Vec<Vec<BigInt>>,
}

impl Chinese {
    pub fn new(moduli: &[Modulus]) -> Self {
        let weight = |m: &Modulus| {
            let others = moduli.iter().filter(|o| o.prime() != m.prime());
            m.inverse(others.fold(m.class(1), |w, o| m.multiply(w, m.class(o.prime()))))
        };
        let weights = moduli.iter().map(|m| (*m, weight(m))).collect();
        let mut levels: Vec<Vec<BigInt>> = vec![moduli.iter().map(|m| m.prime().into()).collect()];
        while let Some(last) = levels.last().filter(|l| l.len() > 1) {
            levels.push(last.chunks(2).map(|pair| pair.iter().product()).collect());
        }
        Chinese { weights, levels }
    }

    /// The product `M` of the primes.
    pub fn modulus(&self) -> BigInt {
        self.levels.last().and_then(|l| l.first()).cloned().unwrap_or_else(BigInt::one)
    }

    /// The `x` in `0..M` with the given classes: `Σ (cᵢ wᵢ mod pᵢ) M / pᵢ`, summed by a tree.
    pub fn combine(&self, classes: impl Iterator<Item = u64>) -> BigInt {
        let terms = classes.zip(&self.weights);
        let mut sums: Vec<BigInt> =
            terms.map(|(c, (m, w))| m.value(m.multiply(c, *w)).into()).collect();
        for products in &self.levels {
            if sums.len() < 2 {
                break;
            }
            let pairs = sums.chunks(2).zip(products.chunks(2));
            sums = pairs
                .map(|pair| match pair {
                    ([a, b], [p, q]) => a * q + b * p,
                    (sums, _) => sums[0].clone(),
                })
                .collect();
        }
        sums.pop().map_or_else(BigInt::zero, |sum| sum.mod_floor(&self.modulus()))
    }
}

/// Fractions over a common denominator that is found on the way.
pub(super) struct Reconstruction {
    modulus: BigInt,
    pub denominator: BigInt,
}

/// How many bits a fraction must be shorter than the modulus to be believed for the time being.
const SLACK: u64 = 40;

impl Reconstruction {
    pub fn new(modulus: BigInt) -> Self {
        Reconstruction { modulus, denominator: BigInt::one() }
    }

    /// The numerator `n` of `x = n / denominator` modulo `M`, after the denominator has been
    /// multiplied by what is missing; `None` where no fraction is short enough.
    ///
    /// Mostly the denominator found so far serves again. Otherwise the fraction is the one of P. Wang, M. Guy and J. Davenport, *P-adic reconstruction of
    /// rational numbers* (1982): the first remainder of Euclid's algorithm on `(M, x)` below the
    /// square root.
    pub fn numerator(&mut self, x: &BigInt) -> Option<BigInt> {
        let y = self.centred(x * &self.denominator);
        let bits = self.modulus.bits().checked_sub(SLACK + self.denominator.bits())?;
        if y.bits() <= bits {
            return Some(y);
        }
        let bound = BigInt::one() << (bits / 2);
        let (mut a, mut b) = (self.modulus.clone(), y.mod_floor(&self.modulus));
        let (mut s, mut t) = (BigInt::zero(), BigInt::one());
        while b > bound {
            let (quotient, rest) = a.div_rem(&b);
            a = std::mem::replace(&mut b, rest);
            let next = s - quotient * &t;
            s = std::mem::replace(&mut t, next);
        }
        if t.is_zero() || t.abs() > bound {
            return None;
        }
        if t.is_negative() {
            (b, t) = (-b, -t);
        }
        self.denominator *= t;
        Some(b)
    }

    /// The representative between `−M/2` and `M/2`.
    fn centred(&self, x: BigInt) -> BigInt {
        let x = x.mod_floor(&self.modulus);
        if &x + &x > self.modulus { x - &self.modulus } else { x }
    }
}
