//! Parts of hydraulics, 1-D mechanics and signals: their laws at random states. `tests/manual` has runs of an arm.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod laws;
mod mechanics;
#[path = "../support/random.rs"]
mod random;
mod signals;

pub(crate) use random::Random;

/// Equal to so much of the larger of a scale and the values.
pub(crate) fn assert_near(found: f64, expected: f64, scale: f64, what: &str) {
    let size = scale.max(expected.abs());
    assert!((found - expected).abs() <= 1e-9 * size, "{what}: {found} instead of {expected}");
}
