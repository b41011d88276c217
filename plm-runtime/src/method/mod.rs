//! Integration methods: how a state is carried over an interval.
//!
//! | method | order | step |
//! |---|---|---|
//! | [`SemiImplicitEuler`] | 1 | fixed |
//! | [`Rk4`] | 4 | fixed |
//! | [`Dopri5`] | 5, dense output of order 4 | by error control |
//! | [`Dop853`] | 8, dense output of order 7 | by error control |
//! | [`Vern9`] | 9, dense output of order 8 | by error control |
//! | [`Adams`] | 1 to 13, dense output of degree 8 | order and step by error control |
//! | [`Gauss`] with 2 or 3 stages | 4, 6; symplectic and time-reversible | fixed |
//! | [`Ros34Pw2`] | 3; L-stable | fixed |
//! | [`RadauIia5`] | 5, dense output of order 3; L-stable | by error control |
//!
//! A method owns what it remembers from step to step (its proposal for the next one, the last rate), so that a saved
//! copy of it resumes to the bit. The formulas of the fixed-step methods are usable alone, for any [`Scalar`].

mod adams;
mod adaptive;
mod dop853;
mod dopri5;
mod embedded;
mod estimate;
mod euler;
mod fixed;
mod gauss;
mod jacobian;
mod length;
mod partition;
mod path;
mod projection;
mod radau;
mod rates;
mod rk4;
mod ros34pw2;
mod vern9;
mod words;

pub use adams::Adams;
pub use dop853::{Dop853, DormandPrince853};
pub use dopri5::{Dopri5, DormandPrince5};
pub use embedded::{Embedded, Limits, Pair};
pub use estimate::Estimate;
pub use euler::{SemiImplicitEuler, SemiImplicitEulerFormula};
pub(crate) use fixed::looked_at;
pub use fixed::{FixedStep, Formula, Made};
pub use gauss::Gauss;
pub(crate) use length::coarseness;
pub(crate) use partition::Partition;
pub use path::Path;
pub use radau::RadauIia5;
pub use rates::Rates;
pub(crate) use rates::Watched;
pub use rk4::{Rk4, Rk4Formula};
pub use ros34pw2::{Ros34Pw2, Ros34Pw2Formula, Trial};
pub use vern9::{Vern9, Verner98};

use core::cmp::Ordering;

use crate::events::before_projection;
use crate::fault::{Cause, Fault};
use crate::protocol::{DriftCheck, Length, Proposal};
use crate::scalar::{Real, Scalar};
use crate::sim::Stats;
use crate::system::{Drift, Health, Rate, Step, System};
use crate::vector::Vector;

/// A method that carries a state over an interval, step by step.
pub trait Method<M: System>: Copy {
    /// Whether [`interpolate`](Self::interpolate) gives states inside the last step.
    const DENSE: bool;
    /// Whether an interval may be made by [`fast_step`](Self::fast_step).
    const FAST: bool = false;
    /// By which results tell what made them.
    const NAME: &'static str = "";
    /// The choice of step lengths: by an estimate of the error, or by the user.
    const LENGTH: Length = if Self::DENSE { Length::Error } else { Length::Fixed { caution: 1.0 } };

    /// Divides the interval from `context.time` to `context.end` into steps.
    ///
    /// # Errors
    /// When the step size does not allow it.
    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault>;

    /// Proposes a step, at most to `context.end`, and exactly there in the last one. With error control it is one that the estimate
    /// of its error accepts.
    ///
    /// # Errors
    /// When no step can be accepted; time and state of the context are then those before the step.
    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault>;

    /// Computes what [`interpolate`](Self::interpolate) needs and the step itself did not; it may be called again.
    ///
    /// # Errors
    /// When an evaluation fails.
    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// The state at a time within the last step, after [`densify`](Self::densify); a rougher one (order 3) without.
    fn interpolate(&self, time: M::S) -> M::X;

    /// What [`interpolate`](Self::interpolate) gives, as polynomials; none where nothing is known of a step, and where the state
    /// stands in what is held.
    fn path(&self) -> Option<Path<M::S, M::X>> {
        None
    }

    /// Discrete state and state at a time within the last step of the context, as [`interpolate`](Self::interpolate).
    fn moment(&self, context: &Context<'_, M>, time: M::S) -> (M::U, M::X) {
        (context.held, self.interpolate(time))
    }

