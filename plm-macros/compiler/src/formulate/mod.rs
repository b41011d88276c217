//! Chooses the unknowns and lays out what is computed, function by function.
//!
//! The least formulation that a mechanism allows is taken: joint coordinates (rungs 1 to 4) where its joints are pairs and
//! its loops can be solved; else rung 5.
//!
//! Rung 5 of the ladder: absolute coordinates and multipliers. It holds every mechanism, whatever its loops and
//! redundancies, so it is also the independent check of the rungs above it.

mod absolute;
mod function;
mod ldl;
mod order;
mod outputs;
mod pattern;
mod reduced;
mod sides;

pub(crate) use absolute::{Absolute, coordinate_name, eliminates_beyond, formulate};
pub(crate) use function::{Function, Place};
pub(crate) use outputs::user as lay_out;
pub(crate) use reduced::{Assembled, Augmented, Chart, Known, Part, Reduced, Term, formulate as reduce};
