//! Differences of FMI 2.0: flags are whole numbers, and the result of an event is one structure.

use core::ffi::{CStr, c_char, c_int, c_void};

use super::listener::Log2;
use super::{Handle, Listener, OK, Outcome, complete, do_step, instantiate, put, update, with};
use crate::fmi::{Call, Exchanged, Instance, Interface, Steps, Variable};
use crate::{Error, Status};

/// `fmi2Boolean`
pub type Flag = c_int;

/// `fmi2CallbackFunctions`
#[repr(C)]
pub struct Functions {
    logger: Log2,
    allocate: *const c_void,
    free: *const c_void,
    finished: *const c_void,
    environment: *mut c_void,
}

/// `fmi2EventInfo`
#[repr(C)]
#[derive(Clone, Copy)]
pub struct EventInfo {
    flags: [Flag; 5],
    next: f64,
}

/// `fmi2Instantiate`; `kind` 0: model exchange, 1: co-simulation.
///
/// # Safety
/// As of [`instantiate`]; `name` and `functions` are null or the caller's.
pub unsafe fn instantiate_two<M: Exchanged>(
    declared: (M, Steps<M>),
    (name, own): (*const c_char, *const c_char),
    kind: c_int,
    functions: *const Functions,
) -> *mut Handle<M> {
    // SAFETY: the caller's part.
    let Some(functions) = (unsafe { functions.as_ref() }) else { return core::ptr::null_mut() };
    // SAFETY: the caller's part.
    let name = if name.is_null() { c"" } else { unsafe { CStr::from_ptr(name) } };
    let listener = Listener::two(functions.logger, functions.environment, name);
    let interface = match kind {
        0 => Interface::ModelExchange,
        1 => Interface::CoSimulation { has_events: false },
        _ => return core::ptr::null_mut(),
    };
    // SAFETY: the caller's part.
    unsafe { instantiate(declared, own, (interface, false), listener) }
}

/// `fmi2NewDiscreteStates`
///
/// # Safety
/// As of [`update`]; `info` is null or the caller's.
pub unsafe fn new_discrete_states<M: Exchanged>(handle: *mut Handle<M>, info: *mut EventInfo) -> Outcome {
    let (mut flags, mut next) = ([false; 5], 0.0);
    // SAFETY: null is reported, and nothing done.
    let places =
        if info.is_null() { [core::ptr::null_mut(); 5] } else { flags.each_mut().map(core::ptr::from_mut) };
    // SAFETY: the caller's part; the flags are this function's.
    let outcome = unsafe { update(handle, places, &raw mut next) };
    if outcome == OK {
        // SAFETY: the caller's part.
        unsafe { info.write_unaligned(EventInfo { flags: flags.map(Flag::from), next }) };
    }
    outcome
}

/// `fmi2CompletedIntegratorStep`
///
/// # Safety
/// As of [`complete`].
pub unsafe fn complete_two<M: Exchanged>(handle: *mut Handle<M>, places: [*mut Flag; 2]) -> Outcome {
    let mut flags = [false; 2];
    let own = flags.each_mut().map(core::ptr::from_mut);
    let wanted = if places.contains(&core::ptr::null_mut()) { [core::ptr::null_mut(); 2] } else { own };
    // SAFETY: the caller's part; the flags are this function's.
    let outcome = unsafe { complete(handle, wanted) };
    if outcome == OK {
        for (place, flag) in places.into_iter().zip(flags) {
            // SAFETY: the caller's part.
            unsafe { place.write_unaligned(flag.into()) };
        }
    }
    outcome
}

/// `fmi2DoStep`
///
/// # Safety
/// As of [`do_step`].
pub unsafe fn do_step_two<M: Exchanged>(handle: *mut Handle<M>, times: (f64, f64)) -> Outcome {
    let (mut flags, mut last) = ([false; 3], 0.0);
    // SAFETY: the caller's part; the flags are this function's.
    unsafe { do_step(handle, times, flags.each_mut().map(core::ptr::from_mut), &raw mut last) }
}

/// `fmi2GetRealStatus`: the last time that was reached (2) is what there is.
///
/// # Safety
/// As of [`with`]; `value` is null or the caller's.
pub unsafe fn real_status<M: Exchanged>(handle: *mut Handle<M>, kind: c_int, value: *mut f64) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        let time = if kind == 2 { instance.get(Variable::Time)? } else { return none() };
        // SAFETY: the caller's part.
        unsafe { put(value, time) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::GetStatus, work) }
}

/// `fmi2GetBooleanStatus`: whether it has ended by itself (3), which it never does.
///
/// # Safety
/// As of [`real_status`].
pub unsafe fn flag_status<M: Exchanged>(handle: *mut Handle<M>, kind: c_int, value: *mut Flag) -> Outcome {
    let work = |_: &mut Instance<M>| match kind {
        // SAFETY: the caller's part.
        3 => unsafe { put(value, 0) },
        _ => none(),
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::GetStatus, work) }
}

fn none() -> Result<(), Error> {
    Err(Status::NoSuch.into())
}
