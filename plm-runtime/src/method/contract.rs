//! Contract of a method: the step, states within it, and the choice of its length.

use super::{Context, Estimate, Path, drift_of_size, excess};
use crate::contact::Change;
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::stats::Stats;
use crate::system::{Drift, System};
use crate::vector::Vector;

/// A method that integrates a state over an interval, step by step: the part that every method has.
///
/// The protocol does the rest: it judges each step, projects its end, ends it at events, splits or repeats it near singular poses, and
/// commits it. A method with error control implements [`ErrorControl`], one whose steps the user chooses [`FixedLength`]; the other
/// trait is left empty.
pub trait Method<M: System>: Clone + DenseOutput<M> + ErrorControl<M> + FixedLength<M> {
    /// Name of the method in results.
    fn name(&self) -> &'static str {
        ""
    }

    /// The choice of step lengths: by an estimate of the error, or by the user.
    #[inline]
    fn length(&self) -> Length {
        if self.is_dense() { Length::Error } else { Length::Fixed { caution: 1.0 } }
    }

    /// Times at which the modes of contact rows change: at events that are located, or in its steps.
    #[inline]
    fn change(&self) -> Change {
        Change::AtEvents
    }

    /// Divides the interval from `context.time` to `context.end` into steps.
    ///
    /// # Errors
    /// When the step size does not allow it.
    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// Proposes a step, at most to `context.end`, and exactly there in the last one. With error control it is one that the estimate
    /// of its error accepts.
    ///
    /// # Errors
    /// When no step can be accepted; time and state of the context are then those before the step.
    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault>;

    /// Forgets the history of the current state: it, a parameter or an input has been changed from outside.
    fn restart(&mut self);

    /// Called after angles were reduced by whole revolutions: the state has other numbers and the same rates.
    fn turned(&mut self) {
        self.restart();
    }

    /// This method with its options, as before its first step.
    #[must_use]
    fn fresh(&self) -> Self;

    /// Drift above which a state is projected.
    fn drift_limit(&self, system: &M) -> Drift<M::S>;
}

/// States within the last step.
pub trait DenseOutput<M: System> {
    /// True if there are any; otherwise the defaults of this trait apply.
    #[inline]
    fn is_dense(&self) -> bool {
        false
    }

    /// Computes the data that [`interpolate`](Self::interpolate) needs beyond those of the step; it may be called again.
    ///
    /// # Errors
    /// When an evaluation fails.
    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// Gives derivatives to the data that [`densify`](Self::densify) and [`interpolate`](Self::interpolate) read, if a step that was
    /// made at once has stored values alone.
    ///
    /// # Errors
    /// When an evaluation fails.
    fn derive(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// State at a time within the last step, after [`densify`](Self::densify); without it, a less accurate one (order 3).
    fn interpolate(&self, time: M::S) -> M::X {
        let _ = time;
        M::X::fill(M::S::ZERO)
    }

    /// States of [`interpolate`](Self::interpolate) as polynomials; `None` without a last step, and if the state is stored in the
    /// discrete state.
    fn path(&self) -> Option<Path<M::S, M::X>> {
        None
    }

    /// Discrete state and state at a time within the last step of the context, as [`interpolate`](Self::interpolate).
    fn moment(&self, context: &Context<'_, M>, time: M::S) -> (M::U, M::X) {
        (context.held, self.interpolate(time))
    }
}

/// Steps whose length follows from an estimate of their error.
pub trait ErrorControl<M: System> {
    /// Relative tolerance; `None` if the user chooses the steps.
    fn tolerance(&self) -> Option<M::S> {
        None
    }

    /// Most steps of an interval, with those near singular poses and those that were rejected.
    fn most_steps(&self) -> u64 {
        u64::MAX
    }

    /// Called after the system has refused the state that the last step, of `h`, led to; the state is that before it again. Returns
    /// true if a shorter step is tried next.
    fn shorten(&mut self, h: M::S) -> bool {
        let _ = h;
        false
    }

