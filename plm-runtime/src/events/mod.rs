//! Event detection: finds the changes of modes of conditions, and limits their number in a short time.
//!
//! The discrete state contains the mode of every condition and is constant during a step, so that the rate is smooth. A guard is
//! positive while the mode of its condition applies. The detector finds the first guard that passes zero on the dense output, repeats
//! the step so that it ends exactly there, and commits the event: another mode, and another state if the event resets it.
//!
//! The step is repeated because the next one starts from its end: the repeated step has the accuracy of every other step and satisfies
//! the constraints, while the dense output is of lower order and violates them.

mod boundary;
mod chattering;
mod committed;
mod derived;
mod detector;
mod dips;
mod enclosure;
mod ends;
mod fixed;
mod guard_free;
mod here;
mod history;
mod jumps;
mod kinks;
mod located;
mod passing;
mod piece;
mod quartic;
mod rates;
mod refined;
mod relevant;
mod requirements;
mod root;
mod rounding;
mod sampled;
mod search;
mod searched;
mod sets;
mod stays;
mod thrown;
mod touch;
mod violated;
mod words;

pub(crate) use self::detector::{Detector, Event};
use self::here::{guards, guards_here};
pub(crate) use self::history::{Beginning, History};
pub(crate) use self::jumps::at_a_jump;
pub use self::relevant::holds;
pub(crate) use self::relevant::refresh;
pub(crate) use self::requirements::hold;
pub use self::sets::{Sets, begin, change, take_sides, with_velocities};
use self::thrown::is_of_state;
pub use self::violated::switch_where_due;
pub(crate) use self::violated::{are_satisfied, before_projection, switch_at_end, switch_each, violated};
