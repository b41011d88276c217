//! Single internal steps of a run.

use super::samples::{Asked, Samples, Seen, Times, Watcher};
use super::{Clock, Sim};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;

/// The point that a run has come to on its way to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// The end of a step before that time.
    Step,
    /// That time.
    End,
}

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Makes one internal step, or two at a time at which something switches, on the way to the time `until`, s. Until that is reached, calls
    /// make the steps of [`step_to`](Self::step_to); a method with steps of one length divides what is left anew with each.
    ///
    /// # Errors
    /// As [`step_to`](Self::step_to).
    pub fn step_towards(this: &mut Self, until: M::S) -> Result<Reached, Fault> {
        let length = until - this.state.time();
        this.advance(until, length, &mut Asked(|_| false))?;
        Ok(this.reached(until))
    }

    /// The same, and shows the end of each step and what switches, as [`watch`](Self::watch).
    ///
    /// # Errors
    /// As [`step_to`](Self::step_to).
    pub fn watch_towards(
        this: &mut Self,
        until: M::S,
        see: impl FnMut(Seen<'_, M::State>),
    ) -> Result<Reached, Fault> {
        let start = this.state.time();
        let times = Times { start, every: until - start, until, last: M::S::ZERO };
        let samples = Samples { times, next: M::S::lit(1.0), moment: this.state };
        let mut watcher: Watcher<M, _, _, true> = Watcher { samples, see, asked: Asked(|_| false) };
        this.advance(until, until - start, &mut watcher)?;
        Ok(this.reached(until))
    }

    fn reached(&mut self, until: M::S) -> Reached {
        if self.state.time() < until {
            return Reached::Step;
        }
        self.clock = Clock { time: until, rest: M::S::ZERO };
        Reached::End
    }
}
