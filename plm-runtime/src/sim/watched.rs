//! A run that shows what happens on its way, and can be ended on its way.

use super::samples::{Asked, Samples, Seen, Times, Watcher};
use super::{Clock, Sim};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Runs as [`run`](Self::run), and shows more: communication points, the end of every internal step, and what switches.
    /// It has the same bits. To be called as `Sim::watch(&mut sim, …)`, so that it hides no output of this name.
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

    /// The same as long as `goes_on` says so, which is asked with the time, s, after each internal step. Where it does not, the
    /// run is at the end of that step or of the next one, and can go on from there.
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

    /// The same without the end of every internal step ([`Seen::Step`]): of a short step that costs as much as the step.
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

    /// Runs as [`watch_events_while`](Self::watch_events_while) with inputs that change on the way: `drive` may change them at the start and
    /// at each time that it has given before, and gives the time of the next change, s, infinite where none comes. A step ends there. A
    /// sample at such a time is that after the change.
    ///
    /// # Errors
    /// As [`run`](Self::run); [`Cause::Interval`](crate::Cause::Interval) where the next change does not lie ahead.
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
            let goes_on = |time| {
                is_over |= !goes_on(time);
                !is_over
            };
            Self::watch_within::<false>(this, (times, next), &mut see, goes_on)?;
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
        goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        let times = this.times(until, every)?;
        see(Seen::Sample(&this.state));
        Self::watch_within::<STEPS>(this, (times, M::S::lit(1.0)), see, goes_on)
    }

    /// Runs to the end of times with the communication points from this number on.
    fn watch_within<const STEPS: bool>(
        this: &mut Self,
        (times, next): (Times<M::S>, M::S),
        see: impl FnMut(Seen<'_, M::State>),
        goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        // Without dense output a run is at its communication points, after what switches there.
        let within = if I::DENSE { times } else { Times { last: M::S::ZERO, ..times } };
        let samples = Samples { times: within, next, moment: this.state };
        let mut watcher: Watcher<M, _, _, STEPS> = Watcher { samples, see, asked: Asked(goes_on) };
        if !I::DENSE {
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

    /// Runs for `dt`, s, as [`step`](Self::step) and with its bits, as long as `goes_on` says so, as in
    /// [`watch_while`](Self::watch_while).
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_while(this: &mut Self, dt: M::S, goes_on: impl FnMut(M::S) -> bool) -> Result<(), Fault> {
        let clock: Clock<M::S> = this.clock.after(this.state.time(), dt);
        this.advance(clock.time, dt, &mut Asked(goes_on))?;
        // Of a time that was not reached nothing is known.
        this.clock = clock;
        Ok(())
    }
}
