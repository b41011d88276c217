//! What contact rows do, and what was counted of their events, whatever the number of rows.

use super::event::Outcome;
use super::modes::Mode;

/// Counters of the events of contact rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Impacts.
    pub impacts: u64,
    /// Gaps that were open and stay closed from an event on: a touch-down without a bounce, or the end of bouncing.
    pub closures: u64,
    /// Events behind which other accelerations satisfy all laws as well.
    pub ambiguous: u64,
    /// Events behind which more rows rest than there are freedoms: accelerations are unique, multipliers are not.
    pub undetermined: u64,
}

impl Counts {
    /// Counts an event.
    pub(super) fn add(&mut self, outcome: &Outcome) {
        self.impacts += u64::from(outcome.impacts);
        self.closures += u64::from(outcome.closures);
        self.ambiguous += u64::from(outcome.is_ambiguous);
        self.undetermined += u64::from(outcome.is_undetermined);
    }
}

/// What the contact rows of a mechanism do; of one without contact nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Status<'a> {
    pub(super) modes: &'a [Mode],
    pub(super) carried: &'a [bool],
    pub(super) counts: Counts,
}

impl Status<'_> {
    /// What a row does; a row that others hold is closed, or sticks.
    #[must_use]
    pub fn mode(&self, row: usize) -> Option<Mode> {
        let is_carried = self.carried.get(row) == Some(&true);
        self.modes.get(row).map(|mode| match mode {
            Mode::Open if is_carried => Mode::Closed,
            Mode::Off | Mode::Forwards | Mode::Backwards if is_carried => Mode::Sticks,
            mode => *mode,
        })
    }

    /// More rows rest than there are freedoms: accelerations are unique, multipliers are not.
    #[must_use]
    pub fn is_undetermined(&self) -> bool {
        self.carried.contains(&true)
    }

    /// What was counted since the run began.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }
}
