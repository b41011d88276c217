//! Runs by a method that is named while a program runs: on the command line, by a page, in Python.
//!
//! An [`Integrator`] is a method with its tolerance or its longest step, and starts a run ([`AnySim`]): a simulation by
//! [`AnyMethod`], whose code a program has once.

mod any_method;
mod integrator;
mod mistake;

pub use any_method::AnyMethod;
pub use integrator::{AnySim, Integrator, METHODS, unknown};
pub use mistake::{BadOption, nearest};
