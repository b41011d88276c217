//! Observers of accepted steps and events.

use crate::events::Beginning;
use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::method::{Context, Method};

/// Observer of accepted steps.
pub(crate) trait Observer<M: Mechanism> {
    /// True if it sees accepted steps.
    const SEES: bool = true;
    /// True if it sees events. Runs without events to show pay nothing for them.
    const SWITCHES: bool = false;
    /// True if it may end the run, by setting `context.end` to the time of a step that it sees.
    const ENDS: bool = false;

    /// Called after a step was accepted; the discrete state is still that during the step.
    fn see<I: Method<M>>(&mut self, method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault>;

    /// Called after an event; `before` has the discrete state and the state just before it.
    #[inline]
    fn switched(&mut self, context: &Context<'_, M>, before: &Beginning<M>, what: Trigger) {
        let _ = (context, before, what);
    }
}

/// Trigger of an event.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Trigger {
    /// This condition.
    Condition(usize),
    /// All conditions that were past their guards.
    Due,
    /// Conditions on the time alone.
    Time,
}

/// Observer that sees nothing.
pub(crate) struct Unobserved;

impl<M: Mechanism> Observer<M> for Unobserved {
    const SEES: bool = false;

    #[inline]
    fn see<I: Method<M>>(&mut self, _method: &mut I, _context: &mut Context<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
}
