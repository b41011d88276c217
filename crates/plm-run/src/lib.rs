//! Runs by a method that is named while a program runs: on the command line, by a page, in Python.
//!
//! An [`Integrator`] is a method with its tolerance or its longest step, and starts a run ([`AnySim`]). What the program does with the
//! run, whatever its method, is an [`OnSim`].

mod any_sim;
mod integrator;
mod mistake;

pub use any_sim::{AnySim, OnSim};
pub use integrator::{Integrator, METHODS, unknown};
pub use mistake::{BadOption, nearest};
