//! Contact rows of a simulation: their modes, and counters of their events.

use super::Sim;
use crate::contact::{Counts, ImpactEnergy, Impulse, Mode};
use crate::mechanism::{Mechanism, Moment};

impl<M: Mechanism, I> Sim<M, I> {
    /// Counters of contact events: impacts, gaps that close and open, frictions that stick and slip, ambiguous and undetermined ones. They are apart from
    /// [`stats`](Self::stats), so that mechanisms without contact have no room for them.
    pub fn contact_stats(&self) -> Counts {
        M::contacts(&self.state.held()).counts()
    }

    /// The mode of the contact row with this name (`foot.tip`); none where there is no such row.
    ///
    /// A gap is [`Open`](Mode::Open) or [`Closed`](Mode::Closed). A friction [sticks](Mode::Sticks), slips
    /// [forwards](Mode::Forwards) or [backwards](Mode::Backwards), or is [off](Mode::Off) as long as nothing pushes.
    pub fn contact(&self, name: &str) -> Option<Mode> {
        self.contacts().find(|(row, _)| *row == name).map(|(_, mode)| mode)
    }

    /// Every contact row with its name and its mode, in the order of their declaration.
    pub fn contacts(&self) -> impl Iterator<Item = (&'static str, Mode)> {
        let (mechanism, held) = (self.state.mechanism(), self.state.held());
        (0..mechanism.contact_count())
            .filter_map(move |row| Some((mechanism.contact_name(row), M::contacts(&held).mode(row)?)))
    }

    /// The last impulse of the contact row with this name, N s or N m s, and its time; none where it has had none, or there is no such
    /// row. The impulse of a gap is positive, that of a friction has the sign of its force.
    pub fn impulse(&self, name: &str) -> Option<Impulse> {
        let (mechanism, held) = (self.state.mechanism(), self.state.held());
        let row = (0..mechanism.contact_count()).find(|row| mechanism.contact_name(*row) == name)?;
        M::contacts(&held).impulse(row)
    }

    /// The energy that impacts have lost since the run began, in all and in the last one.
    pub fn impact_energy(&self) -> ImpactEnergy {
        M::contacts(&self.state.held()).energy()
    }

    /// True while more contact rows rest than there are freedoms: accelerations are unique, pushes and frictions are not, and
    /// those that are given are one of many solutions.
    pub fn is_undetermined(&self) -> bool {
        M::contacts(&self.state.held()).is_undetermined()
    }
}
