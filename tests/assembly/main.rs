//! How a mechanism is put together, at its start and in every step, and what is said where it cannot be.
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

mod assembly;
mod drawn;
#[allow(dead_code, reason = "bits are compared of more")]
#[path = "../scenes/near_singular.rs"]
mod near_singular_scenes;
#[path = "../support/random.rs"]
mod random;
mod robust;
mod scenes;
mod starts;
mod turned_starts;
mod workspace_limits;
