//! Cholesky factors within the envelope of a matrix: row by row from the first entry to the diagonal.
//!
//! What is left of the first entry of a row stays 0 in the factor, so everything is a scalar product
//! of contiguous numbers. For a patch of N × N quads that is N³ numbers and N⁴/2 products: for patches
//! of moderate size less than a hierarchy costs, and one solution replaces many steps.

use super::sparse::Sparse;

/// The lower factor of a positive definite matrix whose unknowns may have been put in another order.
pub(super) struct Envelope {
    /// The unknown at every place of the order.
    order: Vec<u32>,
    /// The column of the first entry of every row.
    first: Vec<u32>,
    /// Row `i` is `values[starts[i]..starts[i + 1]]`, up to the entry before the diagonal.
    starts: Vec<usize>,
    values: Vec<f32>,
    inverse_diagonal: Vec<f32>,
}

impl Envelope {
    /// The factor, or `None` where it would take more than `most` products. A pivot that is not
    /// positive is replaced, so that the result stays a preconditioner.
    pub fn new(matrix: &Sparse<f32>, most: usize) -> Option<Self> {
        let given = Shape::new(matrix, (0..matrix.rows() as u32).collect());
        let shape = if given.products() <= most {
            given
        } else {
            let other = Shape::new(matrix, by_distance(matrix));
            Some(other).filter(|other| other.products() <= most)?
        };
        Some(shape.factor(matrix))
    }

    /// The solution for a right-hand side.
    pub fn solve(&self, right: &[f32]) -> Vec<f32> {
        let mut x: Vec<f32> = self.order.iter().map(|&unknown| right[unknown as usize]).collect();
        for i in 0..x.len() {
            let known = dot(self.row(i), &x[self.first[i] as usize..i]);
            x[i] = (x[i] - known) * self.inverse_diagonal[i];
        }
        for i in (0..x.len()).rev() {
            x[i] *= self.inverse_diagonal[i];
            let value = x[i];
            let above = x[self.first[i] as usize..i].iter_mut();
            above.zip(self.row(i)).for_each(|(x, l)| *x -= l * value);
        }
        let mut solution = vec![0.0; x.len()];
        self.order.iter().zip(x).for_each(|(&unknown, x)| solution[unknown as usize] = x);
        solution
    }

    fn row(&self, i: usize) -> &[f32] {
        &self.values[self.starts[i]..self.starts[i + 1]]
    }
}

/// An order of the unknowns, and the first column of every row in it.
struct Shape {
    order: Vec<u32>,
    place: Vec<u32>,
    first: Vec<u32>,
}

impl Shape {
    fn new(matrix: &Sparse<f32>, order: Vec<u32>) -> Self {
        let mut place = vec![0; order.len()];
        order.iter().zip(0..).for_each(|(&unknown, at)| place[unknown as usize] = at);
        let first_of = |(&unknown, at): (&u32, u32)| {
            matrix.row(unknown as usize).map(|(j, _)| place[j]).min().map_or(at, |j| j.min(at))
        };
        let first = order.iter().zip(0..).map(first_of).collect();
        Shape { order, place, first }
    }

    /// About how many products the factor takes.
    fn products(&self) -> usize {
        let width = |(&first, i): (&u32, usize)| i - first as usize;
        self.first.iter().zip(0..).map(width).map(|w| w * (w + 1) / 2).sum()
    }

    fn factor(self, matrix: &Sparse<f32>) -> Envelope {
        let mut starts = vec![0];
        let widths = self.first.iter().zip(0..).map(|(&first, i)| i - first as usize);
        starts.extend(widths.scan(0, |end, width| {
            *end += width;
            Some(*end)
        }));
        let mut factor = Envelope {
            values: vec![0.0; starts.last().copied().unwrap_or_default()],
            inverse_diagonal: Vec::with_capacity(self.order.len()),
            order: self.order,
            first: self.first,
            starts,
        };
        for i in 0..factor.order.len() {
            let first = factor.first[i] as usize;
            let (before, row) = factor.values.split_at_mut(factor.starts[i]);
            let row = &mut row[..i - first];
            let mut scale = 0.0;
            for (j, &a) in matrix.row(factor.order[i] as usize) {
                match self.place[j] as usize {
                    j if j < i => row[j - first] = a,
                    j if j == i => scale = a,
                    _ => {}
                }
            }
            for j in first..i {
                let common = first.max(factor.first[j] as usize);
                let end = factor.starts[j + 1];
                let known = dot(&row[common - first..j - first], &before[end - (j - common)..end]);
                row[j - first] = (row[j - first] - known) * factor.inverse_diagonal[j];
            }
            let rest = scale - dot(row, row);
            let positive = rest > scale * f32::EPSILON;
            let diagonal = if positive { rest.sqrt() } else { scale.abs().sqrt().max(1.0) };
            factor.inverse_diagonal.push(diagonal.recip());
        }
        factor
    }
}

/// The unknowns by their distance from one that is far from all others (Cuthill and McKee 1969).
fn by_distance(matrix: &Sparse<f32>) -> Vec<u32> {
    let mut order: Vec<u32> = Vec::with_capacity(matrix.rows());
    let mut seen = vec![false; matrix.rows()];
    for root in 0..matrix.rows() as u32 {
        if !seen[root as usize] {
            let end = walk(matrix, root, &mut seen.clone()).last().copied().unwrap_or(root);
            order.extend(walk(matrix, end, &mut seen));
        }
    }
    order
}

/// What can be reached from an unknown, the nearest first.
fn walk(matrix: &Sparse<f32>, from: u32, seen: &mut [bool]) -> Vec<u32> {
    let mut reached = vec![from];
    seen[from as usize] = true;
    let mut next = 0;
    while let Some(&unknown) = reached.get(next) {
        next += 1;
        for (j, _) in matrix.row(unknown as usize) {
            if !std::mem::replace(&mut seen[j], true) {
                reached.push(j as u32);
            }
        }
    }
    reached
}

/// A scalar product with sums of its own for every lane of a vector register.
fn dot(a: &[f32], b: &[f32]) -> f32 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (mut a, mut b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    for (a, b) in a.by_ref().zip(b.by_ref()) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let rest: f32 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f32>() + rest
}
