//! The functions of FMI on an instance behind a pointer.
//!
//! Every function looks at what it is given, gives an error with a log message, and changes nothing then.

mod states;

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::ffi::{CStr, c_char, c_void};
use core::{fmt, slice};

use plm_runtime::{System, Vector};

pub use self::states::{deserialize, forget, restore, save, serialize, serialized_size};
pub use crate::border::put;

use super::mode::NotAllowed;
use super::{Call, Exchanged, Instance, Interface, Update, Variable, token};
use crate::{Status, Text, Trouble};

/// `fmi3Status`
pub type Outcome = i32;
const OK: Outcome = 0;
const ERROR: Outcome = 3;

/// `fmi3LogMessageCallback`
pub type Log = Option<unsafe extern "C" fn(*mut c_void, Outcome, *const c_char, *const c_char)>;

/// What a simulator is given as an instance.
#[repr(C)]
pub struct Handle<M: Exchanged> {
    /// Tells instances from other memory.
    mark: u64,
    instance: Instance<M>,
    /// Steps of co-simulation may return at events.
    returns_early: bool,
    /// Messages are wanted.
    is_heard: bool,
    log: Log,
    environment: *mut c_void,
}

impl<M: Exchanged> Handle<M> {
    /// Tells the simulator what is wrong.
    fn tell(&self, what: impl fmt::Display) {
        if let Some(log) = self.log.filter(|_| self.is_heard) {
            // SAFETY: the simulator gave both.
            unsafe { log(self.environment, ERROR, CATEGORY.as_ptr(), Text::of(what).as_ptr()) };
        }
    }
}

/// The one category of messages.
const CATEGORY: &CStr = c"logStatusError";

const MARK: u64 = 0x706c_6d5f_666d_6933;

/// Makes an instance; null where the token is that of another FMU.
///
/// # Safety
/// `own` is null or a text that ends with a zero; `log` may be called with `environment`.
pub unsafe fn instantiate<M: Exchanged>(
    declared: M,
    own: *const c_char,
    (interface, returns_early): (Interface, bool),
    (log, environment): (Log, *mut c_void),
) -> *mut Handle<M> {
    // SAFETY: the caller's part.
    let is_own =
        !own.is_null() && unsafe { CStr::from_ptr(own) }.to_bytes() == token::<M>().as_str().as_bytes();
    if !is_own {
        let text = Text::of("the instantiation token is that of another FMU");
        if let Some(log) = log {
            // SAFETY: the caller's part.
            unsafe { log(environment, ERROR, CATEGORY.as_ptr(), text.as_ptr()) };
        }
        return core::ptr::null_mut();
    }
    let instance = Instance::new(declared, interface);
    let handle = Handle { mark: MARK, instance, returns_early, is_heard: true, log, environment };
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

/// Lets `work` at an instance; a function for some modes alone is told by `call`.
///
/// # Safety
/// `handle` is null or an instance that nobody else uses meanwhile.
pub unsafe fn with<M: Exchanged>(
    handle: *mut Handle<M>,
    call: impl Into<Option<Call>>,
    work: impl FnOnce(&mut Instance<M>) -> Result<(), Trouble>,
) -> Outcome {
    // SAFETY: as this function's.
    unsafe { opened(handle, call.into(), |handle| work(&mut handle.instance)) }
}

/// Lets `work` at an instance and what belongs to it.
///
/// # Safety
/// As of [`with`].
unsafe fn opened<M: Exchanged>(
    handle: *mut Handle<M>,
    call: Option<Call>,
    work: impl FnOnce(&mut Handle<M>) -> Result<(), Trouble>,
) -> Outcome {
    // SAFETY: it is not null, and aligned; the mark is its first field.
    if handle.is_null() || !handle.is_aligned() || unsafe { handle.cast::<u64>().read() } != MARK {
        return ERROR;
    }
    // SAFETY: the mark is written by `instantiate` alone, with all the rest.
    let handle = unsafe { &mut *handle };
    let Instance { interface, mode, .. } = handle.instance;
    if let Some(call) = call.filter(|call| !call.is_allowed(interface, mode)) {
        handle.tell(NotAllowed(call, interface, mode));
        return ERROR;
    }
    match work(handle) {
        Ok(()) => call.into_iter().for_each(|call| handle.instance.pass(call)),
        Err(trouble) => {
            handle.tell(trouble);
            return ERROR;
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
        handle.tell(format_args!("{name}: this FMU has nothing of that kind"));
        Ok(())
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
        for name in named {
            // SAFETY: the caller's part.
            if name.is_null() || unsafe { CStr::from_ptr(*name) } != CATEGORY {
                return Err(Status::NoSuch.into());
            }
        }
        handle.is_heard = is_heard;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { opened(handle, None, work) }
}

/// Numbers of the caller, to be read.
///
/// # Safety
/// `at` is null or at as many of the caller.
unsafe fn read<'a, T>(at: *const T, count: usize) -> Result<&'a [T], Trouble> {
    match count {
        0 => Ok(&[]),
        _ if at.is_null() => Err(Status::Null.into()),
        _ if !at.is_aligned() => Err(Status::Memory.into()),
        // SAFETY: it is not null, aligned, and the caller's.
        _ => Ok(unsafe { slice::from_raw_parts(at, count) }),
    }
}

/// Writes numbers to room of the caller for exactly as many; what is there may have no value yet.
///
/// # Safety
/// `at` is null or at room of the caller for `count` numbers.
unsafe fn fill((at, count): (*mut f64, usize), values: &[f64]) -> Result<(), Trouble> {
    if count != values.len() {
        return Err(Status::NoSuch.into());
    }
    for (index, value) in values.iter().enumerate() {
        // SAFETY: there is room for as many; null is told by `put`.
        unsafe { put(if at.is_null() { at } else { at.add(index) }, *value)? };
    }
    Ok(())
}

/// The variables of value references.
///
/// # Safety
/// As of [`read`].
unsafe fn variables<M: Exchanged>(
    of: &Instance<M>,
    (at, count): (*const u32, usize),
) -> Result<Vec<Variable>, Trouble> {
    // SAFETY: the caller's part.
    let references = unsafe { read(at, count)? };
    let found = references.iter().map(|reference| Variable::of(of.declared(), *reference));
    found.map(|found| found.ok_or(Status::NoSuch.into())).collect()
}

/// `fmi3GetFloat64`
///
/// # Safety
/// As of [`with`]; the arrays are null or the caller's.
pub unsafe fn get<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*mut f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let wanted = unsafe { variables(instance, references)? };
        let found: Result<Vec<f64>, _> = wanted.into_iter().map(|variable| instance.get(variable)).collect();
        // SAFETY: the caller's part.
        unsafe { fill(values, &found?) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::Get, work) }
}

/// `fmi3SetFloat64`; where one of several is refused, none is set.
///
/// # Safety
/// As of [`get`].
pub unsafe fn set<M: Exchanged>(
    handle: *mut Handle<M>,
    references: (*const u32, usize),
    values: (*const f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let (wanted, values) = unsafe { (variables(instance, references)?, read(values.0, values.1)?) };
        if wanted.len() != values.len() {
            return Err(Status::NoSuch.into());
        }
        let mut changed = instance.clone();
        for (value, variable) in values.iter().zip(wanted) {
            changed.set(variable, *value)?;
        }
        *instance = changed;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::Set, work) }
}

