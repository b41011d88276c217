//! Margins of the modes: numbers that are positive while a mode applies.

use super::driven::leaves;
use super::loads::Load;
use super::modes::{Mode, Modes};
use super::multipliers::{Multipliers, multipliers};
use super::rows::{Limit, Rows, below, indices};
use crate::scalar::Scalar;

/// Number of margins of each row. A friction that sticks has two, for the limits on both sides; the third one is for the sign of the
/// reaction with the number of the row.
pub const PER_ROW: usize = 3;
/// Index of the third margin.
pub(super) const SIGN: usize = 2;

/// Least determinant, relative to that when the modes were chosen, that a slip may lead to: nearer to zero unbounded forces are rounding.
pub(super) const UNIQUE: f64 = 1e-8;
/// A friction without a force gets one if its bound, N or N m, exceeds the inverse of this number.
const NO_BOUND: f64 = 1e12;

/// Number of guards of `rows` contact rows: three each, and the determinant of the active rows.
#[must_use]
pub const fn guard_count(rows: usize) -> usize {
    PER_ROW * rows + 1
}

/// Gives each margin with its index. Returns false if the multipliers in these modes are not unique, or not finite.
pub(super) fn margins<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    (modes, orientation): (&Modes<impl Scalar, N>, T),
    each: &mut impl FnMut(usize, T),
) -> bool {
    let Some(found) = multipliers(rows, &modes.of) else { return false };
    each_margin(rows, (modes, orientation), &found, each);
    true
}

/// Gives each margin with its index, for these multipliers.
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

/// Sum of the static limits of a friction on both sides, with the coefficients of reactions added; zero if none can have a force.
fn bound<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize, lambda: &[T; N]) -> T {
    let adhesion = &rows.adhesion[below::<N>(row)];
    let add = |limit: &Limit<T, N>| {
        let shares = rows.loads_of(row).map(|load| limit.share[below::<N>(load)]);
        shares.fold(limit.at(lambda), |sum, share| sum + share)
    };
    let [lower, upper] = [&adhesion.lower, &adhesion.upper].map(add);
    lower + upper
}

/// Distances of the force of a sticking row from its two limits.
pub(super) fn stick<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize, lambda: &[T; N]) -> [T; 2] {
    let row = below::<N>(row);
    let adhesion = &rows.adhesion[row];
    let [lower, upper] = [&adhesion.lower, &adhesion.upper].map(|limit| rows.limit(row, limit, lambda));
    [lambda[row] + lower, upper - lambda[row]]
}
