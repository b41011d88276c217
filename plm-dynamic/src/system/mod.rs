//! The contracts of the runtime, over tables and functions that a program has made.

mod absolute;
mod charted;
mod events;
mod mechanism;
mod motion;
mod singular;
mod state;

pub use self::state::State;
