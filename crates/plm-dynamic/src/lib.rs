//! Mechanisms at run time: a declaration comes from text, and runs without rustc.
//!
//! The compiler makes tables and straight-line functions of a declaration. This crate evaluates the functions step by step, and has the
//! contracts of the runtime over them, so that assembly, events, charts and every method are those of compiled mechanisms, and so are
//! the bits.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod alone;
mod augmented;
mod capacity;
mod code;
mod column;
mod contact;
mod course;
mod declared;
mod derivatives;
mod description;
mod evaluation;
#[cfg(feature = "derivatives")]
mod gradient;
mod handle;
mod kept;
mod memory;
mod model;
mod native;
mod numbers;
mod places;
mod record;
mod recorded;
mod run;
mod running;
mod sizes;
mod start;
mod system;
mod text;
mod whole;

pub use self::alone::Steps;
pub use self::capacity::{ROWS, SWITCHES};
pub use self::column::Column;
pub use self::course::{Change, Course};
pub use self::declared::Declared;
#[cfg(feature = "derivatives")]
pub use self::gradient::{By, Derivative};
pub use self::handle::{Dynamic, Starts};
pub use self::native::{Element, Function, Input, MachineCode, Tier, Translator};
pub use self::numbers::{Numbers, RowNumbers};
pub use self::record::{Reason, Sample, Watch};
pub use self::run::{Error, Mechanism, Run};
pub use self::running::OnRun;
pub use self::sizes::{Large, Small};
pub use self::start::OnStart;
pub use self::system::State;
pub use self::text::{Compiled, Refused};
pub use plm_run::Integrator;
