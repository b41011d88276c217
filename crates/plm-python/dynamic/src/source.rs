//! C source of a mechanism, and FMUs with it.

use plm_source::{Failure, File, Interfaces, Precision, Version};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::Numbers;
use crate::text::Text;

/// An FMU, and for which parts of the mechanism it has no model exchange.
type Made<'py> = (Bound<'py, PyBytes>, Vec<String>);

/// C99 of a mechanism with numbers by index, SI: names and texts of files.
#[pyfunction]
pub(crate) fn c_source(
    text: &Text,
    single: bool,
    parameters: Numbers,
    starts: Numbers,
    inputs: Numbers,
) -> PyResult<Vec<(String, String)>> {
    let own = text.with(0.0, &parameters, &starts, &inputs);
    let precision = if single { Precision::Single } else { Precision::Double };
    let files = plm_source::c(&own, precision).map_err(refused)?;
    Ok(files.into_iter().map(|File { name, text }| (name, text)).collect())
}

/// An FMU with sources, of version 2 or 3, and all interfaces or one by its name.
#[pyfunction]
pub(crate) fn fmu_source<'py>(
    py: Python<'py>,
    text: &Text,
    fmi: (u8, Option<String>),
    parameters: Numbers,
    starts: Numbers,
    inputs: Numbers,
) -> PyResult<Made<'py>> {
    let version = match fmi.0 {
        2 => Version::Two,
        3 => Version::Three,
        other => return Err(PyValueError::new_err(format!("version is 2 or 3, not {other}"))),
    };
    let interfaces = match fmi.1.as_deref() {
        None => None,
        Some("model-exchange") => Some(Interfaces::ModelExchange),
        Some("co-simulation") => Some(Interfaces::CoSimulation),
        Some(other) => {
            let why = format!("interface is 'model-exchange' or 'co-simulation', not {other:?}");
            return Err(PyValueError::new_err(why));
        }
    };
    let own = text.with(0.0, &parameters, &starts, &inputs);
    let made = plm_source::fmu(&own, version, interfaces).map_err(refused)?;
    let entries = made.files.into_iter().map(|file| (file.name, file.text.into_bytes()));
    let bytes = plm_view::package::archive(entries)?;
    let without = made.without_exchange.iter().map(|part| part.to_string().replace('`', "'")).collect();
    Ok((PyBytes::new(py, &bytes), without))
}

#[allow(clippy::needless_pass_by_value, reason = "taken by `map_err`")]
fn refused(failure: Failure) -> PyErr {
    PyValueError::new_err(failure.to_string().replace('`', "'"))
}
