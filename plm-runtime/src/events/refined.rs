//! Ends of steps at zeros of guards: steps that are repeated to end there, and short corrections.

use super::here::{guards, guards_here};
use super::history::Reached;
use super::rates::{rates, rates_of_both};
use super::rounding::rounding;
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::tolerances::{END_MOVED, REPEATED_STEPS};
use crate::vector::Vector;

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
    for _ in 0..REPEATED_STEPS {
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
    let is_near = ahead.abs() <= END_MOVED.of::<M::S>() * (time - start);
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
