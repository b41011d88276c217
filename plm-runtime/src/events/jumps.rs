//! Where constraint rows would have to jump, and where a pole or the end of a domain is met.

use super::border::rates;
use super::past::required;
use super::{guards_here, switch_where_due};
use crate::fault::{Cause, Fault};
use crate::method::Course;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A step that came to nothing this near before a pole or the end of a domain, in s and as a part of the time, came to nothing there.
const SOON: f64 = 1e-6;

/// Goes on with the sides of `after`, unless constraint rows would have to jump.
pub(crate) fn hold<M: System<S: Real>>(course: &mut Course<'_, M>, after: M::U) -> Result<(), Fault> {
    if let Some(fault) = course.system.jump(course.time, &course.held, &course.x, Some(&after)) {
        return Err(fault);
    }
    course.held = after;
    Ok(())
}

/// The fault of a step that came to nothing, or of what jumps there: joints that would have to jump come apart.
#[cold]
pub(crate) fn at_a_jump<M: System<S: Real>>(course: &mut Course<'_, M>, fault: Fault) -> Fault {
    match fault.cause {
        Cause::StepTooSmall { .. }
        | Cause::Drift { .. }
        | Cause::TooManySteps { .. }
        | Cause::Singular { .. }
        | Cause::Workspace { .. }
        | Cause::NotFinite => {
            let jump = course.system.jump(course.time, &course.held, &course.x, None);
            jump.or_else(|| end_ahead(course)).unwrap_or(fault)
        }
        _ => fault,
    }
}

/// The fault of a pole, or of the end of a domain, that the state would come to at once.
fn end_ahead<M: System<S: Real>>(course: &mut Course<'_, M>) -> Option<Fault> {
    let ends = |i: &usize| course.system.end(*i).is_some() && course.system.matters(&course.held, *i, 0);
    let first = (0..M::G::LEN).find(ends)?;
    let (here, slopes) = (guards_here(course).ok()?, rates(course)?);
    let soon = M::S::lit(SOON) * (M::S::lit(1.0) + course.time.abs());
    let due = |i: &usize| here.at(*i).abs() <= -soon * slopes.at(*i) && course.system.end(*i).is_some();
    let index = (first..M::G::LEN).find(due)?;
    required(course, index).err()
}

/// A step that has led over a jump of rows is not settled: what is off the rows there is the jump, and no drift.
pub(crate) fn before_settling<M: System<S: Real>>(
    course: &Course<'_, M>,
    t: M::S,
    x: &M::X,
) -> Result<(), Fault> {
    let (mut after, mut beyond) = (course.held, *x);
    if M::G::LEN == 0 || switch_where_due(course.system, t, &mut after, &mut beyond)? == 0 {
        return Ok(());
    }
    course.system.jump(t, &course.held, x, Some(&after)).map_or(Ok(()), Err)
}
