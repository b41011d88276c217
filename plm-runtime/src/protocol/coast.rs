//! Fixed steps after which nothing is to be done: they are committed without a copy of the discrete state.
//!
//! The general path works on copies, so that a step can be refused. Systems whose discrete state is large say beforehand that it stays
//! ([`Constraints::is_settled`](crate::Constraints::is_settled)); such a step is judged where it stands, and all others go the general way.

use super::Observer;
use super::advance::{Advance, Made};
use crate::events::{Beginning, Detector, Event};
use crate::mechanism::Mechanism;
use crate::method::Method;
use crate::protocol::near_singular::{Nearness, Rescue};
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, '_, M, I, O> {
    /// Are steps of the method made by [`coast`](Self::coast)?
    pub(super) const COASTS: bool = I::FAST && !I::DENSE && M::SETTLES;

    /// Proposes a step of fixed length, and commits it where it stands if the judge would accept it as it is.
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
        // The discrete state where a step began is asked for with dense output alone.
        let from = Beginning { time, held: self.context.held, x };
        match made {
            Ok(()) => self.conclude(&from, Event::None),
            Err(fault) => self.fail(&from, fault),
        }
    }

    /// Would the judge accept the step from a time and state to the state reached, with nothing to change after it and no event?
    #[inline]
    fn has_nothing_to_do(&self, from: (M::S, &M::X)) -> bool {
        let context = &*self.context;
        let step = context.step(from);
        let all = (context.system, &context.held);
        let (detector, history) = (&*self.guarded.detector, &*self.guarded.history);
        self.guarded.limits.energy_jump.is_none()
            && history.counts.is_none()
            && !self.method.drift_check(context.system).fails(all, context.time, &context.x)
            && M::Rescue::nearness(&step, I::LENGTH) == Nearness::Regular
            && context.system.is_settled(context.time, &context.held, &context.x)
            && !self.method.estimate().is_senseless()
            && (Detector::has_none::<M, I>(context.system, &context.held)
                || detector.excludes_events(history, &step))
    }
}
