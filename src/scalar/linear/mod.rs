//! Linear systems over ℚ with few entries in a row: exact rank, kernel and solutions.
//!
//! Gauss on fractions explodes: the numbers grow at every step, needed or not. Here elimination
//! runs modulo primes just below 2^62, in machine words, along pivots that create few new entries;
//! only the results are carried back to ℚ, and every result is *proved* on the integers:
//!
//! - a minor that is not 0 modulo a prime is not 0: the rank is at least the number of pivots;
//! - a rational vector that solves all equations, checked exactly, is in the kernel; and a rational
//!   combination of pivot rows that equals another row, checked exactly, makes it dependent. Either
//!   bounds the rank from above, and nothing is needed where all rows or all columns have a pivot.
//!
//! A prime that is unlucky costs time, never truth.

mod lift;
mod modular;
mod remainder;
mod sparse;

use std::collections::BTreeMap;
use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use rayon::prelude::*;

use super::RationalField;
use lift::{IntegerRow, Lifter, RationalVector, row_modulo};
use modular::primes;
use sparse::{Matrix, Pivot};

/// A homogeneous system `A x = 0` with rational coefficients, kept by its entries that are not 0.
///
/// ```
/// use isogeo::scalar::{LinearSystem, Rational, Ring};
/// let q = |n| Rational::from_i64(n);
/// let mut system = LinearSystem::new(3);
/// system.push([(0, q(2)), (1, q(-1))])?; // 2 x = y
/// system.push([(1, q(3)), (2, q(-1))])?; // 3 y = z
/// let solved = system.eliminate();
/// assert_eq!((solved.rank(), solved.nullity()), (2, 1));
/// let x: Vec<Rational> = solved.kernel().remove(0);
/// assert_eq!(&x[2] / &x[0], q(6));
/// # Ok::<(), isogeo::scalar::NoSuchUnknown>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct LinearSystem {
    unknowns: usize,
    rows: Vec<IntegerRow>,
    /// `p / q` for each row: what the given row was multiplied by to become one of integers.
    factors: Vec<(BigInt, BigInt)>,
}

/// A coefficient for an unknown that the system does not have, or a list of values of another
/// length than the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoSuchUnknown {
    /// The index, counted from 0, or the length.
    pub index: usize,
    /// What it must be below, or equal to.
    pub limit: usize,
}

impl fmt::Display for NoSuchUnknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "index {} in a linear system of size {}", self.index, self.limit)
    }
}

impl std::error::Error for NoSuchUnknown {}

impl LinearSystem {
    /// The system without equations in so many unknowns (at most 2^32 − 1).
    pub fn new(unknowns: usize) -> Self {
        LinearSystem { unknowns: unknowns.min(u32::MAX as usize), ..Self::default() }
    }

    /// Adds the equation `Σ aⱼ x[j] = 0` with the entries `(j, aⱼ)`, in any order; entries for the
    /// same unknown are added. The equation is stored over the integers, without common factor.
    ///
    /// # Errors
    /// Where an index is not below the number of unknowns; the system is then as before.
    pub fn push<T: RationalField>(
        &mut self,
        entries: impl IntoIterator<Item = (usize, T)>,
    ) -> Result<(), NoSuchUnknown> {
        let mut sums: BTreeMap<usize, T> = BTreeMap::new();
        for (index, a) in entries {
            if index >= self.unknowns {
                return Err(NoSuchUnknown { index, limit: self.unknowns });
            }
            *sums.entry(index).or_insert_with(T::zero) += &a;
        }
        sums.retain(|_, a| !a.is_zero());
        let common = sums.values().fold(BigInt::one(), |l, a| l.lcm(&a.denominator()));
        let cleared = |a: &T| a.numerator() * (&common / a.denominator());
        let mut row: IntegerRow = sums.iter().map(|(&c, a)| (c as u32, cleared(a))).collect();
        let content = row.iter().fold(BigInt::zero(), |g, (_, a)| g.gcd(a));
        if content.is_zero() {
            self.factors.push((BigInt::one(), BigInt::one()));
        } else {
            row.iter_mut().for_each(|(_, a)| *a /= &content);
            self.factors.push((common, content));
        }
        self.rows.push(row);
        Ok(())
    }

    /// The number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// The number of equations, those without entries included.
    pub fn equations(&self) -> usize {
        self.rows.len()
    }

    /// Whether `x` solves all equations, exactly; missing values count as 0.
    pub fn is_solved_by<T: RationalField>(&self, x: &[T]) -> bool {
        self.rows.iter().all(|row| {
            let product = |(c, a): &(u32, BigInt)| {
                let x = x.get(*c as usize).filter(|x| !x.is_zero())?;
                T::from_fraction(a.clone(), BigInt::one()).map(|a| a * x)
            };
            let sum = row.iter().filter_map(product).fold(T::zero(), |sum, term| sum + term);
            sum.is_zero()
        })
    }

