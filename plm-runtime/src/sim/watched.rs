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

    fn watch_by<const STEPS: bool>(
        this: &mut Self,
        (until, every): (M::S, M::S),
        mut see: impl FnMut(Seen<'_, M::State>),
        goes_on: impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        let times = this.times(until, every)?;
        see(Seen::Sample(&this.state));
        let one = M::S::lit(1.0);
        // Without dense output a run is at its communication points, behind what switches there.
        let within = if I::DENSE { times } else { Times { last: M::S::ZERO, ..times } };
        let samples = Samples { times: within, next: one, moment: this.state };
        let mut watcher: Watcher<M, _, _, STEPS> = Watcher { samples, see, asked: Asked(goes_on) };
        if !I::DENSE {
            let mut k = one;
            while k <= times.last {
                this.advance(times.at(k), every, &mut watcher)?;
                if this.state.time() < times.at(k) {
                    return Ok(());
                }
                (watcher.see)(Seen::Sample(&this.state));
                k = k + one;
            }
        }
        this.advance(until, until - times.start, &mut watcher)
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
