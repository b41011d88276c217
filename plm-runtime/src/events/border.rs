//! Guards that are zero but for rounding where a run begins, or goes on after a change from outside: their rates decide on which
//! side it is.

use super::heeded::bit;
use super::past::not_met;
use super::search::{ULPS, rounding};
use super::{advance_to, guards, guards_here};
use crate::fault::Fault;
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::sim::Begun;
use crate::system::System;
use crate::tube::{Interval, Tube};
use crate::vector::Vector;

/// Beyond so many times its rounding no guard is zero, whatever its rate.
const FAR: f64 = 1e6;
/// Steps that are made again at most to end where a requirement does.
const MOST_AGAIN: u32 = 4;

/// What was found on the boundary.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Border {
    /// Conditions whose sides have been decided, one bit each: rounding is not asked again.
    pub(super) decided: u64,
    /// Those that have changed their sides.
    pub(super) switched: u64,
}

/// Decides the sides of the conditions on whose boundary the state is, of the first 64: where the rate leads. In a run that is
/// under way only those are asked that seem to be beyond. A requirement that the rate leads away from is not met.
pub(super) fn decide<M: System<S: Real>>(
    course: &mut Course<'_, M>,
    here: &M::G,
    is_new: bool,
) -> Result<Border, Fault> {
    let mut border = Border::default();
    let has_band = |i: usize| course.system.band(i) > M::S::ZERO;
    let asks = |i: usize| bit(i) != 0 && !has_band(i) && (is_new || here.at(i) <= M::S::ZERO);
    let asked = (0..M::G::LEN).filter(|i| asks(*i)).fold(0, |asked, i| asked | bit(i));
    if asked == 0 || !course.system.is_regular(&course.held) {
        return Ok(border);
    }
    let (time, x) = (course.time, course.x);
    let noise = rounding((course.system, &course.held), (time, time), &x, here);
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
            None => match rates(course) {
                Some(found) => *slopes.insert(found),
                None => return Ok(border),
            },
        };
        let slope = slope.at(i);
        if size > reach(slope) {
            continue;
        }
        if slope >= M::S::ZERO {
            border.decided |= bit(i);
        } else if course.system.must_hold(i) {
            return Err(not_met(course, i, here));
        } else {
            let before = (course.held, course.x);
            course.system.switch(time, &mut course.held, &mut course.x, i)?;
            // Where neither side leads away from the boundary, the value decides.
            if let Some(turned) = rates(course).filter(|turned| turned.at(i) > M::S::ZERO) {
                border.decided |= bit(i);
                border.switched |= bit(i);
                slopes = Some(turned);
            } else {
                (course.held, course.x) = before;
            }
        }
    }
    Ok(border)
}

/// Makes a step again that ends where a requirement stops to hold, until its guard vanishes there but for rounding: the dense output
/// by which it was located is less exact than a step, and from the state at which it ends a run may begin. Whether it has come there.
pub(super) fn meet<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (before, start): (&I, &Begun<M>),
    index: usize,
) -> Result<bool, Fault> {
    for _ in 0..MOST_AGAIN {
        let here = guards_here(course)?;
        let noise = rounding((course.system, &course.held), (course.time, course.time), &course.x, &here);
        let Some(slopes) = rates(course).filter(|_| here.at(index).abs() > noise.at(index)) else { break };
        let time = course.time - here.at(index) / slopes.at(index);
        if !(time > start.time && time < course.end) {
            break;
        }
        let reached = (*method, course.time, course.held, course.x);
        (*method, course.time, course.held, course.x) = (*before, start.time, start.held, start.x);
        course.stats.steps -= 1;
        course.stats.rejected += 1;
        advance_to(method, course, time)?;
        if course.time < time {
            return Ok(false);
        }
        if guards_here(course)?.at(index).abs() >= here.at(index).abs() {
            (*method, course.time, course.held, course.x) = reached;
            break;
        }
    }
    Ok(true)
}

/// How fast each guard changes at the state, per second; none where there is no rate.
pub(super) fn rates<M: System<S: Real>>(course: &mut Course<'_, M>) -> Option<M::G> {
    let (time, x) = (course.time, course.x);
    let mut rate = x;
    course.rate(time, &x, &mut rate).ok()?;
    let moving = |s: M::S, slope: M::S| Tube { slope: Interval::point(slope), ..Tube::constant(s) };
    let mut slopes = M::G::fill(M::S::ZERO);
    let known = course.system.guards_within(
        moving(time, M::S::lit(1.0)),
        &course.held,
        &|i| moving(x.at(i), rate.at(i)),
        &mut |i, tube| {
            let Interval { low, high } = tube.slope;
            if i < M::G::LEN {
                slopes.set(i, M::S::lit(0.5) * (low + high));
            }
        },
    );
    if known {
        return Some(slopes);
    }
    // By a difference, where a system cannot say.
    let h = M::S::EPSILON.sqrt() * (M::S::lit(1.0) + time.abs());
    let ahead = x.map2(&rate, |x, rate| x + h * rate);
    let [here, ahead] =
        [(time, &x), (time + h, &ahead)].map(|(t, x)| guards(course.system, t, &course.held, x));
    Some(ahead.map2(&here, |ahead, here| (ahead - here) / h))
}
