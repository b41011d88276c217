//! Linearisation at a moment: rates, and matrices of a linear system.

use plm_runtime::{Rate, Vector};

use super::{BlockBy, put, with};
use crate::{Error, Foreign, Matrix, ObjectBy, Run, Status};

/// [`ObjectBy::rates`], just as many as there are.
///
/// # Safety
/// As of `step`; `rates` is null or at room of the caller for `count` numbers.
pub unsafe fn rates<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    (rates, count): (*mut M::S, usize),
) -> i32 {
    let work = |object: &mut ObjectBy<M, R>| {
        let found = object.rates()?;
        // SAFETY: the caller's part.
        unsafe { fill((rates, count), <M as Rate>::X::LEN, |index| found.at(index)) }
    };
    // SAFETY: the caller's part.
    unsafe { with(block, work) }
}

/// How many directions the state of a linearisation has: [`Linearised::directions`](crate::Linearised::directions).
///
/// # Safety
/// As of `step`; `count` is null or at a number of the caller.
pub unsafe fn directions<M: Foreign, R: Run<M>>(block: *mut BlockBy<M, R>, count: *mut usize) -> i32 {
    // SAFETY: the caller's part.
    unsafe { with(block, |object| put(count, object.linearised()?.directions())) }
}

/// A matrix of [`ObjectBy::linearised`], row by row: just as many numbers as it has.
///
/// # Safety
/// As of [`rates`].
pub unsafe fn linearise<M: Foreign, R: Run<M>>(
    block: *mut BlockBy<M, R>,
    matrix: i32,
    (numbers, count): (*mut M::S, usize),
) -> i32 {
    let work = |object: &mut ObjectBy<M, R>| {
        let matrix = Matrix::ALL.into_iter().find(|own| *own as i32 == matrix).ok_or(Status::NoSuch)?;
        if numbers.is_null() {
            return Err(Status::Null.into());
        }
        let found = object.linearised()?;
        let (rows, columns) = found.shape(matrix);
        if count != rows * columns {
            return Err(Status::Memory.into());
        }
        found.each(matrix, &mut |row, column, number| {
            // SAFETY: it is not null, and room of the caller for all entries; C may have packed it.
            unsafe { numbers.add(row * columns + column).write_unaligned(number) }
        });
        Ok(())
    };
    // SAFETY: the caller's part.
    unsafe { with(block, work) }
}

/// Writes numbers to room of the caller for exactly as many; the room may be uninitialised.
///
/// # Safety
/// `place` is null or at room of the caller for `count` numbers.
unsafe fn fill<S>(
    (place, count): (*mut S, usize),
    length: usize,
    number: impl Fn(usize) -> S,
) -> Result<(), Error> {
    if place.is_null() {
        return Err(Status::Null.into());
    }
    if count != length {
        return Err(Status::Memory.into());
    }
    for index in 0..length {
        // SAFETY: it is not null, and there is room for as many; C may have packed it.
        unsafe { place.add(index).write_unaligned(number(index)) };
    }
    Ok(())
}
