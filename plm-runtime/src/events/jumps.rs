//! Where constraint rows would have to jump.

use crate::fault::{Cause, Fault};
use crate::method::Course;
use crate::scalar::Real;
use crate::system::System;

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
pub(crate) fn at_a_jump<M: System<S: Real>>(course: &Course<'_, M>, fault: Fault) -> Fault {
    match fault.cause {
        Cause::StepTooSmall { .. }
        | Cause::Drift { .. }
        | Cause::TooManySteps { .. }
        | Cause::Singular { .. }
        | Cause::Workspace { .. } => {
            course.system.jump(course.time, &course.held, &course.x, None).unwrap_or(fault)
        }
        _ => fault,
    }
}
