//! Foreign function interface: objects behind pointers, for C.
//!
//! Every function checks its arguments: pointers that are null or not aligned, memory that is no object of this mechanism, kinds and
//! numbers that do not exist, and values that are not finite give a [`Status`], and nothing is done.
//! No function can check that a pointer is at memory of the caller, or that no other thread uses it: the caller guarantees both,
//! which is the reason why the functions are unsafe.

mod linear;
mod names;

pub use self::linear::{directions, linearise, rates};
pub use self::names::{count, find, name, status_text};

use core::ffi::c_char;
use core::mem::{align_of, size_of};
use core::slice;

use crate::saved::fnv;
use plm_runtime::{Fault, Sim};

use crate::{By, Error, Foreign, Kind, ObjectBy, Run, Status, Text};

/// An object in memory of the caller, with runs by the methods of `R`. Its bytes may be copied: the copy goes on as the original
/// does.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct BlockBy<M, R> {
    /// Identifies objects of this mechanism in other memory.
    mark: u64,
    object: ObjectBy<M, R>,
    text: Text,
}

/// One with runs by the usual method alone.
pub type Block<M> = BlockBy<M, Sim<M>>;

impl<M: Foreign, R: Run<M>> BlockBy<M, R> {
    /// Bytes that it takes.
    pub const SIZE: usize = size_of::<Self>();
    /// Alignment of its address.
    pub const ALIGN: usize = align_of::<Self>();

    /// Mark in the first bytes of an object: a number of the declaration, of the size, and of the methods.
    pub(crate) const MARK: u64 = fnv(M::DECLARATION.as_bytes())
        ^ (Self::SIZE as u64).rotate_left(32)
        ^ R::METHODS.wrapping_mul(0x9e37_79b9_7f4a_7c15);
}

/// Makes an object of a mechanism that is not started, in `size` bytes at `memory`.
///
/// # Safety
/// `memory` is null, or at `size` bytes of the caller that no other thread uses.
pub unsafe fn init<M: Foreign, R: Run<M>>(memory: *mut BlockBy<M, R>, size: usize, mechanism: M) -> i32 {
    if memory.is_null() {
        return Status::Null as i32;
    }
    if size < BlockBy::<M, R>::SIZE || !memory.is_aligned() {
        return Status::Memory as i32;
    }
    let block = BlockBy { mark: BlockBy::<M, R>::MARK, object: ObjectBy::new(mechanism), text: Text::new() };
    // SAFETY: it is not null, aligned, and of the caller for as many bytes; what was there before needs no drop.
    unsafe { memory.write(block) };
    Status::Ok as i32
}

/// Lets `work` at an object.
///
/// # Safety
/// `block` is null, or at memory of the caller as large as an object, that no other thread uses meanwhile.
unsafe fn with<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    work: impl FnOnce(&mut ObjectBy<M, R>) -> Result<(), Error>,
) -> i32 {
    // SAFETY: as this function's.
    let Some(block) = (unsafe { found(block) }) else { return missing(block) as i32 };
    match work(&mut block.object) {
        Ok(()) => Status::Ok as i32,
        Err(error) => {
            block.text = Text::of(error);
            error.status() as i32
        }
    }
}

/// The object at a pointer, if there is one.
///
/// # Safety
/// As of [`with`].
unsafe fn found<'a, M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>) -> Option<&'a mut BlockBy<M, R>> {
    if block.is_null() || !block.is_aligned() {
        return None;
    }
    // SAFETY: it is not null, aligned, and at memory of the caller; the mark is its first field.
    let mark = unsafe { block.cast::<u64>().read() };
    // SAFETY: the mark is written by `init` alone, with all the rest.
    (mark == BlockBy::<M, R>::MARK).then(|| unsafe { &mut *block })
}

/// Why there is no object.
fn missing<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>) -> Status {
    if block.is_null() { Status::Null } else { Status::NoObject }
}

/// [`ObjectBy::start`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn start<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, ObjectBy::start) }
}

/// [`ObjectBy::start_at`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn start_at<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, time: M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.start_at(time)) }
}

