//! Zeros of the transfer from an input to an output: the modes in which the output stays zero while the input moves.

use nalgebra::{Complex, DMatrix, DVector, RowDVector};

use super::response::NoResponse;
use super::{Sampled, System, eigenvalues};
use crate::analysis::Linearisation;

/// A derivative of the output reads the input if its factor is above this fraction of what it could be.
const READS: f64 = 1e-10;

macro_rules! has_zeros {
    ($system:ident) => {
        impl $system {
            /// Zeros of the transfer from an input to an output, small ones first. Modes that the output does not show, or the input does not
            /// reach, are among them and among the poles; none where the output does not depend on the input at all.
            ///
            /// # Errors
            /// [`NoResponse`]: a name that is not there.
            pub fn zeros(&self, input: &str, output: &str) -> Result<Vec<Complex<f64>>, NoResponse> {
                self.system().zeros(input, output)
            }
        }
    };
}

has_zeros!(Linearisation);
has_zeros!(Sampled);

impl System<'_> {
    /// The input that holds y, y', y'', ... at zero up to the derivative that reads it leaves a motion in the subspace where these vanish;
    /// its eigenvalues are the zeros (A. Isidori, Nonlinear Control Systems, 1995, 4.3, of a linear system).
    fn zeros(&self, input: &str, output: &str) -> Result<Vec<Complex<f64>>, NoResponse> {
        let [input, output] = self.pair(input, output)?;
        let b: DVector<f64> = self.b.column(input).into_owned();
        let mut row: RowDVector<f64> = self.c.row(output).into_owned();
        let (n, mut reads) = (self.a.nrows(), self.d[(output, input)]);
        // What vanishes, orthonormal.
        let mut vanish: Vec<RowDVector<f64>> = Vec::new();
        let mut is_read = reads != 0.0;
        while !is_read {
            let mut rest = row.clone();
            for _ in 0..2 {
                for own in &vanish {
                    rest -= own * own.dot(&rest);
                }
            }
            if vanish.len() == n || rest.norm() <= READS * row.norm() || row.norm() == 0.0 {
                return Ok(Vec::new());
            }
            vanish.push(&rest / rest.norm());
            reads = (&row * &b)[(0, 0)];
            is_read = reads.abs() > READS * row.norm() * b.norm();
            // The next derivative is read with the state's own motion.
            row = &row * self.a;
            if !is_read {
                let size = row.norm();
                row /= if size > 0.0 { size } else { 1.0 };
            }
        }
        let closed = self.a - &b * &row / reads;
        let left = complement(&vanish, n);
        Ok(eigenvalues(&(left.transpose() * closed * left)))
    }
}

/// Orthonormal columns across rows that are orthonormal.
fn complement(rows: &[RowDVector<f64>], n: usize) -> DMatrix<f64> {
    let mut columns: Vec<DVector<f64>> = rows.iter().map(RowDVector::transpose).collect();
    while columns.len() < n {
        let across = |k: usize| {
            let mut unit = DVector::zeros(n);
            unit[k] = 1.0;
            for _ in 0..2 {
                for own in &columns {
                    unit -= own * own.dot(&unit);
                }
            }
            unit
        };
        let Some(farthest) = (0..n).map(across).max_by(|a, b| a.norm().total_cmp(&b.norm())) else { break };
        columns.push(&farthest / farthest.norm());
    }
    let rest = &columns[rows.len()..];
    if rest.is_empty() { DMatrix::zeros(n, 0) } else { DMatrix::from_columns(rest) }
}
