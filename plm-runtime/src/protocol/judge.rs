//! Verdict on a proposed step. The judge changes nothing.
//!
//! Every path of [`crate::protocol`] has this judge: the general one, the fast one, a step by itself, and the lanes of a batch.

use super::energy::check_energy;
use super::near_singular::{Nearness, Rescue};
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Context, DriftCheck, Estimate, Length};
use crate::scalar::Scalar;
use crate::system::{Step, System, Updated};

/// What ends a run although its state could be continued.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits<S> {
    /// The energy jumps by more than this fraction.
    pub(crate) energy_jump: Option<S>,
    /// A loop can go on in several ways.
    pub(crate) change_points: bool,
}

impl<S> Limits<S> {
    /// None.
    pub(crate) const NONE: Self = Self { energy_jump: None, change_points: false };
}

/// What a step is judged by.
pub(crate) struct Rules<S> {
    pub(crate) length: Length,
    pub(crate) drift: DriftCheck<S>,
    pub(crate) limits: Limits<S>,
}

/// A step that a method has made, with copies of what it leads to.
pub(crate) struct Proposal<'a, M: System> {
    pub(crate) system: &'a M,
    /// Time, s, and state where it begins.
    pub(crate) from: (M::S, &'a M::X),
    /// The time at its end, s.
    pub(crate) end: M::S,
    /// The discrete state over it; after the verdict [`Accept`](Verdict::Accept), that from its end on.
    pub(crate) held: &'a mut M::U,
    /// The state at its end; after that verdict, with the coordinates and revolutions of that discrete state.
    pub(crate) x: &'a mut M::X,
    /// The smallest pivot ratio of its rates.
    pub(crate) health: M::S,
}

/// What a proposed step is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// It is committed.
    Accept(Updated),
    /// The state is projected onto the constraints, and judged again.
    Project,
    /// A shorter step is tried; of a method that has none this fault is told.
    Shorten(Fault),
    /// It is made in so many parts at least.
    Split(u32),
    /// It is left to the near-singular method.
    NearSingular,
    /// The run ends before it.
    Refuse(Fault),
}

/// Judges a step by what it led to and by the estimate of its error. Nothing but the proposal is changed.
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
    /// The step of a context to the state reached, with copies `held` and `x` of it.
    #[inline]
    pub(crate) fn of(
        context: &Context<'s, M>,
        from: (M::S, &'s M::X),
        (held, x): (&'s mut M::U, &'s mut M::X),
    ) -> Self {
        Self { system: context.system, from, end: context.time, held, x, health: context.health }
    }

    /// The step.
    #[inline]
    pub(crate) fn step(&self) -> Step<'_, M> {
        let Self { system, from, end, held, x, health } = self;
        Step { system: *system, held, from: *from, to: (*end, x), health: *health }
    }
}
