//! Numerical results while a mechanism is compiled: values of expressions, assembly of the start, ranks, freedoms.
//!
//! All of it runs on the interpreter of the tape, and nothing here knows what is right or wrong: `check` judges.

mod assembly;
mod branch;
mod change_point;
mod constraints;
mod damped;
mod far;
mod freedom;
mod lack;
mod placed;
mod pseudo_inverse;
mod random;
mod rank;
mod scene;
mod search;
mod values;

pub(crate) use crate::evaluated::{run, value, values};
pub(crate) use assembly::{Assembly, Reach, assemble, at_start};
pub(crate) use branch::asked;
pub(crate) use change_point::ChangePoint;
pub(crate) use far::Far;
pub(crate) use freedom::{freedom, moves};
pub(crate) use random::Random;
pub(crate) use rank::{Row, rank};
pub(crate) use scene::Scene;
pub(crate) use search::Searched;
pub(crate) use values::{add_switches, defaults, varied};
