//! Sparse matrices by rows, as much of them as multigrid needs.

use std::ops::{AddAssign, Mul, Range, Sub};

use rayon::prelude::*;

/// A matrix by rows: row `i` has the entries `starts[i]..starts[i + 1]`.
#[derive(Clone, Debug)]
pub(super) struct Sparse<T> {
    pub starts: Vec<u32>,
    pub columns: Vec<u32>,
    pub values: Vec<T>,
}

/// The two floating-point types.
pub(super) trait Real:
    Copy + Default + Send + Sync + AddAssign + Mul<Output = Self> + Sub<Output = Self>
{
}
impl Real for f32 {}
impl Real for f64 {}

const CHUNK: usize = 4096;

impl<T> Sparse<T> {
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    #[inline]
    pub fn range(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    #[inline]
    pub fn row(&self, row: usize) -> impl Iterator<Item = (usize, &T)> {
        let range = self.range(row);
        self.columns[range.clone()].iter().map(|&j| j as usize).zip(&self.values[range])
    }

    pub fn map<S>(&self, f: impl Fn(&T) -> S) -> Sparse<S> {
        Sparse {
            starts: self.starts.clone(),
            columns: self.columns.clone(),
            values: self.values.iter().map(f).collect(),
        }
    }
}

impl<T: Real> Sparse<T> {
    #[inline]
    fn dot(&self, row: usize, x: &[T]) -> T {
        let mut sum = T::default();
        for (j, &a) in self.row(row) {
            sum += a * x[j];
        }
        sum
    }

    /// `A x`.
    pub fn apply(&self, x: &[T]) -> Vec<T> {
        let rows = (0..self.rows()).into_par_iter().with_min_len(CHUNK);
        rows.map(|i| self.dot(i, x)).collect()
    }

    /// `b − A x`.
    pub fn residual(&self, x: &[T], b: &[T]) -> Vec<T> {
        let rows = (0..self.rows()).into_par_iter().with_min_len(CHUNK);
        rows.map(|i| b[i] - self.dot(i, x)).collect()
    }

    /// The transposed matrix, of so many rows.
    pub fn transposed(&self, rows: usize) -> Sparse<T> {
        let mut starts = vec![0u32; rows + 1];
        self.columns.iter().for_each(|&j| starts[j as usize + 1] += 1);
        (0..rows).for_each(|i| starts[i + 1] += starts[i]);
        let mut next = starts.clone();
        let mut columns = vec![0; self.columns.len()];
        let mut values = vec![T::default(); self.values.len()];
        for i in 0..self.rows() {
            for (j, &a) in self.row(i) {
                let at = next[j] as usize;
                next[j] += 1;
                (columns[at], values[at]) = (i as u32, a);
            }
        }
        Sparse { starts, columns, values }
    }

    /// The product with a matrix of so many columns.
    pub fn times(&self, other: &Sparse<T>, columns: usize) -> Sparse<T> {
        // Each part has rows of its own; an accumulator holds the place of every column.
        let parts = rayon::current_num_threads().max(1) * 2;
        let step = self.rows().div_ceil(parts).max(1);
        let part = |first: usize| {
            let last = (first + step).min(self.rows());
            let mut place = vec![u32::MAX; columns];
            let (mut lengths, mut ids, mut values) = (Vec::new(), Vec::<u32>::new(), Vec::new());
            for i in first..last {
                let start = ids.len();
                for (k, &a) in self.row(i) {
                    for (j, &b) in other.row(k) {
                        let at = place[j] as usize;
                        if at >= start && at < ids.len() && ids[at] as usize == j {
                            values[at] += a * b;
                        } else {
                            place[j] = ids.len() as u32;
                            ids.push(j as u32);
                            values.push(a * b);
                        }
                    }
                }
                lengths.push((ids.len() - start) as u32);
            }
            (lengths, ids, values)
        };
        let firsts: Vec<usize> = (0..self.rows()).step_by(step).collect();
        let parts: Vec<_> = firsts.into_par_iter().map(part).collect();
        let mut product = Sparse { starts: vec![0], columns: Vec::new(), values: Vec::new() };
        let mut end = 0;
        for (lengths, ids, values) in parts {
            for length in lengths {
                end += length;
                product.starts.push(end);
            }
            product.columns.extend(ids);
            product.values.extend(values);
        }
        product
    }
}
