//! Parts of the library beside closed forms, published figures and conservation laws.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod bristles;
mod catches;
mod functions;
mod hydraulics;
mod joints;
mod loose;
mod plates;
mod pneumatics;
mod signals;
//! Parts of the library beside closed forms and published figures.
mod belts;
mod brakes;
mod gears;
mod motors;
mod ropes;
mod screws;
/// Equal within an amount.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found} instead of {expected}");
}
//! Parts of the library, a module for each field, against closed forms and published figures.
mod contact;
