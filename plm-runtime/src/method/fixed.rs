//! Common parts of the fixed-step methods: division of an interval, health, drift.

mod at_once;
mod formula;
mod whole;

use core::marker::PhantomData;

pub(crate) use self::formula::looked_at;
pub use self::formula::{Formula, Made};

use self::formula::{evaluated, formula};
use super::estimate::Estimate;
use super::length::{are_near, are_straight, is_due};
use super::partition::Partition;
use super::{
    Context, DenseOutput, DriftCheck, ErrorControl, FastStep, FixedLength, Method, drift_of_size, not_finite,
    rate,
};
use crate::fault::Fault;
use crate::scalar::Real;
use crate::stats::Stats;
use crate::system::{Drift, System};
use crate::vector::Vector;

/// A method with steps of equal length.
///
/// An interval is divided into whole steps of at most [`longest_step`](Self::longest_step). The health of the stages is checked once a
/// step; an unhealthy step is repeated, by rank where needed, and so are the following ones until one is healthy throughout. These are
/// projected one by one, because near a singular position the distance from the constraints decides the branch that the motion takes.
/// Otherwise the drift is checked after every [`check_every`](Self::check_every) steps, and again after the next step whenever the state
/// had to be projected.
#[derive(Clone, Copy, Debug)]
pub struct FixedStep<S, F> {
    /// Longest step, s.
    pub longest_step: S,
    /// Tolerated drift, as a fraction of the typical coordinate and velocity.
    pub tolerance: S,
    /// Steps between two checks of the drift, counted across intervals.
    pub check_every: u32,
    pub(crate) partition: Partition<S>,
    /// True if the last step was unhealthy.
    pub(crate) was_unhealthy: bool,
    /// Steps until the next check of the drift.
    pub(super) until_check: u32,
    /// Error of the last step.
    estimate: Estimate<S>,
    formula: PhantomData<F>,
}

impl<S: Real, F: Formula> FixedStep<S, F> {
    /// The method with steps of at most `longest_step`, in s, and a tolerated drift of 1e-10 (at least the resolution of the scalar).
    pub fn new(longest_step: S) -> Self {
        let tolerance = S::lit(1e-10).max(S::lit(64.0) * S::EPSILON);
        Self {
            longest_step,
            tolerance,
            check_every: 8,
            partition: Partition::none(),
            was_unhealthy: false,
            until_check: 0,
            estimate: Estimate::NONE,
            formula: PhantomData,
        }
    }

    /// This method with another tolerance on the drift, as a fraction of the typical coordinate and velocity.
    #[must_use]
    pub fn with_tolerance(self, tolerance: S) -> Self {
        Self { tolerance, ..self }
    }

    /// Makes one step, by rank if needed.
    #[inline]
    pub(crate) fn step<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        x: &mut M::X,
    ) -> Result<(), Fault> {
        let (t, h) = (context.time, self.partition.h);
        if !self.was_unhealthy {
            let all = (context.system, &context.held);
            let (health, are_near) = formula::<F, M>(all, (t, h), (&context.x, x));
            let is_bent = || {
                is_due(context.system, context.stats)
                    && !are_straight::<F, M>(context.system, h, [&context.x, x])
            };
            let is_short = are_near && !is_bent();
            context.stats.evaluations += F::STAGES;
            context.health = context.health.min(health.0);
            if health.is_good() {
                self.estimate =
                    if is_short { Estimate::NONE } else { estimate::<F, M>(all, (t, h), [&context.x, x]) };
                return Ok(());
            }
            *x = context.x;
        }
        self.step_by_rank(context, x)
    }

    /// Records that the last step needed no estimate.
    #[inline]
    pub(crate) fn is_short(&mut self) {
        self.estimate = Estimate::NONE;
    }

    #[cold]
    #[inline(never)]
    fn step_by_rank<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        x: &mut M::X,
    ) -> Result<(), Fault> {
        let (t, h, by_rank) = (context.time, self.partition.h, context.stats.by_rank);
        let mut outcome = Ok(());
        let rates = |t: M::S, x: &M::X, dx: &mut M::X| {
            if outcome.is_ok() {
                outcome = context.rate(t, x, dx);
            }
        };
        let difference = F::step::<M, _>((t, h), x, rates, |_, stages| F::difference::<M>(stages));
        self.was_unhealthy = context.stats.by_rank > by_rank;
        let Context { system, held, x: from, .. } = context;
        self.estimate = F::estimate(&Made { system: *system, held, h, from: (t, from), to: x }, &difference);
        outcome
    }

    /// Moves the context to `next`, the state after the step.
    #[inline]
    pub(crate) fn land<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        next: M::X,
    ) -> Result<(), Fault> {
        if !context.system.is_finite(&next) {
            return Err(not_finite(context.system, self.partition.next_time, &next));
        }
        context.stats.steps += 1;
        (context.time, context.x) = (self.partition.next_time, next);
        self.partition.next();
        Ok(())
    }

    /// Check of the drift after the next step; after steps by rank every drift is projected.
    #[inline]
    pub(crate) fn drift_check(&self) -> DriftCheck<S> {
        if self.skips_check() {
            return DriftCheck::Skip;
        }
        let above = if self.was_unhealthy { S::lit(0.0) } else { S::lit(1.0) };
        DriftCheck::Above { tolerance: self.tolerance, above }
    }

    /// Counts a step towards the next check of the drift.
    #[inline]
    pub(crate) fn keep(&mut self, drifted: bool) {
        self.until_check = match (self.skips_check(), drifted) {
            (true, _) => self.until_check - 1,
            (false, true) => 1,
            (false, false) => self.check_every,
        };
    }

    /// Counts so many steps towards the next check of the drift, as [`keep`](Self::keep) does if it was small.
    #[inline]
    pub(crate) fn skip_checks(&mut self, steps: u64) {
        if steps == 0 {
            return;
        }
        let (first, every) = (u64::from(self.until_check.max(1)), u64::from(self.check_every));
        let until_check = match steps.checked_sub(first) {
            None => first - steps,
            Some(more) => every - more.checked_rem(every).unwrap_or_default(),
        };
        self.until_check = u32::try_from(until_check).unwrap_or(self.check_every);
    }

    /// True if the drift is not checked after the next step.
    #[inline]
    pub(crate) fn skips_check(&self) -> bool {
        self.until_check > 1 && !self.was_unhealthy
    }
}

