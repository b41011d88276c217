//! Parameters and start values from measurements.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, mpsc};
use std::thread;

use plm_cli::value;
use plm_dynamic::{Integrator, Mechanism};
use plm_foreign::Kind;
use plm_python::run::method;
use plm_studies::optimise::{ByDop853, ByRadau, Error, Experiment, Identification, Integration, Unknown};
use plm_view::Recording;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::fit::{Fit, Shown, Small, failed};
use crate::interrupt::next;
use crate::text::{Text, unstarted};
use crate::{By, Numbers};

/// An unknown as Python gives it, SI.
#[derive(FromPyObject)]
pub(crate) struct Wanted {
    /// A parameter or a start value.
    kind: i32,
    name: String,
    guess: Option<f64>,
    bounds: (f64, f64),
    expected: Option<(f64, f64)>,
    size: Option<f64>,
}

/// Readings and inputs as Python gives them, SI.
#[derive(FromPyObject)]
pub(crate) struct Given {
    /// A table with readings, and the columns of it that are read; all where none is named.
    csv: Option<(String, Vec<String>)>,
    times: Vec<f64>,
    measured: Vec<(String, Vec<f64>)>,
    deviations: Vec<(String, f64)>,
    /// Name, times and values.
    inputs: Vec<(String, Vec<f64>, Vec<f64>)>,
    parameters: Vec<(String, f64)>,
    start: Vec<(String, f64)>,
    find: Vec<Wanted>,
    segments: usize,
}

impl Wanted {
    fn unknown(&self) -> Unknown {
        let mut unknown = match Kind::of(self.kind) {
            Ok(Kind::Start) => Unknown::start(&self.name),
            _ => Unknown::parameter(&self.name),
        };
        unknown = unknown.within(self.bounds.0, self.bounds.1);
        if let Some(guess) = self.guess {
            unknown = unknown.from(guess);
        }
        if let Some((value, deviation)) = self.expected {
            unknown = unknown.expected(value, deviation);
        }
        self.size.map_or(unknown.clone(), |size| unknown.of_size(size))
    }
}

impl Given {
    fn experiment(&self, mechanism: &Mechanism) -> Result<Experiment, String> {
        let si = |name: &str| {
            let mut all = mechanism.observables().iter().copied().chain(mechanism.inputs());
            all.find(|(own, _)| *own == name).map_or("", |(_, si)| si)
        };
        let table = self.csv.as_ref().map(|(path, only)| read(path, only).map(|table| (table, only)));
        let table = table.transpose()?;
        let mut experiment = match &table {
            Some((table, only)) => plm_cli::experiment(table, only, mechanism)?,
            None => Experiment::new(self.times.clone()),
        };
        for (name, values) in &self.measured {
            experiment = experiment.measured(name, si(name), values.clone());
        }
        for (name, deviation) in &self.deviations {
            let mut columns = table.iter().flat_map(|(table, _)| table.columns());
            let unit = columns.find(|column| column.name == *name).map(|column| column.unit.as_str());
            // That of a column is in its unit.
            let factor = unit.map_or(Ok(1.0), |unit| value(&format!("1 {unit}"), si(name)))?;
            experiment = experiment.deviation(name, deviation / factor);
        }
        for (name, times, values) in &self.inputs {
            experiment = experiment.input(name, si(name), times.clone(), values.clone());
        }
        for (name, value) in &self.parameters {
            experiment = experiment.parameter(name, *value);
        }
        for (name, value) in &self.start {
            experiment = experiment.start(name, *value);
        }
        let unknowns = self.find.iter().map(Wanted::unknown);
        Ok(unknowns.fold(experiment, Experiment::find).segments(self.segments))
    }
}

/// A table of readings that has these columns.
fn read(path: &str, only: &[String]) -> Result<Recording, String> {
    let table = Recording::read_csv(path).map_err(|unread| unread.to_string())?;
    let names: Vec<&str> = table.columns().iter().map(|column| column.name.as_str()).collect();
    match only.iter().find(|name| !names.contains(&name.as_str())) {
        Some(name) => Err(format!("{path} has no column '{name}'; there are {}", names.join(", "))),
        None => Ok(table),
    }
}

/// Finds unknowns of a mechanism from experiments with it.
#[pyfunction]
pub(crate) fn identify(
    py: Python<'_>,
    text: &Text,
    by: By,
    numbers: (Numbers, Numbers),
    find: Vec<Wanted>,
    experiments: Vec<Given>,
    iterations: usize,
) -> PyResult<Fit> {
    let bad = |why: String| PyValueError::new_err(why.replace('`', "'"));
    let method = method(&by.0, by.1, by.2).map_err(|why| bad(why.to_string()))?;
    let own = text.with(0.0, &numbers.0, &numbers.1, &[]);
    let stop = Arc::new(AtomicBool::new(false));
    let mechanism = own.small().map_err(|why| unstarted(py, why))?;
    let mut problem = Identification::new(mechanism).iterations(iterations).stopped_by(Arc::clone(&stop));
    for unknown in &find {
        problem = problem.find(unknown.unknown());
    }
    for (number, given) in experiments.iter().enumerate() {
        let experiment = given.experiment(&own).map_err(|why| bad(format!("experiment {number}: {why}")))?;
        problem = problem.experiment(experiment);
    }
    let problem = &problem;
    let search: Search<'_> = match method {
        Integrator::Dop853(tolerance) => Box::new(move || found(problem, ByDop853(tolerance))),
        Integrator::RadauIia5(tolerance) => Box::new(move || found(problem, ByRadau(tolerance))),
        _ => return Err(bad("an identification runs by 'dop853' or 'radauiia5'".to_owned())),
    };
    let found = py.detach(|| on_a_thread(&stop, search))?;
    found.map(|fit| Fit::new(text, fit)).map_err(|why| failed(py, &why))
}

/// A search, by the method that was asked for.
type Search<'a> = Box<dyn FnOnce() -> Result<Shown, Error> + Send + 'a>;

fn found<D>(problem: &Identification<Small>, integration: D) -> Result<Shown, Error>
where
    D: Integration<Small> + 'static,
{
    problem.run_by(integration).map(|fit| Box::new((fit, integration)) as Shown)
}

/// Searches while Ctrl+C is looked at, which stops it.
fn on_a_thread<T: Send>(stop: &AtomicBool, search: impl FnOnce() -> T + Send) -> PyResult<T> {
    let ended = |why: String| PyRuntimeError::new_err(format!("the search has no thread: {why}"));
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        let work = move || drop(sender.send(search()));
        thread::Builder::new().spawn_scoped(scope, work).map_err(|why| ended(why.to_string()))?;
        next(&receiver, stop)?.ok_or_else(|| ended("it panicked".to_owned()))
    })
}
