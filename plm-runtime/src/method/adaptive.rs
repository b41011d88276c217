//! Common parts of methods with error control: the stored rate, the length of the next step.

use super::{Context, not_finite};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{System, value};
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Builders and tolerance of a method with the fields `rtol`, `longest_step` and `most_steps`.
macro_rules! builders {
    ([$($generics:tt)*] $method:ty) => {
        impl<$($generics)*> $method {
            /// This method with steps of at most `longest_step`, in s.
            #[must_use]
            pub fn with_longest_step(self, longest_step: M::S) -> Self {
                Self { longest_step, ..self }
            }

            /// This method with at most so many steps, accepted and rejected, in one interval.
            #[must_use]
            pub fn with_most_steps(self, most_steps: u64) -> Self {
                Self { most_steps, ..self }
            }

            /// Tolerance in use: at least some units in the last place.
            fn tolerance(&self) -> M::S {
                self.rtol.max(M::S::lit(8.0) * M::S::EPSILON)
            }
        }
    };
}
pub(super) use builders;

/// Rate at the current state, stored from the last step or evaluated.
pub(super) fn rate_here<M: System<S: Real>>(
    kept: &mut Option<M::X>,
    context: &mut Context<'_, M>,
) -> Result<M::X, Fault> {
    if let Some(rate) = *kept {
        return Ok(rate);
    }
    let x = context.x;
    let mut rate = x;
    context.rate(context.time, &x, &mut rate)?;
    if !(x.is_finite() && rate.is_finite()) {
        return Err(not_finite(context.system, context.time, &rate));
    }
    *kept = Some(rate);
    Ok(rate)
}

/// Length of the next step, and true if it is the last: the proposal, stretched by at most 1 % to reach the end, so that no
/// tiny step follows. The interval may take `most` steps.
pub(super) fn next_step<M: System<S: Real>>(
    most: u64,
    context: &Context<'_, M>,
    proposal: M::S,
) -> Result<(M::S, bool), Fault> {
    // Without states to integrate, steps only follow prescribed motions: their number is not limited.
    if context.system.states() > 0 {
        context.check_steps(most)?;
    }
    let rest = context.end - context.time;
    // A proposal that is no number is none.
    if !goes_on(proposal, rest) && proposal >= M::S::ZERO {
        Ok((rest, true))
    } else if proposal > shortest(context) {
        // Lengths are values: the derivatives of one that moved with an event would propagate to all later steps, enlarged.
        Ok((value(proposal), false))
    } else {
        Err(context.fault(too_small(context, proposal)))
    }
}

/// A mask that is set where a step of the proposed length, stretched by 1 %, does not reach the end, which is `rest` away.
#[inline]
pub(crate) fn goes_on<S: Scalar>(proposal: S, rest: S) -> S::Mask {
    (S::lit(1.01) * proposal).lt(rest)
}

/// Shortest length of a step, s, above which the resolution of the time is the cause of a fault, and not the motion.
const COARSE: f64 = 1e-4;

/// Cause of a fault if a step would have to be shorter than the shortest one.
pub(super) fn too_small<M: System<S: Real>>(context: &Context<'_, M>, step: M::S) -> Cause {
    let (step, shortest) = (step.to_f64(), shortest(context).to_f64());
    if shortest > COARSE {
        Cause::TimeTooCoarse { step, spacing: shortest / 16.0 }
    } else {
        Cause::StepTooSmall { step }
    }
}

/// Shortest step: some units in the last place of the time, so that the time hardly moves.
pub(super) fn shortest<M: System<S: Real>>(context: &Context<'_, M>) -> M::S {
    shortest_between::<M::S>(M::S::EPSILON, [context.time, context.end])
}

/// [`shortest`] on the way from a time to the end of its interval, in numbers with a unit `epsilon` in the last place of 1.
#[inline]
pub(crate) fn shortest_between<S: Scalar>(epsilon: S, [time, end]: [S; 2]) -> S {
    S::lit(16.0) * epsilon * time.abs().max(end.abs())
}

/// Checks that a step still moves the time; otherwise gives the fault that made it so short, or that of the state it led to.
pub(super) fn ensure_moves<M: System<S: Real>>(
    context: &Context<'_, M>,
    h: M::S,
    attempt: Result<M::X, Fault>,
) -> Result<(), Fault> {
    if h > shortest(context) {
        return Ok(());
    }
    let cause = too_small(context, h);
    if matches!(cause, Cause::TimeTooCoarse { .. }) {
        return Err(context.fault(cause));
    }
    let x = attempt?;
    if x.is_finite() { Err(context.fault(cause)) } else { Err(not_finite(context.system, context.time, &x)) }
}

/// Least part of the error expected from the last step for which an estimate is taken.
const CHANCE: f64 = 0.1;

/// Error estimates that do not vanish by chance. With few state variables all components of an estimate can pass zero at
/// once, and a step that is far too long seems accurate. A small estimate is accepted only if the one before was small too.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steady<S: Scalar> {
    /// Length and error of the last accepted step.
    pub(super) last: (S, S),
    /// True if its estimate was not accepted.
    pub(super) doubted: S::Mask,
}

impl<S: Real> InWords for Steady<S> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.last.0, &mut self.last.1]);
        words.flag(&mut self.doubted);
    }
}

impl<S: Scalar> Steady<S> {
    pub(super) fn new() -> Self {
        Self { last: (S::lit(1.0), S::ZERO), doubted: S::ZERO.lt(S::ZERO) }
    }

    /// True if no step has given an error yet.
    pub(super) fn is_new(&self) -> bool {
        self.last.1 == S::ZERO
    }

    /// The first of two where the mask is set, the second elsewhere.
    pub(super) fn select(mask: S::Mask, a: &Self, b: &Self) -> Self {
        let last = (S::select(mask, a.last.0, b.last.0), S::select(mask, a.last.1, b.last.1));
        Self { last, doubted: S::choose(mask, a.doubted, b.doubted) }
    }

    /// Error of a step of the length `h`, which grows with `h` to the `order`.
    pub(super) fn error(&self, h: S, estimate: S, order: u32) -> S {
        let ratio = h / self.last.0;
        let last = S::lit(CHANCE) * self.last.1;
        let expected = (0..order).fold(last, |power, _| power * ratio);
        // NaN stays NaN.
        S::select(self.doubted, estimate, S::select(estimate.lt(expected), expected, estimate))
    }

    /// Stores an accepted step.
    pub(super) fn accept(&mut self, h: S, estimate: S, order: u32) {
        let error = self.error(h, estimate, order);
        *self = Self { last: (h, error), doubted: estimate.lt(error) };
    }
}
