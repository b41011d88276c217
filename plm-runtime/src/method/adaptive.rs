//! What methods with error control share: the rate that is kept, the length of the next step.

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
        }
    };
}
pub(super) use builders;

/// Rate at the current state, kept from the last step or evaluated.
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

/// Length of the next step, and whether it is the last: the proposal, stretched by 1 % at most to hit the end rather than be
/// followed by a tiny one. It is counted down from the steps that are left of `most`.
pub(super) fn next_step<M: System<S: Real>>(
    most: u64,
    context: &Context<'_, M>,
    proposal: M::S,
) -> Result<(M::S, bool), Fault> {
    // Where nothing is integrated, steps are looks at what moves as it is told to: as many as it takes.
    if context.system.states() > 0 {
        context.check_steps(most)?;
    }
    let rest = context.end - context.time;
    if M::S::lit(1.01) * proposal >= rest {
        Ok((rest, true))
    } else if proposal > shortest(context) {
        // Lengths are values: one that moved with an event would pass this on to all after it, enlarged.
        Ok((value(proposal), false))
    } else {
        Err(context.fault(too_small(context, proposal)))
    }
}

/// Where a step of the shortest length is longer than this, s, the digits of the time are to blame and not the motion.
const COARSE: f64 = 1e-4;

/// Why no step is made that is as short as is asked for.
pub(super) fn too_small<M: System<S: Real>>(context: &Context<'_, M>, step: M::S) -> Cause {
    let (step, shortest) = (step.to_f64(), shortest(context).to_f64());
    if shortest > COARSE {
        Cause::TimeTooCoarse { step, spacing: shortest / 16.0 }
    } else {
        Cause::StepTooSmall { step }
    }
}

/// A step of so many units in the last place of the time hardly moves it.
pub(super) fn shortest<M: System<S: Real>>(context: &Context<'_, M>) -> M::S {
    M::S::lit(16.0) * M::S::EPSILON * context.time.abs().max(context.end.abs())
}

/// A step that still moves the time; otherwise the fault that made it so short, or that of the state it led to.
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

/// An estimate is taken for no less than this part of what the last step's says of a step of that length.
const CHANCE: f64 = 0.1;

/// Error estimates that do not vanish by chance. Where a state has few numbers all of an estimate can go through zero at
/// once, and a step that is far too long seems right. A small estimate is believed if the one before was small too.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steady<S> {
    /// Length and error of the last accepted step.
    last: (S, S),
    /// Its estimate was not believed.
    doubted: bool,
}

impl<S: Real> InWords for Steady<S> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.last.0, &mut self.last.1]);
        words.flag(&mut self.doubted);
    }
}

impl<S: Real> Steady<S> {
    pub(super) fn new() -> Self {
        Self { last: (S::lit(1.0), S::ZERO), doubted: false }
    }

    /// No step has told yet what another one may be off.
    pub(super) fn is_new(&self) -> bool {
        self.last.1 == S::ZERO
    }

    /// The error of a step of the length `h`, which grows with `h` to the `order`.
    pub(super) fn error(&self, h: S, estimate: S, order: u32) -> S {
        let ratio = h.plain() / self.last.0.plain();
        let last = S::Plain::lit(CHANCE) * self.last.1.plain();
        let expected = S::of_plain((0..order).fold(last, |power, _| power * ratio));
        // What is not a number stays it.
        if estimate < expected && !self.doubted { expected } else { estimate }
    }

    /// Remembers an accepted step.
    pub(super) fn accept(&mut self, h: S, estimate: S, order: u32) {
        let error = self.error(h, estimate, order);
        *self = Self { last: (h, error), doubted: estimate < error };
    }
}
