//! The reference: the equations of contact in the coordinates of all bodies, from event to event. It shares nothing with the compiler or
//! with the runtime's contact code.

mod choose;
mod event;
mod extrapolation;
mod impact;
mod linear;
pub mod problem;
pub mod run;
pub mod world;
