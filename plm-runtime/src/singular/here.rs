//! The state where a step near a singular pose begins, its rate, and the pose ahead.

use super::ExtendedPrecision;
use super::distance::SingularityDistance;
use super::equations::{Equations, Evaluated};
use super::meeting::Meeting;
use crate::fault::Fault;
use crate::method::Context;

/// The beginning of a step near a singular pose.
pub(super) struct Here<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> {
    pub(super) equations: Equations<M, NQ, NC, NX>,
    /// The state [q, v, first-order states].
    pub(super) full: [M::S; NX],
    /// The state led back onto the constraints, and its rate; none where that is not known.
    pub(super) evaluated: Option<Evaluated<M::S, NX>>,
    /// The singular pose ahead; none where the motion is not known.
    pub(super) singularity: Option<SingularityDistance<M::S>>,
    /// How the mechanism meets the pose that is next.
    pub(super) meeting: Meeting,
}

impl<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Here<M, NQ, NC, NX>
{
    /// Of the next step of `context`.
    ///
    /// # Errors
    /// That of [`Meeting::of`].
    #[inline(never)]
    pub(super) fn before(context: &Context<'_, M>) -> Result<Self, Fault> {
        let mut here = Self {
            equations: Equations::of(*context.system),
            full: context.system.full(context.time, &context.held, &context.x),
            evaluated: None,
            singularity: None,
            meeting: Meeting::Unknown,
        };
        here.look(context);
        let open = &mut here.equations.open;
        here.meeting = Meeting::of(context, (&here.full, here.singularity.as_ref()), open)?;
        if here.meeting.is_reached() {
            here.look(context);
        }
        Ok(here)
    }

    #[inline(never)]
    fn look(&mut self, context: &Context<'_, M>) {
        let at = (context.time, &context.held);
        self.evaluated = self.equations.evaluate(at.0, at.1, &self.full);
        self.singularity =
            self.evaluated.as_ref().map(|evaluated| SingularityDistance::of(&self.equations, at, evaluated));
        if self.singularity.is_some_and(|singularity| !singularity.is_resolved()) {
            (self.evaluated, self.singularity) = (None, None);
        }
    }

    /// Goes to the state that was led back, if it is beside the given one; whether it is.
    pub(super) fn follow(&mut self) -> bool {
        let Some(evaluated) = &self.evaluated else { return false };
        let beside = self.equations.is_beside(&self.full, evaluated);
        if beside {
            self.full = evaluated.x;
        }
        beside
    }
}
