//! Kinematics of contact rows: the quantities at a state that need no forces.

use super::loads::Load;
use super::modes::Modes;
use super::rows::{Rows, below, indices};
use crate::scalar::Scalar;

/// Gaps and rates of all rows, and the kinds of their loads.
#[derive(Clone, Copy, Debug)]
pub struct Kinematics<T, const N: usize> {
    /// As [`Rows::gap`].
    pub gap: [T; N],
    /// As [`Rows::rate`].
    pub rate: [T; N],
    /// As [`Rows::load`].
    pub load: [Load; N],
    /// As [`Rows::read`].
    pub read: [[bool; N]; N],
    /// True for rows whose limits depend on multipliers.
    pub is_coupled: [bool; N],
}

impl<T: Scalar, const N: usize> Kinematics<T, N> {
    /// Zeros, and no loads.
    #[must_use]
    pub fn none() -> Self {
        Self {
            gap: [T::ZERO; N],
            rate: [T::ZERO; N],
            load: [Load::Nothing; N],
            read: [[false; N]; N],
            is_coupled: [false; N],
        }
    }

    /// Kinematics of known rows.
    pub(super) fn of(rows: &Rows<T, N>) -> Self {
        let Rows { gap, rate, load, read, .. } = *rows;
        let is_coupled = core::array::from_fn(|row| {
            let mut limits = [&rows.kinetic[row].lower, &rows.kinetic[row].upper].into_iter();
            limits.any(|limit| limit.by.iter().any(|by| by.to_f64() != 0.0))
        });
        Self { gap, rate, load, read, is_coupled }
    }

    /// Rows with these gaps and rates, without any other data.
    #[must_use]
    pub fn rows(self) -> Rows<T, N> {
        let Self { gap, rate, load, read, .. } = self;
        Rows { gap, rate, load, read, ..Rows::none() }
    }

    /// True if a reaction is a force along a line, whose sign is constant during a step.
    pub(super) fn is_line(&self, load: usize) -> bool {
        matches!(self.load[below::<N>(load)], Load::Line { .. })
    }

    /// True if a reaction bounds a row that slips.
    pub(super) fn bounds_slip(&self, load: usize, modes: &Modes<impl Scalar, N>) -> bool {
        let load = below::<N>(load);
        indices::<N>().any(|row| self.read[row][load] && modes.of[row].slips())
    }

    /// True if guards depend on forces while no row is a constraint. A bound by a reaction has a sign, and it couples
    /// the slipping rows.
    pub(super) fn reads_forces(&self, modes: &Modes<impl Scalar, N>) -> bool {
        indices::<N>()
            .any(|row| modes.of[row].slips() && (self.read[row].contains(&true) || self.is_coupled[row]))
    }
}
