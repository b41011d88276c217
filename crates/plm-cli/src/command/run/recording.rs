//! Files of a recorded run: a results file, a page, CSV.

use std::io::Write;

use plm_dynamic::{Course, Error, OnRun, Run, Sample};
use plm_runtime::{BodyState, Described, Fault, Method, Moment, Sim};
use plm_view::{Page, Recorder, Recording, Results};

use super::{Asked, Ended, Failure, Following, Rows, columns, row, write_whole};
use crate::table::{csv_headings, csv_row};

/// Records until a time, s, so often, s, as compiled programs do.
struct Record<'a, 'b> {
    until: f64,
    every: f64,
    course: &'a mut Course,
    following: &'a mut Following<'b>,
}

/// A recorded run.
struct Recorded {
    outcome: Result<(), Fault>,
    recording: Recording,
    /// Name of the mechanism.
    name: &'static str,
}

impl OnRun for Record<'_, '_> {
    type Output = Recorded;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Recorded {
        let (mut recorder, name) = (Recorder::observing_all(sim), sim.state().mechanism().tables().name);
        let Record { until, every, course, following } = self;
        let goes_on = &mut |time| following.goes_on(time);
        let outcome = if course.is_empty() {
            recorder.run_while(sim, until, every, goes_on)
        } else {
            recorder.run_driven(sim, until, every, &mut |sim| course.drive(sim), goes_on)
        };
        Recorded { outcome, recording: recorder.into_recording(), name }
    }
}

/// Runs, and writes the files that are asked for; the outcome of the run. What came before a fault is written all the same.
pub(super) fn write(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
    to: &mut dyn Write,
) -> Result<Ended, Failure> {
    let (until, every) = (asked.until, asked.every);
    let Recorded { outcome, recording, name } = run.then(Record { until, every, course, following });
    let events = recording.about.events.iter().map(|event| (event.time, event.what.clone())).collect();
    if let Some(path) = &asked.out {
        recording.write(path)?;
    }
    if let Some(path) = &asked.csv {
        let (columns, headings) = columns(run, true);
        let mut text = Vec::new();
        csv_headings(&headings, &mut text)?;
        for sample in samples(&recording).filter(|sample| is_wanted(asked, sample.time)) {
            csv_row(&row(&columns, &sample), &mut text)?;
        }
        write_whole(path, &text, to)?;
    }
    if let Some(path) = &asked.view {
        let results = Results { runs: vec![recording], ..Results::default() };
        Page::new(&results.to_bytes()?, name).write_html(path)?;
    }
    Ok((outcome.map_err(Error::from), events))
}

/// Is the row of this time, s, written?
fn is_wanted(asked: &Asked, time: f64) -> bool {
    let number = time / asked.every;
    asked.rows == Rows::All || (number - number.round()).abs() < 1e-9
}

/// The rows of a recording.
fn samples(recording: &Recording) -> impl Iterator<Item = Sample> {
    let body = |&[x, y, angle, vx, vy, omega]: &[f64; 6]| BodyState::of([x, y, angle], [vx, vy, omega]);
    recording.times().iter().zip(recording.rows()).enumerate().map(move |(k, (time, values))| Sample {
        time: *time,
        bodies: recording.poses(k).iter().map(body).collect(),
        values: values.to_vec(),
    })
}
