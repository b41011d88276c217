//! To a time, the state at another one, and back to the beginning.

use super::samples::sample_at;
use super::{Clock, Sim};
use crate::events::Beginning;
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, Method};
use crate::protocol::Unobserved;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Runs until the time `until`, in s, and ends exactly there. At the present time it does nothing.
    ///
    /// # Errors
    /// As those of [`step`](Self::step); [`Cause::Interval`](crate::Cause::Interval) where that time has passed.
    pub fn step_to(&mut self, until: M::S) -> Result<(), Fault> {
        self.advance(until, until - self.state.time(), &mut Unobserved)?;
        self.clock = Clock { time: until, rest: M::S::lit(0.0) };
        Ok(())
    }

    /// The state at a time, in s, without moving the simulation: ahead by a copy that goes there, within the last step by
    /// the dense output of the method, as the samples of [`run`](Self::run).
    ///
    /// # Errors
    /// [`Cause::Interval`](crate::Cause::Interval) before the last step, or before now where nothing is known of it: after
    /// a change from outside, and with methods without dense output. Ahead, as those of [`step_to`](Self::step_to).
    pub fn at(&self, time: M::S) -> Result<M::State, Fault> {
        let mut other = *self;
        let now = self.state.time();
        if time < now {
            let beginning = self.history.beginning.filter(|beginning| I::DENSE && beginning.time <= time);
            return other.go_back(beginning.ok_or_else(|| self.bad_interval(time - now))?, time);
        }
        other.step_to(time)?;
        Ok(other.state)
    }

    /// The state within the last step.
    fn go_back(&mut self, beginning: Beginning<M>, time: M::S) -> Result<M::State, Fault> {
        if self.method.path().is_none_or(|path| path.start != beginning.time) {
            // The step ended where something switched, and its dense output is gone: it is made again.
            self.state.set(beginning.time, &beginning.held, &beginning.x);
            self.forget();
            self.step_to(time)?;
            return Ok(self.state);
        }
        let Self { state, method, stats, longest_step, .. } = self;
        let (end, mut moment) = (state.time(), *state);
        let told = (stats, longest_step);
        let mut context = Context::new((state.mechanism(), beginning.held), (end, *state.x()), end, told);
        sample_at(method, &mut context, time, &mut moment)?;
        Ok(moment)
    }

    /// Begins again at the time at which it began, from the start values of the mechanism with its parameters as they are
    /// and the inputs as declared. Method and statistics begin anew, options stay: the run has the bits of a fresh one.
    ///
    /// # Errors
    /// As [`Mechanism::start_state`]; the simulation is then as it was.
    pub fn reset(&mut self) -> Result<(), Fault> {
        let (mechanism, time) = (*self.state.mechanism(), self.start_time);
        let (held, x) = mechanism.start_state(time)?;
        let (limits, counts) = (self.limits, self.history.counts.is_some());
        let state = M::State::new(mechanism, held, time, x);
        *self = Self { limits, ..Self::new(state, self.method.fresh()) };
        self.count_states(counts);
        Ok(())
    }
}
