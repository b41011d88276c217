//! Projection after steps with error control.

use super::{Context, drift_of_size, excess};
use crate::fault::Fault;
use crate::scalar::Real;
use crate::system::System;

/// Fraction of the tolerance above which drift is projected.
pub(super) const PROJECTED_ABOVE: f64 = 0.1;

/// Drift relative to its tolerance, and its part that projection cannot remove.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection<S> {
    /// Drift that the last projection could not remove, over the tolerance.
    pub(super) residue: S,
}

impl<S: Real> Projection<S> {
    pub(super) fn new() -> Self {
        Self { residue: S::ZERO }
    }

    /// Drift of a state over the tolerance, less the part that projection cannot remove.
    pub(super) fn drift<M: System<S = S>>(
        &self,
        (system, u): (&M, &M::U),
        tolerance: S,
        (t, x): (S, &M::X),
    ) -> S {
        excess(system.drift(t, u, x), drift_of_size(system, tolerance)) - self.residue
    }

    /// Projects the state that a step leads to.
    pub(super) fn project<M: System<S = S>>(
        &mut self,
        context: &mut Context<'_, M>,
        tolerance: S,
        (time, x): (S, &mut M::X),
    ) -> Result<(), Fault> {
        context.project(time, x)?;
        self.residue = S::ZERO;
        self.residue = self.drift((context.system, &context.held), tolerance, (time, x));
        Ok(())
    }
}
