//! Derivatives of a run by parameters, start values and inputs.

use std::time::{Duration, Instant};

use plm_dynamic::{By as Variable, Derivative};
use plm_foreign::Kind;
use plm_python::run::method;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::text::{Text, unstarted};
use crate::{By, Numbers, bytes};

/// Times; of each quantity its values, and its derivatives.
type Came<'py> = (Bound<'py, PyByteArray>, Vec<Bound<'py, PyByteArray>>, Vec<Bound<'py, PyByteArray>>);

/// Runs a mechanism, and gives quantities with their derivatives by one of its numbers.
#[pyfunction]
pub(crate) fn gradient<'py>(
    py: Python<'py>,
    text: &Text,
    by: By,
    numbers: (Numbers, Numbers, Numbers),
    times: (f64, f64, f64),
    quantities: Vec<usize>,
    variable: (i32, usize),
) -> PyResult<Came<'py>> {
    let bad = |why: String| PyValueError::new_err(why);
    let method = method(&by.0, by.1, by.2).map_err(|why| bad(why.to_string()))?;
    let variable = match Kind::of(variable.0) {
        Ok(Kind::Parameter) => Variable::Parameter(variable.1),
        Ok(Kind::Start) => Variable::Start(variable.1),
        Ok(Kind::Input) => Variable::Input(variable.1),
        _ => return Err(bad("a derivative is by a parameter, a start value or an input".to_owned())),
    };
    let (time, until, every) = times;
    let own = text.with(time, &numbers.0, &numbers.1, &numbers.2);
    let (mut asked, mut interrupt) = (Instant::now(), None);
    let mut goes_on = || {
        if interrupt.is_none() && asked.elapsed() > Duration::from_millis(50) {
            asked = Instant::now();
            interrupt = Python::attach(|py| py.check_signals()).err();
        }
        interrupt.is_none()
    };
    let found = py.detach(|| own.derivative(variable, method, (until, every), &quantities, &mut goes_on));
    interrupt.map_or(Ok(()), Err)?;
    let Derivative { times, values, slopes } = found.map_err(|why| unstarted(py, why))?;
    let columns = |all: Vec<Vec<f64>>| all.into_iter().map(|column| bytes(py, column)).collect();
    Ok((bytes(py, times), columns(values), columns(slopes)))
}
