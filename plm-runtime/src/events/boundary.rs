//! Guards that are zero within rounding at the start of a run or after a change by the caller: their rates decide the mode. Also moves
//! the ends of steps to zeros of guards.

use super::history::Reached;
use super::marks::Marks;
use super::rounding::{ULPS, rounding};
use super::violated::not_met;
use super::{guards, guards_here};
use crate::enclosure::{Enclosed, Interval};
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A guard that is farther from zero than so many of its roundings is not zero, whatever its rate.
const FAR: f64 = 1e6;
/// Most repetitions of a step that has to end where a requirement is no longer satisfied.
const MOST_AGAIN: u32 = 4;

/// Largest change of the end of a step, as a fraction of the step.
const MOVED: f64 = 1e-3;

/// Conditions whose boundaries the state is on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Boundary {
    /// Conditions whose sides have been decided: their guards are not checked again.
    pub(super) decided: Marks,
    /// Conditions that have changed their sides.
    pub(super) switched: Marks,
}

/// Decides the sides of the conditions whose boundaries the state is on, by the direction of the rate. During a run only
/// guards that are not positive are examined. A requirement that the rate leads away from is not satisfied.
pub(super) fn decide<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    here: &M::G,
    is_new: bool,
) -> Result<Boundary, Fault> {
    let mut boundary = Boundary { decided: Marks::NONE, switched: Marks::NONE };
    let has_band = |i: usize| context.system.band(i) > M::S::ZERO;
    let asks = |i: usize| !has_band(i) && (is_new || here.at(i) <= M::S::ZERO);
    let asked = (0..M::G::LEN).filter(|i| asks(*i));
    let asked = Marks::of_all(asked);
    if asked.is_empty() || !context.system.is_regular(&context.held) {
        return Ok(boundary);
    }
    let (time, x) = (context.time, context.x);
    let noise = rounding((context.system, &context.held), (time, time), &x, here);
    let ulps = M::S::lit(ULPS) * M::S::EPSILON * time.abs();
    let mut slopes = None;
    for i in (0..M::G::LEN).filter(|i| asked.has(*i)) {
        let size = here.at(i).abs();
        // The time of an event has rounding errors, in which the state may have gone on.
        let reach = |slope: M::S| noise.at(i) + ulps * slope.abs();
        let far = size > M::S::lit(FAR) * noise.at(i);
        if far || !noise.at(i).is_finite() {
            continue;
        }
        let slope = match slopes {
            Some(known) => known,
            None => match rates(context) {
                Some(found) => *slopes.insert(found),
                None => return Ok(boundary),
            },
        };
        let slope = slope.at(i);
        if size > reach(slope) {
            continue;
        }
        if slope >= M::S::ZERO {
            boundary.decided.put(i);
        } else if context.system.must_hold(i) {
            return Err(not_met(context, i, here));
        } else {
            let before = (context.held, context.x);
            context.system.switch(time, &mut context.held, &mut context.x, i)?;
            // If neither side leads away from the boundary, the value decides.
            if let Some(turned) = rates(context).filter(|turned| turned.at(i) > M::S::ZERO) {
                boundary.decided.put(i);
                boundary.switched.put(i);
                slopes = Some(turned);
            } else {
                (context.held, context.x) = before;
            }
        }
    }
    Ok(boundary)
}

/// Makes one step that ends at a time within the interval at the latest.
pub(super) fn advance_to<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    time: M::S,
) -> Result<(), Fault> {
    let whole = core::mem::replace(&mut context.end, time);
    let outcome = method.advance(context);
    context.end = whole;
    outcome
}

