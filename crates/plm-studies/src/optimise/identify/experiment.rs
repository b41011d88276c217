//! Experiments: readings of outputs over time, with inputs and starts of their own.

use std::path::Path;

use plm_runtime::described::by_number::shown;
use plm_view::Recording;

use crate::optimise::error::{Error, place};
use crate::optimise::mechanism::Optimisable;
use crate::optimise::shot::Direction;
use crate::optimise::signal::Signal;
use crate::optimise::unknown::{Place, Unknown};

/// Readings of one run.
#[derive(Clone, Debug, Default)]
pub struct Experiment {
    pub(crate) times: Vec<f64>,
    /// At which times outputs jump; none where that is not known.
    pub(crate) jumps: Vec<bool>,
    pub(crate) outputs: Vec<Readings>,
    pub(crate) units: Vec<OtherUnit>,
    /// Name, unit, times and values of each input.
    pub(crate) inputs: Vec<(String, String, Vec<f64>, Vec<f64>)>,
    /// Name and value, SI, of parameters and starts that are those of this experiment.
    pub(crate) parameters: Vec<(String, f64)>,
    pub(crate) starts: Vec<(String, f64)>,
    pub(crate) unknowns: Vec<Unknown>,
    pub(crate) segments: usize,
}

/// Readings of one output.
#[derive(Clone, Debug)]
pub(crate) struct Readings {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) values: Vec<f64>,
    /// Standard deviation of a reading, in this unit.
    pub(crate) deviation: Option<f64>,
}

/// A unit that declarations need not have.
#[derive(Clone, Debug)]
pub(crate) struct OtherUnit {
    name: String,
    /// The SI unit, and by what a value is multiplied to be in it.
    si: String,
    factor: f64,
}

impl Experiment {
    /// An experiment with readings at these times, s, ascending, from 0 on.
    pub fn new(times: impl Into<Vec<f64>>) -> Self {
        Self { times: times.into(), segments: 1, ..Self::default() }
    }

    /// The readings of a table: times in its first column, then outputs and inputs by their names with units, as
    /// [`Recording::write_csv`] writes them. Of rows at the same time, before and after an event, inputs have the last one, and outputs
    /// have no reading.
    pub fn from_recording(recording: &Recording) -> Self {
        let times = recording.times();
        let rows: Vec<usize> = (0..times.len())
            .filter(|row| times.get(row + 1).is_none_or(|next| *next != times[*row]))
            .collect();
        let mut experiment = Self::new(rows.iter().map(|row| times[*row]).collect::<Vec<_>>());
        let is_second = |row: &usize| row.checked_sub(1).is_some_and(|before| times[before] == times[*row]);
        experiment.jumps = rows.iter().map(is_second).collect();
        let table: Vec<&[f64]> = recording.rows().collect();
        for (k, column) in recording.columns().iter().enumerate() {
            let values: Vec<f64> =
                rows.iter().map(|row| table[*row].get(k).copied().unwrap_or(f64::NAN)).collect();
            experiment = experiment.measured(&column.name, &column.unit, values);
        }
        experiment
    }

    /// The readings of a CSV file: `time (s),arm.angle (deg),drive (N*m)` in its first line.
    ///
    /// # Errors
    /// [`Error::File`]: the file is not such a table.
    pub fn from_csv(path: impl AsRef<Path>) -> Result<Self, Error> {
        let recording = Recording::read_csv(path).map_err(|unread| Error::File(unread.to_string()))?;
        Ok(Self::from_recording(&recording))
    }

