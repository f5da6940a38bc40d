//! Sparse Cholesky factorisation: the analysis is made once, the numbers often.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// Why a system of equations was not solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFactor {
    /// There is not enough memory.
    OutOfMemory,
    /// The matrix is not positive definite, as far as doubles tell.
    NotPositive,
}

impl std::fmt::Display for NoFactor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            NoFactor::OutOfMemory => "there is not enough memory",
            NoFactor::NotPositive => "the matrix is not positive definite, as far as doubles tell",
        })
    }
}

impl std::error::Error for NoFactor {}

/// Threads could only share single dense blocks; up to hundreds of thousands of rows handing them over
/// costs more than it saves. The results do not depend on the number of threads, either.
pub(super) const ONE_THREAD: Par = Par::Seq;

/// The factor `L` of a positive definite matrix `L Lᵀ`.
pub struct Cholesky {
    pub(super) symbolic: SymbolicCholesky<u32>,
    pub(super) values: Vec<f64>,
    buffer: MemBuffer,
    size: usize,
}

impl Cholesky {
    /// Analyses the pattern of a lower triangle, by columns, with a given order of elimination, or one of
    /// least degrees.
    ///
    /// # Errors
    /// [`NoFactor::OutOfMemory`].
    pub fn analyse(starts: &[u32], rows: &[u32], order: Option<&[u32]>) -> Result<Self, NoFactor> {
        let size = starts.len() - 1;
        let pattern = SymbolicSparseColMatRef::new_checked(size, size, starts, None, rows);
        let mut inverse = vec![0; size];
        let ordering = order.map_or(SymmetricOrdering::Amd, |order| {
            (0..).zip(order).for_each(|(place, row)| inverse[*row as usize] = place);
            SymmetricOrdering::Custom(PermRef::new_checked(order, &inverse, size))
        });
        // By dense blocks, however few: column by column takes twice as long for a few thousand rows.
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_cholesky(pattern, Side::Lower, ordering, params)
            .map_err(|_| NoFactor::OutOfMemory)?;
        let scratch = symbolic
            .factorize_numeric_llt_scratch::<f64>(ONE_THREAD, Default::default())
            .or(symbolic.solve_in_place_scratch::<f64>(1, ONE_THREAD));
        let buffer = MemBuffer::try_new(scratch).map_err(|_| NoFactor::OutOfMemory)?;
        let values = vec![0.0; symbolic.len_val()];
        Ok(Cholesky { symbolic, values, buffer, size })
    }

    /// Computes the factor of the matrix with these entries in the lower triangle.
    ///
    /// # Errors
    /// [`NoFactor::NotPositive`].
    pub fn factorise(
        &mut self,
        starts: &[u32],
        rows: &[u32],
        values: &[f64],
    ) -> Result<(), NoFactor> {
        let pattern =
            SymbolicSparseColMatRef::new_checked(self.size, self.size, starts, None, rows);
        let matrix = SparseColMatRef::new(pattern, values);
        let found = self.symbolic.factorize_numeric_llt(
            &mut self.values,
            matrix,
            Side::Lower,
            LltRegularization::default(),
            ONE_THREAD,
            MemStack::new(&mut self.buffer),
            Default::default(),
        );
        found.map(|_| ()).map_err(|_| NoFactor::NotPositive)
    }

    /// The number of entries of the factor, with those zeros that are stored.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Solves with the factor that was computed last.
    pub fn solve(&mut self, x: &mut [f64]) {
        let size = self.size;
        LltRef::<'_, u32, f64>::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, size, 1),
            ONE_THREAD,
            MemStack::new(&mut self.buffer),
        );
    }
}
