//! An interval that is one step of fixed length: what real time asks for, again and again.
//!
//! The step is made on numbers that nobody else sees, and kept where no more is to be done than the looks that every step has.
//! Otherwise [`steps`](super::steps) makes it, from its beginning: by rank, with known times within it, where guards may come
//! to zero, near singular poses. Both give the same bits and the same statistics.

use super::Sim;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;
use crate::singular::Rescue;
use crate::system::{Accepted, Leg};

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Makes the step to `end`; false, and nothing has changed, where more is to be done.
    #[inline]
    pub(super) fn single(&mut self, end: M::S) -> bool {
        let Self { state, method, watch, kept, limits, stats, .. } = self;
        let (system, time) = (state.mechanism(), state.time());
        let mut held = state.held();
        let instant = system.next_instant(time, &held);
        if instant.is_some_and(|instant| instant <= end)
            || limits.audit()
            || !(watch.is_known() && system.is_regular(&held))
        {
            return false;
        }
        let mut x = *state.x();
        let Some(made) = method.single((system, &held), (time, end), &mut x) else {
            return false;
        };
        let mut error = M::S::ZERO;
        if !made.are_near || method.is_long((system, stats), made.h, [state.x(), &x]) {
            let estimate = method.estimate_of((system, &held), (time, made.h), [state.x(), &x]);
            if estimate.is_senseless() {
                return false;
            }
            error = estimate.error;
        }
        let drifted = method.drifts(system, end, &x);
        if drifted && system.settle(end, &mut x).is_err() {
            return false;
        }
        let leg = Leg { system, held: &held, from: (time, state.x()), to: (end, &x), health: made.health };
        if M::Rescue::parts(&leg, I::CAUTION) > 1
            || M::Rescue::is_due(&leg, false)
            || !watch.is_calm(kept, &leg)
        {
            return false;
        }
        let accepted = system.accept(end, &mut held, &mut x);
        let Ok(Accepted { moved, turned, passed }) = accepted else { return false };
        if passed.is_some() && limits.change_points {
            return false;
        }
        stats.errs(error);
        stats.steps += 1;
        stats.evaluations += made.evaluations;
        stats.settled += u64::from(drifted);
        stats.charts += u64::from(moved);
        stats.change_points += u64::from(passed.is_some());
        if made.h > self.longest_step {
            self.longest_step = made.h;
        }
        method.keep(drifted);
        state.set(end, &held, &x);
        if moved || turned {
            method.restart();
        }
        true
    }
}
