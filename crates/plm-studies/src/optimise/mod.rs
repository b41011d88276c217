//! Numbers of a mechanism from measurements, or for the least cost: identification of parameters and start values
//! ([`Identification`]), combinations of inertias that can be identified ([`base_parameters`]), and inputs of least cost (`Control`, by the
//! feature `optimal-control`).
//!
//! `plm` has all of it as `plm::optimise`, behind the feature `optimise`. All derivatives are those of runs on dual numbers, exact
//! through assembly, loops, events and impacts.

mod base;
#[cfg(feature = "optimal-control")]
mod control;
mod error;
mod identify;
mod least_squares;
mod mechanism;
mod node;
mod rows;
mod shot;
mod signal;
mod stack;
mod unknown;

pub use base::{BaseParameters, base_parameters};
#[cfg(feature = "optimal-control")]
pub use control::{Control, Optimum};
pub use error::{Error, NotConverged};
pub use identify::{
    Combination, Estimate, Experiment, Farthest, Fit, Identification, Loss, Notice, Progress, Residuals,
};
pub use mechanism::{ByDop853, ByRadau, Integration, Optimisable};
pub use nalgebra::DMatrix;
pub use unknown::Unknown;
