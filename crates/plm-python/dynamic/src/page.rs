//! A page of a run, for notebooks and files.

use plm_dynamic::OnRun;
use plm_python::run::{NoRoom, room, rows};
use plm_runtime::held::Discrete;
use plm_runtime::{Described, Fault, Linear, Method, Moment, Sim, Statics};
use plm_view::{Page, Recorder, Recording, Results};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

use crate::{Asking, Native, error};

/// Records until a time, s, so often, s, with everything that is observed, as long as `goes_on` says so.
struct Record<'a> {
    until: f64,
    every: f64,
    goes_on: &'a mut dyn FnMut(f64) -> bool,
}

/// The recording, the name of the mechanism, and how the run ended.
type Recorded = Result<(Recording, &'static str, Result<(), Fault>), NoRoom>;

impl OnRun for Record<'_> {
    type Output = Recorded;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        let mechanism = sim.state().mechanism();
        let (tables, observed) = (mechanism.tables(), mechanism.observables().len());
        room(rows((sim.state().time(), self.until), self.every), 1 + observed + 6 * tables.bodies.len())?;
        let (mut recorder, Self { until, every, mut goes_on }) = (Recorder::observing_all(sim), self);
        let outcome = recorder.run_while(sim, until, every, &mut goes_on);
        Ok((recorder.into_recording(), tables.name, outcome))
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
    let (run, mut asking) = (&mut own.0, Asking::new(None));
    let recorded = py.detach(|| run.then(Record { until, every, goes_on: &mut |time| asking.goes_on(time) }));
    let (recording, name, outcome) =
        recorded.map_err(|why| PyMemoryError::new_err(why.to_string().replace('`', "'")))?;
    asking.error.map_or(Ok(()), Err)?;
    let results = Results { runs: vec![recording], ..Results::default() };
    let html = py.detach(|| results.to_bytes().map(|bytes| Page::new(&bytes, name).to_html()));
    let html = html.map_err(|why| PyValueError::new_err(why.to_string()))?;
    Ok((html, outcome.err().map(|fault| error(py, fault.into()))))
}
