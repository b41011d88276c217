//! Events of conditions whose guards are violated at a state.

use super::boundary::Boundary;
use super::relevant::{bit, refresh};
use super::{Timed, derive_time, guards, guards_here, hold, restore_time};
use crate::contact;
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A gap that is negative by this fraction of the length of the mechanism has sunk in: by less, events are located.
const SUNK: f64 = 1e-9;

/// Switches every condition whose guard is past its band at the state `x`; how many did.
///
/// A condition may switch another one: it is repeated until none is past, but not for ever.
///
/// # Errors
/// Those of [`Events::switch`](crate::Events::switch).
pub fn switch_where_due<M: System<S: Real>>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<u32, Fault> {
    let mut switched = 0;
    switch_each((system, M::G::fill(M::S::ZERO), M::S::ZERO), None, (t, u, x), |_| switched += 1)?;
    Ok(switched)
}

/// The same, where guards are violated below their `edges`; gives `each` that switches. A guard that its own event leaves violated, as
/// that of a ball which has bounced, triggers it again only below where it was left. The guards have passed zero `within` this time; their
/// values may be known.
///
/// After a step of fixed length a point has sunk in by what it has moved since it struck. A condition that would make another row begin
/// below its surface there, as that of the riser of a stair, does not hold: the row that was struck leads the point out again. Those are
/// given, one bit each.
pub(crate) fn switch_each<M: System<S: Real>>(
    (system, mut edges, within): (&M, M::G, M::S),
    known: Option<&M::G>,
    (t, u, x): (M::S, &mut M::U, &mut M::X),
    mut each: impl FnMut(usize),
) -> Result<u64, Fault> {
    let changed = refresh(system, t, u, x);
    let mut here = known.filter(|_| changed == 0).map_or_else(|| guards(system, t, u, x), |here| *here);
    let rows = system.guard_count().saturating_sub(guards_of_contact(system));
    let mut left = 0;
    for _ in 0..=M::G::LEN {
        let mut any = false;
        for i in 0..M::G::LEN {
            if is_below(system, &here, &edges, i) {
                let before = (*u, *x);
                match system.switch_after(t, u, x, (i, within)) {
                    Err(Fault { cause: Cause::Sunk { .. }, .. })
                        if i < rows && has_sunk((system, t), &before, &here, rows) =>
                    {
                        (*u, *x) = before;
                        edges.set(i, here.at(i));
                        left |= bit(i);
                        continue;
                    }
                    outcome => outcome?,
                }
                here = guards(system, t, u, x);
                edges.set(i, here.at(i).min(M::S::ZERO));
                each(i);
                any = true;
            }
        }
        if !any {
            break;
        }
    }
    Ok(left)
}

/// Is a gap negative, after a step of fixed length, or a row that holds away from its place? The guards of contact begin at `rows`.
fn has_sunk<M: System<S: Real>>(
    (system, t): (&M, M::S),
    (u, x): &(M::U, M::X),
    here: &M::G,
    rows: usize,
) -> bool {
    let length = (0..system.coordinates()).fold(M::S::ZERO, |length, i| length.max(system.typical_at(i)));
    let least = M::S::lit(SUNK) * length;
    (rows..M::G::LEN).any(|i| here.at(i) < -least) || system.drift(t, u, x).phi > least
}

/// Guards of contact, which stand after those of conditions.
fn guards_of_contact<M: System>(system: &M) -> usize {
    match system.contact_count() {
        0 => 0,
        rows => contact::guard_count(rows),
    }
}

/// The guard `index` is beyond its band.
pub(super) fn is_violated<M: System<S: Real>>(system: &M, g: &M::G, index: usize) -> bool {
    g.at(index) < -system.band(index)
}

/// The guard `index` is beyond its band below its edge.
pub(super) fn is_below<M: System<S: Real>>(system: &M, g: &M::G, edges: &M::G, index: usize) -> bool {
    g.at(index) < edges.at(index) - system.band(index)
}

/// Conditions that have switched.
pub(super) struct Switched {
    /// One bit for each condition, of those too that were left beyond their guards.
    pub(super) conditions: u64,
    /// How many times.
    pub(super) count: u32,
}

