//! Results: recordings of runs, files, charts; what `plm_view` has, and what records a mechanism.

mod described;
mod foreign;
mod options;
mod program;
mod recorder;

pub use plm_view::*;

pub use described::mechanism;
pub use foreign::{NoDefault, fmu, library};
pub use options::{BadOption, Options};
pub use program::{Program, run, write};
pub use recorder::Recorder;
