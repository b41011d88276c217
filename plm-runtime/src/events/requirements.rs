//! Guards that end a run: requirements, poles, ends of domains, jumps of constraint rows.

use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Ends a run whose requirement `index` is no longer satisfied, or that has come to a pole or the end of a domain.
pub(super) fn required<M: System<S: Real>>(context: &Context<'_, M>, index: usize) -> Result<(), Fault> {
    let (time, name) = (context.time.to_f64(), context.system.guard_name(index));
    if context.system.must_hold(index) {
        return Err(Fault::of_part(time, name, Cause::Required));
    }
    context.system.end(index).map_or(Ok(()), |cause| Err(Fault::of_part(time, name, cause)))
}

/// Fault of a guard that is undecided in a step from a time on; at a pole or the end of a domain, the end of the run there.
#[cold]
pub(super) fn undecided<M: System<S: Real>>(system: &M, time: M::S, index: usize) -> Fault {
    let cause = system.end(index).unwrap_or(Cause::NotDecided);
    Fault::of_part(time.to_f64(), system.guard_name(index), cause)
}

/// Fault of a requirement that is not satisfied at the start of a run, or after a change by the caller.
pub(super) fn not_met<M: System<S: Real>>(context: &Context<'_, M>, index: usize, here: &M::G) -> Fault {
    let cause = Cause::NotMet { by: -here.at(index).to_f64() };
    Fault::of_part(context.time.to_f64(), context.system.guard_name(index), cause)
}

/// Continues with the sides of `after`, unless constraint rows would have to jump.
pub(crate) fn hold<M: System<S: Real>>(context: &mut Context<'_, M>, after: M::U) -> Result<(), Fault> {
    if let Some(fault) = context.system.jump(context.time, &context.held, &context.x, Some(&after)) {
        return Err(fault);
    }
    context.held = after;
    Ok(())
}
