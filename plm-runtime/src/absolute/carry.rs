//! Bodies without mass or inertia.

use super::independent::Independent;
use super::{Absolute, fill};
use crate::fault::Fault;
use crate::limits::{Limit, refused};
use crate::scalar::Real;
use crate::workspace;

/// Checks the coordinates without mass or inertia at the assembled position: every motion must move others with them.
///
/// The kinetic energy is positive for every motion just if no motion that the joints allow moves nothing but these: no
/// combination of their columns of phi_q vanishes. `limits` has mass and inertia of every body.
///
/// # Errors
/// [`Cause::NotAllowed`](crate::Cause::NotAllowed) for the first coordinate that could move alone;
/// [`Cause::Workspace`](crate::Cause::Workspace).
#[cold]
pub fn check_carried<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    limits: &[[Limit; 2]],
) -> Result<(), Fault> {
    let without = m.inverse_mass().map(|inverse| !inverse.is_finite());
    if !without.contains(&true) {
        return Ok(());
    }
    if let Some(cause) = workspace::refusal::<S, NQ, NC>() {
        return Err(Fault::new(t.to_f64(), cause));
    }
    let mut taken = [S::lit(0.0); NQ];
    for (k, _) in without.iter().enumerate().filter(|(_, without)| **without) {
        taken[k] = S::lit(1.0);
        let rank = rank_of(m, (t, q), &taken);
        let count = taken.iter().filter(|taken| **taken > S::lit(0.0)).count();
        let limit = limits.get(k / 3).map(|of_body| of_body[usize::from(k % 3 == 2)]);
        if let (true, Some(limit)) = (rank != Some(count), limit) {
            return Err(refused(t, &limit, "positive where no other mass carries it", S::lit(0.0)));
        }
    }
    Ok(())
}

/// The rank of phi_q in the columns with weight 1. `None` if it is not finite.
#[inline(never)]
fn rank_of<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    at: (S, &[S; NQ]),
    taken: &[S; NQ],
) -> Option<usize> {
    let mut columns = [[S::lit(0.0); NQ]; NC];
    fill(m, at, taken, &mut columns);
    Independent::of(&mut columns, &mut [[]; NC], S::RANK_TOLERANCE).map(|rows| rows.rank())
}
