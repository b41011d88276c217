//! Margins of the modes: numbers that are positive as long as a mode applies.

use super::driven::leaves;
use super::loads::Load;
use super::modes::{Mode, Modes};
use super::multipliers::{Multipliers, multipliers};
use super::rows::{Limit, Rows, below, indices};
use crate::scalar::Scalar;

/// Margins of each row. A friction that sticks has two, for the limits to both sides; the third one is for the sign of the reaction with the
/// number of the row.
pub const PER_ROW: usize = 3;
/// The place of the last one among them.
pub(super) const SIGN: usize = 2;

/// A slip may take so much from the determinant since the modes were chosen: nearer to zero forces are rounding, where they have no bound.
pub(super) const UNIQUE: f64 = 1e-8;
/// A friction without a force gets one where its bound, N or N m, is more than one part in so many.
const NO_BOUND: f64 = 1e12;

/// The number of guards that `rows` contact rows have: three each, and the determinant of the active rows.
#[must_use]
pub const fn guard_count(rows: usize) -> usize {
    PER_ROW * rows + 1
}

/// Gives each margin with its index; false if the multipliers are not unique in these modes, or not finite.
pub(super) fn margins<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    (modes, orientation): (&Modes<impl Scalar, N>, T),
    each: &mut impl FnMut(usize, T),
) -> bool {
    let Some(found) = multipliers(rows, &modes.of) else { return false };
    each_margin(rows, (modes, orientation), &found, each);
    true
}

/// Gives each margin with its index, where these are the multipliers.
pub(super) fn each_margin<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    (modes, orientation): (&Modes<impl Scalar, N>, T),
    Multipliers { lambda, determinant, .. }: &Multipliers<T, N>,
    each: &mut impl FnMut(usize, T),
) {
    let far = T::lit(1.0);
    for row in 0..N {
        let mode = modes.of[row];
        let [first, second] = match mode {
            _ if modes.is_carried(row) => [leaves(rows, modes, row), far],
            Mode::Open => [rows.gap[row], far],
            Mode::Closed => [lambda[row], far],
            Mode::Off => [far - T::lit(NO_BOUND) * bound(rows, row, lambda), far],
            Mode::Sticks => stick(rows, row, lambda),
            Mode::Forwards | Mode::Backwards => [mode.sign::<T>() * rows.rate[row], far],
        };
        each(PER_ROW * row, first);
        each(PER_ROW * row + 1, second);
    }
    for load in 0..N {
        let bounds = |row: usize| rows.read[row][load] && modes.of[row] != Mode::Off;
        let is_read = matches!(rows.load[load], Load::Line { .. }) && indices::<N>().any(bounds);
        each(PER_ROW * load + SIGN, if is_read { rows.size(load, lambda) } else { far });
    }
    let least = if modes.of.iter().any(|mode| mode.slips()) { UNIQUE } else { 0.0 };
    each(PER_ROW * N, orientation * *determinant - T::lit(least));
}

/// The limits of a friction to both sides together, with the shares of reactions as they are; zero where none can have a force.
fn bound<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize, lambda: &[T; N]) -> T {
    let adhesion = &rows.adhesion[below::<N>(row)];
    let add = |limit: &Limit<T, N>| {
        let shares = rows.loads_of(row).map(|load| limit.share[below::<N>(load)]);
        shares.fold(limit.at(lambda), |sum, share| sum + share)
    };
    let [lower, upper] = [&adhesion.lower, &adhesion.upper].map(add);
    lower + upper
}

/// How far a row that sticks is from either limit.
pub(super) fn stick<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize, lambda: &[T; N]) -> [T; 2] {
    let row = below::<N>(row);
    let adhesion = &rows.adhesion[row];
    let [lower, upper] = [&adhesion.lower, &adhesion.upper].map(|limit| rows.limit(row, limit, lambda));
    [lambda[row] + lower, upper - lambda[row]]
}
