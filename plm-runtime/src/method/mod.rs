//! Integration methods: they advance a state over an interval.
//!
//! | method | order | step |
//! |---|---|---|
//! | [`SemiImplicitEuler`] | 1 | fixed |
//! | [`Rk4`] | 4 | fixed |
//! | [`MoreauJean`] | 1, over impacts and changes of stick and slip | fixed |
//! | [`Dopri5`] | 5, dense output of order 4 | by error control |
//! | [`Dop853`] | 8, dense output of order 7 | by error control |
//! | [`Vern9`] | 9, dense output of order 8 | by error control |
//! | [`Adams`] | 1 to 13, dense output of degree 8 | order and step by error control |
//! | [`Gauss`] with 2 or 3 stages | 4, 6; symplectic and time-reversible | fixed |
//! | [`Ros34Pw2`] | 3; L-stable | fixed |
//! | [`RadauIia5`] | 5, dense output of order 3; L-stable | by error control |
//!
//! A method owns the data that it stores from step to step (its proposal for the next one, the last rate), so that a
//! saved copy of it resumes to the bit. The formulas of the fixed-step methods are usable alone, for any [`Scalar`].

mod adams;
mod adaptive;
mod context;
mod contract;
mod dop853;
mod dopri5;
mod embedded;
mod estimate;
mod euler;
mod fixed;
mod gauss;
mod jacobian;
mod length;
mod moreau_jean;
mod partition;
mod path;
mod projection;
mod radau;
mod rates;
mod rk4;
mod ros34pw2;
mod vern9;
mod words;

pub use adams::Adams;
pub(crate) use adaptive::{goes_on, shortest_between};
pub use context::Context;
use context::rate;
pub use contract::{DenseOutput, DriftCheck, ErrorControl, FastStep, FixedLength, Length, Method};
pub use dop853::{Dop853, DormandPrince853};
pub use dopri5::{Dopri5, DormandPrince5};
pub use embedded::{Embedded, Limits, Pair};
pub(crate) use embedded::{Going, Pace, Span, weight};
pub use estimate::Estimate;
pub use euler::{SemiImplicitEuler, SemiImplicitEulerFormula};
pub(crate) use fixed::looked_at;
pub use fixed::{FixedStep, Formula, Made};
pub use gauss::Gauss;
pub(crate) use length::coarseness;
pub use moreau_jean::MoreauJean;
pub(crate) use partition::Partition;
pub use path::Path;
pub use radau::RadauIia5;
use rates::Evaluated;
pub use rates::Rates;
pub(crate) use rates::Watched;
pub use rk4::{Rk4, Rk4Formula};
pub use ros34pw2::{Ros34Pw2, Ros34Pw2Formula, Trial};
pub use vern9::{Vern9, Verner98};

use core::cmp::Ordering;

use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
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
fn larger<S: Real>(a: S, b: S) -> S {
    match a.partial_cmp(&b) {
        Some(Ordering::Less) => b,
        Some(_) => a,
        None => a + b,
    }
}
