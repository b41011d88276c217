//! Who sees the steps of a run, and the samples that it gives.

use super::Begun;
use crate::events;
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Who sees the steps of a run.
pub(crate) trait Observer<M: Mechanism> {
    /// Does it see anything at all?
    const SEES: bool = true;
    /// Does it see what switches? Who does not pays nothing for it.
    const SWITCHES: bool = false;
    /// May it end the run, by putting `course.end` at the time of a step that it sees?
    const ENDS: bool = false;

    /// A step was accepted; what was held over it is held still.
    fn see<I: Method<M>>(&mut self, method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault>;

    /// Something has switched; `before` is the discrete state and the state until then.
    #[inline]
    fn switched(&mut self, course: &Course<'_, M>, before: &Begun<M>, what: Trigger) {
        let _ = (course, before, what);
    }
}

/// What has switched.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Trigger {
    /// This condition.
    Condition(usize),
    /// All conditions that were past their guards.
    Due,
    /// Conditions on the time alone.
    Time,
}

/// Nobody.
pub(crate) struct Unobserved;

impl<M: Mechanism> Observer<M> for Unobserved {
    const SEES: bool = false;

    #[inline]
    fn see<I: Method<M>>(&mut self, _method: &mut I, _course: &mut Course<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
}

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
        course: &mut Course<'_, M>,
        mut sample: impl FnMut(&M::State),
    ) -> Result<(), Fault> {
        while self.next <= self.times.last && self.times.at(self.next) <= course.time {
            sample_at(method, course, self.times.at(self.next), &mut self.moment)?;
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
    fn see<I: Method<M>>(&mut self, method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault> {
        self.samples.give(method, course, &mut self.sample)
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
    /// The condition with this index switches ([`System::guard_name`](crate::System::guard_name)); the state before that.
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

    fn see<I: Method<M>>(&mut self, _method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault> {
        if !(self.0)(course.time) {
            course.end = course.time;
        }
        Ok(())
    }
}

/// Shows samples, steps and switches, and is asked as well.
pub(super) struct Watcher<M: Mechanism, F, G> {
    pub(super) samples: Samples<M>,
    pub(super) see: F,
    pub(super) asked: Asked<G>,
}

impl<M, F, G> Observer<M> for Watcher<M, F, G>
where
    M: Mechanism,
    F: FnMut(Seen<'_, M::State>),
    G: FnMut(M::S) -> bool,
{
    const SWITCHES: bool = true;
    const ENDS: bool = true;

    fn see<I: Method<M>>(&mut self, method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault> {
        let Self { samples, see, asked } = self;
        samples.give(method, course, |state| see(Seen::Sample(state)))?;
        sample_at(method, course, course.time, &mut samples.moment)?;
        see(Seen::Step(&samples.moment));
        asked.see(method, course)
    }

    fn switched(&mut self, course: &Course<'_, M>, before: &Begun<M>, what: Trigger) {
        let Self { samples: Samples { moment, .. }, see, .. } = self;
        let (mut held, mut x) = (before.held, before.x);
        events::refresh(course.system, course.time, &mut held, &x);
        moment.set(course.time, &held, &x);
        match what {
            Trigger::Condition(index) => see(Seen::Condition(index, moment)),
            Trigger::Time => see(Seen::Instant(moment)),
            Trigger::Due => {
                // The events were committed: they do not fail here.
                let _ = events::switch_each(
                    (course.system, M::G::fill(M::S::ZERO)),
                    course.time,
                    &mut held,
                    &mut x,
                    |index| {
                        see(Seen::Condition(index, moment));
                    },
                );
            }
        }
        moment.set(course.time, &course.held, &course.x);
        see(Seen::Switched(moment));
    }
}

/// Puts `moment` at a time within the last step, onto the constraints.
pub(super) fn sample_at<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    time: M::S,
    moment: &mut M::State,
) -> Result<(), Fault> {
    let (mut held, mut x) = (course.held, course.x);
    if time < course.time {
        method.densify(course)?;
        (held, x) = method.moment(course, time);
    }
    let (drift, limit) = (course.system.drift(time, &x), method.drift_limit(course.system));
    if drift.phi > limit.phi || drift.phi_dot > limit.phi_dot {
        course.system.settle(time, &mut x)?;
    }
    events::refresh(course.system, time, &mut held, &x);
    moment.set(time, &held, &x);
    Ok(())
}
