//! Where constraint rows would have to jump, and where a pole or the end of a domain is met.

use super::boundary::rates;
use super::violated::required;
use super::{guards_here, switch_where_due};
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A step that came to nothing this near before a pole or the end of a domain, in s and as a part of the time, came to nothing there.
const SOON: f64 = 1e-6;

/// Goes on with the sides of `after`, unless constraint rows would have to jump.
pub(crate) fn hold<M: System<S: Real>>(context: &mut Context<'_, M>, after: M::U) -> Result<(), Fault> {
    if let Some(fault) = context.system.jump(context.time, &context.held, &context.x, Some(&after)) {
        return Err(fault);
    }
    context.held = after;
    Ok(())
}

/// The fault of a step that came to nothing, or of what jumps there: joints that would have to jump come apart.
#[cold]
pub(crate) fn at_a_jump<M: System<S: Real>>(context: &mut Context<'_, M>, fault: Fault) -> Fault {
    match fault.cause {
        Cause::StepTooSmall { .. }
        | Cause::Drift { .. }
        | Cause::TooManySteps { .. }
        | Cause::Singular { .. }
        | Cause::Workspace { .. }
        | Cause::NotFinite => {
            let jump = context.system.jump(context.time, &context.held, &context.x, None);
            jump.or_else(|| end_ahead(context)).unwrap_or(fault)
        }
        _ => fault,
    }
}

/// The fault of a pole, or of the end of a domain, that the state would come to at once.
fn end_ahead<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<Fault> {
    let ends = |i: &usize| context.system.end(*i).is_some() && context.system.matters(&context.held, *i, 0);
    let first = (0..M::G::LEN).find(ends)?;
    let (here, slopes) = (guards_here(context).ok()?, rates(context)?);
    let soon = M::S::lit(SOON) * (M::S::lit(1.0) + context.time.abs());
    let due = |i: &usize| here.at(*i).abs() <= -soon * slopes.at(*i) && context.system.end(*i).is_some();
    let index = (first..M::G::LEN).find(due)?;
    required(context, index).err()
}

/// A step that has led over a jump of rows is not projected: what is off the rows there is the jump, and no drift.
pub(crate) fn before_projection<M: System<S: Real>>(
    context: &Context<'_, M>,
    t: M::S,
    x: &M::X,
) -> Result<(), Fault> {
    let (mut after, mut beyond) = (context.held, *x);
    if context.system.guard_count() == 0 || switch_where_due(context.system, t, &mut after, &mut beyond)? == 0
    {
        return Ok(());
    }
    context.system.jump(t, &context.held, x, Some(&after)).map_or(Ok(()), Err)
}
