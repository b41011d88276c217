//! The functions of FMI on an instance behind a pointer.
//!
//! Every function checks its arguments; if they are wrong, it gives an error with a log message and changes nothing. Those of 3.0 stand in
//! this
//! module and those below; [`two`] has what 2.0 writes otherwise.

mod listener;
mod states;
mod steps;
pub mod two;
mod values;

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::ffi::{CStr, c_char};
use core::mem::{Discriminant, discriminant};
use core::{fmt, slice};

use plm_runtime::{Cause, Notice};

pub use self::listener::{Listener, Log, Log2};
pub use self::states::{deserialize, forget, restore, save, serialize, serialized_size};
pub use self::steps::{complete, do_step, update};
pub use self::values::{Given, count, get, get_integers, give, set, set_integers, set_states, tangents};
pub use crate::ffi::put;

use super::method::NoMethod;
use super::mode::NotAllowed;
use super::{Call, Exchanged, Instance, Interface, Mode, Steps, Version, token};
use crate::{Error, Status};

use self::listener::Severity;

/// `fmi3Status`, `fmi2Status`
pub type Outcome = i32;
const OK: Outcome = 0;
const WARNING: Outcome = 1;
const DISCARD: Outcome = 2;
const ERROR: Outcome = 3;

/// The instance as a simulator holds it.
#[repr(C)]
pub struct Handle<M: Exchanged> {
    /// Identifies instances in other memory.
    mark: u64,
    instance: Instance<M>,
    /// Steps of co-simulation may return at events.
    returns_early: bool,
    listener: Listener,
    /// Notices that were reported.
    told: Vec<Discriminant<Notice>>,
}

const MARK: u64 = 0x706c_6d5f_666d_6933;

/// Makes an instance; null where the token is that of another FMU.
///
/// # Safety
/// `own` is null or a text that ends with a zero; `listener` may be called.
pub unsafe fn instantiate<M: Exchanged>(
    (declared, steps): (M, Steps<M>),
    own: *const c_char,
    (interface, returns_early): (Interface, bool),
    listener: Listener,
) -> *mut Handle<M> {
    // SAFETY: the caller's part.
    let is_own =
        !own.is_null() && unsafe { CStr::from_ptr(own) }.to_bytes() == token::<M>().as_str().as_bytes();
    if !is_own {
        // SAFETY: the caller's part.
        unsafe { listener.tell(Severity::Error, "the instantiation token is that of another FMU") };
        return core::ptr::null_mut();
    }
    let instance = Instance::with_steps(declared, steps, interface);
    let handle = Handle { mark: MARK, instance, returns_early, listener, told: Vec::new() };
    Box::into_raw(Box::new(handle))
}

/// Ends an instance.
///
/// # Safety
/// `handle` is null or an instance that was not freed.
pub unsafe fn free<M: Exchanged>(handle: *mut Handle<M>) {
    if !handle.is_null() {
        // SAFETY: the caller's part.
        drop(unsafe { Box::from_raw(handle) });
    }
}

/// Why a function did nothing.
trait Reason: fmt::Display {
    /// May another state do where a solver outside has led to this one?
    fn is_of_state(&self) -> bool {
        false
    }
}

impl Reason for Error {
    /// Not where the mechanism has no coordinates, or no memory.
    fn is_of_state(&self) -> bool {
        let Self::Fault(fault) = self else { return false };
        !matches!(fault.cause, Cause::NotRegular | Cause::Workspace { .. } | Cause::NotAllowed { .. })
    }
}

impl Reason for NoMethod {}

/// A solver outside may have gone too far: a shorter step leads to other states. In 2.0 a completed step cannot be discarded (2.1.3);
/// what was asked for at its end is before.
fn severity(reason: &impl Reason, version: Version, call: Option<Call>, mode: Mode) -> Severity {
    let is_final = version == Version::Two && call == Some(Call::CompletedIntegratorStep);
    let is_discarded = mode == Mode::ContinuousTime && !is_final && reason.is_of_state();
    if is_discarded { Severity::Discard } else { Severity::Error }
}

/// Lets `work` at an instance; `call` names a function that only some modes allow.
///
/// # Safety
/// `handle` is null or an instance that no other thread uses meanwhile.
pub unsafe fn with<M: Exchanged>(
    handle: *mut Handle<M>,
    call: impl Into<Option<Call>>,
    work: impl FnOnce(&mut Instance<M>) -> Result<(), Error>,
) -> Outcome {
    // SAFETY: as this function's.
    unsafe { opened(handle, call.into(), |handle| work(&mut handle.instance)) }
}

