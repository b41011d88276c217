//! Inputs over time: the changes of inputs by which a run follows readings.
//!
//! A run holds its inputs over a step. What holds from one reading to the next is that already. For straight lines each input becomes a
//! name for `before + (after - before)*phase` with two inputs, and a clock is a state, so that it moves within steps of any method and
//! conditions on it are located. Steps end at the readings.

mod lines;
mod readings;

use plm_dynamic::{Change, Course, Mechanism};

use self::lines::Lines;
use self::readings::Signal;
use super::asked::{Asked, Interpolation};
use super::{Failure, Streams, setting};
use crate::read::File;

/// A mechanism with what its inputs are over a run.
pub(super) struct Driven {
    pub(super) mechanism: Mechanism,
    /// Changes after the start.
    pub(super) course: Course,
    /// Names of inputs with their values at the start, SI.
    pub(super) begin: Vec<(String, f64)>,
}

impl Driven {
    /// The mechanism of a file with the inputs that are asked for.
    pub(super) fn new(
        asked: &Asked,
        mechanism: Mechanism,
        file: &File,
        streams: &mut Streams,
    ) -> Result<Driven, Failure> {
        let mut given = Vec::new();
        for text in &asked.input {
            let (name, value) = setting("--input", text, mechanism.declared_inputs())?;
            given.push((name.to_owned(), value));
        }
        if asked.signals.files.is_empty() {
            return Ok(Driven { mechanism, course: Course::default(), begin: given });
        }
        let signals = readings::signals(asked, &given, &mechanism, streams)?;
        match asked.signals.interpolation {
            Interpolation::Hold => Ok(held(mechanism, &signals, given, asked.until)),
            Interpolation::Linear => Lines::new(file, &signals)?.driven(&signals, given, asked.until),
        }
    }
}

/// Each reading holds to the next.
fn held(mechanism: Mechanism, signals: &[Signal], mut begin: Vec<(String, f64)>, until: f64) -> Driven {
    let mut changes = Vec::new();
    for own in signals {
        let mut last = own.held(0.0);
        begin.push((own.input.clone(), last));
        let Some(input) = number(&mechanism, &own.input) else { continue };
        for time in times(std::slice::from_ref(own)).into_iter().filter(|time| *time < until) {
            let value = own.held(time);
            if value.to_bits() != last.to_bits() {
                changes.push(Change { time, input, value });
                last = value;
            }
        }
    }
    Driven { mechanism, course: Course::new(changes), begin }
}

/// The times of readings after the start of a run, s, ascending.
fn times(signals: &[Signal]) -> Vec<f64> {
    let all = signals.iter().flat_map(|own| own.times.iter().copied());
    let mut all: Vec<f64> = all.filter(|time| *time > 0.0).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

fn number(mechanism: &Mechanism, input: &str) -> Option<usize> {
    mechanism.inputs().position(|(name, _)| name == input)
}
