//! Sparse polynomials with integer coefficients in up to 64 unknowns.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};
use std::fmt;

use num_integer::Integer;

use super::NodeId;
use crate::scalar::Ring;

/// The number of unknowns that a [`Polynomial`] may have.
const UNKNOWNS: usize = 64;

/// How many terms a polynomial may have before the normal form is given up.
const TERMS: usize = 1 << 19;

/// The exponents of the unknowns; ordered lexicographically.
type Monomial = [u8; UNKNOWNS];

/// A polynomial in unknowns `x0, x1, …` over ℤ: terms in falling lexicographic order, none zero.
///
/// Coefficients have 127 bits, exponents 8; what does not fit is refused, never rounded.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Polynomial {
    terms: Vec<(Monomial, i128)>,
}

/// Why there is no normal form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TooLarge {
    /// More than 64 unknowns.
    Unknowns,
    /// A coefficient beyond 127 bits.
    Coefficient,
    /// An exponent beyond 255.
    Exponent,
    /// More than half a million terms.
    Terms,
    /// A divisor is the zero function: the recorded code divided by zero.
    ZeroDivisor(NodeId),
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TooLarge::Unknowns => write!(f, "more than {UNKNOWNS} unknowns"),
            TooLarge::Coefficient => write!(f, "a coefficient beyond 127 bits"),
            TooLarge::Exponent => write!(f, "an exponent beyond 255"),
            TooLarge::Terms => write!(f, "more than {TERMS} terms"),
            TooLarge::ZeroDivisor(_) => write!(f, "a division by the zero function"),
        }
    }
}

impl std::error::Error for TooLarge {}

fn divides(a: &Monomial, b: &Monomial) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b)
}

fn quotient(b: &Monomial, a: &Monomial) -> Monomial {
    std::array::from_fn(|i| b[i] - a[i])
}

fn product(a: &Monomial, b: &Monomial) -> Result<Monomial, TooLarge> {
    let mut sum = [0; UNKNOWNS];
    let mut carry = false;
    for i in 0..UNKNOWNS {
        let (s, overflown) = a[i].overflowing_add(b[i]);
        sum[i] = s;
        carry |= overflown;
    }
    if carry { Err(TooLarge::Exponent) } else { Ok(sum) }
}

fn times(a: i128, b: i128) -> Result<i128, TooLarge> {
    a.checked_mul(b).ok_or(TooLarge::Coefficient)
}

/// The image of an integer of 127 bits.
pub(super) fn integer<T: Ring>(n: i128) -> T {
    const HALF: i128 = 1 << 42;
    let shift = T::from_i64(HALF as i64);
    let digit = |d: i128| T::from_i64(d as i64);
    (digit(n / HALF / HALF) * &shift + digit(n / HALF % HALF)) * &shift + digit(n % HALF)
}

impl Polynomial {
    /// A constant.
    pub fn constant(n: i128) -> Self {
        Polynomial { terms: if n == 0 { Vec::new() } else { vec![([0; UNKNOWNS], n)] } }
    }

    /// The unknown `x_n`.
    ///
    /// # Errors
    /// [`TooLarge::Unknowns`] beyond the last.
    pub fn unknown(n: usize) -> Result<Self, TooLarge> {
        let mut monomial = [0; UNKNOWNS];
        *monomial.get_mut(n).ok_or(TooLarge::Unknowns)? = 1;
        Ok(Polynomial { terms: vec![(monomial, 1)] })
    }

    /// The unknowns that divide it.
    pub fn common_unknowns(&self) -> Vec<Polynomial> {
        let common = |n: &usize| self.terms.iter().all(|(m, _)| m[*n] > 0);
        (0..UNKNOWNS).filter(common).filter_map(|n| Polynomial::unknown(n).ok()).collect()
    }

    /// Whether it is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value, if it has no unknown.
    pub fn as_constant(&self) -> Option<i128> {
        match self.terms.as_slice() {
            [] => Some(0),
            [(monomial, n)] if *monomial == [0; UNKNOWNS] => Some(*n),
            _ => None,
        }
    }

    /// The number of its terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it has no term: [`is_zero`](Self::is_zero).
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The greatest total degree of a term; 0 for constants.
    pub fn degree(&self) -> u32 {
        let degree = |(m, _): &(Monomial, i128)| m.iter().map(|&e| u32::from(e)).sum();
        self.terms.iter().map(degree).max().unwrap_or(0)
    }

    /// Its value; unknowns that are not given are 0.
    pub fn evaluate<T: Ring>(&self, unknowns: &[T]) -> T {
        self.terms.iter().fold(T::zero(), |sum, (monomial, c)| {
            let powers = unknowns.iter().zip(monomial);
            let term = powers.fold(integer::<T>(*c), |product, (x, &exponent)| {
                (0..exponent).fold(product, |product, _| product * x)
            });
            sum + term
        })
    }

