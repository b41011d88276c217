//! What the fixed-step methods share: dividing an interval, health, drift.

use core::marker::PhantomData;

use super::{Course, Method, drift_of_size, excess, not_finite};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, Health, System};
use crate::vector::Vector;

/// The formula of a fixed-step method.
pub trait Formula: Copy {
    /// Rates per step.
    const STAGES: u64;

    /// The state one step of length `h` after `(t, x)`; `rate(t, x, dx)` writes the rate.
    fn step<M: System>(t: M::S, h: M::S, x: &M::X, rate: impl FnMut(M::S, &M::X, &mut M::X)) -> M::X;

    /// One step for any scalar, with the worst health of its stages and without a second try.
    #[inline]
    fn plain_step<M: System>(system: &M, t: M::S, u: &M::U, x: &mut M::X, h: M::S) -> Health<M::S> {
        let mut worst = Health::perfect();
        *x = Self::step::<M>(t, h, x, |t, x, dx| worst = worst.worst(system.rate(t, u, x, dx)));
        worst
    }
}

/// A method with steps of equal length.
///
/// An interval is divided into whole steps of at most [`longest_step`](Self::longest_step). The health of the stages
/// is looked at once a step; an unhealthy step is done again, by rank where needed, and so are the following ones until
/// one is healthy throughout; these are settled one by one, because what is off the constraints near a singular position
/// decides the branch that the motion takes. Otherwise the drift is looked at after every [`check_every`](Self::check_every) steps, and again
/// after the next step whenever the state had to be settled.
#[derive(Clone, Copy, Debug)]
pub struct FixedStep<S, F> {
    /// Longest step, s.
    pub longest_step: S,
    /// Drift that is tolerated, as a fraction of the typical coordinate and velocity.
    pub tolerance: S,
    /// Steps between two looks at the drift; counted on across intervals.
    pub check_every: u32,
    plan: Plan<S>,
    /// The last step was unhealthy.
    careful: bool,
    /// Steps until the next look at the drift.
    until_check: u32,
    formula: PhantomData<F>,
}

/// An interval divided into equal steps.
#[derive(Clone, Copy, Debug)]
struct Plan<S> {
    start: S,
    h: S,
    steps: u64,
    done: u64,
}

impl<S: Real, F: Formula> FixedStep<S, F> {
    /// Steps of at most `longest_step`, in s; a drift of 1e-10 (of what the scalar can resolve, if that is more).
    pub fn new(longest_step: S) -> Self {
        let tolerance = S::lit(1e-10).max(S::lit(64.0) * S::EPSILON);
        let plan = Plan { start: S::lit(0.0), h: S::lit(0.0), steps: 0, done: 0 };
        Self {
            longest_step,
            tolerance,
            check_every: 8,
            plan,
            careful: false,
            until_check: 0,
            formula: PhantomData,
        }
    }

    /// The same with another tolerance on the drift, as a fraction of the typical coordinate and velocity.
    #[must_use]
    pub fn with_tolerance(self, tolerance: S) -> Self {
        Self { tolerance, ..self }
    }

    /// The next state, by rank where needed.
    fn next<M: System<S = S>>(&mut self, course: &mut Course<'_, M>) -> Result<M::X, Fault> {
        let (t, h) = (course.time, self.plan.h);
        if !self.careful {
            let (system, u) = (course.system, course.input);
            let mut worst = Health::perfect();
            let next = F::step::<M>(t, h, &course.x, |t, x, dx| {
                worst = worst.worst(system.rate(t, u, x, dx));
            });
            course.stats.evaluations += F::STAGES;
            if worst.is_good() {
                return Ok(next);
            }
        }
        self.next_by_rank(course)
    }

    #[cold]
    fn next_by_rank<M: System<S = S>>(&mut self, course: &mut Course<'_, M>) -> Result<M::X, Fault> {
        let (t, h, x) = (course.time, self.plan.h, course.x);
        let by_rank = course.stats.by_rank;
        let mut outcome = Ok(());
        let next = F::step::<M>(t, h, &x, |t, x, dx| {
            if outcome.is_ok() {
                outcome = course.rate(t, x, dx);
            }
        });
        self.careful = course.stats.by_rank > by_rank;
        outcome.map(|()| next)
    }

    /// Settles the state if its drift is due to be looked at and too large; by rank, after every step.
    fn limit_drift<M: System<S = S>>(&mut self, course: &mut Course<'_, M>) -> Result<(), Fault> {
        if self.until_check > 1 && !self.careful {
            self.until_check -= 1;
            return Ok(());
        }
        let drift = course.system.drift(course.time, &course.x);
        let limit = if self.careful { S::lit(0.0) } else { S::lit(1.0) };
        if excess(drift, self.drift_limit(course.system)) > limit {
            self.until_check = 1;
            course.settle()
        } else {
            self.until_check = self.check_every;
            Ok(())
        }
    }
}

impl<M: System<S: Real>, F: Formula> Method<M> for FixedStep<M::S, F> {
    const DENSE: bool = false;

    fn begin(&mut self, course: &Course<'_, M>) -> Result<(), Fault> {
        let span = course.end - course.time;
        // Rounding in `span` must not cost another step.
        let ratio = (span / self.longest_step).to_f64() * (1.0 - 1e-6);
        let whole = ratio as u64;
        let steps = if ratio > whole as f64 { whole.saturating_add(1) } else { whole };
        let h = span / M::S::lit(steps as f64);
        // False for a step that is zero, negative, or not a number.
        let moves = self.longest_step > M::S::lit(0.0) && course.time + h > course.time;
        if !moves {
            return Err(course.fault(Cause::StepTooSmall { step: self.longest_step.to_f64() }));
        }
        self.plan = Plan { start: course.time, h, steps, done: 0 };
        Ok(())
    }

    fn advance(&mut self, course: &mut Course<'_, M>) -> Result<(), Fault> {
        let next = self.next(course)?;
        self.plan.done += 1;
        let time = if self.plan.done < self.plan.steps {
            self.plan.start + M::S::lit(self.plan.done as f64) * self.plan.h
        } else {
            course.end
        };
        if !next.is_finite() {
            return Err(not_finite(course.system, time, &next));
        }
        course.stats.count_step(self.plan.h.to_f64());
        course.time = time;
        course.x = next;
        self.limit_drift(course)
    }

    fn interpolate(&self, _time: M::S) -> M::X {
        M::X::fill(M::S::lit(0.0))
    }

    fn restart(&mut self) {
        self.until_check = 0;
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}
