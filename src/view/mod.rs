//! Results: recordings of runs, files, charts; what `plm_view` has, and what records a mechanism.

mod described;
mod recorder;

pub use plm_view::*;

pub use described::mechanism;
pub use recorder::Recorder;
