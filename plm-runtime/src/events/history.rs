//! History of the last step, and counters of the states that limited steps.

use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// The beginning of a step.
#[derive(Clone, Copy)]
pub(crate) struct Beginning<M: System> {
    /// Time, s.
    pub(crate) time: M::S,
    pub(crate) held: M::U,
    pub(crate) x: M::X,
}

impl<M: System> Beginning<M> {
    /// The state of the context.
    pub(crate) fn of(context: &Context<'_, M>) -> Self {
        Self { time: context.time, held: context.held, x: context.x }
    }
}

/// A method and the state from which it continues, stored for a return to them.
pub(super) struct Reached<M: System, I> {
    pub(super) method: I,
    pub(super) state: Beginning<M>,
}

impl<M: System, I: Clone> Reached<M, I> {
    pub(super) fn of(method: &I, context: &Context<'_, M>) -> Self {
        Self { method: method.clone(), state: Beginning::of(context) }
    }

    /// Returns to them. Field by field: without optimisation a tuple would be a second copy of the method on the stack.
    pub(super) fn restore(&self, method: &mut I, context: &mut Context<'_, M>) {
        method.clone_from(&self.method);
        context.time = self.state.time;
        context.held = self.state.held;
        context.x = self.state.x;
    }
}

/// History of a run.
#[derive(Clone, Copy)]
pub(crate) struct History<M: System> {
    /// Beginning of the last step of a method with dense output; `None` after a change by the caller. With steps of fixed
    /// length, the centre of the guard-free region (`events::guard_free`).
    pub(crate) beginning: Option<Beginning<M>>,
    /// Number of steps that each state has limited, if they are counted.
    pub(crate) counts: Option<M::X>,
}

impl<M: System<S: Real>> History<M> {
    pub(crate) fn new() -> Self {
        Self { beginning: None, counts: None }
    }

    /// Records a step that a method has made.
    #[inline]
    pub(crate) fn see<I: Method<M>>(
        &mut self,
        (method, system): (&I, &M),
        beginning: impl FnOnce() -> Beginning<M>,
    ) {
        if method.is_dense() {
            self.beginning = Some(beginning());
        }
        if let Some(counts) = &mut self.counts
            && let Some(state) = method.limited_by(system)
        {
            counts.set(state, counts.at(state) + M::S::lit(1.0));
        }
    }
}
