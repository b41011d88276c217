//! History of the last step, and counts of the states that limited steps.

use crate::method::Method;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// The beginning of a step.
#[derive(Clone, Copy)]
pub(crate) struct Beginning<M: System> {
    /// s.
    pub(crate) time: M::S,
    pub(crate) held: M::U,
    pub(crate) x: M::X,
}

/// History of a run.
#[derive(Clone, Copy)]
pub(crate) struct History<M: System> {
    /// Where the last step of a method with dense output began; nothing is known of it after a change from outside. With steps
    /// of fixed length, a state around which no guard can come to zero (`events::guard_free`).
    pub(crate) beginning: Option<Beginning<M>>,
    /// How many steps each state has limited, where they are counted.
    pub(crate) counts: Option<M::X>,
}

impl<M: System<S: Real>> History<M> {
    pub(crate) fn new() -> Self {
        Self { beginning: None, counts: None }
    }

    /// A method has made a step.
    #[inline]
    pub(crate) fn see<I: Method<M>>(
        &mut self,
        (method, system): (&I, &M),
        beginning: impl FnOnce() -> Beginning<M>,
    ) {
        if I::DENSE {
            self.beginning = Some(beginning());
        }
        if let Some(counts) = &mut self.counts
            && let Some(state) = method.limited_by(system)
        {
            counts.set(state, counts.at(state) + M::S::lit(1.0));
        }
    }
}
