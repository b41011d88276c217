//! Contact by methods of fixed steps: a step in which a row changes its mode is made in two parts, up to that time and from it on. So an
//! impact is at its time, and a slip ends where its rate is zero.

use super::Observer;
use super::advance::{Advance, Made, project_end};
use crate::events::{Beginning, Event};
use crate::mechanism::Mechanism;
use crate::method::Method;
use crate::scalar::Scalar;

/// Fractions of the step, after that at which the row changes its mode on the cubic, at which the guard of the state is looked at too: the
/// first part is a step of its own, and ends beside the cubic by the error of a step.
const LATER: [f64; 4] = [1e-8, 1e-6, 1e-4, 1e-2];

/// A step that will be made in two parts.
pub(crate) struct Cut<S> {
    /// Fraction of the step at which a row changes its mode.
    share: S,
    /// Its end, s.
    until: S,
}

impl<M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, '_, M, I, O> {
    /// The change of a mode at which the step from a beginning to the state reached is to be cut; none in a part of a step that was cut.
    #[inline]
    pub(super) fn change(&self, from: &Beginning<M>, event: &Event) -> Option<Cut<M::S>> {
        if self.cut.is_some() || M::CONTACTS == 0 || !matches!(event, Event::Behind { .. }) {
            return None;
        }
        let share = self.guarded.detector.changes_mode(self.context, from)?;
        Some(Cut { share, until: self.context.time })
    }

    /// Makes a step in its parts.
    #[cold]
    pub(super) fn make_cut(&mut self, cut: &Cut<M::S>) -> Made<M::S> {
        let whole = self.context.end;
        self.cut = Some(cut.until - self.context.time);
        let made = self.in_parts(cut);
        self.cut = None;
        // An observer may have ended the run.
        let is_ended = matches!(made, Made::Step) && self.context.time < cut.until;
        if is_ended {
            return made;
        }
        self.go_back_to(whole, made)
    }

    /// Makes the parts; between them the rows that hold from then on are led to their places, which the first part has passed by rounding.
    fn in_parts(&mut self, Cut { share, until }: &Cut<M::S>) -> Made<M::S> {
        let (from, before) = (self.context.time, self.context.stats.switches);
        for later in LATER {
            let at = from + (*share + M::S::lit(later)) * (*until - from);
            // Rounding of the time may leave nothing of a part.
            if at <= self.context.time || at >= *until {
                continue;
            }
            let made = self.part(at);
            if !matches!(made, Made::Step) || self.context.time < at {
                return made;
            }
            if self.context.stats.switches > before {
                if let Err(fault) = project_end(self.context) {
                    return Made::Failed(fault);
                }
                break;
            }
        }
        self.part(*until)
    }

    /// Makes a step to the time `end`.
    fn part(&mut self, end: M::S) -> Made<M::S> {
        self.context.end = end;
        match self.method.begin(self.context) {
            Ok(()) => self.step(),
            Err(fault) => Made::Failed(fault),
        }
    }
}