/// Commits the events of the conditions whose guards `here`, at the state reached, are violated; gives those that switched. A guard is
/// violated below its `residual`. After a step no constraint row may jump; after a change from outside, with a `boundary`, what was
/// decided there stays. Guards have passed zero `within` the last step.
pub(super) fn switch_violated<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    here: &M::G,
    (boundary, residual): (Option<Boundary>, M::G),
    within: M::S,
) -> Result<Option<Switched>, Fault> {
    let decided = boundary.map_or(0, |boundary| boundary.decided);
    let edge = |i: usize| if decided & bit(i) == 0 { residual.at(i) } else { -M::S::INFINITY };
    let edges = M::G::from_fn(edge);
    let mut first = None;
    for index in 0..M::G::LEN {
        if !is_below(context.system, here, &edges, index) {
            continue;
        }
        first = first.or(Some(index));
        match boundary {
            None => required(context, index)?,
            Some(_) if context.system.must_hold(index) => return Err(not_met(context, index, here)),
            Some(_) => {}
        }
    }
    let Some(first) = first else { return Ok(None) };
    let moved = match boundary {
        Some(_) => M::S::ZERO,
        None => match derive_time(context, first, within)? {
            Timed::Event(_, moved) => moved,
            Timed::Touch(_) => return Ok(None),
        },
    };
    let (mut after, mut x) = (context.held, context.x);
    let mut switched = Switched { conditions: 0, count: 0 };
    let moment = (context.time, &mut after, &mut x);
    let left = switch_each((context.system, edges, within), Some(here), moment, |index| {
        switched.conditions |= bit(index);
        switched.count += 1;
    })?;
    switched.conditions |= left;
    if boundary.is_none() {
        hold(context, after)?;
    }
    (context.held, context.x) = (after, x);
    if boundary.is_none() {
        restore_time(context, moved)?;
    }
    Ok(Some(switched))
}

/// Commits the events at the end of a step by itself, of the length `step`, where guards are [`violated`].
#[inline]
pub(crate) fn switch_at_end<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    (violated, step): (&M::G, M::S),
) -> Result<(), Fault> {
    if !violated.is_finite() {
        guards_here(context)?;
    }
    switch_violated(context, violated, (None, M::G::fill(M::S::ZERO)), step).map(|_| ())
}

/// Are all guards satisfied at a state?
#[inline]
pub(crate) fn are_satisfied<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> bool {
    violated(system, t, held, x).is_none()
}

/// The guards at a state, where some are violated or none of them a number.
#[inline]
pub(crate) fn violated<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> Option<M::G> {
    let here = guards(system, t, held, x);
    let are_satisfied = here.is_finite() && (0..M::G::LEN).all(|i| !is_violated(system, &here, i));
    (!are_satisfied).then_some(here)
}

/// The end of a run whose requirement `index` is not met any more, or that has come to a pole or the end of a
/// domain.
pub(super) fn required<M: System<S: Real>>(context: &Context<'_, M>, index: usize) -> Result<(), Fault> {
    let (time, name) = (context.time.to_f64(), context.system.guard_name(index));
    if context.system.must_hold(index) {
        return Err(Fault::of_part(time, name, Cause::Required));
    }
    context.system.end(index).map_or(Ok(()), |cause| Err(Fault::of_part(time, name, cause)))
}

/// The fault of a guard that is not decided in a step from a time on: of a pole or a domain the run has come to its end.
#[cold]
pub(super) fn undecided<M: System<S: Real>>(system: &M, time: M::S, index: usize) -> Fault {
    let cause = system.end(index).unwrap_or(Cause::NotDecided);
    Fault::of_part(time.to_f64(), system.guard_name(index), cause)
}

/// The fault of a requirement that is not met where a run begins, or goes on after a change from outside.
pub(super) fn not_met<M: System<S: Real>>(context: &Context<'_, M>, index: usize, here: &M::G) -> Fault {
    let cause = Cause::NotMet { by: -here.at(index).to_f64() };
    Fault::of_part(context.time.to_f64(), context.system.guard_name(index), cause)
}
