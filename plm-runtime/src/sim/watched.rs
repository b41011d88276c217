//! Runs that show their samples, steps and events, and that the caller can end.

use super::samples::{Asked, Samples, Seen, Times, Watcher};
use super::{Clock, Sim};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Runs as [`run`](Self::run), with the same bits, and shows communication points, the end of every internal step, and events. Call it
    /// as `Sim::watch(&mut sim, …)`: an associated function hides no output of this name.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn watch(
        this: &mut Self,
        until: M::S,
        every: M::S,
        see: impl FnMut(Seen<'_, M::State>),
    ) -> Result<(), Fault> {
        Self::watch_while(this, until, every, see, |_| true)
    }

    /// Runs as [`watch`](Self::watch) while `goes_on` returns true. It is called with the time, s, after each internal step. After false
    /// the run stops at the end of that step or of the next one, and can be continued from there.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn watch_while(
        this: &mut Self,
        until: M::S,
        every: M::S,
        see: impl FnMut(Seen<'_, M::State>),
        goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        Self::watch_by::<true>(this, (until, every), see, goes_on)
    }

    /// Runs as [`watch_while`](Self::watch_while) without [`Seen::Step`], which costs about as much as a short step.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn watch_events_while(
        this: &mut Self,
        until: M::S,
        every: M::S,
        see: impl FnMut(Seen<'_, M::State>),
        goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        Self::watch_by::<false>(this, (until, every), see, goes_on)
    }

    /// Runs as [`watch_events_while`](Self::watch_events_while) with inputs that change during the run. `drive` is called at the start and
    /// at each time that it has returned. It may change inputs, and returns the time of the next change, s, infinite if there is none. A
    /// step ends at each of these times, and a sample there shows the state after the change.
    ///
    /// # Errors
    /// Those of [`run`](Self::run); [`Cause::Interval`](crate::Cause::Interval) if the next change is not later than the present time.
    pub fn watch_driven(
        this: &mut Self,
        until: M::S,
        every: M::S,
        mut drive: impl FnMut(&mut Self) -> M::S,
        mut see: impl FnMut(Seen<'_, M::State>),
        mut goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        let whole = this.times(until, every)?;
        let (mut next, mut is_over) = (M::S::ZERO, false);
        loop {
            let change = drive(this);
            this.take_changes()?;
            let now = this.state.time();
            if next <= whole.last_at(now) {
                see(Seen::Sample(&this.state));
                next = next + M::S::lit(1.0);
            }
            if is_over || now >= until {
                return Ok(());
            }
            let end = if change < until { change } else { until };
            if end <= now {
                return Err(this.bad_interval(end - now));
            }
            let times = Times { until: end, last: whole.last_before(end), ..whole };
            let mut goes_on = |time| {
                is_over |= !goes_on(time);
                !is_over
            };
            Self::watch_within::<false>(this, (times, next), &mut see, &mut goes_on)?;
            if this.state.time() < end {
                return Ok(());
            }
            next = next.max(times.last + M::S::lit(1.0));
        }
    }

    fn watch_by<const STEPS: bool>(
        this: &mut Self,
        (until, every): (M::S, M::S),
        mut see: impl FnMut(Seen<'_, M::State>),
        mut goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        let times = this.times(until, every)?;
        see(Seen::Sample(&this.state));
        Self::watch_within::<STEPS>(this, (times, M::S::lit(1.0)), &mut see, &mut goes_on)
    }

    /// Runs to `times.until`, and gives the communication points from the number `next` on.
    fn watch_within<const STEPS: bool>(
        this: &mut Self,
        (times, next): (Times<M::S>, M::S),
        see: &mut dyn FnMut(Seen<'_, M::State>),
        goes_on: &mut dyn FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        // Without dense output the run stops at its communication points, after the events there.
        let within = if this.method.is_dense() { times } else { Times { last: M::S::ZERO, ..times } };
        let samples = Samples { times: within, next, moment: this.state };
        let mut watcher: Watcher<M, STEPS> = Watcher { samples, see, asked: Asked(goes_on) };
        if !this.method.is_dense() {
            let mut k = next;
            while k <= times.last {
                this.advance(times.at(k), times.every, &mut watcher)?;
                if this.state.time() < times.at(k) {
                    return Ok(());
                }
                (watcher.see)(Seen::Sample(&this.state));
                k = k + M::S::lit(1.0);
            }
        }
        this.advance(times.until, times.until - times.start, &mut watcher)
    }

    /// Runs for `dt`, s, as [`step`](Self::step) and with its bits, while `goes_on` returns true, as in [`watch_while`](Self::watch_while).
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_while(this: &mut Self, dt: M::S, mut goes_on: impl FnMut(M::S) -> bool) -> Result<(), Fault> {
        let clock: Clock<M::S> = this.clock.after(this.state.time(), dt);
        this.advance(clock.time, dt, &mut Asked(&mut goes_on))?;
        // If the time was not reached, the clock drops its rest.
        this.clock = clock;
        Ok(())
    }
}
