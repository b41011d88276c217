//! Chooses the unknowns and lays out what is computed, function by function.
//!
//! The least formulation that a mechanism allows is taken: joint coordinates where its joints are pairs and its loops can
//! be solved; else absolute coordinates and multipliers. These hold every mechanism, whatever its loops and redundancies,
//! so that they are also the independent check of joint coordinates.

mod absolute;
mod colours;
mod contact;
mod elimination;
mod function;
mod ldl;
mod linearised;
mod order;
mod outputs;
mod pattern;
mod program;
mod reduced;
mod resolvent;
mod rows;
mod sliding;
mod switches;

pub(crate) use absolute::{Absolute, Conditional, coordinate_name, eliminates_beyond, formulate};
pub(crate) use colours::Reads;
pub(crate) use contact::ContactFunctions;
pub use elimination::Elimination;
pub(crate) use function::{Function, Place};
pub(crate) use linearised::{Augmented, Linearised};
#[cfg(feature = "lowered")]
pub(crate) use outputs::Output as UserOutput;
pub(crate) use program::{Program, reduce};
#[cfg(feature = "lowered")]
pub(crate) use reduced::textbook::{Condition, Row, Textbook, textbook};
pub(crate) use reduced::{Chart, Reduced, is_tree};
pub(crate) use resolvent::Resolvent;
pub use rows::{OfRows, RowTerm};
pub(crate) use sliding::Sliding;