/// Lets `work` at an instance and what belongs to it.
///
/// # Safety
/// As of [`with`].
unsafe fn opened<M: Exchanged, R: Reason>(
    handle: *mut Handle<M>,
    call: Option<Call>,
    work: impl FnOnce(&mut Handle<M>) -> Result<(), R>,
) -> Outcome {
    // SAFETY: it is not null, and aligned; the mark is its first field.
    if handle.is_null() || !handle.is_aligned() || unsafe { handle.cast::<u64>().read() } != MARK {
        return ERROR;
    }
    // SAFETY: the mark is written by `instantiate` alone, with all the rest.
    let handle = unsafe { &mut *handle };
    let Instance { interface, mode, .. } = handle.instance;
    let version = handle.listener.version();
    if let Some(call) = call.filter(|call| !call.is_allowed(version, interface, mode)) {
        let words = NotAllowed(version, call, interface, mode);
        // SAFETY: the simulator gave the listener.
        unsafe { handle.listener.tell(Severity::Error, words) };
        return ERROR;
    }
    match work(handle) {
        Ok(()) => {
            if let Some(call) = call {
                handle.instance.pass(call);
            }
            let is_known = |notice: &Notice| handle.told.contains(&discriminant(notice));
            let goes_on = matches!(call, Some(Call::UpdateDiscreteStates | Call::DoStep));
            let notice = handle.instance.notice().filter(|notice| goes_on && !is_known(notice));
            if let Some(notice) = notice {
                handle.told.push(discriminant(&notice));
                // SAFETY: the simulator gave the listener.
                unsafe { handle.listener.tell(Severity::Warning, notice) };
            }
        }
        Err(reason) => {
            let severity = severity(&reason, version, call, mode);
            // SAFETY: the simulator gave the listener.
            unsafe { handle.listener.tell(severity, reason) };
            return severity.outcome();
        }
    }
    OK
}

/// A function for what a mechanism does not have.
///
/// # Safety
/// As of [`with`].
pub unsafe fn absent<M: Exchanged>(handle: *mut Handle<M>, name: &str) -> Outcome {
    let work = |handle: &mut Handle<M>| {
        let words = format_args!("{name}: this FMU has nothing of that kind");
        // SAFETY: the simulator gave the listener.
        unsafe { handle.listener.tell(Severity::Error, words) };
        Ok::<_, Error>(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, None, work) };
    ERROR
}

/// `fmi3SetDebugLogging`: messages of these categories, of all where none is named.
///
/// # Safety
/// As of [`with`]; `categories` is null or an array of the caller, of texts that end with a zero.
pub unsafe fn hear<M: Exchanged>(
    handle: *mut Handle<M>,
    is_heard: bool,
    (categories, count): (*const *const c_char, usize),
) -> Outcome {
    let work = |handle: &mut Handle<M>| {
        // SAFETY: the caller's part.
        let named = unsafe { read(categories, count)? };
        let mut all = Vec::new();
        for name in named {
            // SAFETY: the caller's part.
            let own = (!name.is_null()).then(|| unsafe { CStr::from_ptr(*name) }).and_then(Severity::of);
            all.push(own.ok_or(Status::NoSuch)?);
        }
        handle.listener.hear(is_heard, if all.is_empty() { &Severity::ALL } else { &all });
        Ok::<_, Error>(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, None, work) }
}

/// Numbers of the caller, to be read.
///
/// # Safety
/// `at` is null or at as many of the caller.
unsafe fn read<'a, T>(at: *const T, count: usize) -> Result<&'a [T], Error> {
    match count {
        0 => Ok(&[]),
        _ if at.is_null() => Err(Status::Null.into()),
        _ if !at.is_aligned() => Err(Status::Memory.into()),
        // SAFETY: it is not null, aligned, and the caller's.
        _ => Ok(unsafe { slice::from_raw_parts(at, count) }),
    }
}

/// Writes numbers to room of the caller for exactly as many; the room may be uninitialised.
///
/// # Safety
/// `at` is null or at room of the caller for `count` numbers.
unsafe fn fill<T: Copy>((at, count): (*mut T, usize), values: &[T]) -> Result<(), Error> {
    if count != values.len() {
        return Err(Status::NoSuch.into());
    }
    for (index, value) in values.iter().enumerate() {
        // SAFETY: there is room for as many; `put` reports null.
        unsafe { put(if at.is_null() { at } else { at.add(index) }, *value)? };
    }
    Ok(())
}
