//! States of an FMU: copies that the simulator holds, and bytes of them.

use alloc::boxed::Box;
use alloc::vec;

use super::{Handle, OK, Outcome, put, read, with};
use crate::fmi::{Exchanged, Instance};
use crate::{Error, Status};

/// `fmi3GetFMUState`: a copy, which is a new one or one that was made before.
///
/// # Safety
/// As of [`with`]; `copy` is null or the caller's, and holds null or such a copy.
pub unsafe fn save<M: Exchanged>(handle: *mut Handle<M>, copy: *mut *mut Instance<M>) -> Outcome {
    // SAFETY: the caller's part.
    unsafe { with(handle, None, |instance| hand_out(instance.clone(), copy)) }
}

/// `fmi3SetFMUState`
///
/// # Safety
/// As of [`with`]; `copy` is null or one of [`save`].
pub unsafe fn restore<M: Exchanged>(handle: *mut Handle<M>, copy: *mut Instance<M>) -> Outcome {
    // SAFETY: the caller's part.
    let copy = unsafe { copy.as_ref() };
    let work = |instance: &mut Instance<M>| {
        let copy = copy.ok_or(Status::Null)?;
        instance.is_like(copy)?;
        *instance = copy.clone();
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, None, work) }
}

/// `fmi3SerializedFMUStateSize`
///
/// # Safety
/// As of [`restore`]; `size` is null or the caller's.
pub unsafe fn serialized_size<M: Exchanged>(
    handle: *mut Handle<M>,
    copy: *const Instance<M>,
    size: *mut usize,
) -> Outcome {
    // SAFETY: the caller's part.
    let copy = unsafe { copy.as_ref() };
    // SAFETY: the caller's part.
    unsafe { with(handle, None, |_| put(size, copy.ok_or(Status::Null)?.saved_size())) }
}

/// `fmi3SerializeFMUState`
///
/// # Safety
/// As of [`restore`]; `bytes` are null or at room of the caller.
pub unsafe fn serialize<M: Exchanged>(
    handle: *mut Handle<M>,
    copy: *const Instance<M>,
    (bytes, size): (*mut u8, usize),
) -> Outcome {
    // SAFETY: the caller's part.
    let copy = unsafe { copy.as_ref() };
    let work = |_: &mut Instance<M>| {
        let copy = copy.filter(|_| !bytes.is_null()).ok_or(Status::Null)?;
        let mut saved = vec![0; copy.saved_size()];
        if saved.len() != size {
            return Err(Status::Memory.into());
        }
        copy.save(&mut saved)?;
        // SAFETY: it is not null, and room of the caller for as many.
        unsafe { bytes.copy_from_nonoverlapping(saved.as_ptr(), size) };
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, None, work) }
}

/// `fmi3DeserializeFMUState`: as [`save`], of bytes.
///
/// # Safety
/// As of [`save`]; `bytes` are null or the caller's.
pub unsafe fn deserialize<M: Exchanged>(
    handle: *mut Handle<M>,
    (bytes, size): (*const u8, usize),
    copy: *mut *mut Instance<M>,
) -> Outcome {
    let work = |instance: &mut Instance<M>| {
        // SAFETY: the caller's part.
        let saved = instance.saved(unsafe { read(bytes, size)? })?;
        // SAFETY: the caller's part.
        unsafe { hand_out(saved, copy) }
    };
    // SAFETY: the caller's part.
    unsafe { with(handle, None, work) }
}

/// Gives the simulator an instance of its own: a new one, or in the place of one that it has.
///
/// # Safety
/// `copy` is null or the caller's, and holds null or one of [`save`].
unsafe fn hand_out<M: Exchanged>(instance: Instance<M>, copy: *mut *mut Instance<M>) -> Result<(), Error> {
    // SAFETY: the caller's part.
    match unsafe { copy.as_mut() } {
        None => return Err(Status::Null.into()),
        Some(place) if place.is_null() => *place = Box::into_raw(Box::new(instance)),
        // SAFETY: the caller's part.
        Some(place) => unsafe { **place = instance },
    }
    Ok(())
}

/// `fmi3FreeFMUState`
///
/// # Safety
/// `copy` is null or the caller's, and holds null or one of [`save`].
pub unsafe fn forget<M: Exchanged>(copy: *mut *mut Instance<M>) -> Outcome {
    // SAFETY: the caller's part.
    if let Some(place) = unsafe { copy.as_mut() }.filter(|place| !place.is_null()) {
        // SAFETY: the caller's part.
        drop(unsafe { Box::from_raw(*place) });
        *place = core::ptr::null_mut();
    }
    OK
}
