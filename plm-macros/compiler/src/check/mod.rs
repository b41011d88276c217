//! Verdicts: what is wrong with a mechanism that could be read, reported where it was declared.
//!
//! Each check looks at what a pass has made of it, the model, the equations or the assembled start, and changes nothing.

mod branch;
mod connectivity;
mod feedback;
mod finite;
mod formulation;
mod jumps;
mod massless;
mod names;
mod pairs;
mod positive;
mod size;
mod start;
mod verdict;

pub(crate) use branch::check_branches;
pub(crate) use connectivity::check_connectivity;
pub(crate) use feedback::check_feedback;
pub(crate) use formulation::check_formulation;
pub(crate) use jumps::check_jumps;
pub(crate) use massless::check_massless;
pub(crate) use names::check_names;
pub(crate) use pairs::check_pairs;
pub(crate) use size::check_size;
pub(crate) use start::check_start;
