//! The contracts of the runtime, over tables and functions that a program has made.

mod absolute;
mod charted;
mod conditional;
mod contact;
mod described;
mod linear;
mod mechanism;
mod motion;
mod sets;
mod singular;
mod sliding;
mod state;
mod statics;
mod switched;

pub use self::state::State;
