//! Conditions of a declaration, and what else makes forces jump, within runs.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

#[path = "../scenes/events.rs"]
mod declared;
mod kinks;
mod near_singular;
#[path = "../support/random.rs"]
mod random;
mod sets;
mod short_events;
mod sides;
