//! Steps that a system computes as a whole.

use super::{FixedStep, Formula, estimate};
use crate::method::Context;
use crate::method::estimate::Estimate;
use crate::method::length::{are_straight, is_due};
use crate::scalar::Real;
use crate::system::System;

impl<S: Real, F: Formula> FixedStep<S, F> {
    /// Makes a step that the system computes as a whole, in the place of the state, which costs one copy of it. Returns false, with nothing
    /// changed, if there is no such step or if it is not healthy.
    #[inline]
    pub(super) fn advance_whole<M: System<S = S>>(&mut self, context: &mut Context<'_, M>) -> bool {
        let (t, h, from) = (context.time, self.partition.h, context.x);
        if self.was_unhealthy {
            return false;
        }
        let Context { system, held, x, .. } = context;
        let Some(whole) = system.whole_step::<F>((t, h), held, &from, x) else { return false };
        if !(whole.health.is_good() && system.is_finite(x)) {
            *x = from;
            return false;
        }
        let is_bent = || is_due(*system, context.stats) && !are_straight::<F, M>(*system, h, [&from, x]);
        let is_short = whole.spread <= S::ZERO && !is_bent();
        self.estimate =
            if is_short { Estimate::NONE } else { estimate::<F, M>((*system, held), (t, h), [&from, x]) };
        context.stats.evaluations += F::STAGES;
        context.stats.steps += 1;
        context.health = context.health.min(whole.health.0);
        context.time = self.partition.next_time;
        self.partition.next();
        true
    }
}
