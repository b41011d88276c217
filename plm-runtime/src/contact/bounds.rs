//! Faults of frictions whose bound is negative.

use super::event::moving_rows;
use super::rows::{Law, Rows, below, indices};
use super::{Contacts, Limit, Modal, lambda_of};
use crate::dual::Dual;
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};

/// A bound below this fraction of the force that would hold the row is rounding.
pub(super) const ROUNDING: f64 = 1e-9;
/// Unit of a bound.
const FORCE: &str = "N or N m";
/// Time, s, within which a bound that comes to zero counts as zero: the accuracy of event times.
const AT_ONCE: f64 = 1e-10;

/// Checks the bounds that no contact force decides, and the coefficients that are the only term of a bound: none may be negative.
///
/// # Errors
/// [`Cause::NotAllowed`] with the row and its bound.
pub(super) fn look_at_bounds<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    for row in indices::<N>().filter(|row| system.exists(u, *row)) {
        let none = rounding(rows, row);
        for found in limits(rows, row).into_iter().filter_map(alone) {
            let what = match found {
                Alone::Force(force) if force < -none => ("bound of friction", force, FORCE),
                Alone::Coefficient(factor) if factor < -M::S::lit(ROUNDING) => {
                    ("coefficient of friction", factor, "")
                }
                _ => continue,
            };
            return Err(negative(system, t, row, what));
        }
    }
    Ok(())
}

/// Checks all bounds as [`look_at_bounds`] does, if at least one bound has a negative term.
///
/// # Errors
/// As [`look_at_bounds`].
pub(super) fn look_at_signs<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    let is_negative = |row: usize| {
        let factors = |limit: &Limit<M::S, N>| limit.by.iter().chain(&limit.share).any(|f| *f < M::S::ZERO);
        let may_fall = system.bound_may_fall(row);
        system.law(row) == Law::Friction
            && limits(rows, row).iter().any(|limit| limit.own < M::S::ZERO || (may_fall && factors(limit)))
    };
    if indices::<N>().any(is_negative) { look_at_bounds(system, t, u, rows) } else { Ok(()) }
}

/// Checks the bounds that depend on the state or the time at their zeros: one that falls is negative from here on.
///
/// # Errors
/// [`Cause::NotAllowed`] with the row.
pub(super) fn look_at_falling_bounds<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    (u, x): (&M::U, &M::X),
    rows: &Rows<M::S, N>,
) -> Result<(), Fault> {
    for row in indices::<N>().filter(|row| system.bound_may_fall(*row) && system.exists(u, *row)) {
        let none = rounding(rows, row);
        let none = if none.is_finite() { none } else { M::S::ZERO };
        let moving = moving_rows(system, (t, u), x, &lambda_of(rows, u.modes()));
        let falls = |found: Alone<Dual<M::S, 1>>| {
            let (Alone::Force(found) | Alone::Coefficient(found)) = found;
            let slope = found.tangents[0];
            slope < M::S::ZERO && found.value.abs() <= none.max(M::S::lit(AT_ONCE) * slope.abs())
        };
        if limits(&moving, row).into_iter().filter_map(alone).any(falls) {
            let what = ("bound of friction, which falls below zero,", M::S::ZERO, FORCE);
            return Err(negative(system, t, row, what));
        }
    }
    Ok(())
}

/// Rounding of a bound; infinite or NaN if the row has no direction.
fn rounding<S: Real, const N: usize>(rows: &Rows<S, N>, row: usize) -> S {
    let row = below::<N>(row);
    S::lit(ROUNDING) * rows.free[row].abs() / rows.delassus[row][row].abs()
}

/// Fault of a negative bound.
fn negative<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    row: usize,
    (what, found, unit): (&'static str, M::S, &'static str),
) -> Fault {
    let found = found.to_f64();
    let cause = Cause::NotAllowed { what, wanted: "finite and not negative", found, unit };
    Fault::of_part(t.to_f64(), system.contact_name(row), cause)
}

/// The least of the limits of a friction that no contact force decides, and of the coefficients that are the only term of a limit;
/// at most 1. A limit that is exactly zero stays zero, and does not count.
pub(super) fn least_bound<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize) -> T {
    let known = limits(rows, row).into_iter().filter_map(alone).map(|found| match found {
        Alone::Force(found) | Alone::Coefficient(found) => found,
    });
    known.filter(|found| *found != T::ZERO).fold(T::lit(1.0), T::min)
}

/// The four limits of a friction.
fn limits<T, const N: usize>(rows: &Rows<T, N>, row: usize) -> [&Limit<T, N>; 4] {
    let row = below::<N>(row);
    let (kinetic, adhesion) = (&rows.kinetic[row], &rows.adhesion[row]);
    [&kinetic.lower, &kinetic.upper, &adhesion.lower, &adhesion.upper]
}

/// Only term of a limit.
enum Alone<T> {
    /// A force, N or N m.
    Force(T),
    /// Coefficient of friction: the factor of a multiplier or of a reaction.
    Coefficient(T),
}

/// The term of a limit that has only one.
fn alone<T: Scalar, const N: usize>(limit: &Limit<T, N>) -> Option<Alone<T>> {
    let mut factors = limit.by.iter().chain(&limit.share).filter(|factor| **factor != T::ZERO);
    match (factors.next(), factors.next()) {
        (None, _) => Some(Alone::Force(limit.own)),
        (Some(factor), None) if limit.own == T::ZERO => Some(Alone::Coefficient(*factor)),
        _ => None,
    }
}
