//! Integration context: the data that methods read and write during an interval.

use super::not_finite;
use super::rates::{evaluate, value};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::stats::Stats;
use crate::system::{Health, Step, System};
use crate::vector::Vector;

/// Integration context: the state during an interval, with its equations and counters.
pub struct Context<'a, M: System> {
    /// The equations.
    pub system: &'a M,
    /// Discrete state, constant during the step: inputs, chart, branches.
    pub held: M::U,
    /// Time reached, s.
    pub time: M::S,
    /// State reached.
    pub x: M::X,
    /// End of the interval, s.
    pub end: M::S,
    /// Counters so far.
    pub stats: &'a mut Stats,
    /// Longest step so far, s.
    pub longest_step: &'a mut M::S,
    /// Smallest pivot ratio of the rates since the last step was accepted, [`Health`].
    pub health: M::S,
    /// Time, s, until which steps are at least made by the near-singular method, without the mechanism's own
    /// coordinates.
    pub(crate) rescued: Option<M::S>,
    /// Steps tried before the interval.
    before: u64,
}

impl<'a, M: System> Context<'a, M> {
    /// Context of a state at a time, for an interval to `end`.
    pub fn new(
        (system, held): (&'a M, M::U),
        (time, x): (M::S, M::X),
        end: M::S,
        (stats, longest_step): (&'a mut Stats, &'a mut M::S),
    ) -> Self {
        let before = stats.steps + stats.rejected;
        Self {
            system,
            held,
            time,
            x,
            end,
            stats,
            longest_step,
            health: M::S::lit(1.0),
            rescued: None,
            before,
        }
    }

    /// This context of an interval before which so many steps were tried.
    pub(crate) fn after(self, before: u64) -> Self {
        Self { before, ..self }
    }

    /// Accepts a step of `h` to a time and state.
    #[inline]
    pub(super) fn reach(&mut self, time: M::S, h: M::S, x: M::X)
    where
        M::S: Real,
    {
        self.stats.steps += 1;
        *self.longest_step = self.longest_step.max(h);
        (self.time, self.x) = (time, x);
    }

    /// Checks that the interval has taken fewer steps than it may.
    pub(crate) fn check_steps(&self, most: u64) -> Result<(), Fault> {
        let tried = self.stats.steps + self.stats.rejected - self.before;
        if tried < most { Ok(()) } else { Err(self.fault(Cause::TooManySteps { steps: most })) }
    }

    /// The step to the state reached.
    pub(crate) fn step<'s>(&'s self, from: (M::S, &'s M::X)) -> Step<'s, M> {
        let to = (self.time, &self.x);
        Step { system: self.system, held: &self.held, from, to, health: self.health }
    }

    /// A fault at the time reached.
    pub(crate) fn fault(&self, cause: Cause) -> Fault {
        Fault::new(self.time.to_f64(), cause)
    }

    /// Rate at `(t, x)`, by rank if it is unhealthy.
    pub(crate) fn rate(&mut self, t: M::S, x: &M::X, dx: &mut M::X) -> Result<(), Fault> {
        let health = rate((self.system, &self.held), t, x, dx);
        self.watch(health, t, x, dx)
    }

    /// Rate at `(t, x)` as values, if steps are made at once.
    pub(super) fn rate_value(&mut self, t: M::S, x: &M::X, dx: &mut M::X) -> Result<(), Fault> {
        if !M::S::AT_ONCE.has_steps() {
            return self.rate(t, x, dx);
        }
        let health = value((self.system, &self.held), t, x, dx);
        self.watch(health, t, x, dx)
    }

    /// Counts a rate of this health, and replaces an unhealthy one by the rate by rank.
    #[inline]
    fn watch(&mut self, health: Health<M::S>, t: M::S, x: &M::X, dx: &mut M::X) -> Result<(), Fault> {
        self.stats.evaluations += 1;
        self.health = self.health.min(health.0);
        if health.is_good() {
            return Ok(());
        }
        // NaN makes every matrix look singular; it is reported as NaN.
        if !x.is_finite() {
            return Err(not_finite(self.system, t, x));
        }
        let outcome = self.system.rate_by_rank(t, &self.held, x, dx);
        self.stats.by_rank += u64::from(outcome.is_ok());
        outcome
    }

    /// Projects a state onto the constraints.
    pub(crate) fn project(&mut self, t: M::S, x: &mut M::X) -> Result<(), Fault> {
        self.stats.projected += 1;
        self.system.project(t, &self.held, x)
    }
}

/// Rate for many callers none of which waits for it: one copy of its code for all of them.
#[inline(never)]
pub(super) fn rate<M: System>((system, held): (&M, &M::U), t: M::S, x: &M::X, dx: &mut M::X) -> Health<M::S> {
    evaluate((system, held), t, x, dx)
}
