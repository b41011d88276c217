//! How much of the stack a solution by rank takes, and how much it may.
//!
//! Elimination of the constraints needs room that grows with the number of bodies. If it is not healthy (redundant rows, too many locks,
//! singular poses), a solution by rank orthogonalises the rows of phi_q. The matrix is then stored in full:
//! [`Mechanism::WORKSPACE`](crate::Mechanism::WORKSPACE) bytes, one set at a time.
//!
//! A stack that overflows ends the program, and how much is left of it cannot be known here. So a solution that would need more than is
//! allowed is refused, with [`Cause::Workspace`], and the run ends as with any other fault.
//!
//! Only these matrices grow with the square of the number of bodies. The functions that store them are not inlined, so that a healthy
//! elimination does not pay for their stack.

use core::sync::atomic::{AtomicUsize, Ordering};

use crate::fault::Cause;

/// Default limit, bytes: half of the default stack of a thread, 2 MiB. It is enough for 256 rows of `f64` on 256 coordinates, some 85
/// bodies.
pub const USUAL: usize = 1 << 20;

static MOST: AtomicUsize = AtomicUsize::new(USUAL);

/// Bytes of stack that a solution by rank takes for so many coordinates and constraint rows.
pub const fn of<S, const NQ: usize, const NC: usize>() -> usize {
    size_of::<[[S; NQ]; NC]>() + size_of::<[[S; NC]; NC]>()
}

/// Allows solutions by rank that take up to so many bytes of stack, in all threads of the program from now on.
///
/// A program whose threads have a larger stack allows more, one for a small target less than [`USUAL`]. The rest of a run
/// needs stack as well; the book has figures (`docs/src/running/stack.md`).
pub fn allow(bytes: usize) {
    MOST.store(bytes, Ordering::Relaxed);
}

/// Bytes of stack that a solution by rank may take.
pub fn allowed() -> usize {
    MOST.load(Ordering::Relaxed)
}

/// Why a solution by rank is refused, if it is.
pub(crate) fn refusal<S, const NQ: usize, const NC: usize>() -> Option<Cause> {
    let (bytes, allowed) = (of::<S, NQ, NC>(), allowed());
    (bytes > allowed).then_some(Cause::Workspace { bytes, allowed })
}
