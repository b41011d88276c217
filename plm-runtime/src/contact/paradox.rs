//! Painlevé's paradox: slips at which accelerations are no longer unique.
//!
//! A sliding contact has the normal acceleration c_n + p D_nn lambda_n, with p = 1 - sigma mu D_nt/D_nn. At p = 0 no contact force
//! changes it; beyond, sliding and lifting off satisfy all laws at once, or neither does (F. Génot, B. Brogliato, New results on
//! Painlevé paradoxes, European Journal of Mechanics A 18, 1999). With several contacts p is the determinant of all active rows over
//! that of the constraint rows.

use super::margins::UNIQUE;
use super::modes::{Mode, Modes};
use super::multipliers::{Multipliers, equation, multipliers};
use super::rows::{Rows, below, indices};
use crate::scalar::Real;

/// The row without a unique force, and p, if the determinant of the active rows has come to zero. `None` if it has not, or not
/// because of a slip: constraint rows may depend on each other too.
pub(super) fn lost<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &Modes<S, N>) -> Option<(usize, S)> {
    let (of, orientation) = (&modes.of, modes.orientation);
    let is_there = |all: Multipliers<S, N>| orientation * all.determinant >= S::lit(UNIQUE);
    if !of.iter().any(|mode| mode.slips()) || multipliers(rows, of).is_some_and(is_there) {
        return None;
    }
    let p = share(rows, of)?;
    let pairs = indices::<N>().filter_map(|row| Some((row, own_share(rows, of, row)?)));
    let (row, _) = pairs.reduce(|least, next| if next.1 < least.1 { next } else { least })?;
    Some((row, p))
}

/// The ratio p of all rows; zero if multipliers are not unique, `None` if those of the constraint rows alone are not.
pub(super) fn share<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &[Mode; N]) -> Option<S> {
    let only_held = modes.map(|mode| if mode.holds() { mode } else { Mode::Open });
    let held = multipliers(rows, &only_held)?.determinant;
    Some(multipliers(rows, modes).map_or(S::ZERO, |all| all.determinant / held))
}

/// The ratio p of one row with the slips as the only other rows.
fn own_share<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &[Mode; N], row: usize) -> Option<S> {
    let (one, row) = (S::lit(1.0), below::<N>(row));
    let slips = |k: &usize| modes[*k].slips();
    let directions = rows.directions(&[S::ZERO; N], |row| modes[row].slips());
    let of = |k: usize| equation(rows, (modes[k], &directions), k).0;
    match modes[row] {
        mode if mode.slips() => Some(of(row)[row]),
        mode if mode.holds() => {
            let d = &rows.delassus[row];
            Some(indices::<N>().filter(slips).fold(one, |p, k| p - d[k] / d[row] * of(k)[row]))
        }
        _ => None,
    }
}
