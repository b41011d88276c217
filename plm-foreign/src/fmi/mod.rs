//! A mechanism as an FMU of FMI 3.0 (Modelica Association, Functional Mock-up Interface Specification 3.0.2): model exchange and
//! co-simulation.
//!
//! [`Instance`] is safe; [`border`] has the functions of FMI; [`description`] writes `modelDescription.xml`.

#[allow(unsafe_code, reason = "pointers of other languages")]
pub mod border;
mod description;
mod instance;
mod mode;
mod names;
mod sides;
mod structure;
mod tangent;
mod variable;

pub use description::{description, token};
pub use instance::{Instance, Update};
pub use mode::{Call, Interface, Mode};
pub use variable::Variable;

use core::fmt;

use plm_runtime::System;

use crate::Foreign;

/// What can be an FMU: every mechanism in `f64`.
pub trait Exchanged: Foreign + System<S = f64> {}

impl<M: Foreign + System<S = f64>> Exchanged for M {}

/// The functions of FMI, for a mechanism called `NAME`.
const FMI: &str = include_str!("fmi.rs.txt");

/// Source of a shared library: the mechanism of a declaration, and the functions of FMI.
///
/// # Errors
/// Those of the writer.
pub fn source<M: Exchanged>(to: &mut impl fmt::Write) -> fmt::Result {
    write!(to, "plm::mechanism! {{\n{}\n}}\n", M::DECLARATION)?;
    crate::source::fill(FMI, M::TABLES.name, to)
}
