//! Objects behind pointers: what C calls.
//!
//! Every function looks at what it is given: pointers that are null or not aligned, memory that is no object of this
//! mechanism, kinds and numbers that do not exist, and values that are no numbers give a [`Status`], and nothing is done.
//! Whether a pointer is at memory of the caller, and whether another thread uses it, nobody can look at: that is the caller's
//! part of every function here, and the reason why they are unsafe.

use core::ffi::{CStr, c_char};
use core::mem::{align_of, size_of};
use core::slice;

use crate::saved::fnv;
use crate::{Foreign, Kind, Object, Status, Text, Trouble};

/// An object in memory of the caller. Its bytes may be copied: the copy goes on as the original does.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Block<M: Foreign> {
    /// Tells objects of this mechanism from other memory.
    mark: u64,
    object: Object<M>,
    text: Text,
}

impl<M: Foreign> Block<M> {
    /// Bytes that it takes.
    pub const SIZE: usize = size_of::<Self>();
    /// What its address must be a multiple of.
    pub const ALIGN: usize = align_of::<Self>();

    /// What the first bytes of an object hold: a number of the declaration and of the size.
    pub(crate) const MARK: u64 = fnv(M::DECLARATION.as_bytes()) ^ (Self::SIZE as u64).rotate_left(32);
}

/// Makes an object of a mechanism that is not started, in `size` bytes at `memory`.
///
/// # Safety
/// `memory` is null, or at `size` bytes that belong to the caller and that nobody else uses.
pub unsafe fn init<M: Foreign>(memory: *mut Block<M>, size: usize, mechanism: M) -> i32 {
    if memory.is_null() {
        return Status::Null as i32;
    }
    if size < Block::<M>::SIZE || !memory.is_aligned() {
        return Status::Memory as i32;
    }
    let block = Block { mark: Block::<M>::MARK, object: Object::new(mechanism), text: Text::new() };
    // SAFETY: it is not null, aligned, and of the caller for as many bytes; what was there before needs no drop.
    unsafe { memory.write(block) };
    Status::Ok as i32
}

/// Lets `work` at an object.
///
/// # Safety
/// `block` is null, or at memory of the caller as large as an object, that nobody else uses meanwhile.
unsafe fn with<M: Foreign>(
    block: *mut Block<M>,
    work: impl FnOnce(&mut Object<M>) -> Result<(), Trouble>,
) -> i32 {
    // SAFETY: as this function's.
    let Some(block) = (unsafe { found(block) }) else { return missing(block) as i32 };
    match work(&mut block.object) {
        Ok(()) => Status::Ok as i32,
        Err(trouble) => {
            block.text = Text::of(trouble);
            trouble.status() as i32
        }
    }
}

/// The object at a pointer, if there is one.
///
/// # Safety
/// As of [`with`].
unsafe fn found<'a, M: Foreign>(block: *mut Block<M>) -> Option<&'a mut Block<M>> {
    if block.is_null() || !block.is_aligned() {
        return None;
    }
    // SAFETY: it is not null, aligned, and at memory of the caller; the mark is its first field.
    let mark = unsafe { block.cast::<u64>().read() };
    // SAFETY: the mark is written by `init` alone, with all the rest.
    (mark == Block::<M>::MARK).then(|| unsafe { &mut *block })
}

/// Why there is no object.
fn missing<M: Foreign>(block: *mut Block<M>) -> Status {
    if block.is_null() { Status::Null } else { Status::NoObject }
}

/// [`Object::start`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn start<M: Foreign>(block: *mut Block<M>) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, Object::start) }
}

/// [`Object::step`]
///
/// # Safety
/// `block` is null, or at memory of the caller as large as an object, that nobody else uses meanwhile.
pub unsafe fn step<M: Foreign>(block: *mut Block<M>, dt: f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.step(dt)) }
}

/// [`Object::step_to`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn step_to<M: Foreign>(block: *mut Block<M>, until: f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.step_to(until)) }
}

/// [`Object::set_tolerance`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set_tolerance<M: Foreign>(block: *mut Block<M>, rtol: f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set_tolerance(rtol)) }
}

/// [`Object::set_longest_step`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set_longest_step<M: Foreign>(block: *mut Block<M>, step: f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set_longest_step(step)) }
}

/// [`Object::time`]
///
/// # Safety
/// As of [`step`]; `time` is null or at a number of the caller.
pub unsafe fn time<M: Foreign>(block: *mut Block<M>, time: *mut f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(time, object.time()?)) }
}

/// [`Object::get`]
///
/// # Safety
/// As of [`step`]; `value` is null or at a number of the caller.
pub unsafe fn get<M: Foreign>(block: *mut Block<M>, kind: i32, index: usize, value: *mut f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(value, object.get(Kind::of(kind)?, index)?)) }
}

