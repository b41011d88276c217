//! Tolerances of methods without an estimate of errors: drift of the joints, and what a scalar resolves.

use crate::scalar::Real;

super::tolerance::tolerances! {
    /// A part of the typical coordinate and velocity. Joints that have drifted farther after a step are projected, unless the caller gives
    /// the method another tolerance: the part up to which joints count as closed ([`CLOSED`](super::CLOSED)). Read by the methods of fixed
    /// steps, by `plm-runtime/src/step.rs` and `plm-runtime/src/contact/project.rs`.
    DRIFT: f64 = 1e-10;
    /// Units in the last place. A smaller part of a size is not resolved: rounding of a sum of eight terms, each of eight products. Read with
    /// [`DRIFT`] and some tolerances of contact.
    RESOLVED: f64 = 64.0;
}

/// A part of a size; the part that the scalar can resolve, if that is more.
#[inline]
pub(crate) fn resolved<S: Real>(part: Tolerance) -> S {
    part.of::<S>().max(RESOLVED.of::<S>() * S::EPSILON)
}

/// The part of the typical coordinate and velocity by which joints may drift.
#[inline]
pub(crate) fn drift<S: Real>() -> S {
    resolved(DRIFT)
}
