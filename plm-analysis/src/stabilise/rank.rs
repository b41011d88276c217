//! Least squares of least norm, and what they leave free, by singular values.

use nalgebra::{DMatrix, DVector};

/// Singular values below this fraction of the largest count as zero.
const RELATIVE: f64 = 1e-11;
/// Singular values below this count as zero in any case: unknowns and rows are scaled to be about one.
const ABSOLUTE: f64 = 1e-12;

/// A matrix by its singular values, A = U S V^T.
pub(super) struct Ranked {
    rows: usize,
    u: DMatrix<f64>,
    s: DVector<f64>,
    v: DMatrix<f64>,
    rank: usize,
}

impl Ranked {
    /// None if an entry is not finite, or the decomposition does not converge.
    pub(super) fn new(matrix: &DMatrix<f64>) -> Option<Self> {
        let (rows, columns) = matrix.shape();
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        if rows == 0 || columns == 0 {
            let (u, s) = (DMatrix::zeros(rows, columns), DVector::zeros(columns));
            return Some(Self { rows, u, s, v: DMatrix::identity(columns, columns), rank: 0 });
        }
        // Rows of zeros: singular vectors of all directions come out, not only of as many as there are rows.
        let tall = matrix.clone().resize(rows.max(columns), columns, 0.0);
        let mut svd = tall.try_svd(true, true, f64::EPSILON, 0)?;
        svd.sort_by_singular_values();
        let (u, s, v) = (svd.u?, svd.singular_values, svd.v_t?.transpose());
        let cut = (RELATIVE * s.max()).max(ABSOLUTE);
        let rank = s.iter().filter(|value| **value > cut).count();
        Some(Self { rows, u, s, v, rank })
    }

    /// The shortest of all x that come nearest to A x = b.
    pub(super) fn solve(&self, b: &DVector<f64>) -> DVector<f64> {
        let mut x = DVector::zeros(self.v.nrows());
        for k in 0..self.rank {
            let along = self.u.column(k).rows(0, self.rows).dot(b) / self.s[k];
            x.axpy(along, &self.v.column(k), 1.0);
        }
        x
    }

    /// Solves for several right-hand sides in columns.
    pub(super) fn solve_all(&self, b: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = DMatrix::zeros(self.v.nrows(), b.ncols());
        for k in 0..b.ncols() {
            x.set_column(k, &self.solve(&b.column(k).into_owned()));
        }
        x
    }

    /// Orthonormal columns z with A z = 0.
    pub(super) fn null_space(&self) -> DMatrix<f64> {
        self.v.columns(self.rank, self.v.ncols() - self.rank).into_owned()
    }
}

/// Orthonormal columns z with A z = 0.
pub(super) fn null_space(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    Some(Ranked::new(matrix)?.null_space())
}
