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
use crate::vector::Vector;

/// Time, s, in which acceleration and jerk give the velocity that decides: at the end of a motion that comes to rest smoothly the
/// acceleration is still that of braking, and the jerk, which ends it, outweighs it.
const SHORTLY: f64 = 1e-5;
/// A prescribed velocity is rounding below so many roundings of the largest of 1 m/s, 1 rad/s and the fastest row.
const STILL: f64 = 64.0;
/// A prescribed acceleration, m/s^2 or rad/s^2, is rounding below so many roundings of 1: in absolute coordinates it is the sum of forces
/// that balance each other.
const UNMOVED: f64 = 4096.0;
/// Acceleration, m/s^2 or rad/s^2, up to which the largest force of a friction does not change the motion of its row.
const UNSHAKEN: f64 = 1e-11;
/// Entry of D, 1/kg or 1/(kg m^2), up to which a carried row may be at rest by a drive.
const NO_DIRECTION: f64 = 1e-9;
/// Speed, m/s or rad/s, at which a row at rest has left its rest: the errors of integration of a zero velocity are smaller, ...
const LEFT: f64 = 1e-9;
/// ... and it is at least so many roundings.
const LEAST_LEFT: f64 = 1024.0;

/// Up to so many times that speed, errors of integration are removed before it is decided if a row has left its rest.
const SLOW: f64 = 1e4;

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
    let share = rows.rate[below::<N>(row)] / T::lit(left::<T>());
    T::lit(1.0) - share * share
}

/// True if a drive lets a friction rest. Its speed is far below the resolution of intervals: its margin is evaluated at points.
pub(super) fn rests<T: Scalar, const N: usize>(
    rows: &Rows<T, N>,
    modes: &Modes<impl Scalar, N>,
    row: usize,
) -> bool {
    let row = below::<N>(row);
    let is_slight = || rows.delassus[row][row].to_f64() <= NO_DIRECTION || rows.is_cancelled(row, 1.0);
    modes.carried[row] && modes.of[row] != Mode::Open && is_slight()
}

fn left<T: Scalar>() -> f64 {
    (LEAST_LEFT * T::PRECISION).max(LEFT)
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
        let is_rounding = most > M::S::ZERO && most * rows.delassus[row][row] <= M::S::lit(UNSHAKEN);
        is_rounding || rows.is_cancelled(row, self.system.length().to_f64())
    }

    /// Removes errors of integration from the velocities by projection, if they could decide that a row is at rest.
    ///
    /// # Errors
    /// Those of [`Contacts::project_joints`].
    pub(super) fn settle_rest(&self, rows: &mut Rows<M::S, N>, u: &M::U, x: &mut M::X) -> Result<(), Fault> {
        let slow = M::S::lit(SLOW * left::<M::S>());
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
        let still = M::S::lit(STILL) * M::S::EPSILON * fastest;
        let mut jerks: Option<[M::S; N]> = None;
        let mut slips = [Slip::ByForces; N];
        for row in indices::<N>() {
            if !self.is_driven(rows, u, row) {
                continue;
            }
            let mut speed = rows.rate[row];
            if speed.abs() <= still {
                let [jerk, shortly] =
                    [jerks.get_or_insert_with(|| self.jerks(rows, u, x))[row], M::S::lit(SHORTLY)];
                speed = shortly * (rows.free[row] + M::S::lit(0.5) * shortly * jerk);
                if speed.abs() <= shortly * M::S::lit(UNMOVED) * M::S::EPSILON {
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
        is_at_rest && rows.rate[below::<N>(row)].abs() < M::S::lit(left::<M::S>())
    }

    /// Rates of the accelerations along the motion, in the modes before the event.
    fn jerks(&self, rows: &Rows<M::S, N>, u: &M::U, x: &M::X) -> [M::S; N] {
        let lambda = multipliers(rows, &u.modes().of).map_or([M::S::ZERO; N], |found| found.lambda);
        let moving = moving_rows(self.system, (self.t, u), x, &lambda);
        Vector::from_fn(|row| moving.free[row].tangents[0])
    }
}
