//! Sweeps of random mechanisms from text beside closed forms, differences, other formulations and other paces.
//!
//! Half of the numbers that a case draws are special ones (`Draw`): 0, 1, equal, at rest, at a bound, closed as drawn.
#![allow(
    clippy::format_push_string,
    reason = "texts of declarations are put together, and nothing waits for them"
)]

mod bounded;
mod bounds;
mod declarations;
mod draw;
mod driven;
mod geared;
mod gradients;
mod hostile;
mod late;
mod locks;
mod pages;
#[path = "../../support/random.rs"]
mod random;
mod resets;
mod sources;
mod sweep;
mod texts;
mod turned;
mod wheels;

pub use random::Random;
pub use sweep::{SWEEPS, Sweep, Table};
pub use texts::{Look, Text, mechanism, with_numbers};
