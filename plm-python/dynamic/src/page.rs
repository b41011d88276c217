//! A page of a run, for notebooks and files.

use plm_dynamic::OnRun;
use plm_runtime::held::Discrete;
use plm_runtime::{Described, Fault, Linear, Method, Moment, Sim, Statics};
use plm_view::{Page, Recorder, Recording, Results};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::{Native, error};

/// Records until a time, s, so often, s, with everything that is observed.
struct Record {
    until: f64,
    every: f64,
}

impl OnRun for Record {
    type Output = (Recording, &'static str, Result<(), Fault>);

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        let (mut recorder, name) = (Recorder::observing_all(sim), sim.state().mechanism().tables().name);
        let outcome = recorder.run(sim, self.until, self.every);
        (recorder.into_recording(), name, outcome)
    }
}

/// Runs until a time, and gives the page of it, and what ended it early.
#[pyfunction]
pub(crate) fn page(
    py: Python<'_>,
    run: &Native,
    until: f64,
    every: f64,
) -> PyResult<(String, Option<PyErr>)> {
    let mut own = run.own()?;
    let run = &mut own.0;
    let (html, outcome) = py.detach(|| {
        let (recording, name, outcome) = run.then(Record { until, every });
        let results = Results { runs: vec![recording], ..Results::default() };
        (results.to_bytes().map(|bytes| Page::new(&bytes, name).to_html()), outcome)
    });
    let html = html.map_err(|why| PyValueError::new_err(why.to_string()))?;
    Ok((html, outcome.err().map(|fault| error(py, fault.into()))))
}