    /// The greatest common divisor of the coefficients, with the sign of the first; 0 for 0.
    pub fn content(&self) -> i128 {
        let gcd = self.terms.iter().fold(0, |gcd: i128, (_, c)| gcd.gcd(c));
        match self.terms.first() {
            Some((_, first)) if *first < 0 => -gcd,
            _ => gcd,
        }
    }

    /// All coefficients divided by a number that divides them.
    pub fn divided(mut self, by: i128) -> Self {
        self.terms.iter_mut().for_each(|(_, c)| *c /= by);
        self
    }

    /// `n` times the polynomial.
    pub fn scaled(&self, n: i128) -> Result<Self, TooLarge> {
        if n == 0 {
            return Ok(Polynomial::default());
        }
        let terms = self.terms.iter().map(|(m, c)| Ok((*m, times(*c, n)?)));
        Ok(Polynomial { terms: terms.collect::<Result<_, _>>()? })
    }

    /// `self + other`.
    pub fn plus(&self, other: &Self) -> Result<Self, TooLarge> {
        let (mut a, mut b) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        let mut terms = Vec::with_capacity(self.len() + other.len());
        while let (Some((m, c)), Some((n, d))) = (a.peek(), b.peek()) {
            match m.cmp(n) {
                Ordering::Greater => terms.extend(a.next()),
                Ordering::Less => terms.extend(b.next()),
                Ordering::Equal => {
                    let sum = c.checked_add(*d).ok_or(TooLarge::Coefficient)?;
                    if sum != 0 {
                        terms.push((*m, sum));
                    }
                    a.next();
                    b.next();
                }
            }
        }
        terms.extend(a.chain(b));
        Ok(Polynomial { terms })
    }

    /// `self · other`.
    pub fn product(&self, other: &Self) -> Result<Self, TooLarge> {
        if let Some(n) = other.as_constant() {
            return self.scaled(n);
        }
        let mut sums: HashMap<Monomial, i128> = HashMap::new();
        for (m, c) in &self.terms {
            for (n, d) in &other.terms {
                let sum = sums.entry(product(m, n)?).or_insert(0);
                *sum = sum.checked_add(times(*c, *d)?).ok_or(TooLarge::Coefficient)?;
            }
            if sums.len() > TERMS {
                return Err(TooLarge::Terms);
            }
        }
        let mut terms: Vec<_> = sums.into_iter().filter(|(_, c)| *c != 0).collect();
        terms.sort_unstable_by_key(|(m, _)| std::cmp::Reverse(*m));
        Ok(Polynomial { terms })
    }

    /// `self / divisor` where that is a polynomial over ℤ, else `None`; the divisor is not 0.
    pub fn exact_quotient(&self, divisor: &Self) -> Result<Option<Self>, TooLarge> {
        let [(first, leading), .., (last, _)] = divisor.terms.as_slice() else {
            let Some((monomial, c)) = divisor.terms.first() else { return Ok(None) };
            let divisible = |(m, d): &(Monomial, i128)| divides(monomial, m) && d % c == 0;
            return Ok(self.terms.iter().all(divisible).then(|| {
                let terms = self.terms.iter().map(|(m, d)| (quotient(m, monomial), d / c));
                Polynomial { terms: terms.collect() }
            }));
        };
        // Both ends of a product are products of ends.
        let (Some((high, _)), Some((low, _))) = (self.terms.first(), self.terms.last()) else {
            return Ok(Some(Polynomial::default()));
        };
        if !divides(first, high) || !divides(last, low) || self.len() < 2 {
            return Ok(None);
        }
        let mut rest: BTreeMap<Monomial, i128> = self.terms.iter().copied().collect();
        let mut terms = Vec::new();
        while let Some((monomial, c)) = rest.pop_last() {
            if !divides(first, &monomial) || c % leading != 0 {
                return Ok(None);
            }
            let (shift, factor) = (quotient(&monomial, first), c / leading);
            for (m, d) in &divisor.terms[1..] {
                let m = product(m, &shift)?;
                let less = times(*d, factor)?;
                let entry = rest.entry(m).or_insert(0);
                *entry = entry.checked_sub(less).ok_or(TooLarge::Coefficient)?;
                if *entry == 0 {
                    rest.remove(&m);
                }
            }
            terms.push((shift, factor));
        }
        Ok(Some(Polynomial { terms }))
    }
}

/// As in `2 x0^2 x3 - x1 + 5`.
impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return write!(f, "0");
        }
        for (n, (monomial, c)) in self.terms.iter().enumerate() {
            let sign = match (n, *c < 0) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            let mut factors = Vec::new();
            if c.unsigned_abs() != 1 || *monomial == [0; UNKNOWNS] {
                factors.push(c.unsigned_abs().to_string());
            }
            for (i, e) in monomial.iter().enumerate().filter(|(_, e)| **e > 0) {
                factors.push(if *e == 1 { format!("x{i}") } else { format!("x{i}^{e}") });
            }
            write!(f, "{sign}{}", factors.join(" "))?;
        }
        Ok(())
    }
}
