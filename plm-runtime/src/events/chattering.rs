//! Chattering: conditions that switch repeatedly within a short window.

use super::boundary::rates;
use super::marks::{MOST_GUARDS, Marks};
use super::rounding::rounding;
use super::{guards, is_of_state};
use crate::fault::{Cause, Fault, Names};
use crate::method::Context;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Most switches of conditions within a short time; more end the run.
const MOST_SWITCHES: u32 = 100;
/// That short time, as a fraction of the longest step so far, ...
const SHORT: f64 = 1e-6;
/// ... and at least so many units in the last place of the time.
const SHORT_ULPS: f64 = 1000.0;
/// Switches of conditions whose guards stay within so many times their rounding in between also count, however long they take, ...
const UNSEEN: f64 = 1e3;
/// ... up to this fraction of the longest step, or of the time to the end of the interval if that is longer.
const UNSEEN_FOR: f64 = 0.01;

/// Number of such switches after which flights accumulate, if conditions have thrown the state back: only rounding lets the next one pass,
/// and the run ends there.
const FLIGHTS: u32 = 8;

/// Window of the present chattering.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chattering<S> {
    /// Beginning of the window, s, and its number of switches.
    pub(super) since: S,
    pub(super) count: u32,
    /// Conditions that take part.
    pub(super) conditions: Marks,
    /// True if the last of them threw its state back.
    pub(super) has_thrown: bool,
}

impl<S: Real> Chattering<S> {
    pub(super) fn new() -> Self {
        Self { since: S::ZERO, count: 0, conditions: Marks::NONE, has_thrown: false }
    }

    /// Counts switches of `conditions`, some of which may have `thrown` the state back. Too many in too short a time are a
    /// fault of all that took part.
    pub(super) fn count<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        conditions: Marks,
        (switched, thrown): (u32, u32),
    ) -> Result<(), Fault> {
        let switched = switched + thrown;
        context.stats.switches += u64::from(switched);
        let time = context.time;
        let short = (S::lit(SHORT) * *context.longest_step).max(S::lit(SHORT_ULPS) * S::EPSILON * time.abs());
        let is_over = time - self.since > short && !self.is_unseen(context, conditions);
        // A switch above rounding between others below it, as of the speed of a ball at the top of such a flight, does not belong to them.
        if is_over && time > self.since && self.is_unseen(context, self.conditions) {
            return Ok(());
        }
        if is_over || time < self.since {
            *self = Self { since: time, count: 0, conditions: Marks::NONE, has_thrown: false };
        }
        let passes = self.has_thrown && switched > 0 && thrown == 0 && self.count >= FLIGHTS;
        let is_end = passes && self.is_unseen(context, conditions);
        self.count = self.count.saturating_add(switched);
        self.conditions = self.conditions | conditions;
        self.has_thrown = thrown > 0;
        if self.count <= MOST_SWITCHES && !is_end {
            return Ok(());
        }
        let marks: [bool; MOST_GUARDS] = core::array::from_fn(|index| self.conditions.has(index));
        let conditions = Names::marked(context.system.conditions(), &marks);
        let within = (time - self.since).to_f64();
        let cause = Cause::Zeno { events: self.count, within, conditions };
        let first = (0..M::G::LEN).find(|index| self.conditions.has(*index)).unwrap_or(0);
        Err(Fault::of_part(time.to_f64(), context.system.guard_name(first), cause))
    }
    /// True if the guard of one of some conditions has moved no farther than rounding, since the window began, on the way to each switch. A
    /// ball at the end of its bounces flies no higher than that, although the window may not be short.
    fn is_unseen<M: System<S = S>>(&self, context: &mut Context<'_, M>, conditions: Marks) -> bool {
        let (time, x, elapsed) = (context.time, context.x, context.time - self.since);
        let longest = context.longest_step.max(context.end - self.since);
        let system = context.system;
        let among = |i: &usize| conditions.has(*i) && is_of_state(system, *i);
        if elapsed > S::lit(UNSEEN_FOR) * longest || self.count == 0 || !(0..M::G::LEN).any(|i| among(&i)) {
            return false;
        }
        let Some(slopes) = rates(context) else { return false };
        let here = guards(context.system, time, &context.held, &x);
        let noise = rounding((context.system, &context.held), (time, time), &x, &here);
        let most = S::lit(UNSEEN * f64::from(self.count));
        (0..M::G::LEN).filter(among).any(|i| elapsed * slopes.at(i).abs() <= most * noise.at(i))
    }
}
