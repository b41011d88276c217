//! Frictions whose slip no contact force changes: a drive prescribes it, or the row has no direction at a pose.
//!
//! Such a row has D_ii = 0. Its slip is a known function of time, and so is its side: that of the velocity; if the velocity is zero, that
//! of the acceleration; if both are zero, that of the jerk. A row that has none of the three is carried, with no force of its own, until it
//! [`leaves`] its rest. The rows that carry it share its load with the friction in an arbitrary way.

use super::event::{Event, moving_rows};
use super::margins::stick;
use super::modes::{Mode, Modes};
use super::multipliers::multipliers;
use super::project::project;
use super::rows::{Law, Rows, below, indices};
use super::{Contacts, Modal};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::tolerances::{SHORTLY, SLIGHT, SLOW_AT_REST, STILL, UNMOVED, UNSHAKEN, left_rest};
use crate::vector::Vector;

/// Cause that decides if a friction slips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slip {
    /// Contact forces, by the laws of friction.
    ByForces,
    /// The motion: the row is at rest.
    Rests,
    /// The motion: the row slips to this side.
    To(Mode),
}

/// Margin of a carried friction: zero when the row leaves a rest that a drive gives it, else 1.
pub(super) fn leaves<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &Modes<impl Scalar, N>,
    row: usize,
) -> T {
    if !rests(rows, modes, row) {
        return T::lit(1.0);
    }
    let share = rows.rate[below::<N>(row)] / T::lit(left_rest(T::PRECISION));
    T::lit(1.0) - share * share
}

/// True if a drive lets a friction rest. Its speed is far below the resolution of intervals: its margin is evaluated at points.
pub(super) fn rests<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &Modes<impl Scalar, N>,
    row: usize,
) -> bool {
    let row = below::<N>(row);
    let is_slight = || rows.delassus[row][row].to_f64() <= SLIGHT.get() || rows.is_cancelled(row, 1.0);
    modes.carried[row] && modes.of[row] != Mode::Open && is_slight()
}

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// True if no contact force changes the rate of this friction: D_ii is zero, or the acceleration by its largest force is rounding.
    fn is_driven(&self, rows: &Rows<M::S, N>, u: &M::U, row: usize) -> bool {
        let row = below::<N>(row);
        if self.system.law(row) != Law::Friction || !self.system.exists(u, row) {
            return false;
        }
        let [lower, upper] = stick(rows, row, &[M::S::ZERO; N]);
        let most = lower.max(upper);
        let is_rounding = most > M::S::ZERO && most * rows.delassus[row][row] <= UNSHAKEN.of::<M::S>();
        is_rounding || rows.is_cancelled(row, self.system.length().to_f64())
    }

    /// Removes errors of integration from the velocities by projection, if they could decide that a row is at rest.
    ///
    /// # Errors
    /// Those of [`Contacts::project_joints`].
    pub(super) fn settle_rest(&self, rows: &mut Rows<M::S, N>, u: &M::U, x: &mut M::X) -> Result<(), Fault> {
        let slow = M::S::lit(SLOW_AT_REST.get() * left_rest(M::S::PRECISION));
        let is_slow = |row: usize| rows.rate[row] != M::S::ZERO && rows.rate[row].abs() <= slow;
        if indices::<N>().any(|row| is_slow(row) && self.is_driven(rows, u, row)) {
            project(self.system, self.t, u, x)?;
            *rows = self.system.rows_at(self.t, u, x);
        }
        Ok(())
    }

    /// Cause of the slip of each friction. The accelerations of rows at rest are rounding, and become zero.
    pub(super) fn slips(&self, rows: &mut Rows<M::S, N>, u: &M::U, x: &M::X) -> [Slip; N] {
        let one = M::S::lit(1.0);
        let fastest = rows.rate.iter().fold(one, |fastest, rate| fastest.max(rate.abs()));
        let still = STILL.of::<M::S>() * M::S::EPSILON * fastest;
        let mut jerks: Option<[M::S; N]> = None;
        let mut slips = [Slip::ByForces; N];
        for row in indices::<N>() {
            if !self.is_driven(rows, u, row) {
                continue;
            }
            let mut speed = rows.rate[row];
            if speed.abs() <= still {
                let [jerk, shortly] =
                    [jerks.get_or_insert_with(|| self.jerks(rows, u, x))[row], SHORTLY.of::<M::S>()];
                speed = shortly * (rows.free[row] + M::S::lit(0.5) * shortly * jerk);
                if speed.abs() <= shortly * UNMOVED.of::<M::S>() * M::S::EPSILON {
                    speed = M::S::ZERO;
                }
            }
            slips[row] = match Mode::of_slip(speed) {
                Some(mode) if !self.has_touched_rest(rows, u, (row, mode)) => Slip::To(mode),
                _ => {
                    rows.free[row] = M::S::ZERO;
                    Slip::Rests
                }
            };
        }
        slips
    }

    /// True if the velocity has come to zero without a change of sign: at the end of a motion that comes to rest smoothly, rounding alone
    /// changes the sign. The row leaves this rest like any other; the event of another row does not end it.
    fn has_touched_rest(&self, rows: &Rows<M::S, N>, u: &M::U, (row, next): (usize, Mode)) -> bool {
        let is_at_rest = match self.occasion.row() {
            Some(own) if own == row => u.modes().of[below::<N>(row)] == next,
            other => other.is_some() && rests(rows, u.modes(), row),
        };
        is_at_rest && rows.rate[below::<N>(row)].abs() < M::S::lit(left_rest(M::S::PRECISION))
    }

    /// Rates of the accelerations along the motion, in the modes before the event.
    fn jerks(&self, rows: &Rows<M::S, N>, u: &M::U, x: &M::X) -> [M::S; N] {
        let lambda = multipliers(rows, &u.modes().of).map_or([M::S::ZERO; N], |found| found.lambda);
        let moving = moving_rows(self.system, (self.t, u), x, &lambda);
        Vector::from_fn(|row| moving.free[row].tangents[0])
    }
}
