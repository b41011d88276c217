//! Linear matrix equations by Schur's form (R. H. Bartels, G. W. Stewart, Comm. ACM 15, 1972).

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

use super::{Time, complex};

/// X of A^T X + X A + Q = 0, or of A^T X A - X + Q = 0 for sampled time; none where eigenvalues allow no unique one.
pub(super) fn lyapunov(time: Time, a: &DMatrix<f64>, q: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = a.nrows();
    let (unitary, t) = Schur::try_new(complex(a), f64::EPSILON, 100 * n.max(1))?.unpack();
    let right = unitary.adjoint() * complex(q) * &unitary;
    let adjoint = t.adjoint();
    let mut y: DMatrix<Complex<f64>> = DMatrix::zeros(n, n);
    for j in 0..n {
        let known = y.columns(0, j) * t.view((0, j), (j, 1));
        let (matrix, known) = match time {
            Time::Continuous => (&adjoint + DMatrix::identity(n, n) * t[(j, j)], known),
            Time::Sampled(_) => (&adjoint * t[(j, j)] - DMatrix::identity(n, n), &adjoint * known),
        };
        let mut column = -(right.column(j) + known);
        if !matrix.solve_lower_triangular_mut(&mut column) {
            return None;
        }
        y.set_column(j, &column.column(0));
    }
    let x = (&unitary * y * unitary.adjoint()).map(|number| number.re);
    let symmetric = (&x + x.transpose()) * 0.5;
    symmetric.iter().all(|number| number.is_finite()).then_some(symmetric)
}