/// [`Object::set`]
///
/// # Safety
/// As of [`step`].
pub unsafe fn set<M: Foreign>(block: *mut Block<M>, kind: i32, index: usize, value: f64) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| object.set(Kind::of(kind)?, index, value)) }
}

/// [`Object::pose`]
///
/// # Safety
/// As of [`step`]; `pose` is null or at six numbers of the caller.
pub unsafe fn pose<M: Foreign>(block: *mut Block<M>, body: usize, pose: *mut [f64; 6]) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(pose, object.pose(body)?)) }
}

/// [`Object::saved_size`]
///
/// # Safety
/// As of [`step`]; `size` is null or at a number of the caller.
pub unsafe fn saved_size<M: Foreign>(block: *mut Block<M>, size: *mut usize) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(size, object.saved_size())) }
}

/// [`Object::save`]
///
/// # Safety
/// As of [`step`]; `bytes` is null or at room of the caller for as many.
pub unsafe fn save<M: Foreign>(block: *mut Block<M>, (bytes, size): (*mut u8, usize)) -> i32 {
    let work = |object: &mut Object<M>| {
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

/// [`Object::saved`]
///
/// # Safety
/// As of [`step`]; `bytes` is null or at as many of the caller.
pub unsafe fn restore<M: Foreign>(
    block: *mut Block<M>,
    declared: M,
    (bytes, size): (*const u8, usize),
) -> i32 {
    let work = |object: &mut Object<M>| {
        if bytes.is_null() {
            return Err(Status::Null.into());
        }
        // SAFETY: it is not null, and the caller's.
        *object = Object::saved(declared, unsafe { slice::from_raw_parts(bytes, size) })?;
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(block, work) }
}

/// The words of the last error, with a zero at their end; they stay until the next call. Without an object the empty text.
///
/// # Safety
/// As of [`step`].
pub unsafe fn text<M: Foreign>(block: *mut Block<M>) -> *const c_char {
    // SAFETY: the caller's part.
    unsafe { found(block) }.map_or(c"".as_ptr(), |block| block.text.as_ptr())
}

/// The words of a status; of a number that is none the empty text.
pub fn status_text(status: i32) -> *const c_char {
    let words = Status::ALL.into_iter().find(|own| *own as i32 == status).map(|status| status.words().1);
    words.unwrap_or(c"").as_ptr()
}

/// How many there are of a kind; 0 where there is no such kind.
pub fn count<M: Foreign>(declared: &M, kind: i32) -> usize {
    Kind::of(kind).map_or(0, |kind| kind.count(declared))
}

/// Writes a name with a zero at its end into `size` bytes at `name`; where they are too few it is cut off.
///
/// # Safety
/// `name` is null or at `size` bytes of the caller.
pub unsafe fn name<M: Foreign>(
    declared: &M,
    kind: i32,
    index: usize,
    (name, size): (*mut c_char, usize),
) -> i32 {
    let own = match Kind::of(kind).and_then(|kind| kind.name(declared, index)) {
        Ok(own) => own,
        Err(trouble) => return trouble.status() as i32,
    };
    if name.is_null() {
        return Status::Null as i32;
    }
    let Some(room) = size.checked_sub(1) else { return Status::Memory as i32 };
    let length = (0..=room.min(own.len())).rev().find(|end| own.is_char_boundary(*end)).unwrap_or(0);
    // SAFETY: `length` is less than `size`, and no longer than the name.
    unsafe {
        name.copy_from_nonoverlapping(own.as_ptr().cast(), length);
        name.add(length).write(0);
    }
    if length == own.len() { Status::Ok as i32 } else { Status::Memory as i32 }
}

/// Writes the number of a name.
///
/// # Safety
/// `name` is null or at a text of the caller that ends with a zero, `index` null or at a number of the caller.
pub unsafe fn find<M: Foreign>(declared: &M, kind: i32, name: *const c_char, index: *mut usize) -> i32 {
    if name.is_null() {
        return Status::Null as i32;
    }
    // SAFETY: the caller's part.
    let name = unsafe { CStr::from_ptr(name) };
    let found = Kind::of(kind).and_then(|kind| kind.find(declared, name.to_bytes()));
    // SAFETY: the caller's part.
    let written = found.and_then(|found| unsafe { put(index, found) });
    written.map_or_else(|trouble| trouble.status() as i32, |()| Status::Ok as i32)
}

/// Writes a value where the caller wants it.
///
/// # Errors
/// [`Status::Null`]
///
/// # Safety
/// `place` is null or at room of the caller for such a value.
pub unsafe fn put<T>(place: *mut T, value: T) -> Result<(), Trouble> {
    if place.is_null() {
        return Err(Status::Null.into());
    }
    // SAFETY: it is not null, and the caller's; C may have packed it.
    unsafe { place.write_unaligned(value) };
    Ok(())
}
