//! What happens within runs: conditions, charts, steps that are refused, faults.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod change_points;
mod chart_changes;
mod charts;
mod events;
mod followed;
mod known_times;
#[path = "../support/linkage.rs"]
mod linkage;
#[path = "../support/mechanisms.rs"]
mod mechanisms;
#[path = "../../../tests/support/random.rs"]
mod random;
mod resets;
mod short_events;
