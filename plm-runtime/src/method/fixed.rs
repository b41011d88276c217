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

    /// Takes the state `x` from `t` to `t + h`; `rate(t, x, dx)` writes the rate.
    fn step<M: System>(t: M::S, h: M::S, x: &mut M::X, rate: impl FnMut(M::S, &M::X, &mut M::X));

    /// One step for any scalar, with the worst health of its stages and without a second try.
    #[inline]
    fn plain_step<M: System>(system: &M, t: M::S, u: &M::U, x: &mut M::X, h: M::S) -> Health<M::S> {
        let mut worst = Health::perfect();
        Self::step::<M>(t, h, x, |t, x, dx| worst = worst.worst(system.rate(t, u, x, dx)));
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
    end: S,
    h: S,
    /// The time after the next step.
    next_time: S,
    steps: u32,
    /// Steps up to that time.
    done: u32,
}

impl<S: Real, F: Formula> FixedStep<S, F> {
    /// Steps of at most `longest_step`, in s; a drift of 1e-10 (of what the scalar can resolve, if that is more).
    pub fn new(longest_step: S) -> Self {
        let tolerance = S::lit(1e-10).max(S::lit(64.0) * S::EPSILON);
        let zero = S::lit(0.0);
        let plan = Plan { start: zero, end: zero, h: zero, next_time: zero, steps: 0, done: 0 };
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

    /// Makes one step, by rank where needed.
    #[inline]
    fn step<M: System<S = S>>(&mut self, course: &mut Course<'_, M>, x: &mut M::X) -> Result<(), Fault> {
        if !self.careful {
            let health = F::plain_step(course.system, course.time, &course.held, x, self.plan.h);
            course.stats.evaluations += F::STAGES;
            if health.is_good() {
                return Ok(());
            }
            *x = course.x;
        }
        self.step_by_rank(course, x)
    }

    #[cold]
    fn step_by_rank<M: System<S = S>>(
        &mut self,
        course: &mut Course<'_, M>,
        x: &mut M::X,
    ) -> Result<(), Fault> {
        let (t, h, by_rank) = (course.time, self.plan.h, course.stats.by_rank);
        let mut outcome = Ok(());
        F::step::<M>(t, h, x, |t, x, dx| {
            if outcome.is_ok() {
                outcome = course.rate(t, x, dx);
            }
        });
        self.careful = course.stats.by_rank > by_rank;
        outcome
    }

    /// Settles a new state if its drift is due to be looked at and too large; by rank, after every step.
    #[inline]
    fn limit_drift<M: System<S = S>>(
        &mut self,
        course: &mut Course<'_, M>,
        next: &mut M::X,
    ) -> Result<(), Fault> {
        if self.until_check > 1 && !self.careful {
            self.until_check -= 1;
            return Ok(());
        }
        let drift = course.system.drift(self.plan.next_time, next);
        let limit = if self.careful { S::lit(0.0) } else { S::lit(1.0) };
        if excess(drift, self.drift_limit(course.system)) > limit {
            self.until_check = 1;
            course.settle(self.plan.next_time, next)
        } else {
            self.until_check = self.check_every;
            Ok(())
        }
    }
}

impl<S: Real> Plan<S> {
    /// Divides an interval into whole steps of at most `longest` (and a millionth, so that rounding in the length of the
    /// interval does not cost another step). None if such steps do not move the time or cannot be counted.
    fn new(start: S, end: S, longest: S) -> Option<Self> {
        let ratio = ((end - start) / longest).to_f64() * (1.0 - 1e-6);
        // False for a step that is negative or not a number.
        if !(0.0..f64::from(u32::MAX)).contains(&ratio) {
            return None;
        }
        let whole = ratio as u32;
        let steps = if ratio > f64::from(whole) { whole + 1 } else { whole.max(1) };
        let h = (end - start) / S::lit(f64::from(steps));
        let mut plan = Self { start, end, h, next_time: start, steps, done: 0 };
        plan.next();
        (plan.next_time > start).then_some(plan)
    }

    /// The time after the next step.
    #[inline]
    fn next(&mut self) {
        self.done = self.done.wrapping_add(1);
        let inside = self.start + S::lit(f64::from(self.done)) * self.h;
        self.next_time = if self.done < self.steps { inside } else { self.end };
    }
}

impl<M: System<S: Real>, F: Formula> Method<M> for FixedStep<M::S, F> {
    const DENSE: bool = false;

    fn begin(&mut self, course: &mut Course<'_, M>) -> Result<(), Fault> {
        let Some(plan) = Plan::new(course.time, course.end, self.longest_step) else {
            return Err(course.fault(Cause::StepTooSmall { step: self.longest_step.to_f64() }));
        };
        self.plan = plan;
        course.stats.longest_step = course.stats.longest_step.max(plan.h.to_f64());
        Ok(())
    }

    #[inline]
    fn advance(&mut self, course: &mut Course<'_, M>) -> Result<(), Fault> {
        let mut next = course.x;
        self.step(course, &mut next)?;
        if !next.is_finite() {
            return Err(not_finite(course.system, self.plan.next_time, &next));
        }
        self.limit_drift(course, &mut next)?;
        course.stats.steps += 1;
        (course.time, course.x) = (self.plan.next_time, next);
        self.plan.next();
        Ok(())
    }

    fn interpolate(&self, _time: M::S) -> M::X {
        M::X::fill(M::S::lit(0.0))
    }

    fn restart(&mut self) {
        self.until_check = 0;
    }

    fn accepts(&self) -> bool {
        self.until_check == self.check_every || self.careful
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}
