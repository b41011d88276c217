//! Outcome of an event of contact rows.

use super::impact::Doubts;
use super::modes::{Mode, Modes};
use crate::scalar::Scalar;

/// Outcome of an event: counts of what changed, and doubts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Number of impacts.
    pub impacts: u32,
    /// Gaps that were open before and are closed from now on. This count and the next three are zero at the
    /// start of a run.
    pub closures: u32,
    /// Gaps that were closed before and are open from now on.
    pub openings: u32,
    /// Frictions that stick from now on.
    pub sticks: u32,
    /// Frictions that slip from now on, or reverse their slip.
    pub slips: u32,
    /// Steps of Newton's method for reactions in the plane.
    pub newton: u32,
    /// True if other accelerations of the rows satisfy all laws as well.
    pub is_ambiguous: bool,
    /// Ambiguities of its impacts.
    pub doubts: Doubts,
    /// True if more rows are at rest than there are degrees of freedom: accelerations are unique, multipliers
    /// are not.
    pub is_undetermined: bool,
}

impl Outcome {
    /// Counts the rows whose modes differ.
    pub(super) fn compare<S: Scalar, const N: usize>(&mut self, before: &Modes<S, N>, after: &Modes<S, N>) {
        let sticks = |modes: &Modes<S, N>, i: usize| modes.is_sticking(i);
        for i in 0..N {
            let (was, is) = (before.of[i], after.of[i]);
            let is_gap = matches!(is, Mode::Open | Mode::Closed);
            let opens = is_gap && after.is_open(i);
            self.openings += u32::from(opens && (was == Mode::Closed || before.carried[i]));
            self.closures += u32::from(is_gap && !opens && before.is_open(i));
            let has_stuck = sticks(before, i);
            self.sticks += u32::from(!is_gap && sticks(after, i) && !has_stuck);
            self.slips += u32::from(is.slips() && !after.carried[i] && (was != is || before.carried[i]));
        }
    }
}
