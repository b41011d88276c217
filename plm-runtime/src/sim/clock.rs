//! Compensated sum of the lengths of many intervals.

use plm_math::exact::two_sum;

use crate::scalar::Real;

/// The time as the sum of all intervals so far, with the rounding error of the sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock<S> {
    /// The time to which `rest` belongs, s.
    pub(crate) time: S,
    /// Rounding error of the sum, s: the sum is `time + rest`.
    pub(crate) rest: S,
}

impl<S: Real> Clock<S> {
    /// The clock `dt` after the time `now`. A rest that belongs to another time than `now` is dropped.
    pub(crate) fn after(self, now: S, dt: S) -> Self {
        let rest = if self.time == now { self.rest } else { S::ZERO };
        let (length, low) = two_sum(dt, rest);
        let (time, high) = two_sum(now, length);
        Self { time, rest: high + low }
    }
}
