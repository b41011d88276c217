//! Contact rows of a simulation: their modes, and counters of their events.

use super::Sim;
use crate::contact::{Counts, Mode};
use crate::mechanism::{Mechanism, Moment};

impl<M: Mechanism, I> Sim<M, I> {
    /// Counters of contact events: impacts, gaps that stay closed, ambiguous and undetermined ones. They are apart from
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
        (0..M::CONTACTS)
            .filter_map(move |row| Some((mechanism.contact_name(row), M::contacts(&held).mode(row)?)))
    }

    /// True while more contact rows rest than there are freedoms: accelerations are unique, pushes and frictions are not, and
    /// those that are given are one of many solutions.
    pub fn is_undetermined(&self) -> bool {
        M::contacts(&self.state.held()).is_undetermined()
    }
}
