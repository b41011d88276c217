//! Many runs of a mechanism side by side: one for each row of numbers, on several threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use plm_dynamic::{Error, Integrator};
use plm_foreign::Kind;
use plm_python::run::{Asked, Record, Running, method, room, rows};
use plm_runtime::Fault;
use pyo3::exceptions::{PyMemoryError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyByteArray;

use crate::interrupt::next;
use crate::run::Own;
use crate::text::{Text, unstarted};
use crate::{By, bytes, error};

/// A number by its index and its values, one for each run.
type Varied = Vec<(usize, Vec<f64>)>;
/// Samples and numbers of a run; times; the numbers of all runs, run by run and row by row; what ended runs early.
type Came<'py> = (usize, usize, Bound<'py, PyByteArray>, Bound<'py, PyByteArray>, Vec<(usize, PyErr)>);
/// A run that has ended.
type Ended = Result<(Record, Result<(), Fault>), Error>;

/// Stack of a thread: that of a mechanism of 64 bodies with contact.
const STACK: usize = 16 << 20;

/// Everything that runs have in common, and what they differ by.
struct Plan<'a> {
    text: &'a Text,
    method: Integrator,
    time: f64,
    asked: Asked<'a>,
    /// Parameters, start values, inputs.
    varied: [&'a Varied; 3],
}

impl Plan<'_> {
    /// A run by its number.
    fn run(&self, number: usize, stop: &AtomicBool) -> Ended {
        let of = |varied: &Varied| -> Vec<(usize, f64)> {
            varied.iter().filter_map(|(k, values)| Some((*k, *values.get(number)?))).collect()
        };
        let [parameters, starts, inputs] = self.varied.map(of);
        let mechanism = self.text.with(self.time, &parameters, &starts, &inputs);
        let mut run = Own(mechanism.start_with(self.method)?);
        Ok(run.run(self.asked, &mut |_| !stop.load(Ordering::Relaxed)))
    }
}

/// Runs a mechanism once for each row of numbers.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "called by Python alone")]
pub(crate) fn rollouts<'py>(
    py: Python<'py>,
    text: &Text,
    count: usize,
    by: By,
    varied: (Varied, Varied, Varied),
    times: (f64, f64, f64),
    quantities: Vec<(i32, usize)>,
    poses: bool,
    threads: Option<usize>,
) -> PyResult<Came<'py>> {
    let method = method(&by.0, by.1, by.2).map_err(|bad| PyValueError::new_err(bad.to_string()))?;
    let kinds = quantities.into_iter().map(|(kind, index)| Kind::of(kind).map(|kind| (kind, index)));
    let quantities: Vec<(Kind, usize)> =
        kinds.collect::<Result<_, _>>().map_err(|trouble| error(py, trouble))?;
    let (time, until, every) = times;
    let columns = 1 + quantities.len() + if poses { 6 * text.mechanism.tables().bodies.len() } else { 0 };
    room(count as f64 * rows((time, until), every), columns)
        .map_err(|why| PyMemoryError::new_err(why.to_string().replace('`', "'")))?;
    let plan = Plan {
        text,
        method,
        time,
        asked: Asked { until, every, quantities: &quantities, poses },
        varied: [&varied.0, &varied.1, &varied.2],
    };
    let cores = || thread::available_parallelism().map_or(1, usize::from);
    let threads = threads.unwrap_or_else(cores).clamp(1, count.max(1));
    let runs = py.detach(|| all(&plan, count, threads))?;
    joined(py, runs)
}

/// All runs, in their order.
fn all(plan: &Plan, count: usize, threads: usize) -> PyResult<Vec<Ended>> {
    let (due, stop) = (AtomicUsize::new(0), &AtomicBool::new(false));
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads {
            let (sender, due) = (sender.clone(), &due);
            let work = move || {
                while !stop.load(Ordering::Relaxed) {
                    let number = due.fetch_add(1, Ordering::Relaxed);
                    if number >= count || sender.send((number, plan.run(number, stop))).is_err() {
                        break;
                    }
                }
            };
            let spawned = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
            spawned.map_err(|why| {
                stop.store(true, Ordering::Relaxed);
                PyRuntimeError::new_err(format!("a thread cannot be started: {why}"))
            })?;
        }
        drop(sender);
        let mut ended: Vec<Option<Ended>> = (0..count).map(|_| None).collect();
        while let Some((number, run)) = next(&receiver, stop)? {
            ended[number] = Some(run);
        }
        Ok(ended.into_iter().flatten().collect())
    })
}

/// Runs as arrays. Samples after the end of a run are no numbers.
fn joined(py: Python<'_>, runs: Vec<Ended>) -> PyResult<Came<'_>> {
    let of_time = |ended: &Ended| ended.as_ref().ok().and_then(|(record, _)| record.columns.first().cloned());
    let complete = runs.iter().find(|ended| matches!(ended, Ok((_, Ok(())))));
    let times = complete.and_then(of_time).unwrap_or_default();
    let width =
        runs.iter().find_map(|ended| ended.as_ref().ok()).map_or(0, |(record, _)| record.columns.len() - 1);
    let mut numbers = Vec::with_capacity(runs.len() * times.len() * width);
    let mut faults = Vec::new();
    for (number, ended) in runs.into_iter().enumerate() {
        let columns = match ended {
            Ok((record, outcome)) => {
                faults.extend(outcome.err().map(|fault| (number, error(py, fault.into()))));
                record.columns
            }
            Err(why) => {
                faults.push((number, unstarted(py, why)));
                Vec::new()
            }
        };
        let own: &[f64] = columns.first().map_or(&[], Vec::as_slice);
        for (row, time) in times.iter().enumerate() {
            // The last row of a run that ended early may stand between two samples.
            let is_there = own.get(row).is_some_and(|own| own.to_bits() == time.to_bits());
            let value = |column: usize| columns.get(1 + column).and_then(|column| column.get(row)).copied();
            numbers.extend((0..width).map(|column| value(column).filter(|_| is_there).unwrap_or(f64::NAN)));
        }
    }
    Ok((times.len(), width, bytes(py, times), bytes(py, numbers), faults))
}
