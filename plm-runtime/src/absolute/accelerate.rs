//! Accelerations and multipliers by rank.

use super::independent::{Independent, moving_tolerance};
use super::newton::scale_columns;
use crate::fault::{Cause, Fault};
use crate::linalg::dot;
use crate::scalar::Real;
use crate::vector::Vector;

/// Accelerations and multipliers of M a + phi_q^T lambda = Q, phi_q a = gamma.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acceleration<S, const NQ: usize, const NC: usize> {
    /// Accelerations, m/s^2 and rad/s^2.
    pub a: [S; NQ],
    /// Multipliers, N and N m; of all that balance, those with the smallest sum of squares.
    pub lambda: [S; NC],
    /// Multipliers that redundancy leaves undetermined.
    pub undetermined: [bool; NC],
    /// Rank of phi_q.
    pub rank: usize,
}

/// Solves for accelerations and multipliers by rank: with A = phi_q M^-1/2 = U S V^T and b = phi_q M^-1 Q - gamma,
/// a = M^-1 Q - M^-1/2 V S^+ U^T b and lambda = U S^+ S^+ U^T b.
///
/// It works on A itself: digits are lost to its condition number, not to the square of it as with A A^T. Directions that
/// are lost at a singular position do not constrain the accelerations there.
///
/// # Errors
/// [`Cause::Singular`] if the matrix is not finite.
pub fn accelerate<S: Real, const NQ: usize, const NC: usize>(
    t: S,
    inverse_mass: &[S; NQ],
    force: &[S; NQ],
    gamma: &[S; NC],
    phi_q: &[[S; NQ]; NC],
) -> Result<Acceleration<S, NQ, NC>, Fault> {
    let mut a: [S; NQ] = Vector::from_fn(|i| inverse_mass[i] * force[i]);
    let b: [S; NC] = Vector::from_fn(|j| dot(&phi_q[j], &a) - gamma[j]);
    let roots = inverse_mass.map(S::sqrt);
    let mut scaled = *phi_q;
    scale_columns(&mut scaled, &roots);
    let Some(independent) = Independent::rows(scaled, moving_tolerance()) else {
        return Err(Fault::new(t.to_f64(), Cause::Singular { rows: NC }));
    };
    let (y, lambda) = independent.solve(&b);
    for i in 0..NQ {
        a[i] = a[i] - roots[i] * y[i];
    }
    Ok(Acceleration { a, lambda, undetermined: independent.dependent(), rank: independent.rank() })
}
