//! Runs to a time, the state at another time, and reset.

use super::samples::sample_at;
use super::{Clock, Sim};
use crate::events::Beginning;
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, Method};
use crate::protocol::Unobserved;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Runs until the time `until`, s, and ends exactly there. Does nothing if that is the present time.
    ///
    /// # Errors
    /// Those of [`step`](Self::step); [`Cause::Interval`](crate::Cause::Interval) if that time is in the past.
    pub fn step_to(&mut self, until: M::S) -> Result<(), Fault> {
        self.advance(until, until - self.state.time(), &mut Unobserved)?;
        self.clock = Clock { time: until, rest: M::S::lit(0.0) };
        Ok(())
    }

    /// The state at a time, s, without moving the simulation. A later time is reached by a copy; a time within the last
    /// step is evaluated by the dense output of the method, as the samples of [`run`](Self::run) are.
    ///
    /// # Errors
    /// [`Cause::Interval`](crate::Cause::Interval) for a time before the last step, or before now if the last step is
    /// unknown: after a change by the caller, and with methods without dense output. For a later time, those of
    /// [`step_to`](Self::step_to).
    pub fn at(&self, time: M::S) -> Result<M::State, Fault> {
        let mut other = self.clone();
        let now = self.state.time();
        if time < now {
            let beginning =
                self.history.beginning.filter(|beginning| self.method.is_dense() && beginning.time <= time);
            return other.go_back(beginning.ok_or_else(|| self.bad_interval(time - now))?, time);
        }
        other.step_to(time)?;
        Ok(other.state)
    }

    /// The state within the last step, which began at `beginning`.
    fn go_back(&mut self, beginning: Beginning<M>, time: M::S) -> Result<M::State, Fault> {
        if self.method.path().is_none_or(|path| path.start != beginning.time) {
            // An event ended the step, so that its dense output is gone: the step is repeated.
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

    /// Restarts at the time at which the simulation began, with the start values of the mechanism, its present parameters
    /// and the inputs as declared. Method and statistics are reset, options are unchanged: the run has the bits of a fresh
    /// one.
    ///
    /// # Errors
    /// Those of [`Mechanism::start_state`]; the simulation is unchanged then.
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
