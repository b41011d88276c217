//! End of a step: at an event, at a kink, or as proposed.

use super::enclosure::Enclosure;
use super::kinks::kink;
use super::passing::{Pass, pass};
use super::relevant::Relevant;
use super::sampled::Sampled;
use super::search::{First, Found};
use super::touch::touch;
use super::violated::undecided;
use super::{Beginning, Detector, guards};
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Reason for the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ends {
    /// No event: the whole step, or a part of it.
    Whole,
    /// This condition switches.
    Due(usize),
    /// A kink, before which a condition may switch: the dense output that says so goes over the kink, and is inaccurate before
    /// it.
    BeforeKink,
    /// A point just beyond a kink: derivatives differ from here on.
    BeyondKink,
}

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// Reason and time of the end of the last step.
    pub(super) fn ends<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        context: &mut Context<'_, M>,
        (start, end): (&Beginning<M>, &G),
        (least, beyond_kinks): (S, bool),
    ) -> Result<(Ends, S), Fault> {
        if context.system.contact_count() > 0 && self.stay(context, start, end) {
            return Ok((Ends::Whole, context.time));
        }
        if context.system.guard_count() > 0 {
            method.densify(context)?;
        }
        let path = method.path();
        let enclosure = path.map_or_else(
            || Enclosure::unknown(context.system, &context.held),
            |path| Enclosure::over(context, &path),
        );
        let found = if enclosure.guards {
            (Found::Nothing, context.time)
        } else {
            self.search(method, context, (start, end), enclosure.relevant)
        };
        let (ends, time) = match found {
            (Found::Undecided(index), _) => return Err(undecided(context.system, start.time, index)),
            (Found::Crossing(index, _), time) => (Ends::Due(index), time),
            (Found::Open(_), time) if time - start.time > least => (Ends::Whole, time),
            _ => (Ends::Whole, context.time),
        };
        let bends = enclosure.kinks != 0 && !beyond_kinks;
        if M::S::HAS_DERIVATIVES {
            let passed = if bends { pass(method, context, (enclosure.kinks, least))? } else { None };
            let is_over = matches!(passed, Some(Pass::Over(_)));
            return Ok(match passed.map(Pass::end).filter(|kink| *kink < context.time) {
                Some(kink) if time < kink => (Ends::BeforeKink, kink),
                Some(kink) if is_over => (Ends::BeyondKink, kink),
                Some(kink) => (Ends::Whole, kink),
                None => {
                    if ends == Ends::Whole && !enclosure.guards {
                        touch(method, context, (enclosure.relevant, &self.residual))?;
                    }
                    (ends, time)
                }
            });
        }
        let crossing = matches!(ends, Ends::Due(_)).then_some(time);
        let kink = if bends { kink(method, context, (start.time, crossing), enclosure.kinks)? } else { None };
        Ok(match kink.filter(|kink| *kink < context.time) {
            Some(kink) if time < kink => (Ends::BeforeKink, kink),
            Some(kink) => (Ends::Whole, kink),
            None => (ends, time),
        })
    }

    /// Searches the dense output of the last step for the first event, and its time.
    fn search<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        context: &mut Context<'_, M>,
        (start, end): (&Beginning<M>, &G),
        relevant: Relevant,
    ) -> (Found<S>, S) {
        if context.system.guard_count() == 0 {
            return (Found::Nothing, context.time);
        }
        let Some(path) = method.path() else {
            let began = guards(context.system, start.time, &start.held, &start.x);
            let sampled = Sampled { method, context, start: start.time, residual: &self.residual, relevant };
            return sampled.first(&began, end);
        };
        let asked = First { path: &path, residual: &self.residual, relevant };
        let found = context.system.ask(&context.held, asked);
        let time = match found {
            Found::Crossing(_, theta) | Found::Open(theta) => path.time(theta),
            Found::Nothing | Found::Undecided(_) => context.time,
        };
        (found, time)
    }
}
