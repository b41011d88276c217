//! Partition of an interval into fixed steps, and the arrival of implicit methods at their end.

use super::adaptive::too_small;
use super::{Context, drift_of_size, excess, not_finite};
use crate::fault::Fault;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// An interval divided into equal steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Partition<S> {
    start: S,
    end: S,
    /// Length of a step, s.
    pub(crate) h: S,
    /// The time after the next step.
    pub(crate) next_time: S,
    /// Number of steps. Whole numbers are counted in the scalar, so that a target without f64 needs no conversion.
    steps: S,
    /// Steps up to `next_time`.
    done: S,
}

impl<S: Real> Partition<S> {
    /// A partition without steps.
    pub(super) fn none() -> Self {
        Self { start: S::ZERO, end: S::ZERO, h: S::ZERO, next_time: S::ZERO, steps: S::ZERO, done: S::ZERO }
    }

    /// Divides the rest of an interval into whole steps of at most `longest`.
    pub(super) fn of_interval<M: System<S = S>>(
        context: &mut Context<'_, M>,
        longest: S,
    ) -> Result<Self, Fault> {
        let Some(partition) = Self::new(context.time, context.end, longest) else {
            return Err(context.fault(too_small(context, longest)));
        };
        *context.longest_step = context.longest_step.max(partition.h);
        Ok(partition)
    }

    /// Moves the context to `next`, the state after the step; projects it if it drifted by more than `tolerance` of the
    /// typical sizes, or if the step went by rank. Returns true if it did.
    pub(super) fn arrive<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        mut next: M::X,
        tolerance: S,
        by_rank: bool,
    ) -> Result<bool, Fault> {
        if !next.is_finite() {
            return Err(not_finite(context.system, self.next_time, &next));
        }
        let drift = context.system.drift(self.next_time, &context.held, &next);
        let limit = if by_rank { S::ZERO } else { S::lit(1.0) };
        let drifted = excess(drift, drift_of_size(context.system, tolerance)) > limit;
        if drifted {
            context.project(self.next_time, &mut next)?;
        }
        context.stats.steps += 1;
        (context.time, context.x) = (self.next_time, next);
        self.next();
        Ok(drifted)
    }

    /// Length of the step that makes an interval alone; `None` if that takes several, or is impossible.
    #[inline]
    pub(super) fn one_step(start: S, end: S, longest: S) -> Option<S> {
        let (length, rounding) = Self::length(start, end);
        let fits = Self::least(length, rounding) <= longest && longest > S::ZERO && end > start;
        fits.then(|| if (length - longest).abs() <= rounding { longest } else { length })
    }

    /// Length of an interval, and its error by rounding of the times.
    #[inline]
    fn length(start: S, end: S) -> (S, S) {
        (end - start, S::lit(2.0) * S::EPSILON * start.abs().max(end.abs()))
    }

    /// Part of an interval that has to be divided: less the larger of its rounding and a millionth.
    #[inline]
    fn least(length: S, rounding: S) -> S {
        (length - rounding.max(S::lit(1e-6) * length)).max(S::ZERO)
    }

    /// Divides an interval into whole steps of at most `longest` (plus a millionth, and the error of the interval's length
    /// by rounding of the times, so that neither costs another step). An interval of whole steps gets steps of exactly
    /// that length. `None` if such steps do not move the time or cannot be counted.
    fn new(start: S, end: S, longest: S) -> Option<Self> {
        let (one, (length, rounding)) = (S::lit(1.0), Self::length(start, end));
        let ratio = Self::least(length, rounding) / longest;
        // False for a step that is negative or NaN.
        let counts = longest > S::ZERO && ratio < one / S::EPSILON;
        if !counts {
            return None;
        }
        let whole = ratio.floor();
        let steps = if ratio > whole { whole + one } else { whole.max(one) };
        let even = (length - steps * longest).abs() <= rounding;
        let h = if even { longest } else { length / steps };
        let mut partition = Self { start, end, h, next_time: start, steps, done: S::ZERO };
        partition.next();
        (partition.next_time > start).then_some(partition)
    }

    /// Sets the time after the next step.
    #[inline]
    pub(crate) fn next(&mut self) {
        self.done = self.done + S::lit(1.0);
        let inside = self.start + self.done * self.h;
        self.next_time = if self.done < self.steps { inside } else { self.end };
    }
}
