//! Results: recordings of runs, files, charts; what `plm_view` has, what records a mechanism, and whole programs over one.
//!
//! `plm::view` is this crate.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod arguments;
mod foreign;
mod library;
mod linking;
mod options;
mod program;
mod server;
mod sketch;
#[cfg(feature = "c-source")]
mod source;

pub use plm_foreign::fmi::Version;
pub use plm_view::*;

pub use arguments::{Arguments, Known};
pub use foreign::{NoDefault, fmu, fmu_of, library};
pub use library::Library;
pub use options::{Options, Table};
pub use plm_python::wheel::wheel;
pub use plm_run::{BadOption, Integrator};
#[cfg(feature = "c-source")]
pub use plm_source::Precision;
pub use program::{Program, run, write};
pub use server::Server;
pub use sketch::sketch;
#[cfg(feature = "c-source")]
pub use source::c_source;
