//! Steps of formulas by the rate of a system, with the comparison of their rates.

use super::{Formula, at_once};
use crate::method::Evaluated;
use crate::method::length::{are_near, spread};
use crate::scalar::{Real, Scalar};
use crate::system::{Health, OneStep, Rate, System};

/// Makes a step as [`looked_at`](super::looked_at) does, with the rate of a system evaluated as by methods.
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
