//! Results: recordings of runs, files, charts; what `plm_view` has, and what records a mechanism.

mod described;
mod options;
mod program;
mod recorder;
mod sketch;

pub use plm_view::*;

pub use described::mechanism;
pub use options::{BadOption, Options};
pub use program::{Program, run, write};
pub use recorder::Recorder;
pub use sketch::sketch;
