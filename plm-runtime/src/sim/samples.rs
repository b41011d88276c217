//! Who sees the steps of a run, and the samples that it gives.

use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, Method};
use crate::scalar::Scalar;

/// Who sees the steps of a run.
pub(super) trait Observer<M: Mechanism> {
    /// A step was accepted; what was held over it is held still.
    fn see<I: Method<M>>(&mut self, method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault>;
}

/// Nobody.
pub(super) struct Unobserved;

impl<M: Mechanism> Observer<M> for Unobserved {
    #[inline]
    fn see<I: Method<M>>(&mut self, _method: &mut I, _course: &mut Course<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
}

/// Gives samples at even times.
pub(super) struct Sampler<M: Mechanism, T, F> {
    /// Number of the next sample, and of the last one.
    pub(super) next: M::S,
    pub(super) last: M::S,
    pub(super) time_of: T,
    pub(super) moment: M::State,
    pub(super) sample: F,
}

impl<M: Mechanism, T: Fn(M::S) -> M::S, F: FnMut(&M::State)> Observer<M> for Sampler<M, T, F> {
    fn see<I: Method<M>>(&mut self, method: &mut I, course: &mut Course<'_, M>) -> Result<(), Fault> {
        while self.next <= self.last && (self.time_of)(self.next) <= course.time {
            sample_at(method, course, (self.time_of)(self.next), &mut self.moment)?;
            (self.sample)(&self.moment);
            self.next = self.next + M::S::lit(1.0);
        }
        Ok(())
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
    moment.set(time, &held, &x);
    Ok(())
}
