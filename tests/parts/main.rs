//! Parts of the library beside closed forms, published figures and conservation laws.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

#[macro_use]
#[path = "../scenes/parts/mod.rs"]
mod declared;

mod belts;
mod brakes;
mod bristles;
mod catches;
mod contact;
mod functions;
mod gears;
mod hydraulics;
mod joints;
mod loose;
mod motors;
mod plates;
mod pneumatics;
mod ropes;
mod screws;
mod signals;
mod starts;

/// Equal within an amount.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found} instead of {expected}");
}
