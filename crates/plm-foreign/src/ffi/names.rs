//! Names by number, and numbers by name.

use core::ffi::{CStr, c_char};

use super::put;
use crate::{Foreign, Kind, Status};

/// The text of a status; empty for a number that is none.
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
        Err(error) => return error.status() as i32,
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
    written.map_or_else(|error| error.status() as i32, |()| Status::Ok as i32)
}
