//! Single internal steps of a run.

use super::samples::{Asked, Samples, Seen, Times, Watcher};
use super::{Clock, Sim};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;

/// Point that a run has reached on its way to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// End of a step before that time.
    Step,
    /// The time itself.
    End,
}

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Makes one internal step towards the time `until`, s, or two at an event. Repeated calls make the steps of
    /// [`step_to`](Self::step_to), except that a method with steps of fixed length divides the remaining interval again at each
    /// call.
    ///
    /// # Errors
    /// As [`step_to`](Self::step_to).
    pub fn step_towards(this: &mut Self, until: M::S) -> Result<Reached, Fault> {
        let length = until - this.state.time();
        this.advance(until, length, &mut Asked(&mut |_| false))?;
        Ok(this.reached(until))
    }

    /// Makes a step as [`step_towards`](Self::step_towards), and shows its end and its events as [`watch`](Self::watch) does.
    ///
    /// # Errors
    /// As [`step_to`](Self::step_to).
    pub fn watch_towards(
        this: &mut Self,
        until: M::S,
        mut see: impl FnMut(Seen<'_, M::State>),
    ) -> Result<Reached, Fault> {
        let start = this.state.time();
        let times = Times { start, every: until - start, until, last: M::S::ZERO };
        let samples = Samples { times, next: M::S::lit(1.0), moment: this.state };
        let mut goes_on = |_| false;
        let mut watcher: Watcher<M, true> = Watcher { samples, see: &mut see, asked: Asked(&mut goes_on) };
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
