//! Events that throw the state back over their own guards: a ball that falls below the floor flies up again.
//!
//! The guard of such an event is zero there within rounding: its value does not tell the side to which it goes. The next step does not tell
//! either, since it may be longer than the whole flight. The slope of the guard after the event does.

use super::boundary::{rates, rates_of_both};
use super::rounding::rounding;
use super::{guards, hold};
use crate::contact;
use crate::fault::{Cause, Fault, Names};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Time ahead of a state at rest at which its event is tried, in square roots of the rounding of 1 s plus the time: as little as lets the
/// guard change by more than its rounding.
const AHEAD: f64 = 64.0;

/// Commits the event of the condition `index`, and the return over its guard if that follows at once; gives the number of returns.
///
/// # Errors
/// Those of [`Events::switch`](crate::Events::switch), and a jump of constraint rows; [`Cause::Zeno`] for a state at rest whose event
/// throws back every motion.
pub(super) fn switch_there_and_back<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    index: usize,
) -> Result<u32, Fault> {
    let (held, before) = (context.held, context.x);
    switch(context, index)?;
    let thrown = switch_back(context, index, &before)?;
    if thrown == 0 && is_same(&context.x, &before) && rests(context, index, &held) {
        let marks: [bool; 64] = core::array::from_fn(|i| i == index);
        let conditions = Names::marked(context.system.conditions(), &marks);
        let cause = Cause::Zeno { events: 0, within: 0.0, conditions };
        return Err(Fault::of_part(context.time.to_f64(), context.system.guard_name(index), cause));
    }
    Ok(thrown)
}

/// True if a state is at rest on the boundary of a condition whose event has set nothing, because nothing moves. A moment later it would be
/// beyond, and its event would throw it back: the flights have no height. `held` is the discrete state before the event.
fn rests<M: System<S: Real>>(context: &mut Context<'_, M>, index: usize, held: &M::U) -> bool {
    if !is_of_state(context.system, index) {
        return false;
    }
    let here = (context.time, context.held, context.x);
    context.held = *held;
    let rests = rates_of_both(context).is_some_and(|(rate, _)| {
        let ahead = M::S::lit(AHEAD) * M::S::EPSILON.sqrt() * (M::S::lit(1.0) + here.0.abs());
        context.x = here.2.map2(&rate, |x, rate| x + ahead * rate);
        let guards = guards(context.system, here.0, held, &here.2);
        let noise = rounding((context.system, held), (here.0, here.0), &here.2, &guards);
        let (falls, fallen) = (slope(context, index) * ahead < -noise.at(index), context.x);
        let is_set = falls && switch(context, index).is_ok() && !is_same(&context.x, &fallen);
        is_set && slope(context, index) < M::S::lit(0.0)
    });
    (context.time, context.held, context.x) = here;
    rests
}

fn is_same<S: Real, X: Vector<S>>(x: &X, before: &X) -> bool {
    (0..X::LEN).all(|i| x.at(i) == before.at(i))
}

/// Commits the return over the guard of the condition `index`, if its event has changed the state `before` and leads back at once; gives
/// the number of returns. If the other side leads back too nothing is thrown: the two sides alternate.
///
/// # Errors
/// As [`switch_there_and_back`].
pub(super) fn switch_back<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    index: usize,
    before: &M::X,
) -> Result<u32, Fault> {
    // A guard whose own value the event has changed is on its side already.
    let stands = |context: &Context<'_, M>| {
        let guard = |x: &M::X| guards(context.system, context.time, &context.held, x).at(index);
        guard(before) == guard(&context.x)
    };
    let is_asked = is_of_state(context.system, index) && !is_same(&context.x, before) && stands(context);
    if !is_asked || slope(context, index) >= M::S::lit(0.0) {
        return Ok(0);
    }
    let there = (context.held, context.x);
    switch(context, index)?;
    if slope(context, index) > M::S::lit(0.0) {
        return Ok(1);
    }
    (context.held, context.x) = there;
    Ok(0)
}

/// True if the state leads away from the boundary of a condition, to its side in the discrete state. The residual of the condition and
/// rounding may be between; a state that a jump of another condition has put beyond the boundary leads to it.
pub(super) fn leads_away<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    (index, residual): (usize, M::S),
) -> bool {
    if !is_of_state(context.system, index) {
        return false;
    }
    let (time, here) = (context.time, guards(context.system, context.time, &context.held, &context.x));
    let noise = rounding((context.system, &context.held), (time, context.end), &context.x, &here);
    here.at(index) >= residual.min(M::S::lit(0.0)) - noise.at(index) && slope(context, index) > M::S::lit(0.0)
}

/// True if this guard belongs to a condition, not to a contact row. The guards of rows come last.
pub(super) fn is_of_state<M: System>(system: &M, index: usize) -> bool {
    let rows = system.contact_count();
    let of_rows = if rows > 0 { contact::guard_count(rows) } else { 0 };
    index + of_rows < system.guard_count()
}

/// Rate of change of a guard, per second; zero if there is no rate.
fn slope<M: System<S: Real>>(context: &mut Context<'_, M>, index: usize) -> M::S {
    rates(context).map_or(M::S::lit(0.0), |slopes| slopes.at(index))
}

fn switch<M: System<S: Real>>(context: &mut Context<'_, M>, index: usize) -> Result<(), Fault> {
    let (mut after, mut x) = (context.held, context.x);
    context.system.switch(context.time, &mut after, &mut x, index)?;
    hold(context, after)?;
    context.x = x;
    Ok(())
}
