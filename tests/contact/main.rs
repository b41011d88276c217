//! Friction and unilateral contact in declarations, against closed forms.
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

/// What `machines.rs` declares is text here; `benches/contact.rs` compiles it.
macro_rules! mechanism {
    ($($declaration:tt)*) => {
        scene! { $($declaration)* }
    };
}

#[macro_use]
#[path = "../scenes/contact.rs"]
mod declared;

mod around;
mod assembled;
mod bounds;
#[path = "../support/compass.rs"]
mod compass;
mod existence;
mod flights;
mod friction;
mod joints;
mod loads;
mod loops;
mod machines;
mod many_rows;
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