/// [`ObjectBy::step`]
///
/// # Safety
/// `block` is null, or at memory of the caller as large as an object, that no other thread uses meanwhile.
pub unsafe fn step<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, dt: M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.step(dt)) }
}

/// [`ObjectBy::step_to`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn step_to<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, until: M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.step_to(until)) }
}

/// [`ObjectBy::step_alone`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn step_alone<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    step: impl FnOnce(&mut M::State) -> Result<(), Fault>,
) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.step_alone(step)) }
}

/// [`ObjectBy::set_method`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set_method<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, method: i32) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set_method(By::of(method)?)) }
}

/// [`ObjectBy::set_tolerance`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set_tolerance<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, rtol: M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set_tolerance(rtol)) }
}

/// [`ObjectBy::set_longest_step`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set_longest_step<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, step: M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set_longest_step(step)) }
}

/// [`ObjectBy::time`]
///
/// # Safety
/// As of [`step`]; `time` is null or at a number of the caller.
pub unsafe fn time<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, time: *mut M::S) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(time, object.time()?)) }
}

/// [`ObjectBy::get`]
///
/// # Safety
/// As of [`step`]; `value` is null or at a number of the caller.
pub unsafe fn get<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    kind: i32,
    index: usize,
    value: *mut M::S,
) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(value, object.get(Kind::of(kind)?, index)?)) }
}

/// [`ObjectBy::set`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    kind: i32,
    index: usize,
    value: M::S,
) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set(Kind::of(kind)?, index, value)) }
}

/// [`ObjectBy::pose`]
///
/// # Safety
/// As of [`step`]; `pose` is null or at six numbers of the caller.
pub unsafe fn pose<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    body: usize,
    pose: *mut [M::S; 6],
) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(pose, object.pose(body)?)) }
}

/// [`ObjectBy::saved_size`]
///
/// # Safety
/// As of [`step`]; `size` is null or at a number of the caller.
pub unsafe fn saved_size<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, size: *mut usize) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(size, object.saved_size())) }
}

/// [`ObjectBy::save`]
///
/// # Safety
/// As of [`step`]; `bytes` is null or at room of the caller for as many.
pub unsafe fn save<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, (bytes, size): (*mut u8, usize)) -> i32 {
    let work = |object: &mut ObjectBy<M, R>| {
        if bytes.is_null() {
            return Err(Status::Null.into());
        }
        if size != object.saved_size() {
            return Err(Status::Memory.into());
        }
        // SAFETY: it is not null, and room of the caller for as many, which have a value now.
        object.save(unsafe {
            bytes.write_bytes(0, size);
            slice::from_raw_parts_mut(bytes, size)
        })
    };
    // SAFETY: the caller's part.
    unsafe { with(block, work) }
}

/// [`ObjectBy::saved`]
///
/// # Safety
/// As of [`step`]; `bytes` is null or at as many of the caller.
pub unsafe fn restore<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    declared: M,
    (bytes, size): (*const u8, usize),
) -> i32 {
    let work = |object: &mut ObjectBy<M, R>| {
        if bytes.is_null() {
            return Err(Status::Null.into());
        }
        // SAFETY: it is not null, and the caller's.
        *object = ObjectBy::saved(declared, unsafe { slice::from_raw_parts(bytes, size) })?;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(block, work) }
}

/// The text of the last error, with a zero at its end; it is valid until the next call. Without an object the empty text.
///
/// # Safety
/// As of [`step`].
pub unsafe fn text<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>) -> *const c_char {
    // SAFETY: the caller's part.
    unsafe { found(block) }.map_or(c"".as_ptr(), |block| block.text.as_ptr())
}

/// Writes a value where the caller wants it.
///
/// # Errors
/// [`Status::Null`]
///
/// # Safety
/// `place` is null or at room of the caller for such a value.
pub unsafe fn put<T>(place: *mut T, value: T) -> Result<(), Error> {
    if place.is_null() {
        return Err(Status::Null.into());
    }
    // SAFETY: it is not null, and the caller's; C may have packed it.
    unsafe { place.write_unaligned(value) };
    Ok(())
}
