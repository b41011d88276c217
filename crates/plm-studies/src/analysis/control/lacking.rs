//! Modes that inputs do not reach, or that outputs do not show (M. L. J. Hautus, Proc. Kon. Ned. Akad. Wet. A 72, 1969).

use std::fmt;

use nalgebra::{Complex, DMatrix, DVector};

use super::{System, complex, eigenvalues};
use crate::analysis::Mode;

/// Singular values below this fraction of the largest count as zero.
const RANK_TOLERANCE: f64 = 1e-9;
/// Iterations of a decomposition at most; some for each value do.
const ITERATIONS: usize = 10_000;

/// A mode that inputs do not reach or outputs do not show, and what moves most in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lacking {
    /// The mode: of a sampled system that of its logarithm over the period.
    pub mode: Mode,
    /// The coordinate, velocity or first-order state with the largest part in it: of a mode that is not reached in the combination of states
    /// that no input changes.
    pub state: &'static str,
}

impl fmt::Display for Lacking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, mostly of `{}`", self.mode, self.state)
    }
}

impl System<'_> {
    /// The modes for which (lambda - A, B) has not the full rank, B having the columns of these inputs.
    pub(super) fn not_reached(&self, b: &DMatrix<f64>) -> Vec<Lacking> {
        self.lacking(&self.a.transpose(), &b.transpose())
    }

    /// The modes for which these outputs, the rows of C, show nothing.
    pub(super) fn not_shown(&self, c: &DMatrix<f64>) -> Vec<Lacking> {
        self.lacking(self.a, c)
    }

    /// Eigenvectors of a matrix that the rows do not see.
    fn lacking(&self, a: &DMatrix<f64>, rows: &DMatrix<f64>) -> Vec<Lacking> {
        let (n, scale) = (a.nrows(), a.norm().max(f64::MIN_POSITIVE));
        // Rows count by their directions, whatever their units.
        let mut scaled = rows.clone();
        for mut row in scaled.row_iter_mut() {
            let norm = row.norm();
            if norm > 0.0 {
                row *= scale / norm;
            }
        }
        let mut found: Vec<Lacking> = Vec::new();
        for eigenvalue in eigenvalues(a).into_iter().filter(|eigenvalue| eigenvalue.im >= 0.0) {
            let mut all = DMatrix::zeros(n + scaled.nrows(), n);
            let shifted = complex(a) - DMatrix::identity(n, n) * eigenvalue;
            all.view_mut((0, 0), (n, n)).copy_from(&shifted);
            all.view_mut((n, 0), (scaled.nrows(), n)).copy_from(&complex(&scaled));
            // Not sorted: of entries near the end of the range of numbers a singular value may be none.
            let svd = all.try_svd_unordered(false, true, f64::EPSILON, ITERATIONS);
            let Some(svd) = svd.filter(|svd| svd.singular_values.iter().all(|own| own.is_finite())) else {
                continue;
            };
            let (Some(vectors), least) = (svd.v_t, svd.singular_values.imin()) else { continue };
            if svd.singular_values[least] <= RANK_TOLERANCE * svd.singular_values.max() {
                let shape = vectors.row(least).adjoint();
                found.push(Lacking { mode: self.mode(eigenvalue), state: self.largest(&shape) });
            }
        }
        found
    }

    /// The mode with an eigenvalue.
    pub(super) fn mode(&self, eigenvalue: Complex<f64>) -> Mode {
        match self.time {
            super::Time::Continuous => Mode::new(eigenvalue),
            super::Time::Sampled(period) => Mode::new(eigenvalue.ln() / period),
        }
    }

    /// The name of the state with the largest part in a combination of directions.
    fn largest(&self, shape: &DVector<Complex<f64>>) -> &'static str {
        let parts = complex(self.basis) * shape;
        // Of parts that are equal but for rounding the first one.
        let mut largest = (0, 0.0);
        for (k, part) in parts.iter().enumerate() {
            if part.norm() > largest.1 * (1.0 + 1e-6) {
                largest = (k, part.norm());
            }
        }
        self.states.get(largest.0).copied().unwrap_or("")
    }
}
