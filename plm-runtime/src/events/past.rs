//! Conditions that are past their guards.

use super::{guards, guards_here, hold, is_past, required, switch_where_due};
use crate::fault::Fault;
use crate::method::Course;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Holds the other sides of conditions that are past their guards `here`, at the state reached: the first of them, and how many
/// switched. Where a step led there, no row may jump by it; what a change from outside asks for is taken as it is.
pub(super) fn hold_past<M: System<S: Real>>(
    course: &mut Course<'_, M>,
    here: &M::G,
    by_step: bool,
) -> Result<Option<(usize, u32)>, Fault> {
    let Some(first) = (0..M::G::LEN).find(|i| is_past(course.system, here, *i)) else { return Ok(None) };
    for index in (first..M::G::LEN).filter(|i| is_past(course.system, here, *i)) {
        required(course, index)?;
    }
    let mut after = course.held;
    let switched = switch_where_due(course.system, course.time, &mut after, &course.x);
    if by_step {
        hold(course, after)?;
    }
    course.held = after;
    Ok(Some((first, switched)))
}

/// The same at the end of a step by itself.
#[inline]
pub(crate) fn switch_past<M: System<S: Real>>(course: &mut Course<'_, M>) -> Result<(), Fault> {
    if M::G::LEN == 0 {
        return Ok(());
    }
    let here = guards_here(course)?;
    hold_past(course, &here, true).map(|_| ())
}

/// Is no condition past its guard at a state?
#[inline]
pub(crate) fn are_quiet<M: System<S: Real>>(system: &M, t: M::S, held: &M::U, x: &M::X) -> bool {
    let here = guards(system, t, held, x);
    here.is_finite() && (0..M::G::LEN).all(|i| !is_past(system, &here, i))
}
