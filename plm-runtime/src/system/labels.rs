//! Names of states and conditions, for diagnostics.

use crate::system::Rate;

/// Names of a mechanism's states, conditions and rows of contact.
#[derive(Clone, Copy, Debug)]
pub struct LabelTable {
    /// Parts that the numbers of the state belong to.
    pub parts: PartNames,
    /// Name of each number of the state, as `arm.omega`; in charts, of the coordinate that it is in each.
    pub states: &'static [&'static str],
    /// Chart by chart, names of its coordinates, then of their rates; empty where one chart has those of `states`.
    pub in_charts: &'static [&'static str],
    /// Names of the guards: of conditions, then of contact.
    pub guards: &'static [&'static str],
    /// Texts of the same, as they were written.
    pub conditions: &'static [&'static str],
    /// Names of the conditions on the time alone.
    pub instants: &'static [&'static str],
    /// Names of the rows of contact, as `foot.tip`.
    pub contacts: &'static [&'static str],
}

impl LabelTable {
    /// Without any name.
    pub const NONE: Self = Self {
        parts: PartNames::Numbers(&[]),
        states: &[],
        in_charts: &[],
        guards: &[],
        conditions: &[],
        instants: &[],
        contacts: &[],
    };
}

/// Parts that the numbers of a state belong to.
#[derive(Clone, Copy, Debug)]
pub enum PartNames {
    /// Part of each number.
    Numbers(&'static [&'static str]),
    /// Bodies, which have three absolute coordinates each, and first-order states.
    Bodies {
        /// Names of the bodies.
        bodies: &'static [&'static str],
        /// Names of the states.
        states: &'static [&'static str],
    },
}

impl PartNames {
    /// Part of a number of a state with so many coordinates.
    fn of(&self, number: usize, coordinates: usize) -> Option<&'static str> {
        match self {
            Self::Numbers(parts) => parts.get(number),
            Self::Bodies { bodies, states } => match number.checked_sub(2 * coordinates) {
                Some(state) => states.get(state),
                None => bodies.get(number % coordinates.max(1) / 3),
            },
        }
        .copied()
    }
}

/// Names of states and conditions, by which faults and notices tell them. Without names they tell numbers and times alone.
pub trait Labels: Rate {
    /// All names.
    fn labels(&self) -> &'static LabelTable {
        &LabelTable::NONE
    }

    /// Number of the chart that `u` holds; nothing where names are the same in all charts.
    fn chart_of(&self, u: &Self::U) -> Option<usize> {
        let _ = u;
        None
    }

    /// The part that the state with this index belongs to.
    fn part_of_state(&self, index: usize) -> &'static str {
        self.number_at(index)
            .and_then(|number| self.labels().parts.of(number, self.coordinates()))
            .unwrap_or_default()
    }

    /// The name of the state with this index, `arm.omega`; in charts, of the coordinate that it is in each.
    fn name_of_state(&self, index: usize) -> &'static str {
        let name = self.number_at(index).and_then(|number| self.labels().states.get(number));
        name.copied().unwrap_or_else(|| self.part_of_state(index))
    }

    /// The name of the state with this index in the chart that `u` holds.
    fn name_in_chart(&self, u: &Self::U, index: usize) -> &'static str {
        let count = 2 * self.coordinates();
        let place = self.number_at(index).filter(|number| *number < count).zip(self.chart_of(u));
        let name = place.and_then(|(number, chart)| self.labels().in_charts.get(chart * count + number));
        name.copied().unwrap_or_else(|| self.name_of_state(index))
    }

    /// The condition with this index.
    fn guard_name(&self, index: usize) -> &'static str {
        self.labels().guards.get(index).copied().unwrap_or_default()
    }

    /// The contact row with this index, `foot.tip`.
    fn contact_name(&self, row: usize) -> &'static str {
        self.labels().contacts.get(row).copied().unwrap_or_default()
    }

    /// All conditions as they were written, by index, for faults that name several.
    fn conditions(&self) -> &'static [&'static str] {
        self.labels().conditions
    }
}
