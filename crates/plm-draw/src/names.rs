//! Names of ports, as a picture has them.

use std::fmt;

/// A port by its owner: `ground`, `bar`, `bar[0]`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PortName {
    /// The body, or `ground`.
    pub owner: String,
    /// The port of it.
    pub port: String,
}

/// The owner of ports that stand still.
pub const GROUND: &str = "ground";

impl PortName {
    /// A port of an owner.
    pub fn new(owner: impl Into<String>, port: impl Into<String>) -> PortName {
        PortName { owner: owner.into(), port: port.into() }
    }

    /// Does it belong to the ground?
    pub fn is_of_ground(&self) -> bool {
        self.owner == GROUND
    }
}

impl fmt::Display for PortName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.owner, self.port)
    }
}
