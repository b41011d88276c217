//! The machines, one file each, which can be copied.

pub mod andrews;
pub mod excavator;
pub mod geneva;
pub mod jansen;
pub mod klann;
pub mod lambda;
pub mod peaucellier;
pub mod pumpjack;
pub mod scissor;
pub mod walschaerts;
pub mod watt;
pub mod whitworth;
pub mod wiper;