    /// Has the run begin at this time of the readings, s: clocks of instruments do not begin with the motion. Readings before it are left
    /// out; inputs begin with their value at that time.
    #[must_use]
    pub fn beginning_at(mut self, time: f64) -> Self {
        let mut from = self.times.partition_point(|own| *own < time);
        self.jumps.resize(self.times.len(), false);
        // The row before has what inputs are then, and no readings of outputs.
        if self.times.get(from) != Some(&time) && from > 0 {
            from -= 1;
            (self.times[from], self.jumps[from]) = (time, true);
        }
        for (_, _, times, values) in &mut self.inputs {
            let first = times.partition_point(|own| *own <= time).saturating_sub(1);
            *times = times.iter().skip(first).map(|own| (own - time).max(0.0)).collect();
            *values = values.iter().skip(first).copied().collect();
        }
        for readings in &mut self.outputs {
            readings.values = readings.values.iter().skip(from).copied().collect();
        }
        self.jumps = self.jumps.iter().skip(from).copied().collect();
        self.times = self.times.iter().skip(from).map(|own| own - time).collect();
        self
    }

    /// Adds the readings of an output, in the unit of its declaration, the SI unit or one of [`unit`](Self::unit). Those that are no numbers (NaN) are left out. The
    /// readings of an input hold from their times on.
    #[must_use]
    pub fn measured(mut self, output: &str, unit: &str, values: impl Into<Vec<f64>>) -> Self {
        self.outputs.push(Readings {
            name: output.to_owned(),
            unit: unit.to_owned(),
            values: values.into(),
            deviation: None,
        });
        self
    }

    /// Sets the standard deviation of the readings of the last output, or of all with this name, in their unit. Without one the readings
    /// count by their own spread, and the deviation is taken from the residuals.
    #[must_use]
    pub fn deviation(mut self, output: &str, deviation: f64) -> Self {
        for readings in self.outputs.iter_mut().filter(|readings| readings.name == output) {
            readings.deviation = Some(deviation);
        }
        self
    }

    /// Adds a unit for readings and inputs, such as `cm`: a value times `factor` is one in the SI unit, `m`.
    #[must_use]
    pub fn unit(mut self, name: &str, si: &str, factor: f64) -> Self {
        self.units.push(OtherUnit { name: name.to_owned(), si: si.to_owned(), factor });
        self
    }

    /// Sets an input, in a unit as those of [`measured`](Self::measured): each value holds from its time, s, to the next.
    #[must_use]
    pub fn input(
        mut self,
        name: &str,
        unit: &str,
        times: impl Into<Vec<f64>>,
        values: impl Into<Vec<f64>>,
    ) -> Self {
        self.inputs.push((name.to_owned(), unit.to_owned(), times.into(), values.into()));
        self
    }

    /// Sets a parameter of this experiment alone, such as a load, SI.
    #[must_use]
    pub fn parameter(mut self, name: &str, value: f64) -> Self {
        self.parameters.push((name.to_owned(), value));
        self
    }

    /// Sets a start value of this experiment, SI.
    #[must_use]
    pub fn start(mut self, name: &str, value: f64) -> Self {
        self.starts.push((name.to_owned(), value));
        self
    }

    /// Adds an unknown of this experiment alone, such as a start value.
    #[must_use]
    pub fn find(mut self, unknown: Unknown) -> Self {
        self.unknowns.push(unknown);
        self
    }

    /// Shoots in so many segments: the states in which they begin are unknowns, and that they continue each other a constraint (H. G.
    /// Bock, 1983). For long runs, and motions that are unstable. Contacts and loops are to be in the same modes and charts as
    /// with the guesses where a segment begins.
    #[must_use]
    pub fn segments(self, count: usize) -> Self {
        Self { segments: count.max(1), ..self }
    }
}

/// An output that was found in the tables of the mechanism, with its readings in SI.
#[derive(Clone, Debug)]
pub(crate) struct Output {
    pub(crate) name: String,
    /// Number among the observables.
    pub(crate) index: usize,
    pub(crate) unit: String,
    /// A value in SI is one in this unit times the factor.
    pub(crate) factor: f64,
    pub(crate) values: Vec<f64>,
    /// By what a residual is divided, SI.
    pub(crate) deviation: f64,
    pub(crate) is_given: bool,
}

