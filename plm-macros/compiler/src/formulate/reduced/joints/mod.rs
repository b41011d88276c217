//! Joint coordinates: bodies as a tree of joints, and the loops that tie them.

pub(crate) mod chain;
pub(crate) mod coordinates;
pub(crate) mod explicit;
