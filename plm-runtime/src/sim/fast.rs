//! Fast path for an interval of exactly one fixed step, the case of real-time loops.
//!
//! It works on a copy of the state, and commits what the judge accepts at once or after a projection, where no event is possible.
//! Otherwise the general path ([`Advance`](crate::protocol::Advance)) makes the step from its beginning, with the same bits.

use super::Sim;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{DriftCheck, Estimate, Method};
use crate::protocol::{Limits, Proposal, Rules, Verdict, judge};
use crate::scalar::Scalar;
use crate::system::Updated;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Makes the step to `end`. Returns false, with nothing changed, if the general path has to make it.
    #[inline]
    pub(super) fn fast_step(&mut self, end: M::S) -> bool {
        let Self { state, method, detector, history, limits, stats, .. } = self;
        let (system, start, mut held) = (state.mechanism(), state.time(), state.held());
        let instant = system.next_time_event(start, &held);
        if instant.is_some_and(|instant| instant <= end)
            || limits.energy_jump.is_some()
            || !(detector.is_known() && system.is_regular(&held))
        {
            return false;
        }
        let (mut x, from) = (*state.x(), (start, state.x()));
        let Some(made) = method.fast_step((system, &held), (start, end), &mut x) else {
            return false;
        };
        let mut error = M::S::ZERO;
        if !made.are_near || method.is_long((system, stats), made.h, [from.1, &x]) {
            let estimate = method.estimate_of((system, &held), (start, made.h), [from.1, &x]);
            if estimate.is_senseless() {
                return false;
            }
            error = estimate.error;
        }
        let limits = Limits { energy_jump: None, ..*limits };
        let mut rules = Rules { length: method.length(), drift: method.drift_check(system), limits };
        let drifted = rules.drift.fails((system, &held), end, &x);
        if drifted && system.project(end, &held, &mut x).is_err() {
            return false;
        }
        rules.drift = DriftCheck::Skip;
        let mut proposal = Proposal { system, from, end, held: &mut held, x: &mut x, health: made.health };
        if !detector.excludes_events(history, &proposal.step()) {
            return false;
        }
        let Verdict::Accept(accepted) = judge(&mut proposal, Estimate::NONE, &rules) else { return false };
        stats.errs(error);
        stats.steps += 1;
        stats.evaluations += made.evaluations;
        stats.projected += u64::from(drifted);
        if made.h > self.longest_step {
            self.longest_step = made.h;
        }
        method.keep(drifted);
        state.set(end, &held, &x);
        let Updated { moved, turned, passed } = accepted;
        if moved || turned || passed.is_some() {
            stats.charts += u64::from(moved);
            stats.change_points += u64::from(passed.is_some());
            method.restart();
        }
        true
    }
}
