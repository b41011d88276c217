//! `plm._native`: mechanisms from text for Python.
//!
//! A run is that of packages of compiled mechanisms (`native.rs.txt`); a text gives its mechanism, tables, runs and rollouts.

mod fit;
mod gradient;
mod identify;
mod interrupt;
mod library;
mod page;
mod rollouts;
mod run;
mod source;
mod tables;
mod text;

/// Names that a package of a compiled mechanism takes from `plm-planar`.
mod plm {
    pub(crate) use plm_foreign as foreign;
    pub(crate) use plm_python::run as python;
    pub(crate) use plm_runtime::{Cause, Fault};
}

use crate::run::Own;

/// Name of a run in the message that it is busy.
const TITLE: &str = "the simulation";
/// Module of Python that has the types of values.
const VALUES: &str = "plm._values";

include!("../../src/wheel/native.rs.txt");

#[pymodule]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }

    #[pymodule_export]
    use super::Native;
    #[pymodule_export]
    use super::fit::Fit;
    #[pymodule_export]
    use super::gradient::gradient;
    #[pymodule_export]
    use super::identify::identify;
    #[pymodule_export]
    use super::library::parts;
    #[pymodule_export]
    use super::page::page;
    #[pymodule_export]
    use super::rollouts::rollouts;
    #[pymodule_export]
    use super::source::{c_source, fmu_source};
    #[pymodule_export]
    use super::text::{Text, command, diagnostics, value};
}
