//! Motion of an experiment with the estimates, recorded with its readings and residuals.

use std::fmt;

use nalgebra::DVector;
use plm_runtime::Fault;
use plm_view::{Column, Recorder, Recording, Row};

use super::experiment::Prepared;
use super::fit::{Fit, Residuals};
use super::problem::{Readings, derived};
use super::segments::Segment;
use crate::mechanism::{Integration, Optimisable};
use crate::shot::Begin;

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

    /// Runs, with a row at each reading.
    fn record(&self, integration: &impl Integration<M>) -> Result<Recording, Fault> {
        let mut recorder: Option<Recorder<M>> = None;
        for (segment, begin) in &self.segments {
            derived(&self.experiment, segment, (&self.mechanism, *begin), |shot| {
                shot.run(integration, &mut |_, state| {
                    recorder.get_or_insert_with(|| Recorder::observing_all(state)).take(state);
                })
            })?;
        }
        Ok(recorder.map(Recorder::into_recording).unwrap_or_default())
    }
}

impl<M: Optimisable> Fit<M> {
    /// The motion of an experiment, from 0, with the estimates, at the times of its readings. Behind the quantities of the mechanism stand
    /// readings and residuals in the units that were given: `rod.angle measured` and `rod.angle residual`. A page draws them as curves.
    ///
    /// # Errors
    /// The fault of a run by this method; [`Fit`] itself has run by that of the identification. There is nothing of an experiment that
    /// there is not.
    pub fn recording(&self, experiment: usize, integration: impl Integration<M>) -> Result<Recording, Fault> {
        let Some(motion) = self.motions.get(experiment) else { return Ok(Recording::default()) };
        let model = motion.record(&integration)?;
        let own: Vec<&Residuals> =
            self.residuals.iter().filter(|residuals| residuals.experiment == experiment).collect();
        let added = own.iter().flat_map(|of| {
            ["measured", "residual"]
                .map(|what| Column::from((format!("{} {what}", of.output), of.unit.clone())))
        });
        let mut all =
            Recording::of(model.about.mechanism.clone(), model.columns().iter().cloned().chain(added));
        all.about.name = format!("experiment {experiment}");
        for (k, (time, values)) in model.times().iter().zip(model.rows()).enumerate() {
            let differences = own.iter().flat_map(|of| [of.readings[k], of.model[k] - of.readings[k]]);
            let values: Vec<f64> = values.iter().copied().chain(differences).collect();
            let [poses, ground] = [model.poses(k).as_flattened(), model.ground(k).as_flattened()];
            all.push_row(&Row { time: *time, poses, ground, values: &values });
        }
        Ok(all)
    }
}
