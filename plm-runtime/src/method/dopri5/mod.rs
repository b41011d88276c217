//! Dormand-Prince 5(4) with step control, dense output, and projection where the constraints drift.

mod control;
mod stages;
mod start;
mod tableau;

use self::control::Control;
use self::stages::{Dense, Trial, trial};
use self::start::first_step;
use super::{Course, Method, drift_of_size, excess, larger, not_finite};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;

/// Dormand-Prince 5(4): steps chosen by the error, dense output of order 4, no second evaluation at accepted states.
///
/// The error norm is the root mean square of error_i / (rtol typical_i + rtol max|x_i|), or the drift of the new state
/// over rtol times the typical coordinate (velocity), whichever is larger. Above a tenth of that the new state is
/// settled, the rate is evaluated there, and the dense output is led to the settled state and its rate.
#[derive(Clone, Copy, Debug)]
pub struct Dopri5<M: System> {
    /// Relative tolerance; the absolute one of each state is this times its typical size.
    pub rtol: M::S,
    /// Longest step, s.
    pub longest_step: M::S,
    /// Accepted and rejected steps that one interval may take.
    pub most_steps: u64,
    /// Proposal for the next step, s; none before the first.
    proposal: Option<M::S>,
    control: Control<M::S>,
    /// The rate at the current state, unless that has been changed.
    rate: Option<M::X>,
    dense: Option<Dense<M::S, M::X>>,
    /// Drift that the last projection could not remove, over the tolerance.
    residue: M::S,
    steps_left: u64,
}

/// Drift is settled above this fraction of the tolerance.
const SETTLED_ABOVE: f64 = 0.1;

impl<M: System<S: Real>> Default for Dopri5<M> {
    fn default() -> Self {
        Self::new(M::S::lit(1e-8))
    }
}

impl<M: System<S: Real>> Dopri5<M> {
    /// With the relative tolerance `rtol` (not below what the scalar can resolve).
    pub fn new(rtol: M::S) -> Self {
        Self {
            rtol,
            longest_step: M::S::INFINITY,
            most_steps: 1_000_000,
            proposal: None,
            control: Control::new(),
            rate: None,
            dense: None,
            residue: M::S::lit(0.0),
            steps_left: 0,
        }
    }

    /// The same with steps of at most `longest_step`, in s.
    #[must_use]
    pub fn with_longest_step(self, longest_step: M::S) -> Self {
        Self { longest_step, ..self }
    }

    /// The same with at most so many steps, accepted and rejected, in one interval.
    #[must_use]
    pub fn with_most_steps(self, most_steps: u64) -> Self {
        Self { most_steps, ..self }
    }

    /// The tolerance in use: at least some units in the last place.
    fn tolerance(&self) -> M::S {
        self.rtol.max(M::S::lit(8.0) * M::S::EPSILON)
    }

    /// Rate at the current state, kept from the last step or evaluated.
    fn rate_here(&mut self, course: &mut Course<'_, M>) -> Result<M::X, Fault> {
        if let Some(rate) = self.rate {
            return Ok(rate);
        }
        let x = course.x;
        let mut rate = x;
        course.rate(course.time, &x, &mut rate)?;
        if !(x.is_finite() && rate.is_finite()) {
            return Err(not_finite(course.system, course.time, &rate));
        }
        self.rate = Some(rate);
        Ok(rate)
    }

    /// Length of the next step, and whether it is the last: the proposal, stretched by 1 % at most to hit the end rather
    /// than be followed by a tiny one.
    fn next_step(&mut self, course: &Course<'_, M>, proposal: M::S) -> Result<(M::S, bool), Fault> {
        if self.steps_left == 0 {
            return Err(course.fault(Cause::TooManySteps { steps: self.most_steps }));
        }
        self.steps_left -= 1;
        let left = course.end - course.time;
        if M::S::lit(1.01) * proposal >= left {
            Ok((left, true))
        } else if course.time + proposal > course.time {
            Ok((proposal, false))
        } else {
            Err(course.fault(Cause::StepTooSmall { step: proposal.to_f64() }))
        }
    }

    /// Error and drift of a trial step, as multiples of the tolerance.
    fn judge(&self, course: &Course<'_, M>, h: M::S, trial: &Trial<M::X>) -> (M::S, M::S) {
        let (rtol, typical) = (self.tolerance(), course.system.typical());
        let mut sum = M::S::lit(0.0);
        for i in 0..M::X::LEN {
            let size = course.x.at(i).abs().max(trial.x.at(i).abs());
            let ratio = trial.error.at(i) / (rtol * (typical.at(i) + size));
            sum = ratio.mul_add(ratio, sum);
        }
        let error = (sum / M::S::lit(M::X::LEN.max(1) as f64)).sqrt();
        (error, self.drift_ratio(course.system, course.time + h, &trial.x))
    }

