//! Identification: parameters and start values of a mechanism from measurements.

mod chart;
mod experiment;
mod fit;
mod loss;
mod notice;
mod problem;
mod recording;
mod segments;
mod statistics;
mod table;
mod wake;
mod watch;

pub use experiment::Experiment;
pub use fit::{Combination, Estimate, Fit, Residuals};
pub use loss::Loss;
pub use notice::{Farthest, Notice};
pub use watch::Progress;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use self::experiment::Prepared;
use self::problem::Readings;
use self::watch::Watch;
use crate::optimise::error::{Error, NotConverged};
use crate::optimise::least_squares::{
    End, Evaluation, FIRST_DAMPING, FIRST_DAMPING_NEAR, Found, Left, Limits, approach, minimise,
};
use crate::optimise::mechanism::{ByDop853, Integration, Optimisable};
use crate::optimise::stack::on_large_stack;
use crate::optimise::unknown::{Place, Unknown};

/// A mechanism, experiments with it, and the unknowns that they have in common.
///
/// The weighted squares of the residuals are minimised by the method of Levenberg and Marquardt on exact derivatives. A trial whose run
/// ends with a fault is a step that is too long: a shorter one is tried.
#[derive(Clone, Debug)]
pub struct Identification<M> {
    mechanism: M,
    unknowns: Vec<Unknown>,
    experiments: Vec<Experiment>,
    iterations: usize,
    loss: Loss,
    watch: Option<Watch>,
    stop: Arc<AtomicBool>,
}

impl<M: Optimisable> Identification<M> {
    /// Nothing is known yet but the mechanism, with its parameters as they are.
    pub fn new(mechanism: M) -> Self {
        let (unknowns, experiments, loss, watch, stop) = Default::default();
        Self { mechanism, unknowns, experiments, iterations: 200, loss, watch, stop }
    }

    /// Adds an unknown that all experiments have in common, but for those that set it.
    #[must_use]
    pub fn find(mut self, unknown: Unknown) -> Self {
        self.unknowns.push(unknown);
        self
    }

    /// Adds an experiment.
    #[must_use]
    pub fn experiment(mut self, experiment: Experiment) -> Self {
        self.experiments.push(experiment);
        self
    }

    /// Ends the search after so many iterations; 200 without.
    #[must_use]
    pub fn iterations(self, most: usize) -> Self {
        Self { iterations: most, ..self }
    }

    /// Has residuals count otherwise than by their squares, such as by [`Loss::Huber`] where some readings are wrong. Their deviations,
    /// where they are not given, are then those of most of the residuals.
    #[must_use]
    pub fn loss(self, loss: Loss) -> Self {
        Self { loss, ..self }
    }

    /// Calls a function after each iteration, on the thread of the search.
    #[must_use]
    pub fn watched_by(self, watch: impl Fn(&Progress) + Send + Sync + 'static) -> Self {
        Self { watch: Some(Watch(Arc::new(watch))), ..self }
    }

    /// Ends the search once this is true: another thread sets it. It is read before each iteration.
    #[must_use]
    pub fn stopped_by(self, stop: Arc<AtomicBool>) -> Self {
        Self { stop, ..self }
    }

    /// Finds the unknowns with runs by Dormand and Prince of order 8 and the tolerance 1e-10.
    ///
    /// # Errors
    /// As [`run_by`](Self::run_by).
    pub fn run(&self) -> Result<Fit<M>, Error> {
        self.run_by(ByDop853::default())
    }

    /// Finds the unknowns with runs by a method.
    ///
    /// # Errors
    /// Names and units that are not there; readings that do not fit; a run with the guesses that ends with a fault; a search that does not
    /// end at a minimum, with the cause.
    pub fn run_by(&self, integration: impl Integration<M>) -> Result<Fit<M>, Error> {
        on_large_stack(|| self.found_by(integration))
    }

