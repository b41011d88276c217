//! Steps: of a solver outside, of co-simulation, and the events between them.

use super::{Handle, Outcome, opened, put, with};
use crate::fmi::{Call, Exchanged, Instance, Update, Variable};
use crate::{Error, Status};

/// `fmi3UpdateDiscreteStates`; `flags`: more updates are needed, the simulation ends, nominals changed, states changed, a time
/// is known.
///
/// # Safety
/// As of [`with`]; the pointers are null or the caller's.
pub unsafe fn update<M: Exchanged>(handle: *mut Handle<M>, flags: [*mut bool; 5], next: *mut f64) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        if flags.contains(&core::ptr::null_mut()) || next.is_null() {
            return Err(Status::Null.into());
        }
        let Update { states_changed, next: time } = instance.update()?;
        let values = [false, false, states_changed, states_changed, time.is_some()];
        for (flag, value) in flags.into_iter().zip(values) {
            // SAFETY: the caller's part.
            unsafe { put(flag, value)? };
        }
        // SAFETY: the caller's part.
        unsafe { put(next, time.unwrap_or_default()) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::UpdateDiscreteStates, work) }
}

/// `fmi3DoStep`; `flags`: an event is to be handled, the simulation ends, it returned early.
///
/// # Safety
/// As of [`update`].
pub unsafe fn do_step<M: Exchanged>(
    handle: *mut Handle<M>,
    (from, length): (f64, f64),
    flags: [*mut bool; 3],
    last: *mut f64,
) -> Outcome {
    let work = |handle: &mut Handle<M>| {
        if flags.contains(&core::ptr::null_mut()) || last.is_null() {
            return Err(Error::from(Status::Null));
        }
        let instance = &mut handle.instance;
        let now = instance.get(Variable::Time)?;
        // The simulator adds up its own times.
        let agrees = (from - now).abs() <= 1e-9 * length.abs().max(now.abs()).max(1e-9);
        if !agrees {
            return Err(Status::Interval.into());
        }
        let event = instance.step_to(from + length, handle.returns_early)?;
        for (flag, value) in flags.into_iter().zip([event, false, event]) {
            // SAFETY: the caller's part.
            unsafe { put(flag, value)? };
        }
        // SAFETY: the caller's part.
        unsafe { put(last, instance.get(Variable::Time)?) }
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, Some(Call::DoStep), work) }
}

/// `fmi3CompletedIntegratorStep`; `flags`: an event is to follow, the simulation ends.
///
/// # Safety
/// As of [`update`].
pub unsafe fn complete<M: Exchanged>(handle: *mut Handle<M>, flags: [*mut bool; 2]) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        if flags.contains(&core::ptr::null_mut()) {
            return Err(Status::Null.into());
        }
        let follows = instance.accept()?;
        for (flag, value) in flags.into_iter().zip([follows, false]) {
            // SAFETY: the caller's part.
            unsafe { put(flag, value)? };
        }
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::CompletedIntegratorStep, work) }
}
