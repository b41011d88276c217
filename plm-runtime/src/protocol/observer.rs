//! Observers of accepted steps and events.

use crate::events::Beginning;
use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::method::{Context, Method};

/// An observer of accepted steps.
pub(crate) trait Observer<M: Mechanism> {
    /// Does it see anything at all?
    const SEES: bool = true;
    /// Does it see events? A run without pays nothing for them.
    const SWITCHES: bool = false;
    /// May it end the run, by putting `context.end` at the time of a step that it sees?
    const ENDS: bool = false;

    /// A step was accepted; what was held over it is held still.
    fn see<I: Method<M>>(&mut self, method: &mut I, context: &mut Context<'_, M>) -> Result<(), Fault>;

    /// Something has switched; `before` is the discrete state and the state until then.
    #[inline]
    fn switched(&mut self, context: &Context<'_, M>, before: &Beginning<M>, what: Trigger) {
        let _ = (context, before, what);
    }
}

/// What has switched.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Trigger {
    /// This condition.
    Condition(usize),
    /// All conditions that were past their guards.
    Due,
    /// Conditions on the time alone.
    Time,
}

/// Nobody.
pub(crate) struct Unobserved;

impl<M: Mechanism> Observer<M> for Unobserved {
    const SEES: bool = false;

    #[inline]
    fn see<I: Method<M>>(&mut self, _method: &mut I, _context: &mut Context<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
}
