//! Margins of the modes: numbers that are positive as long as a mode applies.

use super::modes::{Mode, Modes};
use super::multipliers::{Multipliers, multipliers};
use super::rows::Rows;
use crate::scalar::Scalar;

/// Margins of each row. A row that sticks has two, for the limits to both sides.
pub const PER_ROW: usize = 2;

/// The number of guards that `rows` contact rows have: two each, and the determinant of the active rows.
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
    let Some(Multipliers { lambda, determinant }) = multipliers(rows, &modes.of) else { return false };
    let far = T::lit(1.0);
    for (row, mode) in modes.of.iter().enumerate() {
        let [first, second] = match mode {
            _ if modes.is_carried(row) => [far, far],
            Mode::Open => [rows.gap[row], far],
            Mode::Closed => [lambda[row], far],
            Mode::Off => [far, far],
            Mode::Sticks => stick(rows, row, &lambda),
            Mode::Forwards | Mode::Backwards => [mode.sign::<T>() * rows.rate[row], far],
        };
        each(PER_ROW * row, first);
        each(PER_ROW * row + 1, second);
    }
    each(PER_ROW * N, orientation * determinant);
    true
}

/// How far a row that sticks is from either limit.
pub(super) fn stick<T: Scalar, const N: usize>(rows: &Rows<T, N>, row: usize, lambda: &[T; N]) -> [T; 2] {
    let adhesion = &rows.adhesion[row];
    [lambda[row] + adhesion.lower.at(lambda), adhesion.upper.at(lambda) - lambda[row]]
}
