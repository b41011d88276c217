//! Random six-bars from text: chains, the paths of their points, and how straight these are.

pub mod chains;
pub mod known;
pub mod search;
pub mod straight;
pub mod trace;