    /// The rank, proved, and which unknowns determine the others.
    ///
    /// One elimination modulo one prime where the equations are independent; otherwise the smaller
    /// of two proofs: the kernel, or the combinations for the dependent equations, both over ℚ (see
    /// [`Echelon::kernel`] for their cost).
    pub fn eliminate(&self) -> Echelon<'_> {
        let equations = self.rows.iter().filter(|row| !row.is_empty()).count();
        let mut pivots = Vec::new();
        for modulus in primes() {
            let rows = self.rows.iter().map(|row| row_modulo(row, &modulus)).collect();
            pivots = Matrix::new(modulus, self.unknowns, rows).pivots();
            if pivots.len() == equations || self.rank_is_at_most(&pivots) {
                break;
            }
        }
        let mut is_free = vec![true; self.unknowns];
        pivots.iter().for_each(|p| is_free[p.column as usize] = false);
        let free = (0..self.unknowns).filter(|&c| is_free[c]).collect();
        let lifter = Lifter::new(&self.rows, self.unknowns, &pivots);
        Echelon { system: self, pivots, free, lifter }
    }

    /// Proves that the rank is no larger than the number of pivots, or finds that it is.
    fn rank_is_at_most(&self, pivots: &[Pivot]) -> bool {
        let mut columns: Vec<IntegerRow> = vec![Vec::new(); self.unknowns];
        for (r, row) in self.rows.iter().enumerate() {
            for (c, a) in row {
                columns[*c as usize].push((r as u32, a.clone()));
            }
        }
        let swapped: Vec<Pivot> =
            pivots.iter().map(|p| Pivot { row: p.column, column: p.row }).collect();
        let others = |rows: &[IntegerRow], pivots: &[Pivot]| {
            let mut other: Vec<bool> = rows.iter().map(|row| !row.is_empty()).collect();
            pivots.iter().for_each(|p| other[p.row as usize] = false);
            (0..rows.len() as u32).filter(|&r| other[r as usize]).collect::<Vec<u32>>()
        };
        let (dependent, free) = (others(&self.rows, pivots), others(&columns, &swapped));
        let (rows, lines, pivots, wanted) = if free.len() <= dependent.len() {
            (&self.rows, self.unknowns, pivots, free)
        } else {
            (&columns, self.rows.len(), swapped.as_slice(), dependent)
        };
        let lifter = Lifter::new(rows, lines, pivots);
        wanted.par_iter().all(|&line| {
            let vector = lifter.vector(line);
            rows.iter().all(|row| vector.solves(row))
        })
    }
}

/// A system after elimination: its rank, and its solutions as far as they are asked for.
pub struct Echelon<'a> {
    system: &'a LinearSystem,
    pivots: Vec<Pivot>,
    free: Vec<usize>,
    lifter: Lifter<'a>,
}

impl Echelon<'_> {
    /// The rank of the system, exactly.
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// The dimension of the space of solutions: unknowns − rank.
    pub fn nullity(&self) -> usize {
        self.free.len()
    }

    /// The unknowns that determine all others, in increasing order: parameters of the solutions.
    /// They are chosen for short computations, not as the last possible ones.
    pub fn free_unknowns(&self) -> &[usize] {
        &self.free
    }

    /// The pairs (equation, unknown) of the pivots in the order of elimination: each equation
    /// determines its unknown from free unknowns and later pivots.
    pub fn pivots(&self) -> impl ExactSizeIterator<Item = (usize, usize)> + '_ {
        self.pivots.iter().map(|p| (p.row as usize, p.column as usize))
    }

    /// The solution that is 1 in the `k`-th free unknown and 0 in the other free ones.
    ///
    /// # Errors
    /// Where `k` is not below the [`nullity`](Self::nullity).
    pub fn kernel_vector<T: RationalField>(&self, k: usize) -> Result<Vec<T>, NoSuchUnknown> {
        let free = self.free.get(k).ok_or(NoSuchUnknown { index: k, limit: self.free.len() })?;
        Ok(dense(&self.lifter.vector(*free as u32), self.system.unknowns))
    }

    /// The basis of the solutions that is the identity matrix in the free unknowns: the reduced
    /// echelon form of the kernel, in the order of [`free_unknowns`](Self::free_unknowns).
    ///
    /// With `e` entries after elimination, `k` vectors and numbers of at most `b` bits it takes
    /// `O(b)` primes, `O(e b)` word operations for each vector, and `O(b²)` for each entry of a
    /// vector that is not 0: no more, up to a constant, than schoolbook arithmetic on the answer.
    /// The answer itself may be large; [`kernel_vector`](Self::kernel_vector) gives it piecewise.
    pub fn kernel<T: RationalField>(&self) -> Vec<Vec<T>> {
        let vector = |free: &usize| dense(&self.lifter.vector(*free as u32), self.system.unknowns);
        self.free.par_iter().map(vector).collect()
    }

    /// The solution of `A x = b` with all free unknowns 0; `None` where there is no solution.
    ///
    /// # Errors
    /// Where `b` has not one value for every equation.
    pub fn solve<T: RationalField>(&self, b: &[T]) -> Result<Option<Vec<T>>, NoSuchUnknown> {
        let LinearSystem { unknowns, rows, factors } = self.system;
        if b.len() != rows.len() {
            return Err(NoSuchUnknown { index: b.len(), limit: rows.len() });
        }
        // One more unknown, which is 1: A x − b x₀ = 0.
        let with_value = |((row, (p, q)), b): ((&IntegerRow, &(BigInt, BigInt)), &T)| {
            let (value, unit) = (-p * b.numerator(), q * b.denominator());
            let mut row: IntegerRow = row.iter().map(|(c, a)| (*c, a * &unit)).collect();
            if !value.is_zero() {
                row.push((*unknowns as u32, value));
            }
            row
        };
        let rows: Vec<IntegerRow> = rows.iter().zip(factors).zip(b).map(with_value).collect();
        let vector = Lifter::new(&rows, unknowns + 1, &self.pivots).vector(*unknowns as u32);
        let solved = rows.iter().all(|row| vector.solves(row));
        Ok(solved.then(|| dense(&vector, *unknowns)))
    }
}

fn dense<T: RationalField>(vector: &RationalVector, length: usize) -> Vec<T> {
    let value = |c| {
        let numerator = vector.numerators.get(&(c as u32))?.clone();
        T::from_fraction(numerator, vector.denominator.clone())
    };
    (0..length).map(|c| value(c).unwrap_or_else(T::zero)).collect()
}
