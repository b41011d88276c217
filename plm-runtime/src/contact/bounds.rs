//! Bounds of frictions that are negative.

use super::rows::{Friction, Rows};
use super::{Contacts, Limit};
use crate::fault::{Cause, Fault};
use crate::scalar::Scalar;

/// A bound is rounding below this fraction of the force that would hold the row.
const ROUNDING: f64 = 1e-9;

/// Looks at the bounds that no force of contact decides: each must not be negative.
///
/// # Errors
/// [`Cause::NotAllowed`] with the row and its bound.
pub(super) fn look_at_bounds<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    let is_known =
        |limit: &&Limit<M::S, N>| limit.share == M::S::ZERO && limit.by.iter().all(|by| *by == M::S::ZERO);
    for row in (0..N).filter(|row| system.exists(u, *row)) {
        let bounds = [&rows.kinetic[row], &rows.adhesion[row]];
        let limits = bounds.into_iter().flat_map(|bound| [&bound.lower, &bound.upper]);
        // Infinite, or not a number, where the row has no direction.
        let none = M::S::lit(ROUNDING) * rows.free[row].abs() / rows.delassus[row][row];
        if let Some(limit) = limits.filter(is_known).find(|limit| limit.own < -none) {
            let found = limit.own.to_f64();
            let cause = Cause::NotAllowed {
                what: "bound of friction",
                wanted: "finite and not negative",
                found,
                unit: "N or N m",
            };
            return Err(Fault::of_part(t.to_f64(), system.contact_name(row), cause));
        }
    }
    Ok(())
}

/// The same where only bounds are looked at that are negative by themselves.
///
/// # Errors
/// As [`look_at_bounds`].
pub(super) fn look_at_signs<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    let is_negative =
        |friction: &Friction<M::S, N>| friction.lower.own < M::S::ZERO || friction.upper.own < M::S::ZERO;
    let is_any = rows.kinetic.iter().chain(&rows.adhesion).any(is_negative);
    if is_any { look_at_bounds(system, t, u, rows) } else { Ok(()) }
}
