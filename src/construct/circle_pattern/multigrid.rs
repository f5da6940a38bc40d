//! Multigrid by smoothed aggregation: a preconditioner for weighted graph Laplacians.
//!
//! Neighbouring unknowns that are strongly coupled are joined to one coarse unknown; the piecewise
//! constant interpolation is smoothed once. It only steers the conjugate gradients, so it is kept in
//! single precision, which halves the memory that has to be moved.

use rayon::prelude::*;

use super::envelope::Envelope;
use super::sparse::Sparse;

/// A hierarchy of ever smaller systems.
pub(super) struct Multigrid {
    levels: Vec<Level>,
    /// The factor of the coarsest system; none where nothing could be joined any more before.
    coarsest: Option<Envelope>,
}

struct Level {
    matrix: Sparse<f32>,
    inverse_diagonal: Vec<f32>,
    interpolation: Sparse<f32>,
    restriction: Sparse<f32>,
}

/// Damping of the Jacobi steps: the spectrum of a scaled Laplacian lies in [0, 2].
const DAMPING: f32 = 2.0 / 3.0;
/// For every unknown of the finest system, so many products may be spent on a factor.
const PRODUCTS: usize = 2500;

impl Multigrid {
    /// Coarsens until the factor of the system is cheap: small systems are not coarsened at all.
    pub fn new(matrix: &Sparse<f64>) -> Self {
        let most = PRODUCTS * matrix.rows();
        let mut matrix = matrix.map(|&x| x as f32);
        let mut levels = Vec::new();
        loop {
            if let Some(coarsest) = Envelope::new(&matrix, most) {
                return Multigrid { levels, coarsest: Some(coarsest) };
            }
            let inverse_diagonal = inverse_diagonal(&matrix);
            let aggregates = aggregate(&matrix);
            let coarse = aggregates.iter().max().map_or(0, |&a| a as usize + 1);
            // Where nothing can be joined any more, the Jacobi steps have to do.
            if coarse == 0 || coarse * 10 > matrix.rows() * 9 {
                let none = Sparse { starts: vec![0], columns: Vec::new(), values: Vec::new() };
                let (interpolation, restriction) = (none.clone(), none);
                levels.push(Level { matrix, inverse_diagonal, interpolation, restriction });
                return Multigrid { levels, coarsest: None };
            }
            let interpolation = smoothed(&matrix, &inverse_diagonal, &aggregates, coarse);
            let restriction = interpolation.transposed(coarse);
            let next = restriction.times(&matrix.times(&interpolation, coarse), coarse);
            levels.push(Level { matrix, inverse_diagonal, interpolation, restriction });
            matrix = next;
        }
    }

    /// Whether it is a factor of the system itself.
    pub fn is_factor(&self) -> bool {
        self.levels.is_empty()
    }

    /// One V-cycle from zero: an approximate solution, linear and symmetric in the right-hand side.
    pub fn apply(&self, right: &[f64]) -> Vec<f64> {
        let right: Vec<f32> = right.par_iter().map(|&x| x as f32).collect();
        self.cycle(0, &right).into_par_iter().map(f64::from).collect()
    }

    fn cycle(&self, depth: usize, right: &[f32]) -> Vec<f32> {
        let Some(level) = self.levels.get(depth) else {
            return self.coarsest.as_ref().map_or(right.to_vec(), |factor| factor.solve(right));
        };
        let Level { matrix, inverse_diagonal, interpolation, restriction } = level;
        let scaled = |x: f32, d: f32| DAMPING * x * d;
        let pairs = right.par_iter().zip(inverse_diagonal).with_min_len(4096);
        let mut x: Vec<f32> = pairs.map(|(&r, &d)| scaled(r, d)).collect();
        if interpolation.rows() == x.len() {
            let rest = matrix.residual(&x, right);
            let correction = self.cycle(depth + 1, &restriction.apply(&rest));
            let correction = interpolation.apply(&correction);
            x.par_iter_mut().with_min_len(4096).zip(&correction).for_each(|(x, c)| *x += c);
        }
        let rest = matrix.residual(&x, right);
        let pairs = x.par_iter_mut().zip(rest.par_iter().zip(inverse_diagonal)).with_min_len(4096);
        pairs.for_each(|(x, (&r, &d))| *x += scaled(r, d));
        x
    }
}

fn inverse_diagonal(matrix: &Sparse<f32>) -> Vec<f32> {
    let of_row = |i: usize| {
        let diagonal = matrix.row(i).find(|&(j, _)| j == i).map_or(0.0, |(_, &a)| a);
        if diagonal > 0.0 { 1.0 / diagonal } else { 0.0 }
    };
    (0..matrix.rows()).map(of_row).collect()
}

/// The number of the aggregate of each unknown: a root with its strong neighbours; what is left
/// joins a neighbour.
fn aggregate(matrix: &Sparse<f32>) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let diagonal: Vec<f32> = (0..matrix.rows())
        .map(|i| matrix.row(i).find(|&(j, _)| j == i).map_or(0.0, |(_, &a)| a))
        .collect();
    let strong = |i: usize, j: usize, a: f32| {
        // A coupling of a tenth of the geometric mean of the diagonals.
        i != j && a < 0.0 && 100.0 * a * a > diagonal[i] * diagonal[j]
    };
    let neighbours =
        |i: usize| matrix.row(i).filter(move |&(j, &a)| strong(i, j, a)).map(|(j, &a)| (j, a));
    let mut of = vec![NONE; matrix.rows()];
    let mut count = 0;
    for i in 0..matrix.rows() {
        if of[i] == NONE && neighbours(i).all(|(j, _)| of[j] == NONE) {
            of[i] = count;
            neighbours(i).for_each(|(j, _)| of[j] = count);
            count += 1;
        }
    }
    let roots = of.clone();
    for (i, own) in of.iter_mut().enumerate().filter(|(_, own)| **own == NONE) {
        let joined = neighbours(i).filter(|&(j, _)| roots[j] != NONE);
        match joined.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((j, _)) => *own = roots[j],
            None => {
                *own = count;
                count += 1;
            }
        }
    }
    of
}

/// `(I − ω D⁻¹ A) P` for the piecewise constant P of the aggregates.
fn smoothed(
    matrix: &Sparse<f32>,
    inverse_diagonal: &[f32],
    aggregates: &[u32],
    coarse: usize,
) -> Sparse<f32> {
    let constant = Sparse {
        starts: (0..=matrix.rows() as u32).collect(),
        columns: aggregates.to_vec(),
        values: vec![1.0; matrix.rows()],
    };
    let mut smoothed = matrix.times(&constant, coarse);
    for i in 0..matrix.rows() {
        let range = smoothed.range(i);
        let scale = DAMPING * inverse_diagonal[i];
        for k in range {
            let own = if smoothed.columns[k] == aggregates[i] { 1.0 } else { 0.0 };
            smoothed.values[k] = own - scale * smoothed.values[k];
        }
    }
    smoothed
}