/// An experiment that was looked up.
#[derive(Clone, Debug)]
pub(crate) struct Prepared<M> {
    /// The mechanism with the parameters and starts of this experiment.
    pub(crate) mechanism: M,
    pub(crate) times: Vec<f64>,
    pub(crate) outputs: Vec<Output>,
    pub(crate) signals: Vec<Signal>,
    pub(crate) unknowns: Vec<Place>,
    /// Unknowns of all experiments that do not change in this one.
    pub(crate) fixed: Vec<Direction>,
    pub(crate) segments: usize,
}

impl<M: Optimisable> Prepared<M> {
    /// Prepares an experiment.
    ///
    /// # Errors
    /// Names and units that are not there, readings that do not fit the times.
    pub(crate) fn new(of: &Experiment, known: &M, number: usize) -> Result<Self, Error> {
        let problem = |problem: String| Error::Readings { experiment: number, problem };
        check_times(&of.times).map_err(problem)?;
        let (mut mechanism, mut fixed) = (*known, Vec::new());
        let parameters = of.parameters.iter().map(|(name, value)| (Unknown::parameter(name), *value));
        let starts = of.starts.iter().map(|(name, value)| (Unknown::start(name), *value));
        for (own, value) in parameters.chain(starts) {
            let place = Place::of(&own.from(value), known)?;
            place.set(&mut mechanism, value);
            fixed.push(place.direction);
        }
        let mut prepared = Self {
            mechanism,
            times: of.times.clone(),
            outputs: Vec::new(),
            signals: Vec::new(),
            unknowns: of
                .unknowns
                .iter()
                .map(|unknown| Place::of(unknown, &mechanism))
                .collect::<Result<_, _>>()?,
            fixed,
            segments: of.segments,
        };
        for (name, unit, times, values) in &of.inputs {
            prepared.add_input((name, unit, &of.units), (times, values)).map_err(|why| why.of(number))?;
        }
        for readings in &of.outputs {
            let Readings { name, unit, values, .. } = readings;
            if values.len() != of.times.len() {
                let text = format!("`{name}` has {} readings at {} times", values.len(), of.times.len());
                return Err(problem(text));
            }
            if known.tables().inputs.iter().any(|input| input.name == name) {
                prepared
                    .add_input((name, unit, &of.units), (&of.times, values))
                    .map_err(|why| why.of(number))?;
            } else {
                prepared.add_output(readings, of)?;
            }
        }
        prepared.check(known).map_err(problem)?;
        if prepared.outputs.is_empty() {
            return Err(problem("no output was measured".to_owned()));
        }
        Ok(prepared)
    }

    /// Readings are finite, and each output is read once: twice it would count twice, and its errors as independent ones.
    fn check(&self, known: &M) -> Result<(), String> {
        for (k, output) in self.outputs.iter().enumerate() {
            let Output { name, unit, values, factor, .. } = output;
            if self.outputs.iter().take(k).any(|other| other.name == *name) {
                return Err(format!("`{name}` is measured twice: one of its columns is to be left out"));
            }
            if let Some(at) = values.iter().position(|value| value.is_infinite()) {
                let (value, time) = (values[at] / factor, self.times[at]);
                return Err(format!(
                    "`{name}` is {value} {unit} at {time} s: a reading is a number, or NaN where there is none"
                ));
            }
        }
        let inputs = known.tables().inputs;
        let twice = self
            .signals
            .iter()
            .enumerate()
            .find(|(k, own)| self.signals.iter().take(*k).any(|other| other.input == own.input));
        let name = twice.and_then(|(_, own)| inputs.get(own.input)).map(|input| input.name);
        name.map_or(Ok(()), |name| Err(format!("`{name}` is given twice: an input has one course")))
    }

