//! A mechanism as an FMU of FMI 2.0 or 3.0 (Modelica Association, Functional Mock-up Interface Specification 2.0.5 and 3.0.2):
//! model exchange and co-simulation.
//!
//! [`Instance`] is safe; [`ffi`] has the functions of FMI; [`description`] writes `modelDescription.xml`.

mod description;
mod exchange;
mod facts;
#[allow(unsafe_code, reason = "pointers of other languages")]
pub mod ffi;
mod follow;
mod instance;
mod late;
mod method;
mod mode;
mod names;
mod sides;
mod structure;
mod tangent;
mod variable;
mod version;

pub use description::{build_description, description, token};
pub use exchange::Update;
pub use facts::{Code, Facts, Interfaces, Parameter};
pub use instance::Instance;
pub use method::{Absent, Choice, Emitted, Function, Made, NoMethod, Step, Steps};
pub use mode::{Call, Interface, Mode};
pub use variable::Variable;
pub use version::Version;

use core::fmt;

use plm_runtime::System;

use crate::Foreign;

/// Mechanisms that can be an FMU: every one in `f64`.
pub trait Exchanged: Foreign + System<S = f64> {}

impl<M: Foreign + System<S = f64>> Exchanged for M {}

/// The functions of FMI, for a mechanism called `NAME`: what both versions have in common, and those of each.
const FMI: [&str; 3] = [include_str!("fmi.rs.txt"), include_str!("three.rs.txt"), include_str!("two.rs.txt")];

/// Source of a shared library: the mechanism of a declaration, and the functions of both versions of FMI.
///
/// # Errors
/// Those of the writer.
pub fn source<M: Exchanged>(to: &mut impl fmt::Write) -> fmt::Result {
    write!(to, "plm::mechanism! {{\n{}\n}}\n", M::DECLARATION)?;
    FMI.iter().try_for_each(|text| crate::source::fill(text, M::TABLES.name, to))
}
