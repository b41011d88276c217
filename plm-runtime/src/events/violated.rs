//! Events of conditions whose guards are violated at a state.

use super::boundary::Boundary;
use super::marks::Marks;
use super::relevant::refresh;
use super::{Timed, derive_time, guards, guards_here, hold, restore_time};
use crate::contact;
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Depth, as a fraction of the length of the mechanism, above which a negative gap is a penetration: events are located more accurately.
pub const SUNK: f64 = 1e-9;

/// Commits the events of all conditions whose guards are past their bands at the state `x`; returns their number.
///
/// Conditions may switch each other, so that this is repeated until no guard is past its band, up to a bound.
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

/// Commits events as [`switch_where_due`] does, of guards that are violated below their `edges`; calls `each` for every condition that
/// switches. A guard that its own event leaves violated, as that of a ball which has bounced, triggers its event again only below that
/// value. The guards have passed zero `within` this time; their values may be `known`.
///
/// After a step of fixed length a point penetrates by its motion since it struck. A condition that would make another row begin below its
/// surface there, as that of the riser of a stair, does not switch: the row that was struck leads the point out again. These conditions
/// are returned.
pub(crate) fn switch_each<M: System<S: Real>>(
    (system, mut edges, within): (&M, M::G, M::S),
    known: Option<&M::G>,
    (t, u, x): (M::S, &mut M::U, &mut M::X),
    mut each: impl FnMut(usize),
) -> Result<Marks, Fault> {
    let changed = refresh(system, t, u, x);
    let mut here = known.filter(|_| changed.is_empty()).map_or_else(|| guards(system, t, u, x), |here| *here);
    let rows = system.guard_count().saturating_sub(guards_of_contact(system));
    let mut left = Marks::NONE;
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
                        left.put(i);
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

/// True if a gap is negative after a step of fixed length, or a constraint row away from its place. The guards of contact begin at `rows`.
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

/// Number of guards of contact, which come after those of conditions.
fn guards_of_contact<M: System>(system: &M) -> usize {
    match system.contact_count() {
        0 => 0,
        rows => contact::guard_count(rows),
    }
}

/// True if the guard `index` is beyond its band.
pub(super) fn is_violated<M: System<S: Real>>(system: &M, g: &M::G, index: usize) -> bool {
    g.at(index) < -system.band(index)
}

/// True if the guard `index` is beyond its band below its edge.
pub(super) fn is_below<M: System<S: Real>>(system: &M, g: &M::G, edges: &M::G, index: usize) -> bool {
    g.at(index) < edges.at(index) - system.band(index)
}

/// Conditions that have switched.
pub(super) struct Switched {
    /// They, and those that were left beyond their guards.
    pub(super) conditions: Marks,
    /// Number of switches.
    pub(super) count: u32,
}

/// Commits the events of the conditions whose guards `here`, at the state reached, are violated below their `residual`; returns those that
/// switched. After a step no constraint row may jump. After a change by the caller, with a `boundary`, the sides decided there stay.
/// Guards have passed zero `within` the last step.
pub(super) fn switch_violated<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    here: &M::G,
    (boundary, residual): (Option<Boundary>, M::G),
    within: M::S,
) -> Result<Option<Switched>, Fault> {
    let decided = boundary.map_or(Marks::NONE, |boundary| boundary.decided);
    let edge = |i: usize| if decided.has(i) { -M::S::INFINITY } else { residual.at(i) };
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
    let mut switched = Switched { conditions: Marks::NONE, count: 0 };
    let moment = (context.time, &mut after, &mut x);
    let left = switch_each((context.system, edges, within), Some(here), moment, |index| {
        switched.conditions.put(index);
        switched.count += 1;
    })?;
    switched.conditions = switched.conditions | left;
    if boundary.is_none() {
        hold(context, after)?;
    }
    (context.held, context.x) = (after, x);
    if boundary.is_none() {
        restore_time(context, moved)?;
    }
    Ok(Some(switched))
}

/// Commits the events at the end of a single step, of the length `step`, at which guards are [`violated`].
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

/// True if all guards are satisfied at a state.
#[inline]
pub(crate) fn are_satisfied<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> bool {
    violated(system, t, held, x).is_none()
}

/// Guards at a state, if one of them is violated or not finite; `None` otherwise.
#[inline]
pub(crate) fn violated<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> Option<M::G> {
    let here = guards(system, t, held, x);
    let are_satisfied = here.is_finite() && (0..M::G::LEN).all(|i| !is_violated(system, &here, i));
    (!are_satisfied).then_some(here)
}

/// Ends a run whose requirement `index` is no longer satisfied, or that has come to a pole or the end of a domain.
pub(super) fn required<M: System<S: Real>>(context: &Context<'_, M>, index: usize) -> Result<(), Fault> {
    let (time, name) = (context.time.to_f64(), context.system.guard_name(index));
    if context.system.must_hold(index) {
        return Err(Fault::of_part(time, name, Cause::Required));
    }
    context.system.end(index).map_or(Ok(()), |cause| Err(Fault::of_part(time, name, cause)))
}

/// Fault of a guard that is undecided in a step from a time on; at a pole or the end of a domain, the end of the run there.
#[cold]
pub(super) fn undecided<M: System<S: Real>>(system: &M, time: M::S, index: usize) -> Fault {
    let cause = system.end(index).unwrap_or(Cause::NotDecided);
    Fault::of_part(time.to_f64(), system.guard_name(index), cause)
}

/// Fault of a requirement that is not satisfied at the start of a run, or after a change by the caller.
pub(super) fn not_met<M: System<S: Real>>(context: &Context<'_, M>, index: usize, here: &M::G) -> Fault {
    let cause = Cause::NotMet { by: -here.at(index).to_f64() };
    Fault::of_part(context.time.to_f64(), context.system.guard_name(index), cause)
}