    fn add_output(&mut self, readings: &Readings, of: &Experiment) -> Result<(), Error> {
        let Readings { name, unit, values, deviation } = readings;
        let all = self.mechanism.observables();
        let index = place("output", name, all.iter().map(|(name, _)| *name))?;
        let si = all.get(index).map_or("", |(_, unit)| *unit);
        let declared =
            shown(&self.mechanism).nth(index).flatten().map_or((si, 1.0), |(_, own)| (own.unit, own.factor));
        let factor = factor((name, unit, &of.units), declared, si)?;
        let is_jump = |k: usize| of.jumps.get(k).is_some_and(|jump| *jump);
        let reading = |(k, value): (usize, &f64)| if is_jump(k) { f64::NAN } else { value * factor };
        let values: Vec<f64> = values.iter().enumerate().map(reading).collect();
        let spread = spread(&values);
        self.outputs.push(Output {
            name: name.clone(),
            index,
            unit: unit.clone(),
            factor,
            values,
            deviation: deviation.map_or(spread, |deviation| deviation * factor),
            is_given: deviation.is_some(),
        });
        Ok(())
    }

    fn add_input(&mut self, of: Given<'_>, (times, values): (&[f64], &[f64])) -> Result<(), Wrong> {
        let (name, ..) = of;
        let all = self.mechanism.tables().inputs;
        let index = place("input", name, all.iter().map(|input| input.name)).map_err(Wrong::Error)?;
        let declared = all.get(index).map_or(("", 1.0), |own| (own.unit, own.factor));
        let si = self.mechanism.input_names().get(index).map_or("", |(_, unit)| *unit);
        let factor = factor(of, declared, si).map_err(Wrong::Error)?;
        check_times(times).map_err(|problem| Wrong::Readings(format!("`{name}`: {problem}")))?;
        if times.len() != values.len() || values.iter().any(|value| !value.is_finite()) {
            let text = format!(
                "`{name}` has {} values at {} times, which are to be numbers",
                values.len(),
                times.len()
            );
            return Err(Wrong::Readings(text));
        }
        let values = values.iter().map(|value| value * factor).collect();
        self.signals.push(Signal { input: index, times: times.to_vec(), values });
        Ok(())
    }
}

/// Error of an input.
enum Wrong {
    Error(Error),
    Readings(String),
}

impl Wrong {
    fn of(self, experiment: usize) -> Error {
        match self {
            Self::Error(error) => error,
            Self::Readings(problem) => Error::Readings { experiment, problem },
        }
    }
}

fn check_times(times: &[f64]) -> Result<(), String> {
    let ascend = times.windows(2).all(|pair| matches!(pair, [a, b] if a < b));
    let are_finite = times.iter().all(|time| time.is_finite() && *time >= 0.0);
    if times.is_empty() {
        Err("there are no times".to_owned())
    } else if !ascend || !are_finite {
        Err("the times do not ascend from 0 s on".to_owned())
    } else {
        Ok(())
    }
}

/// A quantity that is given: its name, its unit, and units beside those of the declaration.
type Given<'a> = (&'a str, &'a str, &'a [OtherUnit]);

/// By what a value in a unit is multiplied to be in SI.
fn factor((name, unit, others): Given<'_>, (declared, factor): (&str, f64), si: &str) -> Result<f64, Error> {
    if unit == declared {
        Ok(factor)
    } else if unit == si {
        Ok(1.0)
    } else if let Some(other) = others.iter().find(|other| other.name == unit && other.si == si) {
        Ok(other.factor)
    } else {
        let expected = if si == declared { format!("`{si}`") } else { format!("`{declared}` or `{si}`") };
        Err(Error::Unit { name: name.to_owned(), found: unit.to_owned(), expected })
    }
}

/// Standard deviation of values about their mean; 1 where they are all the same.
fn spread(values: &[f64]) -> f64 {
    let own: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    let mean = own.iter().sum::<f64>() / own.len().max(1) as f64;
    let square = own.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / own.len().max(1) as f64;
    if square > 0.0 { square.sqrt() } else { 1.0 }
}
