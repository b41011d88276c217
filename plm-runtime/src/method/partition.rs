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
    /// The length of a step, s.
    pub(crate) h: S,
    /// The time after the next step.
    pub(crate) next_time: S,
    /// Whole numbers, counted in the scalar: a target that has no f64 converts none.
    steps: S,
    /// Steps up to that time.
    done: S,
}

impl<S: Real> Partition<S> {
    /// Nothing planned.
    pub(super) fn none() -> Self {
        Self { start: S::ZERO, end: S::ZERO, h: S::ZERO, next_time: S::ZERO, steps: S::ZERO, done: S::ZERO }
    }

    /// Divides what is left of an interval into whole steps of at most `longest`.
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

    /// Takes the context to `next`, the state after the step; projects it if it drifted by more than `tolerance` of the
    /// typical sizes, or if the step went by rank. Returns whether it did.
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

    /// The length of the step that makes an interval alone; none where that takes several, or cannot be.
    #[inline]
    pub(super) fn one_step(start: S, end: S, longest: S) -> Option<S> {
        let (length, rounding) = Self::length(start, end);
        let fits = Self::least(length, rounding) <= longest && longest > S::ZERO && end > start;
        fits.then(|| if (length - longest).abs() <= rounding { longest } else { length })
    }

    /// The length of an interval, and what rounding of the times makes of it.
    #[inline]
    fn length(start: S, end: S) -> (S, S) {
        (end - start, S::lit(2.0) * S::EPSILON * start.abs().max(end.abs()))
    }

    /// What of an interval has to be divided: not what may be rounding, nor a millionth.
    #[inline]
    fn least(length: S, rounding: S) -> S {
        (length - rounding.max(S::lit(1e-6) * length)).max(S::ZERO)
    }

    /// Divides an interval into whole steps of at most `longest` (and a millionth, and what rounding of the times makes of
    /// the interval's length, so that neither costs another step). An interval of whole steps gets steps of exactly that
    /// length. None if such steps do not move the time or cannot be counted.
    fn new(start: S, end: S, longest: S) -> Option<Self> {
        let (one, (length, rounding)) = (S::lit(1.0), Self::length(start, end));
        let ratio = Self::least(length, rounding) / longest;
        // False for a step that is negative or not a number.
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

    /// The time after the next step.
    #[inline]
    pub(crate) fn next(&mut self) {
        self.done = self.done + S::lit(1.0);
        let inside = self.start + self.done * self.h;
        self.next_time = if self.done < self.steps { inside } else { self.end };
    }
}
