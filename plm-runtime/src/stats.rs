//! Counters of a simulation: steps, rejections, evaluations, events.

use crate::scalar::Real;

/// Counters of a simulation: steps, rejections, evaluations, events.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stats {
    /// Accepted internal steps.
    pub steps: u64,
    /// Rejected internal steps.
    pub rejected: u64,
    /// Evaluations of the rate.
    pub evaluations: u64,
    /// Matrices of derivatives of the rate.
    pub jacobians: u64,
    /// Decompositions of such matrices.
    pub factorisations: u64,
    /// Projections onto the constraints.
    pub projected: u64,
    /// Evaluations that were done again by rank.
    pub by_rank: u64,
    /// Changes of chart.
    pub charts: u64,
    /// Singular poses that were passed, where the mechanism could have gone on in another way.
    pub change_points: u64,
    /// Steps near singular poses, where no chart is good: without charts and in numbers of twice the precision.
    pub near_singular: u64,
    /// Steps of fixed length that were too long for the loops, and were made in parts.
    pub divided: u64,
    /// Conditions that switched, and known times that were passed.
    pub switches: u64,
    /// Conditions that came and went within a step of a method without dense output, and were passed over.
    pub passed_over: u64,
    /// Changes of parameters that joints, masses or known times read, after each of which it was assembled anew.
    pub renewed: u64,
    /// Longest accepted step, s.
    pub longest_step: f64,
    /// The largest error that a step of fixed length was estimated at, as a share of the size of a state; zero below about 1e-4.
    pub largest_error: f64,
    /// The sum of the largest errors of all those steps, as a share of the size of the state.
    pub errors: f64,
}

impl Stats {
    /// A step was off by as much, as a share of the state.
    #[inline]
    pub(crate) fn errs<S: Real>(&mut self, error: S) {
        // Most have none, and `f64` is software on small targets.
        if error > S::ZERO {
            let error = error.to_f64();
            self.largest_error = self.largest_error.max(error);
            self.errors += error;
        }
    }
}
