//! Files of a recorded run: a results file, a page, CSV.

use std::io::Write;

use plm_dynamic::{Course, Error, OnRun, Reason, Run, Sample, Watch};
use plm_runtime::{BodyState, Described, Method, Moment, Sim};
use plm_view::{Page, Recorder, Recording, Results, Row};

use super::{Asked, Ended, Failure, Following, Rows, columns, row, write_whole};
use crate::table::{csv_headings, csv_row};

/// The description of a run that is about to begin, and the name of the mechanism. The run itself is made where rows are: another one
/// here would be compiled for each size and method again.
struct Describe;

impl OnRun for Describe {
    type Output = (Recording, &'static str);

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let (mut recorder, name) = (Recorder::observing_all(sim), sim.state().mechanism().tables().name);
        recorder.begin(sim);
        (recorder.into_recording(), name)
    }
}

/// Samples that become rows of a recording.
struct Recorded<'a, 'b> {
    recording: Recording,
    following: &'a mut Following<'b>,
    /// Do ports of the ground move?
    ground_moves: bool,
}

impl Watch for Recorded<'_, '_> {
    fn sample(&mut self, sample: &Sample, _: Reason) {
        let poses: Vec<f64> = sample.bodies.iter().flat_map(|body| body.components()).collect();
        let ground = if self.ground_moves { sample.ground.concat() } else { Vec::new() };
        let row = Row { time: sample.time, poses: &poses, ground: &ground, values: &sample.values };
        // A run begins where the last row is.
        if !self.recording.ends_with(&row) {
            self.recording.push_row(&row);
        }
    }

    fn event(&mut self, time: f64, what: &str) {
        self.recording.push_event(time, what);
    }

    fn goes_on(&mut self, time: f64) -> bool {
        self.following.goes_on(time)
    }
}

/// Records until a time, s, so often, s, as compiled programs do: the outcome, the recording, and the name of the mechanism.
fn record(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
) -> (Result<(), Error>, Recording, &'static str) {
    let (recording, name) = run.then(Describe);
    let ground_moves = recording.about.mechanism.ground_moves();
    let mut watch = Recorded { recording, following, ground_moves };
    let outcome = if course.is_empty() {
        run.watch(asked.until, asked.every, &mut watch)
    } else {
        run.watch_driven(asked.until, asked.every, course, &mut watch)
    };
    let mut recording = watch.recording;
    if let Err(Error::Fault(fault)) = &outcome {
        let (part, text) = (fault.part.to_owned(), fault.cause.to_string());
        recording.about.fault = Some(plm_view::Fault { time: fault.time, part, text });
    }
    recording.about.notices = run.notices().iter().map(ToString::to_string).collect();
    (outcome, recording, name)
}

/// Runs, and writes the files that are asked for; the outcome of the run. What came before a fault is written all the same.
pub(super) fn write(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
    to: &mut dyn Write,
) -> Result<Ended, Failure> {
    let (outcome, recording, name) = record(asked, run, course, following);
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
    Ok((outcome, events))
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
        ground: Vec::new(),
        values: values.to_vec(),
    })
}
