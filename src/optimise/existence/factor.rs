//! How far the product of a sparse factor with its transpose is from the matrix.
//!
//! The factor comes in blocks of consecutive columns with the same rows. What a block contributes to the
//! product is one dense product.

use std::ops::Range;

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::{Accum, Mat, MatMut, MatRef};

use super::rounding::{gamma, largest, up};
use crate::optimise::cholesky::{Cholesky, ONE_THREAD};
use crate::optimise::normal::NormalMatrix;

/// Columns of a lower triangle with the same rows, which begin with the columns themselves. What stands
/// above the diagonal means nothing.
struct Block<'a> {
    columns: Range<usize>,
    rows: Vec<u32>,
    values: MatRef<'a, f64>,
}

/// A factor `L` by blocks, in the order of elimination.
struct Factor<'a> {
    blocks: Vec<Block<'a>>,
    /// The block of each column.
    block_of: Vec<u32>,
    /// The row of the factor that each row of the matrix becomes.
    order: Vec<u32>,
}

/// Not below the 2-norm of `A − L Lᵀ` for the factor `L` that was computed last, where `products` bounds the
/// number of products in an entry of `A` and `sizes` the 2-norm of the matrix of the sums of their sizes.
///
/// The difference is computed, and its Frobenius norm is added to a bound of the rounding errors of its computation:
/// dense products may be summed up in any order. Of the factor nothing is assumed. `None` if it has
/// not the form of one.
pub fn misfit(
    matrix: &NormalMatrix,
    cholesky: &Cholesky,
    products: usize,
    sizes: f64,
) -> Option<f64> {
    let factor = Factor::new(cholesky, matrix.starts.len() - 1)?;
    let frobenius = factor.difference(matrix)?.norm(&factor);
    // In an entry: each product is made by one operation, and added by one for each other product.
    let operations = factor.longest_row() + products + 2;
    let rounding = up(gamma(operations) * up(sizes + factor.norm_of_sizes()));
    // A product that underflows is wrong by less than that; and no entry of a matrix is
    // larger than its norm, nor the norm than the number of rows times all entries.
    let underflow = f64::MIN_POSITIVE * operations as f64 * factor.order.len() as f64;
    Some(up(frobenius + rounding + underflow))
}

impl<'a> Factor<'a> {
    fn new(cholesky: &'a Cholesky, size: usize) -> Option<Self> {
        let order: Vec<u32> = match cholesky.symbolic.perm() {
            Some(perm) => perm.arrays().1.to_vec(),
            None => (0..size as u32).collect(),
        };
        let mut met = vec![false; size];
        for &row in &order {
            if std::mem::replace(met.get_mut(row as usize)?, true) {
                return None;
            }
        }
        let blocks = blocks(cholesky);
        let mut block_of = Vec::with_capacity(size);
        for (b, block) in (0..).zip(&blocks) {
            let Block { columns, rows, values } = block;
            let diagonal = rows.iter().map(|&r| r as usize).take(columns.len());
            let fits = columns.start == block_of.len()
                && columns.clone().eq(diagonal)
                && rows.is_sorted_by(|a, b| a < b)
                && rows.last().is_some_and(|&r| (r as usize) < size)
                && (values.nrows(), values.ncols()) == (rows.len(), columns.len());
            if !fits {
                return None;
            }
            block_of.extend(columns.clone().map(|_| b));
        }
        let whole = order.len() == size && block_of.len() == size;
        whole.then_some(Factor { blocks, block_of, order })
    }

    /// `A − L Lᵀ`; `None` if it has an entry where the factor has none.
    fn difference(&self, matrix: &NormalMatrix) -> Option<Difference> {
        let entries = |block: &Block<'_>| vec![0.0; block.rows.len() * block.columns.len()];
        let mut difference = Difference(self.blocks.iter().map(entries).collect());
        for j in 0..self.order.len() {
            for entry in matrix.starts[j] as usize..matrix.starts[j + 1] as usize {
                let (i, j) = (self.order[matrix.rows[entry] as usize], self.order[j]);
                let (row, column) = (i.max(j), i.min(j) as usize);
                let b = self.block_of[column] as usize;
                let Block { columns, rows, .. } = &self.blocks[b];
                let place = rows.binary_search(&row).ok()?;
                difference.0[b][(column - columns.start) * rows.len() + place] +=
                    matrix.values[entry];
            }
        }
        let mut product = Vec::new();
        for block in &self.blocks {
            self.subtract(block, &mut product, &mut difference)?;
        }
        Some(difference)
    }

