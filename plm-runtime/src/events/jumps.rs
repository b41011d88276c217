//! Jumps of constraint rows, poles, and ends of domains.

use super::boundary::rates;
use super::violated::required;
use super::{guards_here, switch_where_due};
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Time, in s and as a part of the time, before a pole or the end of a domain within which a failed step is attributed to it.
const SOON: f64 = 1e-6;

/// Continues with the sides of `after`, unless constraint rows would have to jump.
pub(crate) fn hold<M: System<S: Real>>(context: &mut Context<'_, M>, after: M::U) -> Result<(), Fault> {
    if let Some(fault) = context.system.jump(context.time, &context.held, &context.x, Some(&after)) {
        return Err(fault);
    }
    context.held = after;
    Ok(())
}

/// Fault of a failed step, or that of a jump or of an end there: joints that would have to jump come apart.
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

/// Fault of a pole, or of the end of a domain, that the state would reach at once.
fn end_ahead<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<Fault> {
    let ends = |i: &usize| context.system.end(*i).is_some() && context.system.matters(&context.held, *i, 0);
    let first = (0..M::G::LEN).find(ends)?;
    let (here, slopes) = (guards_here(context).ok()?, rates(context)?);
    let soon = M::S::lit(SOON) * (M::S::lit(1.0) + context.time.abs());
    let due = |i: &usize| here.at(*i).abs() <= -soon * slopes.at(*i) && context.system.end(*i).is_some();
    let index = (first..M::G::LEN).find(due)?;
    required(context, index).err()
}

/// Refuses to project a step that has crossed a jump of rows: its distance from the rows is the jump, and no drift.
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
