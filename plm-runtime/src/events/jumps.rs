//! Steps that fail at a jump of constraint rows, at a pole, or at the end of a domain.

use super::guards_here;
use super::rates::rates;
use super::requirements::required;
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::tolerances::SOON;
use crate::vector::Vector;

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
    let soon = SOON.of::<M::S>() * (M::S::lit(1.0) + context.time.abs());
    let due = |i: &usize| here.at(*i).abs() <= -soon * slopes.at(*i) && context.system.end(*i).is_some();
    let index = (first..M::G::LEN).find(due)?;
    required(context, index).err()
}