    fn found_by(&self, integration: impl Integration<M>) -> Result<Fit<M>, Error> {
        let mut problem = self.prepared(integration)?;
        let start = problem
            .start()
            .map_err(|fault| Error::AtGuess { experiment: problem.failed, fault: Box::new(fault) })?;
        let at_guess = |experiment, fault| Error::AtGuess { experiment, fault: Box::new(fault) };
        let mut limits = Limits {
            iterations: self.iterations,
            step: 1e-13,
            cosine: 1e-11,
            constraint: 1e-10,
            damping: FIRST_DAMPING,
        };
        let mut first = start;
        if !problem.nodes.iter().all(Vec::is_empty) {
            first = approach(&mut problem, &first).map_err(|fault| at_guess(problem.failed, fault))?;
            limits.damping = FIRST_DAMPING_NEAR;
        }
        let first = wake::awake(&mut problem, first).map_err(|fault| at_guess(problem.failed, fault))?;
        let found =
            minimise(&mut problem, &first, &limits).map_err(|fault| at_guess(problem.failed, fault))?;
        let found =
            wake::left(&mut problem, found, &limits).map_err(|fault| at_guess(problem.failed, fault))?;
        check(&problem.places, &found)?;
        let found = if self.loss == Loss::Squares {
            found
        } else {
            problem.loss = self.loss;
            loss::settled(&mut problem, found, &limits).map_err(|fault| at_guess(problem.failed, fault))?
        };
        check(&problem.places, &found)?;
        Ok(statistics::fit(&problem, &found))
    }

    fn prepared<D: Integration<M>>(&self, integration: D) -> Result<Readings<M, D>, Error> {
        let shared: Vec<Place> = self
            .unknowns
            .iter()
            .map(|unknown| Place::of(unknown, &self.mechanism))
            .collect::<Result<_, _>>()?;
        let experiments: Vec<Prepared<M>> = self
            .experiments
            .iter()
            .enumerate()
            .map(|(number, experiment)| Prepared::new(experiment, &self.mechanism, number))
            .collect::<Result<_, _>>()?;
        if experiments.is_empty() {
            return Err(Error::Nothing("experiment"));
        }
        if !self.loss.is_sensible() {
            return Err(Error::Loss(self.loss));
        }
        let own = (Arc::clone(&self.stop), self.watch.clone());
        let problem = Readings::new(self.mechanism, shared, experiments, integration, own);
        let (readings, unknowns) = (problem.rows(), problem.places.len());
        if unknowns == 0 {
            return Err(Error::Nothing("unknown to be found"));
        }
        if readings < unknowns {
            return Err(Error::TooFew { readings, unknowns });
        }
        Ok(problem)
    }
}

/// Has the search ended at a minimum? Where no step descends, it has if what is left of the slope is rounding of the runs.
fn check(places: &[Place], found: &Found) -> Result<(), Error> {
    let why = match found.end {
        End::Converged => return Ok(()),
        End::Iterations => NotConverged::Iterations(found.iterations),
        End::Stopped => NotConverged::Stopped(found.iterations),
        End::Faults(fault) => NotConverged::Faults(Box::new(fault)),
        End::NoDescent(left) if is_flat(found, left) => return Ok(()),
        End::NoDescent(_) => NotConverged::NoDescent,
    };
    let best = places.iter().zip(found.z.iter()).map(|(place, value)| (place.name.clone(), *value)).collect();
    let residuals = &found.at.residuals;
    let rms = residuals.norm() / (residuals.len().max(1) as f64).sqrt();
    Err(Error::NotConverged { why, best, plan: Vec::new(), rms })
}

/// True if the rest of the slope is that of rounding, or far below the accuracy of the readings.
fn is_flat(found: &Found, Left { promised, noise }: Left) -> bool {
    let Evaluation { residuals, constraints, .. } = &found.at;
    if constraints.iter().any(|open| open.abs() > 1e-7) {
        return false;
    }
    // With residuals of this size, relative to the readings, the slopes are those of rounding.
    if residuals.amax() < 1e-8 || !constraints.is_empty() {
        return true;
    }
    // One standard error of an unknown changes the sum of squares by the variance of the residuals.
    let freedoms = residuals.len().saturating_sub(found.z.len()).max(1) as f64;
    let by_errors = 0.5 * ERRORS * ERRORS * residuals.norm_squared() / freedoms;
    // A sum of squares of noisy residuals is known up to their product with the noise.
    let by_noise = if noise < NOISE { 10.0 * noise * residuals.norm() } else { 0.0 };
    promised <= by_errors.max(by_noise)
}

/// So many standard errors from a minimum count as none.
const ERRORS: f64 = 1e-3;
/// Noise of runs, in deviations of a reading, from which on it is a jump.
const NOISE: f64 = 1e-5;
