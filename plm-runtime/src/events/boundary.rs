//! Guards that are zero but for rounding where a run begins, or goes on after a change from outside: their rates decide the mode. Ends of
//! steps are led to where a guard vanishes.

use super::history::Reached;
use super::relevant::bit;
use super::rounding::{ULPS, rounding};
use super::violated::not_met;
use super::{guards, guards_here};
use crate::enclosure::{Enclosed, Interval};
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Beyond so many times its rounding no guard is zero, whatever its rate.
const FAR: f64 = 1e6;
/// Steps that are made again at most to end where a requirement does.
const MOST_AGAIN: u32 = 4;

/// The end of a step is moved by this fraction of the step at most.
const MOVED: f64 = 1e-3;

/// Conditions on whose boundary the state is.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Boundary {
    /// Conditions whose sides have been decided, one bit each: rounding is not asked again.
    pub(super) decided: u64,
    /// Those that have changed their sides.
    pub(super) switched: u64,
}

/// Decides the sides of the conditions on whose boundary the state is, of the first 64: where the rate leads. In a run that is
/// under way only those are asked that seem to be beyond. A requirement that the rate leads away from is not met.
pub(super) fn decide<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    here: &M::G,
    is_new: bool,
) -> Result<Boundary, Fault> {
    let mut boundary = Boundary::default();
    let has_band = |i: usize| context.system.band(i) > M::S::ZERO;
    let asks = |i: usize| bit(i) != 0 && !has_band(i) && (is_new || here.at(i) <= M::S::ZERO);
    let asked = (0..M::G::LEN).filter(|i| asks(*i)).fold(0, |asked, i| asked | bit(i));
    if asked == 0 || !context.system.is_regular(&context.held) {
        return Ok(boundary);
    }
    let (time, x) = (context.time, context.x);
    let noise = rounding((context.system, &context.held), (time, time), &x, here);
    let ulps = M::S::lit(ULPS) * M::S::EPSILON * time.abs();
    let mut slopes = None;
    for i in (0..M::G::LEN).filter(|i| asked & bit(*i) != 0) {
        let size = here.at(i).abs();
        // The time of an event is as exact as rounding leaves it: so far the state may have gone.
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
            boundary.decided |= bit(i);
        } else if context.system.must_hold(i) {
            return Err(not_met(context, i, here));
        } else {
            let before = (context.held, context.x);
            context.system.switch(time, &mut context.held, &mut context.x, i)?;
            // Where neither side leads away from the boundary, the value decides.
            if let Some(turned) = rates(context).filter(|turned| turned.at(i) > M::S::ZERO) {
                boundary.decided |= bit(i);
                boundary.switched |= bit(i);
                slopes = Some(turned);
            } else {
                (context.held, context.x) = before;
            }
        }
    }
    Ok(boundary)
}

/// One step that ends at a time within the interval at the latest.
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

/// Makes a step again that ends where a requirement stops to hold, until its guard vanishes there but for rounding: the dense output
/// by which it was located is less exact than a step, and from the state at which it ends a run may begin. Whether it has come there.
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

/// What became of the end of a step that a guard has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refined {
    /// It is where the guard vanishes, as far as a short way leads there.
    Here,
    /// It is too far from there for that: the step has to be made again.
    Far,
}

/// Moves the end of a step that a guard has ended to where that guard vanishes. The dense output by which the time was located is less
/// exact than the step, by much where a row of contact comes slowly. The way is so short that the midpoint rule leads there.
///
/// The state is projected first: gaps that close at one moment because others are closed would do so one after the other by the drift of
/// those, and a row that opens would keep its drift as a gap.
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
    // False for what is not a number.
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

/// How fast each guard changes at the state, per second; none where there is no rate.
pub(super) fn rates<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<M::G> {
    rates_of_both(context).map(|(_, slopes)| slopes)
}

/// How fast the state and each guard change.
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
    // By a difference, where a system cannot say.
    let h = M::S::EPSILON.sqrt() * (M::S::lit(1.0) + time.abs());
    let ahead = x.map2(&rate, |x, rate| x + h * rate);
    let guards = |t, x| guards(context.system, t, &context.held, x);
    let (here, ahead) = (guards(time, &x), guards(time + h, &ahead));
    Some((rate, ahead.map2(&here, |ahead, here| (ahead - here) / h)))
}