/// `fmi3GetDirectionalDerivative`
///
/// # Safety
/// As of [`get`].
pub unsafe fn tangents<M: Exchanged>(
    handle: *mut Handle<M>,
    (unknowns, knowns): ((*const u32, usize), (*const u32, usize)),
    seeds: (*const f64, usize),
    tangents: (*mut f64, usize),
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let (unknowns, knowns) = unsafe { (variables(instance, unknowns)?, variables(instance, knowns)?) };
        // SAFETY: the caller's part.
        let seeds = unsafe { read(seeds.0, seeds.1)? };
        if seeds.len() != knowns.len() {
            return Err(Status::NoSuch.into());
        }
        let knowns: Vec<_> = knowns.into_iter().zip(seeds.iter().copied()).collect();
        let found = instance.tangents(&knowns, &unknowns)?;
        // SAFETY: the caller's part.
        unsafe { fill(tangents, &found) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::GetDirectionalDerivative, work) }
}

/// A vector of the mechanism into room of the caller.
///
/// # Safety
/// As of [`get`].
pub unsafe fn give<M: Exchanged, X: Vector<f64>>(
    handle: *mut Handle<M>,
    call: Call,
    room: (*mut f64, usize),
    vector: impl FnOnce(&Instance<M>) -> Result<X, Trouble>,
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        instance.renew()?;
        let vector = vector(instance)?;
        let numbers: Vec<f64> = (0..X::LEN).map(|index| vector.at(index)).collect();
        // SAFETY: the caller's part.
        unsafe { fill(room, &numbers) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, call, work) }
}

/// `fmi3SetContinuousStates`
///
/// # Safety
/// As of [`get`].
pub unsafe fn set_states<M: Exchanged>(handle: *mut Handle<M>, (at, count): (*const f64, usize)) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let states = unsafe { read(at, count)? };
        if states.len() != <M as System>::X::LEN {
            return Err(Status::NoSuch.into());
        }
        let x = <M as System>::X::from_fn(|index| states.get(index).copied().unwrap_or_default());
        instance.place(None, Some(x))
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, Call::SetContinuousStates, work) }
}

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
            return Err(Status::Null.into());
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
