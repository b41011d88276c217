//! Time stepping of J. J. Moreau and M. Jean: fixed steps over impacts and friction, without events of contact.

use super::partition::Partition;
use super::{
    Context, DenseOutput, DriftCheck, ErrorControl, FixedLength, Length, Method, drift_of_size, not_finite,
    unhealthy,
};
use crate::contact::{Change, Solution, Stride, smooth_step};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Time stepping of Moreau and Jean with steps of equal length: order 1, one rate a step, for any contact in it.
///
/// Forces, masses and rows are evaluated at one intermediate place, `q + (1 - theta) h v`, with the velocity at the beginning of the step.
/// With more `EVALUATIONS` than one ([`with_evaluations`](Self::with_evaluations)), each further one is there with the velocity that the
/// one before predicts: two and `theta = 1/2` are of order 2 between changes of modes, for all forces. The impulses of all contact rows
/// over the step are one contact problem, which takes a bounded number of rounds; no event of a row is searched. A step in which a gap closes
/// with a rate is split once, at the impact, which takes place at its share of the step. Sticking
/// frictions stay in their places, and closed gaps do not penetrate ([`contact`](crate::contact), [`Stride`]). Conditions, and events by
/// `when`, switch at the end of the step.
///
/// Without contact it is a semi-implicit Euler method with `theta = 1`, and with `theta = 1/2` the midpoint rule of positions, of order 2
/// if forces depend on positions alone. It does not resolve stiff equations.
#[derive(Clone, Copy, Debug)]
pub struct MoreauJean<S, const EVALUATIONS: usize = 1> {
    /// Longest step, s.
    pub longest_step: S,
    /// Weight of the velocity at the end of a step in the change of positions, 1/2 to 1.
    pub theta: S,
    /// Tolerated drift of the joints, as a fraction of the typical coordinate and velocity.
    pub tolerance: S,
    partition: Partition<S>,
    /// Residual of the last step.
    residual: S,
    /// Largest residual of all steps so far.
    largest_residual: S,
}

impl<S: Real> MoreauJean<S> {
    /// The [`theta`](Self::theta) of [`new`](Self::new).
    pub const THETA: f64 = 0.5;

    /// The method with steps of at most `longest_step`, in s, [`THETA`](Self::THETA), one evaluation, and a tolerated drift of 1e-10 (at
    /// least the resolution of the scalar).
    pub fn new(longest_step: S) -> Self {
        let tolerance = S::lit(1e-10).max(S::lit(64.0) * S::EPSILON);
        Self::of(longest_step, S::lit(Self::THETA), tolerance)
    }
}

impl<S: Real, const EVALUATIONS: usize> MoreauJean<S, EVALUATIONS> {
    fn of(longest_step: S, theta: S, tolerance: S) -> Self {
        let (partition, residual) = (Partition::none(), S::ZERO);
        Self { longest_step, theta, tolerance, partition, residual, largest_residual: residual }
    }

    /// This method with so many evaluations of the equations of motion in a step, one or more: two make it of order 2 between changes of modes.
    #[must_use]
    pub fn with_evaluations<const COUNT: usize>(self) -> MoreauJean<S, COUNT> {
        const { assert!(COUNT > 0, "a step of `MoreauJean` takes one evaluation or more") }
        MoreauJean::of(self.longest_step, self.theta, self.tolerance)
    }

    /// This method with another [`theta`](Self::theta); a number outside of 1/2 to 1 becomes the nearest one within.
    #[must_use]
    pub fn with_theta(self, theta: S) -> Self {
        Self { theta: theta.max(S::lit(0.5)).min(S::lit(1.0)), ..self }
    }

    /// This method with another tolerance on the drift, as a fraction of the typical coordinate and velocity.
    #[must_use]
    pub fn with_tolerance(self, tolerance: S) -> Self {
        Self { tolerance, ..self }
    }

    /// Rate, m/s or rad/s, by which a law of contact was violated in the last step: rounding if its contact problem was solved.
    pub fn residual(&self) -> S {
        self.residual
    }

