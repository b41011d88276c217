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
//! saved copy of it resumes to the bit. The formulas of the fixed-step methods are usable alone, for any [`Scalar`](crate::Scalar).

mod adams;
mod adaptive;
mod context;
mod contract;
mod dop853;
mod dopri5;
mod drift;
mod embedded;
mod estimate;
mod euler;
mod faults;
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
pub use context::Context;
use context::rate;
pub use contract::{DenseOutput, DriftCheck, ErrorControl, FastStep, FixedLength, Length, Method};
pub use dop853::{Dop853, DormandPrince853};
pub use dopri5::{Dopri5, DormandPrince5};
use drift::larger;
pub(crate) use drift::{drift_of_size, excess};
pub use embedded::{Embedded, Limits, Pair};
pub use estimate::Estimate;
pub use euler::{SemiImplicitEuler, SemiImplicitEulerFormula};
pub(crate) use faults::{not_finite, unhealthy};
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
