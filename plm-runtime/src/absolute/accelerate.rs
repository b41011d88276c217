//! Accelerations and multipliers by rank.

use super::independent::{Independent, moving_tolerance, scale_columns};
use crate::fault::{Cause, Fault};
use crate::linalg::{diagonal, dot};
use crate::scalar::Real;
use crate::vector::Vector;
use crate::workspace;

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
/// `phi_q` puts its entries into a matrix of zeros.
///
/// # Errors
/// [`Cause::Singular`] if the matrix is not finite, [`Cause::Workspace`] if it takes more of the stack than is allowed.
#[cold]
pub fn accelerate<S: Real, const NQ: usize, const NC: usize>(
    t: S,
    inverse_mass: &[S; NQ],
    force: &[S; NQ],
    gamma: &[S; NC],
    phi_q: impl FnOnce(&mut [[S; NQ]; NC]),
) -> Result<Acceleration<S, NQ, NC>, Fault> {
    match workspace::refusal::<S, NQ, NC>() {
        Some(cause) => Err(Fault::new(t.to_f64(), cause)),
        None => by_rank(t, inverse_mass, force, gamma, phi_q),
    }
}

/// Holds the matrices, which nothing before it must pay for.
#[inline(never)]
fn by_rank<S: Real, const NQ: usize, const NC: usize>(
    t: S,
    inverse_mass: &[S; NQ],
    force: &[S; NQ],
    gamma: &[S; NC],
    phi_q: impl FnOnce(&mut [[S; NQ]; NC]),
) -> Result<Acceleration<S, NQ, NC>, Fault> {
    // One by one: a build without optimisation copies what is made as a pair.
    let mut rows = [[S::lit(0.0); NQ]; NC];
    let mut combinations = [[S::lit(0.0); NC]; NC];
    phi_q(&mut rows);
    diagonal(&mut combinations);
    let mut a: [S; NQ] = Vector::from_fn(|i| inverse_mass[i] * force[i]);
    let b: [S; NC] = Vector::from_fn(|j| dot(&rows[j], &a) - gamma[j]);
    let roots = inverse_mass.map(S::sqrt);
    scale_columns(&mut rows, &roots);
    let Some(independent) = Independent::of(&mut rows, &mut combinations, moving_tolerance()) else {
        return Err(Fault::new(t.to_f64(), Cause::Singular { rows: NC }));
    };
    let (y, lambda) = independent.solve(&b);
    for i in 0..NQ {
        a[i] = a[i] - roots[i] * y[i];
    }
    Ok(Acceleration { a, lambda, undetermined: independent.dependent(), rank: independent.rank() })
}
