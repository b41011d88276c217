//! Tables of conditions.

/// The conditions, kinks and rows of contact of a mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Switches {
    /// Number of conditions of the state, which have a guard each.
    pub guards: usize,
    /// Number of kinks.
    pub kinks: usize,
    /// Number of conditions of the time alone; their sides stand after those of the state.
    pub times: usize,
    /// Conditions and kinks matter only while others have a certain side.
    pub selective: bool,
    /// By condition and kink the decision that it begins with.
    pub roots: &'static [u16],
    /// Decisions: the condition that is asked, and the next ones by its side. 0 says no, 1 yes.
    pub nodes: &'static [(u8, u16, u16)],
    /// Rows of constraints that have another form on each side of a condition: the row, the condition.
    pub jumps: &'static [(usize, usize)],
    /// Number of rows of contact.
    pub rows: usize,
    /// Number of guards of contact.
    pub contact_guards: usize,
    /// The size of a reaction in the plane bounds a friction.
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
