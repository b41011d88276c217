//! What a method does, and what the protocol asks it: the step, states within it, and who chooses its length.

use super::{Context, Estimate, Path, drift_of_size, excess};
use crate::contact::Change;
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::stats::Stats;
use crate::system::{Drift, System};
use crate::vector::Vector;

/// A method that carries a state over an interval, step by step: what every method has to do.
///
/// The protocol does the rest: it judges each step, projects its end, ends it at events, splits or repeats it next to singular poses,
/// and commits it. A method with error control implements [`ErrorControl`], one whose step the user chooses [`FixedLength`]; the
/// other is left empty.
pub trait Method<M: System>: Copy + DenseOutput<M> + ErrorControl<M> + FixedLength<M> {
    /// By which results tell what made them.
    const NAME: &'static str = "";
    /// The choice of step lengths: by an estimate of the error, or by the user.
    const LENGTH: Length = if Self::DENSE { Length::Error } else { Length::Fixed { caution: 1.0 } };

    /// When the modes of contact rows change: at events that are located, or in its steps.
    const CHANGE: Change = Change::AtEvents;

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

    /// Angles were brought back by whole turns: the state has other numbers and the same rates.
    fn turned(&mut self) {
        self.restart();
    }

    /// The same method with its options, as it was before its first step.
    #[must_use]
    fn fresh(&self) -> Self;

    /// The drift above which a state is projected.
    fn drift_limit(&self, system: &M) -> Drift<M::S>;
}

/// States within the last step.
pub trait DenseOutput<M: System> {
    /// Whether there are any; without, all of it stays as it is here.
    const DENSE: bool = false;

    /// Computes what [`interpolate`](Self::interpolate) needs and the step itself did not; it may be called again.
    ///
    /// # Errors
    /// When an evaluation fails.
    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// Gives what [`densify`](Self::densify) and [`interpolate`](Self::interpolate) read the derivatives, where a step that was made at
    /// once keeps values alone.
    ///
    /// # Errors
    /// When an evaluation fails.
    fn derive(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let _ = context;
        Ok(())
    }

    /// The state at a time within the last step, after [`densify`](Self::densify); a rougher one (order 3) without.
    fn interpolate(&self, time: M::S) -> M::X {
        let _ = time;
        M::X::fill(M::S::ZERO)
    }

    /// The states that [`interpolate`](Self::interpolate) gives, as polynomials; none where nothing is known of a step, and where the
    /// state stands in the discrete state.
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
    /// The relative tolerance; none where the user chooses the steps.
    fn tolerance(&self) -> Option<M::S> {
        None
    }

    /// How many steps an interval may take, those near singular poses and those that were rejected among them.
    fn most_steps(&self) -> u64 {
        u64::MAX
    }

    /// The system has refused the state that the last step, of `h`, led to, and the state is that before it again:
    /// whether a shorter step is tried next.
    fn shorten(&mut self, h: M::S) -> bool {
        let _ = h;
        false
    }

    /// The state with the largest part of the error estimate in the last step, by its index; none where something else
    /// decided how long the step was: the end of the interval, a longest step, the drift.
    fn limited_by(&self, system: &M) -> Option<usize> {
        let _ = system;
        None
    }
}

/// Steps whose length the user chooses.
pub trait FixedLength<M: System>: Sized {
    /// Whether an interval may be made by [`fast_step`](Self::fast_step).
    const FAST: bool = false;

    /// Takes the state `x` over an interval between two times by the formula alone, as [`Method::advance`] would before it
    /// checks the step. None where that takes more than one step, or where the step is not healthy; `x` is of no use then. The
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

    /// The error of the last step: zero where that is too little to be estimated, and of steps that an estimate has chosen.
    fn estimate(&self) -> Estimate<M::S> {
        Estimate::NONE
    }

    /// The error of a step between two times and states.
    fn estimate_of(
        &self,
        (system, held): (&M, &M::U),
        times: (M::S, M::S),
        ends: [&M::X; 2],
    ) -> Estimate<M::S> {
        let _ = (system, held, times, ends);
        Estimate::NONE
    }

    /// Whether the error of such a step is to be estimated, as its ends tell.
    #[inline]
    fn is_long(&self, (system, stats): (&M, &Stats), h: M::S, ends: [&M::X; 2]) -> bool {
        let _ = (system, stats, h, ends);
        false
    }

    /// Whether the state that the next step leads to is projected. Methods that project by themselves have no check.
    #[inline]
    fn drift_check(&self, system: &M) -> DriftCheck<M::S> {
        let _ = system;
        DriftCheck::Skip
    }

    /// A step is committed; its end was projected if it had `drifted`.
    #[inline]
    fn keep(&mut self, drifted: bool) {
        let _ = drifted;
    }

    /// The same method with steps of at most `longest`, s, as before its first step; none where an estimate of the error chooses them.
    fn shorter(&self, longest: M::S) -> Option<Self> {
        let _ = longest;
        None
    }
}

/// A step that makes an interval alone, by [`FixedLength::fast_step`].
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

/// What has chosen the length of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// An estimate of its error.
    Error,
    /// The user; next to a flat pose such a step must be shorter by `caution` than one of order 4 for an error as small.
    Fixed {
        /// A factor of at least 1.
        caution: f64,
    },
    /// The user, of a step by itself, which cannot be split.
    Alone,
    /// The near-singular method, by the distance to the singular pose.
    NearSingular,
}

/// Whether the drift from the constraints is looked at after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriftCheck<S> {
    /// Not after this one, or the method has projected the state itself.
    Skip,
    /// The state is projected if its drift is `above` so many times what is tolerated.
    Above {
        /// What is tolerated, as a fraction of the typical coordinate and velocity.
        tolerance: S,
        /// 1, or 0 where every drift is projected.
        above: S,
    },
}

impl<S: Real> DriftCheck<S> {
    /// Has the state to be projected?
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
