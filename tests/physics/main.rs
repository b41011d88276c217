//! Runs against laws of mechanics, published figures and references of many digits.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]
#![allow(clippy::approx_constant, reason = "the manual prints what it prints")]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

mod absolute;
mod compliance;
#[path = "../scenes/massless.rs"]
mod declared;
mod feedback;
mod gravity;
mod manual;
mod massless;
mod physics;
mod references;
mod scenes;
