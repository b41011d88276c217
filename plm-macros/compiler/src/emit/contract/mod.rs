//! Implementations of the runtime's traits for the mechanism.

pub(super) mod absolute;
pub(super) mod charted;
pub(super) mod conditional;
pub(super) mod contact;
mod contact_motion;
mod contact_projection;
pub(super) mod contact_sliding;
pub(super) mod described;
mod directions;
pub(super) mod limits;
pub(super) mod linear;
pub(super) mod moment;
pub(super) mod pack;
mod pairs;
pub(super) mod ports;
pub(super) mod rate;
pub(super) mod sets;
pub(super) mod singular;
pub(super) mod statics;
pub(super) mod switched;
pub(super) mod system;
pub(crate) mod turns;
