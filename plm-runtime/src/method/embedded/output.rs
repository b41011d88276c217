//! Dense output of the last step.

use super::at_once::Known;
use super::{Embedded, Pair, Span};
use crate::fault::Fault;
use crate::method::{Context, DenseOutput, Path};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

impl<M: System<S: Real>, P: Pair> Embedded<M, P> {
    /// The last step for the search of events: the values of one that was made at once, unless all of it has derivatives.
    fn seen(&self) -> Option<Span<M::S, M::X>> {
        self.span.map(|span| match self.known {
            Known::Values if M::S::AT_ONCE.has_steps() => span.values(),
            _ => span,
        })
    }
}

impl<M: System<S: Real> + Copy, P: Pair> DenseOutput<M> for Embedded<M, P> {
    #[inline]
    fn is_dense(&self) -> bool {
        true
    }

    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if let (Some(step), Some(k), None) = (self.seen(), &self.stages, &self.bends) {
            let (mut outcome, known) = (Ok(()), self.known);
            let bends = P::bend::<M>(step.time, step.h, &step.from, k, &step.rate_to, |t, x, dx| {
                if outcome.is_ok() {
                    outcome = match known {
                        Known::Values => context.rate_value(t, x, dx),
                        Known::Derivatives => context.rate(t, x, dx),
                    };
                }
            });
            outcome?;
            self.bends = Some(bends);
        }
        Ok(())
    }

    fn derive(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        if let (true, Known::Values, Some(step), Some(mut k)) =
            (M::S::AT_ONCE.has_steps(), self.known, self.span, self.stages)
        {
            // A step by rank has derivatives already.
            if !self.was_unhealthy {
                Self::computed::<false>((context, step.time, &step.from), &step.rate_from, step.h, &mut k);
            }
            let mut rate = |time: M::S, x: &M::X, value: &M::X| {
                let mut rate = *x;
                context.rate(time, x, &mut rate)?;
                Ok(rate.map2(value, |own, value| own.with_plain(value.plain())))
            };
            let rate_from = rate(step.time, &step.from, &step.rate_from)?;
            let rate_to = rate(step.time + step.h, &step.to, &step.rate_to)?;
            self.span = Some(Span { rate_from, rate_to, ..step });
            (self.stages, self.bends, self.known) = (Some(k), None, Known::Derivatives);
        }
        Ok(())
    }

    fn interpolate(&self, time: M::S) -> M::X {
        let bends = self.bends.as_ref().map_or(&[] as &[M::X], |bends| bends.as_ref());
        self.span.map_or(M::X::fill(M::S::lit(0.0)), |step| step.at(time, bends))
    }

    fn path(&self) -> Option<Path<M::S, M::X>> {
        let bends = self.bends.as_ref().map_or(&[] as &[M::X], |bends| bends.as_ref());
        self.seen().map(|span| span.path(bends))
    }
}
