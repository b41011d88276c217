//! Trees: elimination from the tips to the ground, and back.

pub(crate) mod articulated;
pub(crate) mod augmented;
pub(crate) mod reactions;
pub(crate) mod spatial;
