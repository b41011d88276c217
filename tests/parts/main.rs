//! Parts of the library beside closed forms and published figures.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

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
