//! Solutions over ℚ from solutions modulo primes.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use num_bigint::BigInt;
use num_traits::Zero;

use super::modular::{Modulus, primes};
use super::remainder::{Chinese, Reconstruction};
use super::sparse::{Equation, Matrix, Pivot, Row, substitute};

/// A row of integers, sorted by columns, without zeros.
pub(super) type IntegerRow = Vec<(u32, BigInt)>;

/// The image of a row modulo a prime.
pub(super) fn row_modulo(row: &IntegerRow, m: &Modulus) -> Row {
    row.iter().map(|(c, a)| (*c, m.class_of(a))).filter(|(_, a)| *a != 0).collect()
}

/// The columns of a rational vector that are not 0, over one denominator; one column is 1.
#[derive(Clone, Debug)]
pub(super) struct RationalVector {
    pub numerators: BTreeMap<u32, BigInt>,
    pub denominator: BigInt,
}

impl RationalVector {
    /// Whether the vector solves an equation, exactly.
    pub fn solves(&self, row: &IntegerRow) -> bool {
        let terms = row.iter().filter_map(|(c, a)| Some(a * self.numerators.get(c)?));
        terms.sum::<BigInt>().is_zero()
    }
}

/// The pivot rows of a matrix, eliminated modulo as many primes as were needed so far.
pub(super) struct Lifter<'a> {
    rows: Vec<&'a IntegerRow>,
    columns: usize,
    pivots: Vec<Pivot>,
    state: Mutex<State>,
}

type Images = Vec<Arc<(Modulus, Vec<Equation>)>>;

struct State {
    primes: Box<dyn Iterator<Item = Modulus> + Send>,
    images: Images,
    chinese: BTreeMap<usize, Arc<Chinese>>,
}

impl<'a> Lifter<'a> {
    /// `pivots` must belong to an elimination of `rows` modulo some prime, so that the minor of
    /// pivot rows and pivot columns is not 0.
    pub fn new(rows: &'a [IntegerRow], columns: usize, pivots: &[Pivot]) -> Self {
        let used = pivots.iter().map(|p| &rows[p.row as usize]).collect();
        let pivots =
            pivots.iter().enumerate().map(|(i, p)| Pivot { row: i as u32, column: p.column });
        let state =
            State { primes: Box::new(primes()), images: Images::new(), chinese: BTreeMap::new() };
        Lifter { rows: used, columns, pivots: pivots.collect(), state: Mutex::new(state) }
    }

    /// The rational vector that solves all pivot rows, is 1 in column `free` and 0 in the other
    /// columns without pivot; there is exactly one, by Cramer's rule.
    ///
    /// More primes are taken until the fractions found solve the equations over the integers, so
    /// that the answer is certain. It happens as soon as the product of the primes exceeds, by the
    /// slack, the square of the longest numerator or denominator; those are minors of the pivot
    /// rows, so that Hadamard's bound `∏ |row|` holds for them.
    pub fn vector(&self, free: u32) -> RationalVector {
        let mut count = 2;
        let mut doubtful = 0;
        loop {
            let (images, chinese) = self.images(count);
            let solutions: Vec<Vec<u64>> =
                images.iter().map(|i| substitute(&i.0, &i.1, self.columns, free)).collect();
            match self.reconstruct(&chinese, &solutions, free, doubtful) {
                Ok(vector) if self.rows.iter().all(|row| vector.solves(row)) => return vector,
                Ok(_) => {}
                Err(pivot) => doubtful = pivot,
            }
            count += count.div_ceil(2);
        }
    }

    /// The first `count` images of the pivot rows; a prime that divides the pivot minor is left
    /// out.
    fn images(&self, count: usize) -> (Images, Arc<Chinese>) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        while state.images.len() < count
            && let Some(modulus) = state.primes.next()
        {
            let rows = self.rows.iter().map(|row| row_modulo(row, &modulus)).collect();
            let matrix = Matrix::new(modulus, self.columns, rows);
            if let Some(equations) = matrix.replay(&self.pivots) {
                state.images.push(Arc::new((modulus, equations)));
            }
        }
        let images: Images = state.images.iter().take(count).cloned().collect();
        let chinese = state.chinese.entry(count).or_insert_with(|| {
            let moduli: Vec<Modulus> = images.iter().map(|i| i.0).collect();
            Arc::new(Chinese::new(&moduli))
        });
        (images, Arc::clone(chinese))
    }

    /// The fractions with these classes, or the pivot that has none that is short enough; the one
    /// that failed before is tried first. The columns solved last come first: theirs are the
    /// longest denominators, which mostly serve the others.
    fn reconstruct(
        &self,
        chinese: &Chinese,
        solutions: &[Vec<u64>],
        free: u32,
        doubtful: usize,
    ) -> Result<RationalVector, usize> {
        let mut fractions = Reconstruction::new(chinese.modulus());
        let all = (0..self.pivots.len()).filter(|&i| i != doubtful);
        let first = (doubtful < self.pivots.len()).then_some(doubtful);
        let mut found: Vec<(u32, BigInt, BigInt)> = Vec::new();
        for i in first.into_iter().chain(all) {
            if solutions.iter().all(|s| s[i] == 0) {
                continue;
            }
            let x = chinese.combine(solutions.iter().map(|s| s[i]));
            let numerator = fractions.numerator(&x).ok_or(i)?;
            found.push((self.pivots[i].column, numerator, fractions.denominator.clone()));
        }
        let denominator = fractions.denominator;
        let scaled = |(column, n, d): (u32, BigInt, BigInt)| {
            (column, if d == denominator { n } else { n * (&denominator / d) })
        };
        let mut numerators: BTreeMap<u32, BigInt> = found.into_iter().map(scaled).collect();
        numerators.insert(free, denominator.clone());
        Ok(RationalVector { numerators, denominator })
    }
}