    /// Takes the state `x` over an interval between two times by the formula alone, as [`advance`](Self::advance) would before it
    /// looks at the step. None where that takes more than one step, or where the step is not healthy; `x` is of no use then. The
    /// method stays as it is.
    #[inline]
    fn fast_step(
        &self,
        (system, held): (&M, &M::U),
        times: (M::S, M::S),
        x: &mut M::X,
    ) -> Option<FastStep<M::S>> {
        let _ = (system, held, times, x);
        None
    }

    /// How far the last step was off, where its length was fixed and was not chosen for its error: zero where that is too little
    /// to be estimated, and of other steps.
    fn estimate(&self) -> Estimate<M::S> {
        Estimate::NONE
    }

    /// How far a step of such a length from a time was off.
    fn estimate_of(
        &self,
        (system, held): (&M, &M::U),
        times: (M::S, M::S),
        ends: [&M::X; 2],
    ) -> Estimate<M::S> {
        let _ = (system, held, times, ends);
        Estimate::NONE
    }

    /// Is the error of such a step to be estimated for what its ends tell?
    #[inline]
    fn is_long(&self, (system, stats): (&M, &Stats), h: M::S, ends: [&M::X; 2]) -> bool {
        let _ = (system, stats, h, ends);
        false
    }

    /// Whether the state that the next step leads to is projected. Methods that project by themselves have no check.
    #[inline]
    fn drift_check(&self) -> DriftCheck<M::S> {
        DriftCheck::Skip
    }

    /// A step is committed; its end was projected if it had `drifted`.
    #[inline]
    fn keep(&mut self, drifted: bool) {
        let _ = drifted;
    }

    /// Forgets what is known of the current state: it, a parameter or an input has been changed from outside.
    fn restart(&mut self);

    /// Angles were brought back by whole turns: the state has other numbers and the same rates.
    fn turned(&mut self) {
        self.restart();
    }

    /// The system has refused the state that the last step, of `h`, led to, and the state is that before it again:
    /// whether a shorter step is tried next. Not where steps are fixed.
    fn shorten(&mut self, h: M::S) -> bool {
        let _ = h;
        self.restart();
        false
    }

    /// The same method with steps of at most `longest`, s, as before its first step; none where an estimate of the error chooses them.
    fn shorter(&self, longest: M::S) -> Option<Self> {
        let _ = longest;
        None
    }

    /// The same method with its options, as it was before its first step.
    #[must_use]
    fn fresh(&self) -> Self;

    /// The state with the largest part of the error estimate in the last step, by its index; none where something else
    /// decided how long the step was: the end of the interval, a longest step, the drift.
    fn limited_by(&self, system: &M) -> Option<usize> {
        let _ = system;
        None
    }

    /// The relative tolerance of steps that are chosen by their error.
    fn tolerance(&self) -> Option<M::S> {
        None
    }

    /// How many steps an interval may take, those near singular poses and those that were rejected among them.
    fn most_steps(&self) -> u64 {
        u64::MAX
    }

    /// The drift above which a state is projected.
    fn drift_limit(&self, system: &M) -> Drift<M::S>;
}

/// A step that makes an interval alone, by [`Method::fast_step`].
#[derive(Clone, Copy, Debug)]
pub struct FastStep<S> {
    /// Its length, s.
    pub h: S,
    /// The smallest pivot ratio of its rates.
    pub health: S,
    /// Evaluations of the rate that it took.
    pub evaluations: u64,
    /// Its rates are so little apart that its error needs no estimate.
    pub are_near: bool,
}

/// Integration context: a state on its way through an interval.
pub struct Context<'a, M: System> {
    /// The equations.
    pub system: &'a M,
    /// What is held over the step: inputs, chart, branches.
    pub held: M::U,
    /// The time reached, s.
    pub time: M::S,
    /// The state reached.
    pub x: M::X,
    /// The end of the interval, s.
    pub end: M::S,
    /// What was done so far.
    pub stats: &'a mut Stats,
    /// The longest step so far, s.
    pub longest_step: &'a mut M::S,
    /// The smallest pivot ratio of the rates since the last step was accepted, [`Health`].
    pub health: M::S,
    /// Steps are made without what the mechanism's own coordinates need, until this time at least.
    pub(crate) rescued: Option<M::S>,
    /// Steps that had been tried before the interval.
    before: u64,
}

