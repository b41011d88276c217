//! Motion of an experiment with the estimates, recorded with its readings and residuals.
//!
//! A motion has many rows between readings, so that it is a curve; readings have numbers in their own rows alone.

use std::fmt;

use nalgebra::DVector;
use plm_runtime::Fault;
use plm_view::{Column, Recorder, Recording, Role, Row};

use super::experiment::{Output, Prepared};
use super::fit::Fit;
use super::problem::{Readings, seen_at};
use super::segments::Segment;
use crate::optimise::mechanism::{Integration, Optimisable};
use crate::optimise::shot::Begin;

/// An experiment with the estimates, and where its segments begin.
#[derive(Clone)]
pub(crate) struct Motion<M: Optimisable> {
    experiment: Prepared<M>,
    mechanism: M,
    segments: Vec<(Segment, Begin<M>)>,
}

impl<M: Optimisable> fmt::Debug for Motion<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion").field("times", &self.experiment.times).finish_non_exhaustive()
    }
}

impl<M: Optimisable> Motion<M> {
    pub(crate) fn new<D: Integration<M>>(of: &Readings<M, D>, number: usize, z: &DVector<f64>) -> Self {
        let segments = of.segments[number].iter().enumerate();
        Self {
            experiment: of.experiments[number].clone(),
            mechanism: of.mechanism(number, z),
            segments: segments.map(|(k, segment)| (*segment, of.begin(number, k, z))).collect(),
        }
    }

    /// Runs, with a row at each reading and rows between them; the second has the number of the reading of each row.
    fn record(&self, integration: &impl Integration<M>) -> Result<(Recording, Vec<Option<usize>>), Fault> {
        let (mut recorder, mut readings): (Option<Recorder<M>>, _) = (None, Vec::new());
        let times = &self.experiment.times;
        let longest = times.last().map_or(0.0, |end| end / ROWS);
        for (segment, begin) in &self.segments {
            let seen = between(times, segment, longest);
            let samples: Vec<f64> = seen.iter().map(|(time, _)| *time).collect();
            seen_at(&self.experiment, (segment, &samples), (&self.mechanism, *begin), |shot| {
                shot.run(integration, &mut |sample, state| {
                    let recorder = recorder.get_or_insert_with(|| Recorder::observing_all(state));
                    let before = recorder.recording().len();
                    recorder.take(state);
                    // A moment that is the one before has no row of its own.
                    if recorder.recording().len() > before {
                        readings.push(seen.get(sample).and_then(|(_, reading)| *reading));
                    }
                })
            })?;
        }
        Ok((recorder.map(Recorder::into_recording).unwrap_or_default(), readings))
    }
}

/// Rows of a motion, about.
const ROWS: f64 = 1000.0;

/// Times of the readings of a segment with their numbers, and times between them that are not further apart than `longest`.
fn between(times: &[f64], segment: &Segment, longest: f64) -> Vec<(f64, Option<usize>)> {
    let begin = segment.begin(times);
    let (mut seen, mut last) = (Vec::new(), None);
    for sample in segment.samples() {
        let (from, time) = (last.unwrap_or(begin), times[sample]);
        let parts = ((time - from) / longest).ceil();
        // The start of a run is seen, where no reading is; a later segment begins at a reading of the one before.
        let first = usize::from(last.is_some() || begin > 0.0);
        seen.extend((first..parts as usize).map(|part| (from + (time - from) * part as f64 / parts, None)));
        seen.push((time, Some(sample)));
        last = Some(time);
    }
    seen
}

impl<M: Optimisable> Fit<M> {
    /// The motion of an experiment, from 0, with the estimates: about a thousand rows. After the quantities of the mechanism stand readings
    /// and residuals of each output, in its unit and in the rows of the readings alone: `rod.angle measured` and `rod.angle residual`. Their
    /// [`Role`] says how they are drawn.
    ///
    /// # Errors
    /// The fault of a run by this method; [`Fit`] itself has run by that of the identification. There is nothing of an experiment that
    /// there is not.
    pub fn recording(&self, experiment: usize, integration: impl Integration<M>) -> Result<Recording, Fault> {
        let Some(motion) = self.motions.get(experiment) else { return Ok(Recording::default()) };
        motion.recorded(experiment, &integration).map(|(recording, _)| recording)
    }
}

impl<M: Optimisable> Motion<M> {
    /// The recording of an experiment with this number, and the columns of each output: motion, readings, residuals.
    pub(crate) fn recorded(
        &self,
        number: usize,
        integration: &impl Integration<M>,
    ) -> Result<(Recording, Vec<[usize; 3]>), Fault> {
        let (model, readings) = self.record(integration)?;
        let own: Vec<Read<'_>> =
            self.experiment.outputs.iter().filter_map(|output| Read::new(output, model.columns())).collect();
        let added = own.iter().flat_map(Read::columns);
        let mut all =
            Recording::of(model.about.mechanism.clone(), model.columns().iter().cloned().chain(added));
        all.about.name = format!("experiment {number}");
        for (row, (time, values)) in model.times().iter().zip(model.rows()).enumerate() {
            let reading = readings.get(row).copied().flatten();
            let added = own.iter().flat_map(|own| own.values(reading, values));
            let values: Vec<f64> = values.iter().copied().chain(added).collect();
            let [poses, ground] = [model.poses(row).as_flattened(), model.ground(row).as_flattened()];
            all.push_row(&Row { time: *time, poses, ground, values: &values });
        }
        let columns = own.iter().enumerate().map(|(k, own)| {
            let first = model.columns().len() + 2 * k;
            [own.index, first, first + 1]
        });
        Ok((all, columns.collect()))
    }
}

/// An output that was measured, and its column.
struct Read<'a> {
    output: &'a Output,
    column: &'a Column,
    index: usize,
}

impl<'a> Read<'a> {
    fn new(output: &'a Output, columns: &'a [Column]) -> Option<Self> {
        let index = columns.iter().position(|column| column.name == output.name)?;
        Some(Self { output, column: columns.get(index)?, index })
    }

    fn columns(&self) -> [Column; 2] {
        let Column { name, unit, factor, .. } = self.column;
        [("measured", Role::Reading), ("residual", Role::Residual)].map(|(what, role)| Column {
            factor: *factor,
            ..Column::from((format!("{name} {what}"), unit.clone())).with_role(role)
        })
    }

    /// Reading and residual in a row, in the unit of the column.
    fn values(&self, reading: Option<usize>, row: &[f64]) -> [f64; 2] {
        let of = |reading: usize| self.output.values.get(reading).copied();
        let measured = reading.and_then(of).unwrap_or(f64::NAN) / self.column.factor.unwrap_or(1.0);
        [measured, row.get(self.index).copied().unwrap_or(f64::NAN) - measured]
    }
}
