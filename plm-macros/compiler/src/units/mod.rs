//! Units and dimensions.
//!
//! Inside, every quantity is in SI; the user's unit is kept for display. The radian has dimension 1, but it is a kind:
//! its exponent is carried along so that a literal or a parameter that is an angle can be asked to say deg, rad or
//! rev, while it cancels freely in expressions (BIPM, The International System of Units, 9th edition, section 2.3.3).

mod dimension;
mod display;
mod table;

pub use dimension::Dimension;
pub use display::{DisplayUnit, UnitFactor};
pub use table::{MAY_BE_NAMES, Unit, is_unit, names, unit};