    /// Index of the state with the largest part of the error estimate in the last step; `None` if the length of the step had another
    /// reason: the end of the interval, a longest step, the drift.
    fn limited_by(&self, system: &M) -> Option<usize> {
        let _ = system;
        None
    }
}

/// Steps whose length the user chooses.
pub trait FixedLength<M: System>: Sized {
    /// True if [`fast_step`](Self::fast_step) may make an interval.
    #[inline]
    fn is_fast(&self) -> bool {
        false
    }

    /// Advances the state `x` over an interval between two times by the formula alone, as [`Method::advance`] would before it checks
    /// the step. `None` if that takes more than one step, or if the step is not healthy; `x` is invalid then. The method is unchanged.
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

    /// Time at which the step ends that is to be made next; `None` if an estimate of the error chooses the steps.
    #[inline]
    fn next_time(&self) -> Option<M::S> {
        None
    }

    /// Error of the last step: zero if it is too small to be estimated, and for steps with error control.
    fn estimate(&self) -> Estimate<M::S> {
        Estimate::NONE
    }

    /// Error of a step between two times and states.
    fn estimate_of(
        &self,
        (system, held): (&M, &M::U),
        times: (M::S, M::S),
        ends: [&M::X; 2],
    ) -> Estimate<M::S> {
        let _ = (system, held, times, ends);
        Estimate::NONE
    }

    /// True if the error of such a step has to be estimated, judged by its ends.
    #[inline]
    fn is_long(&self, (system, stats): (&M, &Stats), h: M::S, ends: [&M::X; 2]) -> bool {
        let _ = (system, stats, h, ends);
        false
    }

    /// Check of the drift after the next step. Methods that project by themselves have none.
    #[inline]
    fn drift_check(&self, system: &M) -> DriftCheck<M::S> {
        let _ = system;
        DriftCheck::Skip
    }

    /// Called when a step is committed; its end was projected if it had `drifted`.
    #[inline]
    fn keep(&mut self, drifted: bool) {
        let _ = drifted;
    }

    /// This method with steps of at most `longest`, s, as before its first step; `None` if an estimate of the error chooses the steps.
    fn shorter(&self, longest: M::S) -> Option<Self> {
        let _ = longest;
        None
    }
}

/// A step over a whole interval, by [`FixedLength::fast_step`].
#[derive(Clone, Copy, Debug)]
pub struct FastStep<S> {
    /// Its length, s.
    pub h: S,
    /// Smallest pivot ratio of its rates.
    pub health: S,
    /// Number of evaluations of the rate.
    pub evaluations: u64,
    /// True if its rates differ so little that its error needs no estimate.
    pub are_near: bool,
}

/// Choice of the length of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// By an estimate of its error.
    Error,
    /// By the user; next to a flat pose such a step must be shorter by `caution` than one of order 4 for an error as small.
    Fixed {
        /// A factor of at least 1.
        caution: f64,
    },
    /// By the user, for a single step, which cannot be split.
    Alone,
    /// By the near-singular method, from the distance to the singular pose.
    NearSingular,
}

/// Check of the drift from the constraints after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriftCheck<S> {
    /// No check after this step, or the method has projected the state itself.
    Skip,
    /// The state is projected if its drift is `above` so many times the tolerated one.
    Above {
        /// Tolerated drift, as a fraction of the typical coordinate and velocity.
        tolerance: S,
        /// 1, or 0 if every drift is projected.
        above: S,
    },
}

impl<S: Real> DriftCheck<S> {
    /// True if the state has to be projected.
    #[inline]
    pub(crate) fn fails<M: System<S = S>>(self, (system, u): (&M, &M::U), t: S, x: &M::X) -> bool {
        match self {
            Self::Skip => false,
            Self::Above { tolerance, above } => {
                excess(system.drift(t, u, x), drift_of_size(system, tolerance)) > above
            }
        }
    }
}
