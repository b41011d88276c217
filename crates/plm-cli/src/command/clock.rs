//! The clock of readings beside that of a run.

use plm_view::Recording;

use super::words::Words;
use super::{Failure, Streams};
use crate::value::value;

/// The time of the readings at which a run begins.
#[derive(Clone, Copy)]
pub(super) enum Begin {
    /// At the first reading.
    First,
    /// At this time, s.
    At(f64),
}

/// So many intervals between readings before the first one are many.
const LATE: f64 = 10.0;

impl Begin {
    /// The value of `--from`; `None` if readings and run have one clock.
    pub(super) fn asked(words: &mut Words) -> Result<Option<Begin>, Failure> {
        let Some(text) = words.value("--from") else { return Ok(None) };
        if text == "first" {
            return Ok(Some(Begin::First));
        }
        Ok(Some(Begin::At(value(&text, "s").map_err(|why| format!("--from: {why}"))?)))
    }

    /// The time of a table at which the run begins, s.
    pub(super) fn of(self, readings: &Recording) -> Option<f64> {
        match self {
            Begin::First => readings.times().first().copied(),
            Begin::At(time) => Some(time),
        }
    }
}

/// Reads a table, and says what is to be known of how it was read, and of readings that begin late that their clock may not be that of the
/// run.
pub(super) fn read(path: &str, from: Option<Begin>, streams: &mut Streams) -> Result<Recording, Failure> {
    let readings = Recording::read_csv(path)?;
    for notice in &readings.about.notices {
        writeln!(streams.errors, "plm: {path}: {notice}")?;
    }
    let times = readings.times();
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return Ok(readings) };
    let step = (last - first) / (times.len() as f64 - 1.0).max(1.0);
    if from.is_none() && *first > LATE * step && step > 0.0 {
        writeln!(
            streams.errors,
            "plm: {path} begins at {first} s, and the run at 0 s: where the clock began before the motion, `--from first` or `--from {first}s` has \
             both begin together"
        )?;
    }
    Ok(readings)
}
