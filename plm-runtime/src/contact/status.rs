//! Status of contact rows, and counters of their events, for any number of rows.

use super::booked::{ImpactEnergy, Impulse};
use super::modes::Mode;
use super::outcome::Outcome;

/// Counters of the events of contact rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Impacts.
    pub impacts: u64,
    /// Gaps that were open and stay closed after an event: a touch-down without a bounce, or the end of bouncing.
    pub closures: u64,
    /// Gaps that were closed and are open after an event; a bounce is an impact and not counted here.
    pub openings: u64,
    /// Frictions that slipped, or had no normal force, and stick after an event.
    pub sticks: u64,
    /// Frictions that stuck, or had no normal force, and slip after an event, and those that reverse their slip.
    pub slips: u64,
    /// Steps of Newton's method for frictions that are bounded by a reaction in the plane, in events.
    pub newton: u64,
    /// Events after which other accelerations satisfy all laws as well.
    pub ambiguous: u64,
    /// Events with impacts for which other impulses, with other rates after them, satisfy all laws as well: in corners, and of
    /// several rows at once if impacts are solved in sequence.
    pub ambiguous_impacts: u64,
    /// Events with impacts whose impulses several rows may share in many ways while some of them have a restitution: the rates after
    /// them are one of many.
    pub undetermined_impacts: u64,
    /// Events after which more rows are at rest than there are degrees of freedom: accelerations are unique, multipliers are not.
    pub undetermined: u64,
}

impl Counts {
    /// Counts an event.
    pub(super) fn add(&mut self, outcome: &Outcome) {
        self.impacts += u64::from(outcome.impacts);
        self.closures += u64::from(outcome.closures);
        self.openings += u64::from(outcome.openings);
        self.sticks += u64::from(outcome.sticks);
        self.slips += u64::from(outcome.slips);
        self.newton += u64::from(outcome.newton);
        self.ambiguous += u64::from(outcome.is_ambiguous);
        self.ambiguous_impacts += u64::from(outcome.doubts.is_ambiguous);
        self.undetermined_impacts += u64::from(outcome.doubts.is_undetermined);
        self.undetermined += u64::from(outcome.is_undetermined);
    }
}

/// Status of the contact rows of a mechanism; empty without contact.
#[derive(Clone, Copy, Debug, Default)]
pub struct Status<'a> {
    pub(super) modes: &'a [Mode],
    pub(super) carried: &'a [bool],
    pub(super) counts: Counts,
    pub(super) impulses: &'a [Impulse],
    pub(super) energy: ImpactEnergy,
}

impl Status<'_> {
    /// Number of guards of the rows: [`guard_count`](super::guard_count) of the rows that there is room for.
    #[must_use]
    pub fn guard_count(&self) -> usize {
        if self.modes.is_empty() { 0 } else { super::guard_count(self.modes.len()) }
    }

    /// True if the rows have the modes of `other`, another moment, with no impact in between.
    pub(crate) fn has_modes_of(&self, other: &Self) -> bool {
        self.counts.impacts == other.counts.impacts
            && self.modes.iter().zip(other.modes).all(|(mode, other)| mode == other)
            && self.carried.iter().zip(other.carried).all(|(carried, other)| carried == other)
    }

    /// Mode of a row; a row that others carry is reported as closed or sticking.
    #[must_use]
    pub fn mode(&self, row: usize) -> Option<Mode> {
        let is_carried = self.carried.get(row) == Some(&true);
        self.modes.get(row).map(|mode| match mode {
            Mode::Open if is_carried => Mode::Closed,
            Mode::Off | Mode::Forwards | Mode::Backwards if is_carried => Mode::Sticks,
            mode => *mode,
        })
    }

    /// True if more rows are at rest than there are degrees of freedom: accelerations are unique, multipliers are not.
    #[must_use]
    pub fn is_undetermined(&self) -> bool {
        self.carried.contains(&true)
    }

    /// Last impulse of a row; `None` before the first one. Impulses at one time are added.
    #[must_use]
    pub fn impulse(&self, row: usize) -> Option<Impulse> {
        self.impulses.get(row).copied().filter(|impulse| impulse.time.is_finite())
    }

    /// Energy of the impacts since the run began.
    #[must_use]
    pub fn energy(&self) -> ImpactEnergy {
        self.energy
    }

    /// Counters of the events since the run began.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }
}
