//! Steps of a pair that are made elsewhere, side by side with those of other runs.

use super::{Embedded, Known, Pace, Pair, Span, first_step};
use crate::fault::Fault;
use crate::method::Context;
use crate::method::adaptive::rate_here;
use crate::scalar::{Real, Scalar};
use crate::system::System;

/// The numbers from which a run makes its next step.
#[derive(Clone, Copy)]
pub(crate) struct Going<S: Real, X> {
    pub(crate) pace: Pace<S>,
    pub(crate) rate: X,
}

impl<M: System<S = f64>, P: Pair> Embedded<M, P> {
    /// Computes what the next step begins with, as [`advance`](crate::Method::advance) does.
    pub(crate) fn ready(&mut self, context: &mut Context<'_, M>) -> Result<Going<f64, M::X>, Fault> {
        let rate = rate_here(&mut self.rate, context)?;
        if self.is_at_start() {
            self.pace.proposal = first_step(context, &rate, self.tolerance(), P::ORDER)?;
        }
        Ok(Going { pace: self.pace, rate })
    }

    /// Pace and rate at the beginning of the next step, if these are known.
    pub(crate) fn going(&self) -> Option<Going<f64, M::X>> {
        let rate = self.rate.filter(|_| !self.is_at_start())?;
        Some(Going { pace: self.pace, rate })
    }

    /// Has it not made a step yet?
    pub(crate) fn is_at_start(&self) -> bool {
        self.pace.proposal == f64::ZERO
    }

    /// Was the last step made without a solution by rank?
    pub(crate) fn is_regular(&self) -> bool {
        !self.was_unhealthy
    }

    /// Goes on from steps that were made elsewhere, the last of which has these stages.
    pub(crate) fn go_on(&mut self, going: Going<f64, M::X>, stages: P::Stages<M::X>, by_error: bool) {
        (self.pace, self.rate, self.stages, self.by_error) =
            (going.pace, Some(going.rate), Some(stages), by_error);
        (self.span, self.bends, self.known) = (None, None, Known::Values);
    }

    /// The last step that was made elsewhere, for states within it.
    pub(crate) fn has_made(&mut self, span: Span<f64, M::X>) {
        self.span = Some(span);
    }
}
