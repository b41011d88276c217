//! Where methods fail: each scene beside the value that theory or a reference gives.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(dead_code, reason = "the example shows more of the scenes")]
#![allow(clippy::excessive_precision, reason = "references keep the digits that they were computed with")]

#[path = "../../examples/stability/figures/mod.rs"]
mod figures;
#[path = "../../examples/stability/scenes/mod.rs"]
mod scenes;

mod dead;
mod dyads;
mod extremes;
mod flat;
mod long;
mod near_singular;
mod page;
mod short_events;
mod stiff;
mod theory;
mod waiting;