/// Repeats a step so that it ends where a requirement is no longer satisfied, until its guard is zero there within rounding: the dense
/// output that located the time is less accurate than a step, and a run may begin at the state reached. Returns false if a repeated step
/// ends before that time.
pub(super) fn meet<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    before: &Reached<M, I>,
    index: usize,
) -> Result<bool, Fault> {
    for _ in 0..MOST_AGAIN {
        let here = guards_here(context)?;
        let noise =
            rounding((context.system, &context.held), (context.time, context.time), &context.x, &here);
        let Some(slopes) = rates(context).filter(|_| here.at(index).abs() > noise.at(index)) else { break };
        let time = context.time - here.at(index) / slopes.at(index);
        if !(time > before.state.time && time < context.end) {
            break;
        }
        let reached = Reached::of(method, context);
        before.restore(method, context);
        context.stats.steps -= 1;
        context.stats.rejected += 1;
        advance_to(method, context, time)?;
        if context.time < time {
            return Ok(false);
        }
        if guards_here(context)?.at(index).abs() >= here.at(index).abs() {
            reached.restore(method, context);
            break;
        }
    }
    Ok(true)
}

/// Result of [`refine`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refined {
    /// The guard is zero at the end, as far as a short correction can achieve.
    Here,
    /// The zero is too far away: the step has to be repeated.
    Far,
}

/// Moves the end of a step to the zero of the guard that has ended it. The dense output that located the time is less accurate than the
/// step, by far if a contact row approaches slowly. The distance is so short that the midpoint rule suffices.
///
/// The state is projected first: otherwise gaps that close at one moment because others are closed would close one after another by the
/// drift of those, and a row that opens would keep its drift as a gap.
pub(super) fn refine<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    start: M::S,
    index: usize,
) -> Result<Refined, Fault> {
    let mut projected = context.x;
    context.project(context.time, &mut projected)?;
    context.x = projected;
    let (here, time, x) = (guards_here(context)?, context.time, context.x);
    let noise = rounding((context.system, &context.held), (time, time), &x, &here);
    let off = here.at(index);
    let Some((rate, slopes)) = rates_of_both(context).filter(|_| off.abs() > noise.at(index)) else {
        return Ok(Refined::Here);
    };
    let ahead = -off / slopes.at(index);
    // False for NaN.
    let is_near = ahead.abs() <= M::S::lit(MOVED) * (time - start);
    if !is_near {
        return Ok(Refined::Far);
    }
    if time + ahead > context.end {
        return Ok(Refined::Here);
    }
    let half = M::S::lit(0.5) * ahead;
    let (middle, mut rate_there) = (x.map2(&rate, |x, rate| x + half * rate), rate);
    context.rate(time + half, &middle, &mut rate_there)?;
    let moved = x.map2(&rate_there, |x, rate| x + ahead * rate);
    if guards(context.system, time + ahead, &context.held, &moved).at(index).abs() < off.abs() {
        (context.time, context.x) = (time + ahead, moved);
    }
    Ok(Refined::Here)
}

/// Rate of change of each guard at the state, per second; `None` if there is no rate.
pub(super) fn rates<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<M::G> {
    rates_of_both(context).map(|(_, slopes)| slopes)
}

/// Rates of change of the state and of each guard.
pub(super) fn rates_of_both<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<(M::X, M::G)> {
    let (time, x) = (context.time, context.x);
    let mut rate = x;
    context.rate(time, &x, &mut rate).ok()?;
    let moving = |s: M::S, slope: M::S| Enclosed { slope: Interval::point(slope), ..Enclosed::constant(s) };
    let mut slopes = M::G::fill(M::S::ZERO);
    let known = context.system.guards_within(
        moving(time, M::S::lit(1.0)),
        &context.held,
        &|i| moving(x.at(i), rate.at(i)),
        &mut |i, guard| {
            let Interval { low, high } = guard.slope;
            if i < M::G::LEN {
                slopes.set(i, M::S::lit(0.5) * (low + high));
            }
        },
    );
    if known {
        return Some((rate, slopes));
    }
    // By a difference quotient, if the system cannot enclose its guards.
    let h = M::S::EPSILON.sqrt() * (M::S::lit(1.0) + time.abs());
    let ahead = x.map2(&rate, |x, rate| x + h * rate);
    let guards = |t, x| guards(context.system, t, &context.held, x);
    let (here, ahead) = (guards(time, &x), guards(time + h, &ahead));
    Some((rate, ahead.map2(&here, |ahead, here| (ahead - here) / h)))
}
