//! Friction and unilateral contact in declarations, against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod around;
mod assembled;
#[path = "../support/beside_text.rs"]
mod beside_text;
mod bounds;
#[path = "../support/compass.rs"]
mod compass;
mod existence;
mod flights;
mod friction;
mod from_text;
mod joints;
mod loads;
mod loops;
mod machines;
mod mixed;
mod painleve;
mod pictures;
mod reactions;
mod release;
mod scenes;
mod sums;

/// Asserts that two numbers differ by `within` at most.
#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}
