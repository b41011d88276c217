//! The time over many intervals.

use plm_math::exact::two_sum;

use crate::scalar::Real;

/// The time as the intervals so far have it: what rounding has left out of it is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock<S> {
    /// The time that it belongs to, s.
    pub(crate) time: S,
    /// What is to be added to it, s.
    pub(crate) rest: S,
}

impl<S: Real> Clock<S> {
    /// The clock after `dt`, from the time `now`; what is known of another time is forgotten.
    pub(crate) fn after(self, now: S, dt: S) -> Self {
        let rest = if self.time == now { self.rest } else { S::ZERO };
        let (length, low) = two_sum(dt, rest);
        let (time, high) = two_sum(now, length);
        Self { time, rest: high + low }
    }
}
