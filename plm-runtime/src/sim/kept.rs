//! What a simulation keeps of its steps: where one began, and which states limited them.

use crate::method::Method;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Where a step began, and what was held there.
#[derive(Clone, Copy)]
pub(crate) struct Begun<M: System> {
    /// s.
    pub(crate) time: M::S,
    pub(crate) held: M::U,
    pub(crate) x: M::X,
}

/// What a simulation keeps of its steps.
#[derive(Clone, Copy)]
pub(crate) struct Kept<M: System> {
    /// Where the last step of a method with dense output began; nothing is known of it after a change from outside. With steps
    /// of fixed length, a state around which no guard can come to zero (`events::calm`).
    pub(crate) begun: Option<Begun<M>>,
    /// How many steps each state has limited, where they are counted.
    pub(super) counts: Option<M::X>,
}

impl<M: System<S: Real>> Kept<M> {
    pub(super) fn new() -> Self {
        Self { begun: None, counts: None }
    }

    /// A method has made a step.
    #[inline]
    pub(crate) fn see<I: Method<M>>(&mut self, (method, system): (&I, &M), begun: impl FnOnce() -> Begun<M>) {
        if I::DENSE {
            self.begun = Some(begun());
        }
        if let Some(counts) = &mut self.counts
            && let Some(state) = method.limited_by(system)
        {
            counts.set(state, counts.at(state) + M::S::lit(1.0));
        }
    }
}
