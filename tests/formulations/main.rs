//! Formulations of the same mechanism: joint coordinates, loops in closed form and by iteration, absolute coordinates.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

mod formulations;
mod limits;
mod loops_on_moving_bodies;
mod newton;
#[path = "../support/random.rs"]
mod random;
mod reactions;
mod redundant;