    /// Drift of a state over the tolerance, less what projection cannot remove.
    fn drift_ratio(&self, system: &M, t: M::S, x: &M::X) -> M::S {
        excess(system.drift(t, x), drift_of_size(system, self.tolerance())) - self.residue
    }

    /// The state at the end of an accepted step and its rate, settled if the drift asks for it or the step went by rank.
    fn arrive(
        &mut self,
        course: &mut Course<'_, M>,
        time: M::S,
        trial: &Trial<M::X>,
        drift: M::S,
        by_rank: bool,
    ) -> Result<(M::X, M::X), Fault> {
        let limit = if by_rank { M::S::lit(0.0) } else { M::S::lit(SETTLED_ABOVE) };
        if drift <= limit {
            return Ok((trial.x, trial.rate));
        }
        let (mut x, mut rate) = (trial.x, trial.rate);
        course.settle(time, &mut x)?;
        course.rate(time, &x, &mut rate)?;
        self.residue = M::S::lit(0.0);
        self.residue = self.drift_ratio(course.system, time, &x);
        Ok((x, rate))
    }

    /// The proposal after an accepted step: a step that was cut to hit the end says little of the next one.
    fn propose(&mut self, proposal: M::S, h: M::S, error: M::S) {
        let mut control = self.control;
        let next = h * control.accept(error);
        if h < proposal {
            self.proposal = Some(next.max(proposal));
        } else {
            self.control = control;
            self.proposal = Some(next);
        }
    }
}

impl<M: System<S: Real> + Copy> Method<M> for Dopri5<M> {
    const DENSE: bool = true;

    fn begin(&mut self, _course: &mut Course<'_, M>) -> Result<(), Fault> {
        self.steps_left = self.most_steps;
        Ok(())
    }

    fn advance(&mut self, course: &mut Course<'_, M>) -> Result<(), Fault> {
        let rate = self.rate_here(course)?;
        let mut proposal = match self.proposal {
            Some(proposal) => proposal,
            None => first_step(course, &rate, self.tolerance())?,
        };
        loop {
            proposal = proposal.min(self.longest_step);
            let (h, last) = self.next_step(course, proposal)?;
            let by_rank = course.stats.by_rank;
            let attempt = trial(course, &rate, h);
            let (error, drift) = match &attempt {
                Ok(trial) => self.judge(course, h, trial),
                Err(_) => (M::S::INFINITY, M::S::INFINITY),
            };
            let worst = larger(error, drift);
            if worst <= M::S::lit(1.0) {
                let time = if last { course.end } else { course.time + h };
                let trial = attempt?;
                let (to, rate_to) =
                    self.arrive(course, time, &trial, drift, course.stats.by_rank > by_rank)?;
                self.dense = Some(Dense {
                    time: course.time,
                    h,
                    from: course.x,
                    to,
                    rate_from: rate,
                    rate_to,
                    bend: trial.bend,
                });
                self.rate = Some(rate_to);
                self.propose(proposal, h, worst);
                course.stats.steps += 1;
                course.stats.longest_step = course.stats.longest_step.max(h.to_f64());
                (course.time, course.x) = (time, to);
                return Ok(());
            }
            course.stats.rejected += 1;
            proposal = h * self.control.reject(worst);
            ensure_moves(course, proposal, attempt)?;
        }
    }

    fn interpolate(&self, time: M::S) -> M::X {
        self.dense.map_or(M::X::fill(M::S::lit(0.0)), |dense| dense.at(time))
    }

    fn restart(&mut self) {
        self.rate = None;
        self.dense = None;
        self.residue = M::S::lit(0.0);
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance() * M::S::lit(SETTLED_ABOVE))
    }
}

/// A step that still moves the time; otherwise the fault that made it so short.
fn ensure_moves<M: System<S: Real>>(
    course: &Course<'_, M>,
    h: M::S,
    attempt: Result<Trial<M::X>, Fault>,
) -> Result<(), Fault> {
    let scale = course.time.abs().max(course.end.abs());
    if h > M::S::lit(16.0) * M::S::EPSILON * scale {
        return Ok(());
    }
    let trial = attempt?;
    if trial.x.is_finite() {
        Err(course.fault(Cause::StepTooSmall { step: h.to_f64() }))
    } else {
        Err(not_finite(course.system, course.time, &trial.x))
    }
}
