//! Capacities that sizes of `Dynamic` have in common.

use plm_runtime::contact;

/// Parameters.
pub(crate) const PARAMETERS: usize = 64;
/// Inputs.
pub(crate) const INPUTS: usize = 32;
/// Conditions, of the state and of the time; in the sizes of few bodies, guards of rows of contact among them.
pub(crate) const SWITCHES: usize = 64;
/// Kinks.
pub(crate) const KINKS: usize = 96;
/// Rows of contact, and reactions that bound frictions, in the sizes of few bodies.
pub(crate) const ROWS: usize = 12;
/// Those in the largest size.
pub(crate) const MOST_ROWS: usize = 32;
/// Conditions with guards of rows of contact in the largest size.
pub(crate) const MOST_GUARDS: usize = SWITCHES + contact::PER_ROW * MOST_ROWS;
/// Events that set states.
pub(crate) const EVENTS: usize = 16;