    /// The largest [`residual`](Self::residual) of all steps.
    pub fn largest_residual(&self) -> S {
        self.largest_residual
    }

    /// The next step of the partition.
    pub(crate) fn stride(&self, t: S) -> Stride<S> {
        Stride { t, h: self.partition.h, theta: self.theta }
    }

    /// Advances to the state `next` after a step with contact rows, if that could be made and is healthy. The caller sets the discrete
    /// state after it.
    pub(crate) fn land_with_rows<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        made: &Result<Solution<S>, Fault>,
        next: M::X,
    ) -> Result<(), Fault> {
        let Solution { residual, health, evaluations, .. } = (*made)?;
        context.stats.evaluations += u64::from(evaluations);
        context.health = context.health.min(health.0);
        if !health.is_good() {
            let here = (context.time, context.x);
            return Err(unhealthy(context.system, &context.held, here, context.x));
        }
        self.residual = residual;
        self.largest_residual = self.largest_residual.max(residual);
        self.land(context, next)
    }

    /// Advances to the state after a step.
    fn land<M: System<S = S>>(&mut self, context: &mut Context<'_, M>, next: M::X) -> Result<(), Fault> {
        if !next.is_finite() {
            return Err(not_finite(context.system, self.partition.next_time, &next));
        }
        context.stats.steps += 1;
        (context.time, context.x) = (self.partition.next_time, next);
        self.partition.next();
        Ok(())
    }
}

impl<M: System<S: Real>, const EVALUATIONS: usize> Method<M> for MoreauJean<M::S, EVALUATIONS> {
    #[inline]
    fn name(&self) -> &'static str {
        "MoreauJean"
    }
    #[inline]
    fn length(&self) -> Length {
        Length::Fixed { caution: 1.0 }
    }

    #[inline]
    fn change(&self) -> Change {
        Change::InSteps
    }

    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.partition = Partition::of_interval(context, self.longest_step)?;
        Ok(())
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let (mut next, stride) = (context.x, self.stride(context.time));
        if context.system.contact_count() > 0 {
            let mut held = context.held;
            let made = context.system.stride::<EVALUATIONS>(&stride, &mut held, &mut next, |_, _, _| Ok(()));
            self.land_with_rows(context, &made, next)?;
            context.held = held;
            return Ok(());
        }
        let mut outcome = Ok(());
        smooth_step::<M, EVALUATIONS>(&stride, &mut next, |t, x, dx| {
            outcome = outcome.and_then(|()| context.rate(t, x, dx));
        });
        outcome?;
        self.land(context, next)
    }

    fn restart(&mut self) {}

    fn fresh(&self) -> Self {
        Self::of(self.longest_step, self.theta, self.tolerance)
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}

impl<M: System<S: Real>, const EVALUATIONS: usize> DenseOutput<M> for MoreauJean<M::S, EVALUATIONS> {}

impl<M: System<S: Real>, const EVALUATIONS: usize> ErrorControl<M> for MoreauJean<M::S, EVALUATIONS> {}

impl<M: System<S: Real>, const EVALUATIONS: usize> FixedLength<M> for MoreauJean<M::S, EVALUATIONS> {
    #[inline]
    fn next_time(&self) -> Option<M::S> {
        Some(self.partition.next_time)
    }

    // With contact rows a step projects its joints itself.
    fn drift_check(&self, system: &M) -> DriftCheck<M::S> {
        if system.contact_count() > 0 {
            return DriftCheck::Skip;
        }
        DriftCheck::Above { tolerance: self.tolerance, above: M::S::lit(1.0) }
    }

    fn shorter(&self, longest: M::S) -> Option<Self> {
        Some(Self::of(longest, self.theta, self.tolerance))
    }
}

/// Options, and residuals.
impl<S: Real, const EVALUATIONS: usize> InWords for MoreauJean<S, EVALUATIONS> {
    fn each(&mut self, words: &mut impl Words) {
        let Self { longest_step, theta, tolerance, residual, largest_residual, .. } = self;
        words.numbers([longest_step, theta, tolerance, residual, largest_residual]);
    }
}
