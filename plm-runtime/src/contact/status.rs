//! What contact rows do, and what was counted of their events, whatever the number of rows.

use super::booked::{ImpactEnergy, Impulse};
use super::modes::Mode;
use super::outcome::Outcome;

/// Counters of the events of contact rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Impacts.
    pub impacts: u64,
    /// Gaps that were open and stay closed from an event on: a touch-down without a bounce, or the end of bouncing.
    pub closures: u64,
    /// Gaps that were closed and are open from an event on; a bounce is an impact and none of these.
    pub openings: u64,
    /// Frictions that slipped, or had no normal force, and stick from an event on.
    pub sticks: u64,
    /// Frictions that stuck, or had no normal force, and slip from an event on, and those that slip the other way.
    pub slips: u64,
    /// Steps of Newton's method for frictions that are bounded by a reaction in the plane, in events.
    pub newton: u64,
    /// Events after which other accelerations satisfy all laws as well.
    pub ambiguous: u64,
    /// Events with impacts that other impulses, with other rates after them, would satisfy as well: in corners, and of several rows
    /// at once by sequential impacts.
    pub ambiguous_impacts: u64,
    /// Events with impacts whose impulses several rows may share in many ways, some of which have a restitution: the rates after them
    /// are one of many.
    pub undetermined_impacts: u64,
    /// Events after which more rows rest than there are freedoms: accelerations are unique, multipliers are not.
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

/// What the contact rows of a mechanism do; of one without contact nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Status<'a> {
    pub(super) modes: &'a [Mode],
    pub(super) carried: &'a [bool],
    pub(super) counts: Counts,
    pub(super) impulses: &'a [Impulse],
    pub(super) energy: ImpactEnergy,
}

impl Status<'_> {
    /// How many guards the rows have: [`guard_count`](super::guard_count) of the places that there are for them.
    #[must_use]
    pub fn guard_count(&self) -> usize {
        if self.modes.is_empty() { 0 } else { super::guard_count(self.modes.len()) }
    }

    /// Do the rows do the same as those of another moment, with no impact between?
    pub(crate) fn has_modes_of(&self, other: &Self) -> bool {
        self.counts.impacts == other.counts.impacts
            && self.modes.iter().zip(other.modes).all(|(mode, other)| mode == other)
            && self.carried.iter().zip(other.carried).all(|(carried, other)| carried == other)
    }

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

    /// The last impulse of a row; none where it has had none. Impulses at one time are added.
    #[must_use]
    pub fn impulse(&self, row: usize) -> Option<Impulse> {
        self.impulses.get(row).copied().filter(|impulse| impulse.time.is_finite())
    }

    /// Energy that impacts have lost since the run began.
    #[must_use]
    pub fn energy(&self) -> ImpactEnergy {
        self.energy
    }

    /// What was counted since the run began.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }
}
