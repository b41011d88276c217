//! Contact rows of a simulation: their modes, and counters of their events.

use super::Sim;
use crate::contact::{Counts, ImpactEnergy, Impulse, Mode};
use crate::mechanism::{Mechanism, Moment};

impl<M: Mechanism, I> Sim<M, I> {
    /// Counters of contact events: impacts, gaps that close and open, frictions that stick and slip, ambiguous and undetermined ones. They
    /// are not part of [`stats`](Self::stats), so that mechanisms without contact need no memory for them.
    pub fn contact_stats(&self) -> Counts {
        M::contacts(&self.state.held()).counts()
    }

    /// Mode of the contact row with this name (`foot.tip`); `None` if there is no such row.
    ///
    /// A gap is [`Open`](Mode::Open) or [`Closed`](Mode::Closed). A friction [sticks](Mode::Sticks), slips [forwards](Mode::Forwards) or
    /// [backwards](Mode::Backwards), or is [off](Mode::Off) while it has no normal force.
    pub fn contact(&self, name: &str) -> Option<Mode> {
        self.contacts().find(|(row, _)| *row == name).map(|(_, mode)| mode)
    }

    /// All contact rows with their names and modes, in the order of declaration.
    pub fn contacts(&self) -> impl Iterator<Item = (&'static str, Mode)> {
        let (mechanism, held) = (self.state.mechanism(), self.state.held());
        (0..mechanism.contact_count())
            .filter_map(move |row| Some((mechanism.contact_name(row), M::contacts(&held).mode(row)?)))
    }

    /// Last impulse of the contact row with this name, N s or N m s, and its time; `None` before the first impulse, or if there is no such
    /// row. The impulse of a gap is positive, that of a friction has the sign of its force.
    pub fn impulse(&self, name: &str) -> Option<Impulse> {
        let (mechanism, held) = (self.state.mechanism(), self.state.held());
        let row = (0..mechanism.contact_count()).find(|row| mechanism.contact_name(*row) == name)?;
        M::contacts(&held).impulse(row)
    }

    /// Energy lost in impacts since the run began: the total, and that of the last impact.
    pub fn impact_energy(&self) -> ImpactEnergy {
        M::contacts(&self.state.held()).energy()
    }

    /// True while more contact rows are at rest than there are degrees of freedom. Accelerations are unique then; the contact forces and
    /// frictions returned are one of many solutions.
    pub fn is_undetermined(&self) -> bool {
        M::contacts(&self.state.held()).is_undetermined()
    }
}
