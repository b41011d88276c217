//! Readings of inputs: tables with times and columns by the names of inputs.

use plm_compiler::diag::nearest;
use plm_dynamic::{Declared, Mechanism};
use plm_view::{Column, Recording};

use super::super::super::clock;
use super::super::super::words::known;
use super::{Asked, Failure, Streams};
use crate::value::value;

/// An input over time: SI, times ascend. Two readings at one time are a jump.
pub(super) struct Signal {
    /// Its name.
    pub(super) input: String,
    pub(super) times: Vec<f64>,
    pub(super) values: Vec<f64>,
}

impl Signal {
    /// The last reading up to a time, s; the first one before all.
    pub(super) fn held(&self, time: f64) -> f64 {
        let after = self.times.partition_point(|own| *own <= time);
        self.values[after.saturating_sub(1)]
    }

    /// Its value from a time on, s, on straight lines between readings.
    pub(super) fn from(&self, time: f64) -> f64 {
        self.on_line(self.times.partition_point(|own| *own <= time), time)
    }

    /// Its value up to a time, s.
    pub(super) fn up_to(&self, time: f64) -> f64 {
        self.on_line(self.times.partition_point(|own| *own < time), time)
    }

    /// The value on the line that ends at this reading; constant before the first and after the last one.
    fn on_line(&self, end: usize, time: f64) -> f64 {
        let (Some(begin), true) = (end.checked_sub(1), end < self.times.len()) else {
            return self.values[end.min(self.values.len() - 1)];
        };
        let [from, to] = [begin, end].map(|k| (self.times[k], self.values[k]));
        from.1 + (to.1 - from.1) * ((time - from.0) / (to.0 - from.0))
    }
}

/// The inputs of all tables.
///
/// # Errors
/// A table that is none, a column that is no input, an input that is given twice, a unit of another quantity.
pub(super) fn signals(
    asked: &Asked,
    given: &[(String, f64)],
    mechanism: &Mechanism,
    streams: &mut Streams,
) -> Result<Vec<Signal>, Failure> {
    let mut signals: Vec<Signal> = Vec::new();
    let mut columns = Vec::new();
    for path in &asked.signals.files {
        let table = clock::read(path, asked.signals.from, streams)?;
        columns.extend(table.columns().iter().map(|column| column.name.clone()));
        let start = asked.signals.from.and_then(|from| from.of(&table)).unwrap_or(0.0);
        let times = times(path, &table)?;
        for (k, column) in table.columns().iter().enumerate() {
            let only = &asked.signals.only;
            if !only.is_empty() && !only.contains(&column.name) {
                continue;
            }
            let own = input(path, column, mechanism)?;
            if given.iter().any(|(name, _)| *name == own.name) {
                return Err(format!("`{}` is given by --input, and by {path}", own.name).into());
            }
            if signals.iter().any(|other| other.input == own.name) {
                return Err(format!("`{}` is given twice: an input has one course", own.name).into());
            }
            let factor = factor(path, column, &own)?;
            let values = table.rows().map(|row| row.get(k).copied().unwrap_or(f64::NAN) * factor);
            signals.push(signal((path, own.name), times.iter().map(|time| time - start).zip(values))?);
        }
        ends_early(path, asked, times, start, streams)?;
    }
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    known("--only", asked.signals.only.iter().map(String::as_str), &columns)?;
    if signals.is_empty() {
        return Err(format!("{} has no column beside the time", asked.signals.files.join(", ")).into());
    }
    Ok(signals)
}

/// The times of a table, s, which ascend; two rows may have one time.
fn times<'a>(path: &str, table: &'a Recording) -> Result<&'a [f64], Failure> {
    let times = table.times();
    if times.is_empty() {
        return Err(format!("{path} has headings, and no readings").into());
    }
    if let Some(time) = times.iter().find(|time| !time.is_finite()) {
        return Err(format!("{path}: {time} s is no time of a reading").into());
    }
    match times.windows(2).find(|pair| pair[1] < pair[0]) {
        Some(pair) => {
            Err(format!("{path}: times of readings ascend, and {} s stands after {} s", pair[1], pair[0])
                .into())
        }
        None => Ok(times),
    }
}

/// The input of a column.
fn input<'a>(path: &str, column: &Column, mechanism: &'a Mechanism) -> Result<Declared<'a>, Failure> {
    let name = &column.name;
    let mut all = mechanism.declared_inputs();
    if let Some(own) = all.clone().find(|own| own.name == name) {
        return Ok(own);
    }
    if all.next().is_none() {
        return Err(format!("{path}: the mechanism has no input `{name}`: it has none").into());
    }
    let names: Vec<&str> = mechanism.inputs().map(|(name, _)| name).collect();
    let near =
        nearest(name, names.iter().copied()).map_or(String::new(), |near| format!("; `{near}` is one"));
    Err(format!(
        "{path}: `{name}` is no input{near}\ninputs: {}; `--only NAMES` names the columns that are read",
        names.join(", ")
    )
    .into())
}

/// By what the numbers of a column are multiplied to be in SI.
fn factor(path: &str, column: &Column, own: &Declared) -> Result<f64, Failure> {
    let Declared { name, si, unit, factor } = own;
    if column.unit == *unit {
        return Ok(*factor);
    }
    if column.unit.is_empty() {
        let expected = if si == unit { format!("`{si}`") } else { format!("`{unit}` or `{si}`") };
        return Err(format!("{path}: `{name}` is in {expected}, and no unit is given").into());
    }
    let one = value(&format!("1 {}", column.unit), si);
    Ok(one.map_err(|why| format!("{path}: {name}: {why}"))?)
}

/// An input without the gaps between its readings.
fn signal((path, name): (&str, &str), readings: impl Iterator<Item = (f64, f64)>) -> Result<Signal, Failure> {
    let (times, values): (Vec<f64>, Vec<f64>) = readings.filter(|(_, value)| !value.is_nan()).unzip();
    if let Some(at) = values.iter().position(|value| value.is_infinite()) {
        let time = times[at];
        return Err(format!("{path}: `{name}` is {} at {time} s: a reading is a number", values[at]).into());
    }
    if times.is_empty() {
        return Err(format!("{path}: `{name}` has no readings").into());
    }
    Ok(Signal { input: name.to_owned(), times, values })
}

/// Says of readings that end before the run that the last ones hold.
fn ends_early(
    path: &str,
    asked: &Asked,
    times: &[f64],
    start: f64,
    streams: &mut Streams,
) -> Result<(), Failure> {
    let last = times.last().map_or(0.0, |last| last - start);
    if last < asked.until {
        let until = asked.until;
        writeln!(
            streams.errors,
            "plm: {path} ends at {last} s, and the run at {until} s: its last readings hold from there on"
        )?;
    }
    Ok(())
}
