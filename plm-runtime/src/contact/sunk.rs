//! Penetration: gaps that are negative where a row begins to exist.

use super::Contacts;
use super::event::CLOSED;
use super::rows::{below, indices};
use crate::fault::{Cause, Fault};
use crate::scalar::Scalar;

/// Checks the rows that begin to exist by an event.
///
/// # Errors
/// [`Cause::Sunk`] if a gap is negative, [`Cause::Open`] if a constraint is open.
pub fn appear<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    (u, x): (&M::U, &M::X),
    existed: [bool; N],
) -> Result<(), Fault> {
    above((system, t), u, x, |row| !existed[below::<N>(row)])
}

/// Gap, as a fraction of the length of the mechanism, up to which a constraint that begins to exist is led back. Starts are rounded.
pub(super) const ROUNDED: f64 = 1e-4;

/// Checks that the gaps of the rows selected by `of` are not negative, and that constraints among them are closed.
pub(super) fn above<M: Contacts<N>, const N: usize>(
    (system, t): (&M, M::S),
    u: &M::U,
    x: &M::X,
    of: impl Fn(usize) -> bool,
) -> Result<(), Fault> {
    let is_new = |row: &usize| of(*row) && system.exists(u, *row);
    if !indices::<N>().any(|row| is_new(&row)) {
        return Ok(());
    }
    let rows = system.rows_at(t, u, x);
    let gap = |row: usize| rows.gap[below::<N>(row)];
    let is_open = |row: &usize| gap(*row).abs() > M::S::lit(ROUNDED) * system.length();
    if let Some(row) =
        indices::<N>().filter(is_new).filter(|row| system.law(*row).is_constraint()).find(is_open)
    {
        let cause = Cause::Open { gap: gap(row).abs().to_f64() };
        return Err(Fault::of_part(t.to_f64(), system.contact_name(row), cause));
    }
    let is_asked = |row: &usize| is_new(row) && system.law(*row).is_unilateral();
    let deepest = indices::<N>().filter(is_asked).reduce(|a, b| if gap(b) < gap(a) { b } else { a });
    match deepest.filter(|row| gap(*row) < -M::S::lit(CLOSED) * system.length()) {
        Some(row) => {
            let cause = Cause::Sunk { by: -gap(row).to_f64() };
            Err(Fault::of_part(t.to_f64(), system.contact_name(row), cause))
        }
        None => Ok(()),
    }
}
