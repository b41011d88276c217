//! Results: recordings of runs, files, charts; what `plm_view` has, and what records a mechanism.

mod arguments;
mod described;
mod foreign;
mod integrator;
mod library;
mod options;
mod program;
mod recorder;
mod server;
mod sketch;

pub use plm_view::*;

pub use arguments::{Arguments, BadOption, Known};
pub use described::mechanism;
pub use foreign::{NoDefault, fmu, library};
pub use integrator::Integrator;
pub use library::Library;
pub use options::{Options, Table};
pub use program::{Program, run, write};
pub use recorder::Recorder;
pub use server::Server;
pub use sketch::sketch;
