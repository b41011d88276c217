//! Parameters, inputs and states that the caller changed between two steps, and what depends on them.

use core::ops::{Deref, DerefMut};

use super::Sim;
use crate::fault::{Cause, Fault};
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Marks that the caller may change the state, parameters or inputs before the next step.
    pub(super) fn expect_changes(&mut self) {
        self.forget();
        self.changed = true;
    }

    /// Applies the caller's changes. Changed parameters must have values that the equations allow; if joints read them,
    /// the mechanism is reassembled from its present pose. Time events that a change has moved into the past are
    /// committed, and the modes of contact rows are checked against the state.
    ///
    /// # Errors
    /// Those of [`Mechanism::check`] and [`Mechanism::renew`]; they recur until the change is undone.
    #[cold]
    pub(crate) fn take_changes(&mut self) -> Result<(), Fault> {
        if !self.changed {
            return Ok(());
        }
        let mechanism = self.state.mechanism();
        let (time, mut held, mut x) = (self.state.time(), self.state.held(), *self.state.x());
        let parameters = mechanism.fingerprint();
        if parameters != self.parameters {
            mechanism.check(time)?;
            mechanism.renew(time, &mut held, &mut x)?;
            // Event times may have moved before the present time.
            mechanism.switch_at_time(time, &mut held, &mut x)?;
            self.state.set(time, &held, &x);
            self.parameters = parameters;
            self.stats.renewed += 1;
        } else if mechanism.next_time_event(M::S::lit(f64::NEG_INFINITY), &held).is_some() {
            // Inputs also can move event times before the present time.
            mechanism.switch_at_time(time, &mut held, &mut x)?;
            self.state.set(time, &held, &x);
        }
        if self.state.mechanism().contact_count() > 0 {
            let (time, mut held, mut x) = (self.state.time(), self.state.held(), *self.state.x());
            self.state.mechanism().state_was_set(time, &mut held, &mut x)?;
            self.state.set(time, &held, &x);
        }
        self.changed = false;
        Ok(())
    }

    /// Checks that an interval of `length` to `end` can begin, and applies the caller's changes.
    #[cold]
    pub(super) fn begin(&mut self, end: M::S, length: M::S) -> Result<(), Fault> {
        let time = self.state.time();
        if !(end >= time && end.is_finite()) {
            return Err(self.bad_interval(length));
        }
        self.take_changes()
    }

    pub(super) fn bad_interval(&self, length: M::S) -> Fault {
        Fault::new(self.state.time().to_f64(), Cause::Interval { length: length.to_f64() })
    }
}

impl<M: Mechanism, I> Deref for Sim<M, I> {
    type Target = M::State;

    fn deref(&self) -> &M::State {
        &self.state
    }
}

impl<M: Mechanism, I: Method<M>> DerefMut for Sim<M, I> {
    fn deref_mut(&mut self) -> &mut M::State {
        self.expect_changes();
        &mut self.state
    }
}
