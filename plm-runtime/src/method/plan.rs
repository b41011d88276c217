//! The steps of fixed-step methods: an interval divided, and the arrival of implicit methods at their end.

use super::{Course, drift_of_size, excess, not_finite};
use crate::fault::{Cause, Fault};
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// An interval divided into equal steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan<S> {
    start: S,
    end: S,
    /// The length of a step, s.
    pub(crate) h: S,
    /// The time after the next step.
    pub(crate) next_time: S,
    steps: u32,
    /// Steps up to that time.
    done: u32,
}

impl<S: Real> Plan<S> {
    /// Nothing planned.
    pub(super) fn none() -> Self {
        Self { start: S::ZERO, end: S::ZERO, h: S::ZERO, next_time: S::ZERO, steps: 0, done: 0 }
    }

    /// Divides what is left of an interval into whole steps of at most `longest`.
    pub(super) fn of_course<M: System<S = S>>(course: &mut Course<'_, M>, longest: S) -> Result<Self, Fault> {
        let Some(plan) = Self::new(course.time, course.end, longest) else {
            return Err(course.fault(Cause::StepTooSmall { step: longest.to_f64() }));
        };
        course.stats.longest_step = course.stats.longest_step.max(plan.h.to_f64());
        Ok(plan)
    }

    /// Takes the course to `next`, the state after the step; settles it if it drifted by more than `tolerance` of the
    /// typical sizes, or if the step went by rank. Returns whether it did.
    pub(super) fn arrive<M: System<S = S>>(
        &mut self,
        course: &mut Course<'_, M>,
        mut next: M::X,
        tolerance: S,
        by_rank: bool,
    ) -> Result<bool, Fault> {
        if !next.is_finite() {
            return Err(not_finite(course.system, self.next_time, &next));
        }
        let drift = course.system.drift(self.next_time, &next);
        let limit = if by_rank { S::ZERO } else { S::lit(1.0) };
        let drifted = excess(drift, drift_of_size(course.system, tolerance)) > limit;
        if drifted {
            course.settle(self.next_time, &mut next)?;
        }
        course.stats.steps += 1;
        (course.time, course.x) = (self.next_time, next);
        self.next();
        Ok(drifted)
    }

    /// Divides an interval into whole steps of at most `longest` (and a millionth, so that rounding in the length of the
    /// interval does not cost another step). None if such steps do not move the time or cannot be counted.
    fn new(start: S, end: S, longest: S) -> Option<Self> {
        let ratio = ((end - start) / longest).to_f64() * (1.0 - 1e-6);
        // False for a step that is negative or not a number.
        if !(0.0..f64::from(u32::MAX)).contains(&ratio) {
            return None;
        }
        let whole = ratio as u32;
        let steps = if ratio > f64::from(whole) { whole + 1 } else { whole.max(1) };
        let h = (end - start) / S::lit(f64::from(steps));
        let mut plan = Self { start, end, h, next_time: start, steps, done: 0 };
        plan.next();
        (plan.next_time > start).then_some(plan)
    }

    /// The time after the next step.
    #[inline]
    pub(crate) fn next(&mut self) {
        self.done = self.done.wrapping_add(1);
        let inside = self.start + S::lit(f64::from(self.done)) * self.h;
        self.next_time = if self.done < self.steps { inside } else { self.end };
    }
}
