//! Sampling at equal intervals.

use crate::events::{self, Beginning};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, Method};
use crate::protocol::{Observer, Trigger};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// The communication points of a run: its begin, and after every so many seconds.
#[derive(Clone, Copy)]
pub(super) struct Times<S> {
    pub(super) start: S,
    pub(super) every: S,
    pub(super) until: S,
    /// Number of the last one.
    pub(super) last: S,
}

impl<S: Real> Times<S> {
    pub(super) fn at(&self, k: S) -> S {
        (self.start + k * self.every).min(self.until)
    }

    /// Number of the last one at a time or before it.
    pub(super) fn last_at(&self, time: S) -> S {
        let (number, near) = self.number(time);
        (number + near).floor()
    }

    /// Number of the last one before a time.
    pub(super) fn last_before(&self, time: S) -> S {
        let (number, near) = self.number(time);
        -(near - number).floor() - S::lit(1.0)
    }

    /// The number that a point at a time would have, and how far from it rounding may put one.
    fn number(&self, time: S) -> (S, S) {
        let number = (time - self.start) / self.every;
        (number, S::lit(1e-9).max(S::lit(16.0) * S::EPSILON * number))
    }
}

/// The communication points that are to come.
pub(super) struct Samples<M: Mechanism> {
    pub(super) times: Times<M::S>,
    /// Number of the next one.
    pub(super) next: M::S,
    pub(super) moment: M::State,
}

impl<M: Mechanism> Samples<M> {
    /// After a step: gives those within it.
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

/// Gives samples at even times.
pub(super) struct Sampler<M: Mechanism, F> {
    pub(super) samples: Samples<M>,
    pub(super) sample: F,
}

impl<M: Mechanism, F: FnMut(&M::State)> Observer<M> for Sampler<M, F> {
    fn see<I: Method<M>>(&mut self, method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.samples.give(method, context, &mut self.sample)
    }
}

/// What a run shows on its way, to [`Sim::watch`](super::Sim::watch).
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Seen<'a, T> {
    /// The state at a communication point.
    Sample(&'a T),
    /// The state at the end of an internal step.
    Step(&'a T),
    /// The condition with this index switches ([`Labels::guard_name`](crate::Labels::guard_name)); the state before that.
    Condition(usize, &'a T),
    /// The time comes to where conditions on it alone change
    /// ([`Described::instant_name`](crate::Described::instant_name)); the state before that.
    Instant(&'a T),
    /// The state after all that has switched at its time.
    Switched(&'a T),
}

/// Asked with the time after each step whether to go on.
pub(super) struct Asked<F>(pub(super) F);

impl<M: Mechanism, F: FnMut(M::S) -> bool> Observer<M> for Asked<F> {
    const ENDS: bool = true;

    fn see<I: Method<M>>(&mut self, _method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if !(self.0)(context.time) {
            context.end = context.time;
        }
        Ok(())
    }
}

/// Shows samples and switches, and is asked as well; shows the ends of steps if `STEPS`.
pub(super) struct Watcher<M: Mechanism, F, G, const STEPS: bool> {
    pub(super) samples: Samples<M>,
    pub(super) see: F,
    pub(super) asked: Asked<G>,
}

impl<M, F, G, const STEPS: bool> Observer<M> for Watcher<M, F, G, STEPS>
where
    M: Mechanism,
    F: FnMut(Seen<'_, M::State>),
    G: FnMut(M::S) -> bool,
{
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
                // The events were committed: they do not fail here.
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

/// Puts `moment` at a time within the last step, onto the constraints.
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
