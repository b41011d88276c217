//! Faults of steps that give no state to go on from.

use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A fault that names the part of the first component which is not finite.
pub(crate) fn not_finite<M: System>(system: &M, t: M::S, x: &M::X) -> Fault {
    let index = (0..M::X::LEN).find(|i| !x.at(*i).is_finite());
    let part = index.map_or("", |i| system.part_of_state(i));
    Fault::of_part(t.to_f64(), part, Cause::NotFinite)
}

/// Fault of a step whose rates are unhealthy.
#[cold]
pub(crate) fn unhealthy<M: System<S: Real>>(
    system: &M,
    held: &M::U,
    (time, x): (M::S, M::X),
    next: M::X,
) -> Fault {
    let mut rate = x;
    match system.rate_by_rank(time, held, &x, &mut rate) {
        Err(fault) => fault,
        Ok(()) if !next.is_finite() => not_finite(system, time, &next),
        Ok(()) => Fault::new(time.to_f64(), Cause::NotRegular),
    }
}
