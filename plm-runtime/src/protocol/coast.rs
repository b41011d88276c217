//! Fixed steps that need no further action: they are committed without a copy of the discrete state.
//!
//! The general path works on copies, so that a step can be refused. A system with a large discrete state can tell that a step leaves it
//! unchanged ([`Constraints::is_settled`](crate::Constraints::is_settled)). Such a step is judged in place; all others take the general
//! path.

use super::Observer;
use super::advance::{Advance, Made};
use crate::events::{Beginning, Detector, Event};
use crate::mechanism::Mechanism;
use crate::method::Method;
use crate::protocol::near_singular::{Nearness, Rescue};
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, '_, M, I, O> {
    /// True if the steps of the method are made by [`coast`](Self::coast).
    #[inline]
    pub(super) fn coasts(&self) -> bool {
        M::SETTLES && self.method.is_fast() && !self.method.is_dense()
    }

    /// Proposes a step of fixed length, and commits it in place if the judge would accept it without any change.
    #[inline]
    pub(super) fn coast(&mut self) -> Made<M::S> {
        let Self { method, context, .. } = self;
        let (time, x) = (context.time, context.x);
        context.health = M::S::lit(1.0);
        let made = method.advance(context);
        if made.is_ok() && self.has_nothing_to_do((time, &x)) {
            return self.observer.see(self.method, self.context).map_or_else(Made::Failed, |()| {
                self.context.stats.errs(self.method.estimate().error);
                self.method.keep(false);
                Made::Step
            });
        }
        // Only dense output needs the discrete state at the start of a step.
        let from = Beginning { time, held: self.context.held, x };
        match made {
            Ok(()) => self.conclude(&from, Event::None),
            Err(fault) => self.fail(&from, fault),
        }
    }

    /// True if the judge would accept the step from a time and state to the state reached, with nothing to change after it and no event.
    #[inline]
    fn has_nothing_to_do(&self, from: (M::S, &M::X)) -> bool {
        let context = &*self.context;
        let step = context.step(from);
        let all = (context.system, &context.held);
        let (detector, history) = (&*self.guarded.detector, &*self.guarded.history);
        self.guarded.limits.energy_jump.is_none()
            && history.counts.is_none()
            && !self.method.drift_check(context.system).fails(all, context.time, &context.x)
            && M::Rescue::nearness(&step, self.method.length()) == Nearness::Regular
            && context.system.is_settled(context.time, &context.held, &context.x)
            && !self.method.estimate().is_senseless()
            && (Detector::has_none(context.system, &context.held, self.method.change())
                || detector.excludes_events(history, &step))
    }
}
