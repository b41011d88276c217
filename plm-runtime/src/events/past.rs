//! Conditions that are past their guards.

use super::border::Border;
use super::heeded::bit;
use super::{guards, guards_here, hold, is_below, is_past, switch_each};
use crate::fault::{Cause, Fault};
use crate::method::Course;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// What has switched.
pub(super) struct Switched {
    /// One bit for each condition.
    pub(super) conditions: u64,
    /// How many times.
    pub(super) count: u32,
}

/// Holds the other sides of conditions that are past their guards `here`, at the state reached; gives those
/// that switched. Where a step led there, no row may jump by it. What a change from outside asks for is taken as it is, but for what has
/// been decided on the `border`, and those are not violated again that were `left_over`.
pub(super) fn hold_past<M: System<S: Real>>(
    course: &mut Course<'_, M>,
    here: &M::G,
    (border, left_over): (Option<Border>, M::G),
) -> Result<Option<Switched>, Fault> {
    let decided = border.map_or(0, |border| border.decided);
    let edge = |i: usize| if decided & bit(i) == 0 { left_over.at(i) } else { -M::S::INFINITY };
    let edges = M::G::from_fn(edge);
    let beyond = |i: &usize| is_below(course.system, here, &edges, *i);
    let mut any = false;
    for index in (0..M::G::LEN).filter(beyond) {
        any = true;
        match border {
            None => required(course, index)?,
            Some(_) if course.system.must_hold(index) => return Err(not_met(course, index, here)),
            Some(_) => {}
        }
    }
    if !any {
        return Ok(None);
    }
    let (mut after, mut x) = (course.held, course.x);
    let mut switched = Switched { conditions: 0, count: 0 };
    switch_each((course.system, edges), course.time, &mut after, &mut x, |index| {
        switched.conditions |= bit(index);
        switched.count += 1;
    })?;
    if border.is_none() {
        hold(course, after)?;
    }
    (course.held, course.x) = (after, x);
    Ok(Some(switched))
}

/// The same at the end of a step by itself.
#[inline]
pub(crate) fn switch_past<M: System<S: Real>>(course: &mut Course<'_, M>) -> Result<(), Fault> {
    if M::G::LEN == 0 {
        return Ok(());
    }
    let here = guards_here(course)?;
    hold_past(course, &here, (None, M::G::fill(M::S::ZERO))).map(|_| ())
}

/// Is no condition past its guard at a state?
#[inline]
pub(crate) fn are_quiet<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> bool {
    let here = guards(system, t, held, x);
    here.is_finite() && (0..M::G::LEN).all(|i| !is_past(system, &here, i))
}

/// The end of a run whose requirement `index` is not met any more, or that has come to a pole or the end of a
/// domain.
pub(super) fn required<M: System<S: Real>>(course: &Course<'_, M>, index: usize) -> Result<(), Fault> {
    let (time, name) = (course.time.to_f64(), course.system.guard_name(index));
    if course.system.must_hold(index) {
        return Err(Fault::of_part(time, name, Cause::Required));
    }
    course.system.end(index).map_or(Ok(()), |cause| Err(Fault::of_part(time, name, cause)))
}

/// The fault of a requirement that is not met where a run begins, or goes on after a change from outside.
pub(super) fn not_met<M: System<S: Real>>(course: &Course<'_, M>, index: usize, here: &M::G) -> Fault {
    let cause = Cause::NotMet { by: -here.at(index).to_f64() };
    Fault::of_part(course.time.to_f64(), course.system.guard_name(index), cause)
}