    /// Subtracts what a block contributes to `L Lᵀ`.
    fn subtract(
        &self,
        block: &Block<'_>,
        product: &mut Vec<f64>,
        difference: &mut Difference,
    ) -> Option<()> {
        let (n, k) = (block.rows.len(), block.columns.len());
        let lower = Mat::from_fn(n, k, |i, j| if i < j { 0.0 } else { block.values[(i, j)] });
        product.resize(product.len().max(n * n), 0.0);
        matmul(
            MatMut::from_column_major_slice_mut(&mut product[..n * n], n, n),
            BlockStructure::TriangularLower,
            Accum::Replace,
            &lower,
            BlockStructure::Rectangular,
            lower.transpose(),
            BlockStructure::Rectangular,
            1.0,
            ONE_THREAD,
        );
        let mut places = Vec::with_capacity(n);
        let mut start = 0;
        while start < n {
            // The columns of one other block, and where the rows stand there.
            let b = self.block_of[block.rows[start] as usize] as usize;
            let Block { columns, rows, .. } = &self.blocks[b];
            places.clear();
            let mut place = 0;
            for row in &block.rows[start..] {
                place += rows[place..].iter().position(|r| r == row)?;
                places.push(place);
            }
            let end = block.rows.partition_point(|&r| (r as usize) < columns.end);
            for j in start..end {
                let column = block.rows[j] as usize - columns.start;
                let target = &mut difference.0[b][column * rows.len()..][..rows.len()];
                let source = &product[j * n..][j..n];
                for (value, &place) in source.iter().zip(&places[j - start..]) {
                    target[place] -= value;
                }
            }
            start = end;
        }
        Some(())
    }

    /// Not below the 2-norm of `|L| |L|ᵀ`: the largest sum of a column times that of a row.
    fn norm_of_sizes(&self) -> f64 {
        let (mut sums, mut most) = (vec![0.0; self.order.len()], 0.0);
        for Block { rows, values, .. } in &self.blocks {
            for j in 0..values.ncols() {
                let mut own = 0.0;
                for i in j..values.nrows() {
                    let (sum, size) = (&mut sums[rows[i] as usize], values[(i, j)].abs());
                    (*sum, own) = (up(*sum + size), up(own + size));
                }
                most = largest([most, own]);
            }
        }
        up(most * largest(sums))
    }

    fn longest_row(&self) -> usize {
        let mut lengths = vec![0; self.order.len()];
        for Block { columns, rows, .. } in &self.blocks {
            rows.iter().for_each(|&row| lengths[row as usize] += columns.len());
        }
        lengths.into_iter().max().unwrap_or(0)
    }
}

/// The entries of a lower triangle, in the blocks of a factor, column by column.
struct Difference(Vec<Vec<f64>>);

impl Difference {
    /// Not below the Frobenius norm of the whole symmetric matrix.
    fn norm(&self, factor: &Factor<'_>) -> f64 {
        let mut sum = 0.0;
        for (Block { rows, columns, .. }, values) in factor.blocks.iter().zip(&self.0) {
            for (j, column) in values.chunks_exact(rows.len()).enumerate().take(columns.len()) {
                let below = column[j + 1..].iter().fold(0.0, |sum, x| up(sum + x * x));
                sum = up(sum + column[j] * column[j] + 2.0 * below);
            }
        }
        up(sum.sqrt())
    }
}

fn blocks(cholesky: &Cholesky) -> Vec<Block<'_>> {
    match cholesky.symbolic.raw() {
        SymbolicCholeskyRaw::Simplicial(symbolic) => {
            let column = |(j, ends): (usize, &[u32])| {
                let range = ends[0] as usize..ends[1] as usize;
                let rows = symbolic.row_idx()[range.clone()].to_vec();
                let values = &cholesky.values[range];
                let values = MatRef::from_column_major_slice(values, values.len(), 1);
                Block { columns: j..j + 1, rows, values }
            };
            symbolic.col_ptr().windows(2).enumerate().map(column).collect()
        }
        SymbolicCholeskyRaw::Supernodal(symbolic) => {
            let blocks = SupernodalLltRef::new(symbolic, &cholesky.values);
            let block = |s| {
                let block = blocks.supernode(s);
                let columns = block.start()..block.start() + block.val().ncols();
                let own = columns.clone().map(|j| j as u32);
                let rows = own.chain(block.pattern().iter().copied()).collect();
                Block { columns, rows, values: block.val() }
            };
            (0..symbolic.n_supernodes()).map(block).collect()
        }
    }
}
