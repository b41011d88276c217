//! Names of states and conditions, for diagnostics.

use crate::system::Rate;

/// Names of states and conditions in faults and notices. Without names these report numbers and times alone.
pub trait Labels: Rate {
    /// The part that the state with this index belongs to.
    fn part_of_state(&self, index: usize) -> &'static str {
        let _ = index;
        ""
    }

    /// The name of the state with this index, `arm.omega`; in charts, of the coordinate that it is in each.
    fn name_of_state(&self, index: usize) -> &'static str {
        self.part_of_state(index)
    }

    /// The name of the state with this index in the chart that `u` holds.
    fn name_in_chart(&self, u: &Self::U, index: usize) -> &'static str {
        let _ = u;
        self.name_of_state(index)
    }

    /// The condition with this index.
    fn guard_name(&self, index: usize) -> &'static str {
        let _ = index;
        ""
    }

    /// The contact row with this index, `foot.tip`.
    fn contact_name(&self, row: usize) -> &'static str {
        let _ = row;
        ""
    }

    /// All conditions as they were written, by index, for faults that name several.
    fn conditions(&self) -> &'static [&'static str] {
        &[]
    }
}
