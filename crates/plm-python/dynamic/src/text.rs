//! A declaration as text, and its mechanism.

use std::ffi::OsString;
use std::sync::{Arc, Mutex};

use plm_dynamic::{Error, Mechanism, Refused};
use plm_jit::Host;
use plm_python::run::method;
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::run::Own;
use crate::tables::{Tables, tables};
use crate::{By, Native, Numbers, error};

/// A declaration that was compiled.
#[pyclass(frozen)]
pub(crate) struct Text {
    pub(crate) mechanism: Mechanism,
}

#[pymethods]
impl Text {
    /// Compiles a declaration; its diagnostics have this name of a file, and files that it names are read beside that.
    #[new]
    fn new(py: Python<'_>, name: &str, text: &str) -> PyResult<Self> {
        let compiled = py.detach(|| Mechanism::from_named_text(name, text));
        if let (Ok(mechanism), Some(translator)) = (&compiled, Host::new()) {
            mechanism.translate_by(Arc::new(translator.in_background()));
        }
        compiled.map(|mechanism| Self { mechanism }).map_err(|why| match why {
            Error::Refused(Refused::Mistakes(said)) => refused(py, name, text, &said),
            Error::Refused(Refused::Bug(what)) => PyRuntimeError::new_err(plm_compiler::bug_message(&what)),
            why => PyValueError::new_err(why.to_string()),
        })
    }

    /// Its name, its documentation, and how its equations are formulated.
    fn about(&self) -> (&'static str, &'static str, &'static str) {
        let tables = self.mechanism.tables();
        (tables.name, tables.docs.trim(), tables.report.formulation)
    }

    fn tables(&self) -> Tables {
        tables(&self.mechanism)
    }

    /// Assembles it, with inputs that it begins with.
    #[pyo3(signature = (by, parameters, starts, time, inputs = Numbers::new()))]
    fn start(
        &self,
        py: Python<'_>,
        by: By,
        parameters: Numbers,
        starts: Numbers,
        time: f64,
        inputs: Numbers,
    ) -> PyResult<Native> {
        let method = method(&by.0, by.1, by.2).map_err(|bad| PyValueError::new_err(bad.to_string()))?;
        let own = self.with(time, &parameters, &starts, &inputs);
        let run = py.detach(|| own.start_with(method)).map_err(|why| unstarted(py, why))?;
        Ok(Native(Mutex::new(Own(run))))
    }
}

impl Text {
    /// The mechanism with numbers by index, SI; an index that is not there is not set.
    pub(crate) fn with(
        &self,
        time: f64,
        parameters: &[(usize, f64)],
        starts: &[(usize, f64)],
        inputs: &[(usize, f64)],
    ) -> Mechanism {
        let mut own = self.mechanism.clone();
        own.set_time(time);
        let tables = own.tables();
        // Names of its own are known.
        for (row, value) in
            parameters.iter().filter_map(|(k, value)| Some((tables.parameters.get(*k)?, value)))
        {
            let _ = own.set_parameter(row.name, *value);
        }
        for (row, value) in inputs.iter().filter_map(|(k, value)| Some((tables.inputs.get(*k)?, value))) {
            let _ = own.set_input(row.name, *value);
        }
        let names = own.starts();
        for (name, value) in starts.iter().filter_map(|(k, value)| Some((names.get(*k)?, value))) {
            let _ = own.set_start(name, *value);
        }
        own
    }
}

/// Why a mechanism does not start.
pub(crate) fn unstarted(py: Python<'_>, why: Error) -> PyErr {
    match why {
        Error::Fault(fault) => error(py, fault.into()),
        why @ Error::NotGiven(_) => PyTypeError::new_err(python(&why)),
        why => PyValueError::new_err(python(&why)),
    }
}

/// In the words of Python.
fn python(why: &Error) -> String {
    why.to_string().replace('`', "'")
}

/// The exception of a declaration with mistakes.
fn refused(py: Python<'_>, name: &str, text: &str, said: &str) -> PyErr {
    let exception = py.import("plm._errors").and_then(|module| {
        module.getattr("DeclarationError")?.call1((said.trim_end(), diagnostics(name, text)))
    });
    exception.map_or_else(|error| error, PyErr::from_value)
}

/// The diagnostics of a text as JSON, in the form of `plm check --json`.
#[pyfunction]
pub(crate) fn diagnostics(name: &str, text: &str) -> String {
    serde_json::Value::from(plm_cli::diagnostics(name, text)).to_string()
}

/// A value in SI of a text such as `20 cm`, of a quantity with an SI unit.
#[pyfunction]
pub(crate) fn value(text: &str, si: &str) -> PyResult<f64> {
    plm_cli::value(text, si).map_err(|why| PyValueError::new_err(why.replace('`', "'")))
}

/// The command `plm` with these words; gives its exit code.
#[pyfunction]
pub(crate) fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| {
        let (mut input, mut output, mut errors) = (std::io::stdin(), std::io::stdout(), std::io::stderr());
        let mut streams = plm_cli::Streams { input: &mut input, output: &mut output, errors: &mut errors };
        plm_cli::run(words.into_iter(), &mut streams) as u8
    })
}
