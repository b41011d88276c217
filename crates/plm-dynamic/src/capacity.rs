//! Capacities that all sizes of `Dynamic` have in common.

/// Parameters.
pub(crate) const PARAMETERS: usize = 64;
/// Inputs.
pub(crate) const INPUTS: usize = 32;
/// Conditions, of the state and of the time; and guards, those of rows of contact among them.
pub const SWITCHES: usize = 64;
/// Kinks.
pub(crate) const KINKS: usize = 96;
/// Rows of contact, and reactions that bound frictions.
pub const ROWS: usize = 16;
/// Events that set states.
pub(crate) const EVENTS: usize = 16;
