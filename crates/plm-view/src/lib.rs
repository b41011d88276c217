//! Results of runs: recordings, their files (results files of NumPy arrays, CSV), their curves (SVG), an animated page (HTML); figures
//! beside the published ones.
//!
//! ```
//! use plm_view::{Chart, Recording};
//!
//! let mut recording = Recording::new([("arm.angle", "deg"), ("shoulder.force.x", "N")]);
//! for step in 0..=100 {
//!     let time = f64::from(step) / 100.0;
//!     recording.push(time, [45.0 * time.cos(), 98.1 * time.sin()]);
//! }
//!
//! let folder = std::env::temp_dir().join("plm-view-doc");
//! recording.write(folder.join("arm.npz"))?;
//! recording.write_csv(folder.join("arm.csv"))?;
//! Chart::over_time(&recording).titled("Arm").write_svg(folder.join("arm.svg"))?;
//! # std::fs::remove_dir_all(folder).ok();
//! # Ok::<(), plm_view::Error>(())
//! ```
//!
//! A recording belongs to the caller, not to the run: when a run fails, everything that was recorded before the failure can still be
//! written and viewed.
//!
//! The crate knows numbers, names and units, and the description of a mechanism in a results file. A [`Recorder`] takes that description of
//! any mechanism by its contract, `plm::Described`. The feature `sketch` has [schematic drawings](Sketch) of such a description.
#![cfg_attr(not(feature = "sketch"), allow(rustdoc::broken_intra_doc_links, reason = "the feature `sketch`"))]
#![cfg_attr(docsrs, feature(doc_cfg))]

mod chart;
mod described;
mod error;
mod figures;
pub mod live;
mod markup;
pub mod package;
mod page;
mod recorder;
mod recording;
mod replace;
mod results;
pub mod serve;
#[cfg(feature = "sketch")]
mod sketch;
#[doc(hidden)]
pub mod svg;

pub use chart::{Axis, Chart, Rule, Series};
pub use described::mechanism;
pub use error::{Error, Unread};
pub use figures::{Figure, Figures};
pub use page::{Page, playground_link};
pub use plm_runtime::Operations;
pub use recorder::Recorder;
pub use recording::{About, Column, Event, Fault, Recording, Role, Row};
pub use replace::replace_file;
pub use results::{
    Body, Frame, GroundPort, Mechanism, Parameter, Part, Port, Quantity, Report, Results, Shape,
};
#[cfg(feature = "sketch")]
pub use sketch::{Block, Sense, Side, Sketch, Symbol};
