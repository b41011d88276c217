//! Parts of the library beside closed forms, published figures and conservation laws.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[path = "../support/beside_text.rs"]
mod beside_text;

mod belts;
mod brakes;
mod bristles;
mod catches;
mod contact;
mod from_text;
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

/// Equal within an amount.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found} instead of {expected}");
}
