//! Public items: the mechanism, its start values and inputs, a state that can be read.

pub(super) mod constants;
pub(super) mod implicit;
pub(super) mod input;
pub(super) mod mechanism;
pub(super) mod outputs;
mod rk4;
mod sides;
pub(super) mod solved;
pub(super) mod start;
pub(super) mod state;
pub(super) mod step;
pub(super) mod tables;
