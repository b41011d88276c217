//! Sampling at equal intervals.

use crate::events::{self, Beginning};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, Method};
use crate::protocol::{Observer, Trigger};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Communication points of a run: its start, and multiples of a sampling interval after it.
#[derive(Clone, Copy)]
pub(super) struct Times<S> {
    pub(super) start: S,
    pub(super) every: S,
    pub(super) until: S,
    /// Number of the last point.
    pub(super) last: S,
}

impl<S: Real> Times<S> {
    pub(super) fn at(&self, k: S) -> S {
        (self.start + k * self.every).min(self.until)
    }

    /// Number of the last point at or before a time.
    pub(super) fn last_at(&self, time: S) -> S {
        let (number, near) = self.number(time);
        (number + near).floor()
    }

    /// Number of the last point before a time.
    pub(super) fn last_before(&self, time: S) -> S {
        let (number, near) = self.number(time);
        -(near - number).floor() - S::lit(1.0)
    }

    /// Number that a point at this time would have, and the largest error of that number by rounding.
    fn number(&self, time: S) -> (S, S) {
        let number = (time - self.start) / self.every;
        (number, S::lit(1e-9).max(S::lit(16.0) * S::EPSILON * number))
    }
}

/// Communication points that are still to come.
pub(super) struct Samples<M: Mechanism> {
    pub(super) times: Times<M::S>,
    /// Number of the next point.
    pub(super) next: M::S,
    pub(super) moment: M::State,
}

impl<M: Mechanism> Samples<M> {
    /// Gives the samples within the step that was just made.
    fn give<I: Method<M>>(
        &mut self,
        method: &mut I,
        context: &mut Context<'_, M>,
        mut sample: impl FnMut(&M::State),
    ) -> Result<(), Fault> {
        while self.next <= self.times.last && self.times.at(self.next) <= context.time {
            sample_at(method, context, self.times.at(self.next), &mut self.moment)?;
            sample(&self.moment);
            self.next = self.next + M::S::lit(1.0);
        }
        Ok(())
    }
}

/// Observer that gives samples at equal intervals.
pub(super) struct Sampler<'a, M: Mechanism> {
    pub(super) samples: Samples<M>,
    pub(super) sample: &'a mut dyn FnMut(&M::State),
}

impl<M: Mechanism> Observer<M> for Sampler<'_, M> {
    fn see<I: Method<M>>(&mut self, method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.samples.give(method, context, &mut *self.sample)
    }
}

/// Moment of a run that is shown to the callback of [`Sim::watch`](super::Sim::watch).
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Seen<'a, T> {
    /// The state at a communication point.
    Sample(&'a T),
    /// The state at the end of an internal step.
    Step(&'a T),
    /// The condition with this index switches ([`Labels::guard_name`](crate::Labels::guard_name)); the state just before.
    Condition(usize, &'a T),
    /// A time event: conditions on the time alone change ([`Events::instant_name`](crate::Events::instant_name));
    /// the state just before.
    Instant(&'a T),
    /// The state after all events at its time.
    Switched(&'a T),
}

/// Observer that ends the run when its predicate returns false for the time at the end of a step.
pub(super) struct Asked<'a, S>(pub(super) &'a mut dyn FnMut(S) -> bool);

impl<M: Mechanism> Observer<M> for Asked<'_, M::S> {
    const ENDS: bool = true;

    fn see<I: Method<M>>(&mut self, _method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if !(self.0)(context.time) {
            context.end = context.time;
        }
        Ok(())
    }
}

/// Observer that shows samples and events, and the ends of steps if `STEPS`; `asked` may end the run.
///
/// Its type names no closure: closures within functions that are generic over the method have another type for each of them, and all that
/// advances a run would be compiled for each.
pub(super) struct Watcher<'a, M: Mechanism, const STEPS: bool> {
    pub(super) samples: Samples<M>,
    pub(super) see: &'a mut dyn FnMut(Seen<'_, M::State>),
    pub(super) asked: Asked<'a, M::S>,
}

impl<M: Mechanism, const STEPS: bool> Observer<M> for Watcher<'_, M, STEPS> {
    const SWITCHES: bool = true;
    const ENDS: bool = true;

    fn see<I: Method<M>>(&mut self, method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let Self { samples, see, asked } = self;
        samples.give(method, context, |state| see(Seen::Sample(state)))?;
        if STEPS {
            sample_at(method, context, context.time, &mut samples.moment)?;
            see(Seen::Step(&samples.moment));
        }
        asked.see(method, context)
    }

    fn switched(&mut self, context: &Context<'_, M>, before: &Beginning<M>, what: Trigger) {
        let Self { samples: Samples { moment, .. }, see, .. } = self;
        let (mut held, mut x) = (before.held, before.x);
        events::refresh(context.system, context.time, &mut held, &x);
        moment.set(context.time, &held, &x);
        match what {
            Trigger::Condition(index) => see(Seen::Condition(index, moment)),
            Trigger::Time => see(Seen::Instant(moment)),
            Trigger::Due => {
                // These events have been committed before, so they do not fail here.
                let _ = events::switch_each(
                    (context.system, M::G::fill(M::S::ZERO), M::S::ZERO),
                    None,
                    (context.time, &mut held, &mut x),
                    |index| {
                        see(Seen::Condition(index, moment));
                    },
                );
            }
        }
        moment.set(context.time, &context.held, &context.x);
        see(Seen::Switched(moment));
    }
}

/// Sets `moment` to a time within the last step, and projects it onto the constraints if it has drifted from them.
pub(super) fn sample_at<M: Mechanism, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    time: M::S,
    moment: &mut M::State,
) -> Result<(), Fault> {
    let (mut held, mut x) = (context.held, context.x);
    if time < context.time {
        method.derive(context)?;
        method.densify(context)?;
        (held, x) = method.moment(context, time);
    }
    let (drift, limit) = (context.system.drift(time, &held, &x), method.drift_limit(context.system));
    if drift.phi > limit.phi || drift.phi_dot > limit.phi_dot {
        context.system.project(time, &held, &mut x)?;
    }
    events::refresh(context.system, time, &mut held, &x);
    moment.set(time, &held, &x);
    Ok(())
}