impl<'a, M: System> Context<'a, M> {
    /// A state at a time, on its way to `end`.
    pub fn new(
        (system, held): (&'a M, M::U),
        (time, x): (M::S, M::X),
        end: M::S,
        (stats, longest_step): (&'a mut Stats, &'a mut M::S),
    ) -> Self {
        let before = stats.steps + stats.rejected;
        Self {
            system,
            held,
            time,
            x,
            end,
            stats,
            longest_step,
            health: M::S::lit(1.0),
            rescued: None,
            before,
        }
    }

    /// Has the interval taken more steps than it may?
    pub(crate) fn check_steps(&self, most: u64) -> Result<(), Fault> {
        let tried = self.stats.steps + self.stats.rejected - self.before;
        if tried < most { Ok(()) } else { Err(self.fault(Cause::TooManySteps { steps: most })) }
    }

    /// The step to the state reached, with copies `held` and `x` of what it led to.
    #[inline]
    pub(crate) fn proposal<'s>(
        &self,
        from: (M::S, &'s M::X),
        (held, x): (&'s mut M::U, &'s mut M::X),
    ) -> Proposal<'s, M>
    where
        'a: 's,
    {
        Proposal { system: self.system, from, end: self.time, held, x, health: self.health }
    }

    /// The step to the state reached.
    pub(crate) fn step<'s>(&'s self, from: (M::S, &'s M::X)) -> Step<'s, M> {
        let to = (self.time, &self.x);
        Step { system: self.system, held: &self.held, from, to, health: self.health }
    }

    /// A fault at the time reached.
    pub(crate) fn fault(&self, cause: Cause) -> Fault {
        Fault::new(self.time.to_f64(), cause)
    }

    /// The rate at `(t, x)`, by rank where it is unhealthy.
    pub(crate) fn rate(&mut self, t: M::S, x: &M::X, dx: &mut M::X) -> Result<(), Fault> {
        self.stats.evaluations += 1;
        let health = rate((self.system, &self.held), t, x, dx);
        self.health = self.health.min(health.0);
        if health.is_good() {
            return Ok(());
        }
        // What is not a number makes every matrix look singular; it is named for what it is.
        if !x.is_finite() {
            return Err(not_finite(self.system, t, x));
        }
        let outcome = self.system.rate_by_rank(t, &self.held, x, dx);
        self.stats.by_rank += u64::from(outcome.is_ok());
        outcome
    }

    /// Projects the state reached onto the constraints.
    pub(crate) fn project_end(&mut self) -> Result<(), Fault>
    where
        M: System<S: Real>,
    {
        let (time, mut x) = (self.time, self.x);
        before_projection(self, time, &x)?;
        self.project(time, &mut x)?;
        self.x = x;
        Ok(())
    }

    /// Projects a state onto the constraints.
    fn project(&mut self, t: M::S, x: &mut M::X) -> Result<(), Fault> {
        self.stats.projected += 1;
        self.system.project(t, x)
    }
}

/// The rate where many places ask for it and none waits for it: one copy of its code for all of them.
#[inline(never)]
fn rate<M: Rate>((system, held): (&M, &M::U), t: M::S, x: &M::X, dx: &mut M::X) -> Health<M::S> {
    system.rate(t, held, x, dx)
}

/// A fault that names the part of the first component which is not finite.
pub(crate) fn not_finite<M: System>(system: &M, t: M::S, x: &M::X) -> Fault {
    let index = (0..M::X::LEN).find(|i| !x.at(*i).is_finite());
    let part = index.map_or("", |i| system.part_of_state(i));
    Fault::of_part(t.to_f64(), part, Cause::NotFinite)
}

/// Drift of the size `fraction` of the largest typical coordinate and velocity.
pub(crate) fn drift_of_size<M: System<S: Real>>(system: &M, fraction: M::S) -> Drift<M::S> {
    let typical = system.typical();
    let largest = |from: usize| (from..from + M::NQ).fold(M::S::lit(0.0), |size, i| typical.at(i).max(size));
    Drift { phi: fraction * largest(0), phi_dot: fraction * largest(M::NQ) }
}

/// The larger of the two residuals, each as a multiple of its limit; zero where there is nothing to project.
pub(crate) fn excess<S: Real>(drift: Drift<S>, limit: Drift<S>) -> S {
    let zero = S::lit(0.0);
    let ratio = |size: S, limit: S| if size == zero { zero } else { size / limit };
    larger(ratio(drift.phi, limit.phi), ratio(drift.phi_dot, limit.phi_dot))
}

/// The larger of two numbers; NaN if one of them is.
fn larger<S: Real>(a: S, b: S) -> S {
    match a.partial_cmp(&b) {
        Some(Ordering::Less) => b,
        Some(_) => a,
        None => a + b,
    }
}
