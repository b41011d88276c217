//! Verdict on a proposed step. The judge changes nothing.
//!
//! All paths of [`crate::protocol`] have this judge: the general one, the fast one, a single step, and the lanes of a batch.

use super::energy::check_energy;
use super::near_singular::{Nearness, Rescue};
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Context, DriftCheck, Estimate, Length};
use crate::scalar::Scalar;
use crate::system::{Step, System, Updated};

/// Limits that end a run although its state could be continued.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits<S> {
    /// Largest jump of the energy, as a fraction of the energy that moves.
    pub(crate) energy_jump: Option<S>,
    /// True if the run ends at a change point, where a loop can continue in several ways.
    pub(crate) change_points: bool,
}

impl<S> Limits<S> {
    /// No limits.
    pub(crate) const NONE: Self = Self { energy_jump: None, change_points: false };
}

/// Criteria by which a step is judged.
pub(crate) struct Rules<S> {
    pub(crate) length: Length,
    pub(crate) drift: DriftCheck<S>,
    pub(crate) limits: Limits<S>,
}

/// A step that a method has made, with copies of the state and discrete state that it leads to.
pub(crate) struct Proposal<'a, M: System> {
    pub(crate) system: &'a M,
    /// Time, s, and state at its beginning.
    pub(crate) from: (M::S, &'a M::X),
    /// The time at its end, s.
    pub(crate) end: M::S,
    /// Discrete state during the step; after the verdict [`Accept`](Verdict::Accept), the one that applies from its end on.
    pub(crate) held: &'a mut M::U,
    /// State at its end; after that verdict, in the coordinates and revolutions of the new discrete state.
    pub(crate) x: &'a mut M::X,
    /// Smallest pivot ratio of its rates.
    pub(crate) health: M::S,
}

/// Verdict on a proposed step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// The step is committed.
    Accept(Updated),
    /// The state is projected onto the constraints, and judged again.
    Project,
    /// A shorter step is tried; if the method has none, this fault is reported.
    Shorten(Fault),
    /// The step is made in at least so many parts.
    Split(u32),
    /// The step is left to the near-singular method.
    NearSingular,
    /// The run ends before the step.
    Refuse(Fault),
}

/// Judges a step by the state that it leads to and by its error estimate. Changes nothing but the proposal.
#[allow(clippy::inline_always, reason = "the fast path keeps the state in registers")]
#[inline(always)]
pub(crate) fn judge<M: Mechanism>(
    proposal: &mut Proposal<'_, M>,
    estimate: Estimate<M::S>,
    rules: &Rules<M::S>,
) -> Verdict {
    let (system, start, end) = (proposal.system, proposal.from.0, proposal.end);
    if rules.drift.fails((system, proposal.held), end, proposal.x) {
        return Verdict::Project;
    }
    match M::Rescue::nearness(&proposal.step(), rules.length) {
        Nearness::Regular => {}
        Nearness::Turn { parts } => return Verdict::Split(parts),
        Nearness::Singular => return Verdict::NearSingular,
    }
    if let Some(fraction) = rules.limits.energy_jump
        && let Err(fault) = check_energy(&proposal.step(), fraction)
    {
        return Verdict::Shorten(fault);
    }
    match system.update(end, proposal.held, proposal.x) {
        Err(fault) => Verdict::Shorten(fault),
        Ok(Updated { passed: Some(part), .. }) if rules.limits.change_points => {
            Verdict::Refuse(Fault::of_part(end.to_f64(), part, Cause::ChangePoint))
        }
        Ok(_) if estimate.is_senseless() => Verdict::Refuse(estimate.fault(system, start, end - start)),
        Ok(accepted) => Verdict::Accept(accepted),
    }
}

impl<'s, M: System> Proposal<'s, M> {
    /// The proposal for the step of a context, with copies `held` and `x` of the state reached.
    #[inline]
    pub(crate) fn of(
        context: &Context<'s, M>,
        from: (M::S, &'s M::X),
        (held, x): (&'s mut M::U, &'s mut M::X),
    ) -> Self {
        Self { system: context.system, from, end: context.time, held, x, health: context.health }
    }

    /// The step that is proposed.
    #[inline]
    pub(crate) fn step(&self) -> Step<'_, M> {
        let Self { system, from, end, held, x, health } = self;
        Step { system: *system, held, from: *from, to: (*end, x), health: *health }
    }
}
