//! Sizes of drift: limits, and the excess over them.

use core::cmp::Ordering;

use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;

/// Drift of the size `fraction` of the largest typical coordinate and velocity.
pub(crate) fn drift_of_size<M: System<S: Real>>(system: &M, fraction: M::S) -> Drift<M::S> {
    let typical = system.typical();
    let largest = |from: usize| (from..from + M::NQ).fold(M::S::lit(0.0), |size, i| typical.at(i).max(size));
    Drift { phi: fraction * largest(0), phi_dot: fraction * largest(M::NQ) }
}

/// The larger of the two residuals, each as a multiple of its limit; zero if there is nothing to project.
pub(crate) fn excess<S: Real>(drift: Drift<S>, limit: Drift<S>) -> S {
    let zero = S::lit(0.0);
    let ratio = |size: S, limit: S| if size == zero { zero } else { size / limit };
    larger(ratio(drift.phi, limit.phi), ratio(drift.phi_dot, limit.phi_dot))
}

/// The larger of two numbers; NaN if one of them is.
pub(super) fn larger<S: Real>(a: S, b: S) -> S {
    match a.partial_cmp(&b) {
        Some(Ordering::Less) => b,
        Some(_) => a,
        None => a + b,
    }
}
