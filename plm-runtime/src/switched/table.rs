//! Tables of conditions.

/// The conditions, kinks and rows of contact of a mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Switches {
    /// Number of conditions of the state, which have a guard each.
    pub guards: usize,
    /// Number of kinks.
    pub kinks: usize,
    /// Number of conditions of the time alone; their sides come after those of the state.
    pub times: usize,
    /// True if conditions and kinks matter only while others have a certain side.
    pub selective: bool,
    /// First decision of each condition and kink.
    pub roots: &'static [u16],
    /// Decisions: the condition that is read, and the next decision for each of its sides. Decision 0 is no,
    /// 1 is yes.
    pub nodes: &'static [(u8, u16, u16)],
    /// Rows of constraints that have another form on each side of a condition: the row, the condition.
    pub jumps: &'static [(usize, usize)],
    /// Number of rows of contact.
    pub rows: usize,
    /// Number of guards of contact.
    pub contact_guards: usize,
    /// True if the size of a reaction in the plane bounds a friction.
    pub bends: bool,
}

impl Switches {
    /// No conditions, no contact.
    pub const NONE: Self = Self {
        guards: 0,
        kinks: 0,
        times: 0,
        selective: false,
        roots: &[],
        nodes: &[],
        jumps: &[],
        rows: 0,
        contact_guards: 0,
        bends: false,
    };
}
