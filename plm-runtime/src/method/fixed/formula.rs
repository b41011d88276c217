//! Formulas of fixed-step methods: one step, in any numbers.

use super::at_once;
use crate::method::estimate::Estimate;
use crate::method::length::{are_near, spread};
use crate::method::{Evaluated, Rates, Watched};
use crate::scalar::{Real, Scalar};
use crate::system::{Health, OneStep, Rate, System};

/// The formula of a fixed-step method.
pub trait Formula: Copy {
    /// [`Method::name`](crate::Method::name) of the method.
    const NAME: &'static str = "";
    /// Number of rates per step.
    const STAGES: u64;
    /// Rates at the stages of a step.
    type Stages<X: Copy>: Copy;

    /// Advances the state `x` from `t` to `t + h`; `rates` computes the rates. Returns the result of `look` for the new state and the
    /// rates.
    fn step<M: Rate, T>(
        times: (M::S, M::S),
        x: &mut M::X,
        rates: impl Rates<M>,
        look: impl FnOnce(&M::X, &Self::Stages<M::X>) -> T,
    ) -> T;

    /// Distance of positions from those by the trapezoidal rule, relative to their sizes, below which they need no estimate.
    const STRAIGHT: f64;

    /// True if [`apart`](Self::apart) covers positions; velocities and first-order states are always covered.
    const OF_PLACES: bool;

    /// By state, the difference of the rates of a step of `h`, and its bound for a step that needs no [`estimate`](Self::estimate): a
    /// share of its `size`.
    fn apart<M: Rate>(
        h: M::S,
        stages: &Self::Stages<M::X>,
        size: impl Fn(usize) -> M::S,
    ) -> impl Fn(usize) -> [M::S; 2];

    /// Differences of the rates at the stages from which an [`estimate`](Self::estimate) is made, by state.
    fn difference<M: Rate<S: Real>>(stages: &Self::Stages<M::X>) -> M::X;

    /// Error of a step, estimated from a [`difference`](Self::difference) of its rates.
    fn estimate<M: Rate<S: Real>>(made: &Made<'_, M>, difference: &M::X) -> Estimate<M::S>;

    /// Makes one step for any scalar, without a second attempt; gives the worst health of its stages.
    #[inline]
    fn plain_step<M: Rate>(system: &M, t: M::S, u: &M::U, x: &mut M::X, h: M::S) -> Health<M::S> {
        looked_at::<Self, M, _>((system, u), (t, h), x, |_, _| ()).0
    }
}

/// Makes one step, without a second attempt; gives the worst health of its stages, and the result of `look` for its end and the rates
/// of its stages.
#[allow(clippy::inline_always, reason = "as the formula, which it is")]
#[inline(always)]
pub(crate) fn looked_at<F: Formula, M: Rate, T>(
    (system, u): (&M, &M::U),
    times: (M::S, M::S),
    x: &mut M::X,
    look: impl FnOnce(&M::X, &F::Stages<M::X>) -> T,
) -> (Health<M::S>, T) {
    let mut rates = Watched::new(system, u);
    let seen = F::step::<M, T>(times, x, &mut rates, look);
    (rates.worst, seen)
}

/// Makes a step as [`looked_at`] does, with the rate of a system evaluated as by methods.
#[allow(clippy::inline_always, reason = "as the formula, which it is")]
#[inline(always)]
pub(super) fn evaluated<F: Formula, M: System, T>(
    (system, u): (&M, &M::U),
    times: (M::S, M::S),
    x: &mut M::X,
    look: impl FnOnce(&M::X, &F::Stages<M::X>) -> T,
) -> (Health<M::S>, T) {
    let mut rates = Evaluated::new(system, u);
    let seen = F::step::<M, T>(times, x, &mut rates, look);
    (rates.worst, seen)
}

/// Makes one step, as a whole if the system computes it so; gives the worst health of its stages, and true if its rates differ
/// little.
#[allow(clippy::inline_always, reason = "as the formula, which it is")]
#[inline(always)]
pub(super) fn formula<F: Formula, M: System<S: Real>>(
    (system, u): (&M, &M::U),
    (t, h): (M::S, M::S),
    (from, x): (&M::X, &mut M::X),
) -> (Health<M::S>, bool) {
    if M::WHOLE
        && let Some(whole) = system.whole_step::<F>((t, h), u, from, x)
    {
        return (whole.health, whole.spread <= M::S::ZERO);
    }
    if M::S::AT_ONCE.has_steps() {
        return at_once::step::<F, M>((system, u), (t, h), x);
    }
    evaluated::<F, M, _>((system, u), (t, h), x, |x, stages| are_near::<F, M>(system, h, x, stages))
}

impl<F: Formula> OneStep for F {
    const NAME: &'static str = F::NAME;
    const STAGES: u64 = F::STAGES;

    fn one_step<M: Rate>(
        system: &M,
        (t, h): (M::S, M::S),
        x: &mut M::X,
        rates: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> M::S {
        F::step::<M, _>((t, h), x, rates, |x, stages| spread::<F, M>(system, h, x, stages))
    }
}

/// A step that was made.
pub struct Made<'a, M: Rate> {
    /// The equations.
    pub system: &'a M,
    /// Discrete state during the step.
    pub held: &'a M::U,
    /// Its length, s.
    pub h: M::S,
    /// Time, s, and state before it.
    pub from: (M::S, &'a M::X),
    /// State after it.
    pub to: &'a M::X,
}
