//! Where methods fail: each scene beside the value that theory or a reference gives.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

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
