//! Parts of the library whose runs from text have the bits of compiled code.

mod catching;
mod fluids;
mod transmissions;

pub(crate) use catching::*;
pub(crate) use fluids::*;
pub(crate) use transmissions::*;
