//! How much a mechanism may have of what has the same room in all.

/// Parameters.
pub(crate) const PARAMETERS: usize = 64;
/// Inputs.
pub(crate) const INPUTS: usize = 32;
/// Conditions, of the state and of the time.
pub(crate) const SWITCHES: usize = 64;
/// Kinks.
pub(crate) const KINKS: usize = 64;
/// Guards and kinks.
pub(crate) const WATCHED: usize = SWITCHES + KINKS;
