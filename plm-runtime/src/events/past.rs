//! Switching at the end of a step by itself.

use super::{guards_here, hold, is_past, required, switch_where_due};
use crate::fault::Fault;
use crate::method::Course;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Holds the sides of conditions that are past their guards at the state reached.
#[inline]
pub(crate) fn switch_past<M: System<S: Real>>(course: &mut Course<'_, M>) -> Result<(), Fault> {
    if M::G::LEN == 0 {
        return Ok(());
    }
    let here = guards_here(course)?;
    for index in (0..M::G::LEN).filter(|i| is_past(course.system, &here, *i)) {
        required(course, index)?;
    }
    let mut after = course.held;
    if switch_where_due(course.system, course.time, &mut after, &course.x) > 0 {
        hold(course, after)?;
    }
    Ok(())
}