/// Error of a healthy step of `h` between two states. The step is repeated for it: otherwise all steps would pay for storing their rates to
/// the end.
#[cold]
#[inline(never)]
fn estimate<F: Formula, M: System<S: Real>>(
    (system, held): (&M, &M::U),
    (t, h): (M::S, M::S),
    [from, to]: [&M::X; 2],
) -> Estimate<M::S> {
    let mut again = *from;
    let rates = |t: M::S, x: &M::X, dx: &mut M::X| {
        rate((system, held), t, x, dx);
    };
    let difference = F::step::<M, _>((t, h), &mut again, rates, |_, stages| F::difference::<M>(stages));
    F::estimate(&Made { system, held, h, from: (t, from), to }, &difference)
}

impl<M: System<S: Real>, F: Formula> Method<M> for FixedStep<M::S, F> {
    #[inline]
    fn name(&self) -> &'static str {
        F::NAME
    }

    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.partition = Partition::of_interval(context, self.longest_step)?;
        Ok(())
    }

    #[inline]
    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if M::WHOLE && self.advance_whole(context) {
            return Ok(());
        }
        let mut next = context.x;
        self.step(context, &mut next)?;
        self.land(context, next)
    }

    fn restart(&mut self) {
        self.until_check = 0;
    }

    fn fresh(&self) -> Self {
        let Self { longest_step, tolerance, check_every, .. } = *self;
        Self { tolerance, check_every, ..Self::new(longest_step) }
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}

impl<M: System<S: Real>, F: Formula> DenseOutput<M> for FixedStep<M::S, F> {}

impl<M: System<S: Real>, F: Formula> ErrorControl<M> for FixedStep<M::S, F> {}

impl<M: System<S: Real>, F: Formula> FixedLength<M> for FixedStep<M::S, F> {
    #[inline]
    fn next_time(&self) -> Option<M::S> {
        Some(self.partition.next_time)
    }

    #[inline]
    fn is_fast(&self) -> bool {
        true
    }

    #[inline]
    fn fast_step(
        &self,
        (system, held): (&M, &M::U),
        (t, end): (M::S, M::S),
        to: &mut M::X,
    ) -> Option<FastStep<M::S>> {
        let h = Partition::one_step(t, end, self.longest_step).filter(|_| !self.was_unhealthy)?;
        let (health, are_near) = if M::WHOLE {
            let from = *to;
            formula::<F, M>((system, held), (t, h), (&from, to))
        } else {
            evaluated::<F, M, _>((system, held), (t, h), to, |to, stages| {
                are_near::<F, M>(system, h, to, stages)
            })
        };
        let healthy = to.is_finite() && health.is_good();
        healthy.then_some(FastStep { h, health: health.0, evaluations: F::STAGES, are_near })
    }

    #[inline]
    fn estimate(&self) -> Estimate<M::S> {
        self.estimate
    }

    fn estimate_of(&self, all: (&M, &M::U), times: (M::S, M::S), ends: [&M::X; 2]) -> Estimate<M::S> {
        estimate::<F, M>(all, times, ends)
    }

    #[inline]
    fn is_long(&self, (system, stats): (&M, &Stats), h: M::S, ends: [&M::X; 2]) -> bool {
        is_due(system, stats) && !are_straight::<F, M>(system, h, ends)
    }

    #[inline]
    fn drift_check(&self, _system: &M) -> DriftCheck<M::S> {
        FixedStep::drift_check(self)
    }

    #[inline]
    fn keep(&mut self, drifted: bool) {
        FixedStep::keep(self, drifted);
    }

    fn shorter(&self, longest: M::S) -> Option<Self> {
        let Self { tolerance, check_every, .. } = *self;
        Some(Self { tolerance, check_every, ..Self::new(longest) })
    }
}
