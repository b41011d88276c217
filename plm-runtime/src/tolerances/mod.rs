//! Tolerances of charts, of the near-singular method, of contact and of events, with the unit of each, its derivation and its readers.
//!
//! | file | tolerances |
//! |---|---|
//! | `charts.rs` | loops in closed form: changes of charts, and distances between checks |
//! | `closing.rs` | closed joints, and lengths that repeat each other |
//! | `singular.rs` | the near-singular method |
//! | `drift.rs` | drift of the joints in steps of methods without an estimate |
//! | `contact.rs` | contact rows: gaps, rates, inequalities, impacts, the steps of `MoreauJean` |
//! | `events.rs` | detection of events: rounding of guards, kinks, chattering, guard-free regions |
//! | `bounds.rs` | bounds of work, which are no tolerances |
//!
//! The book's chapter on near-singular poses (`docs/src/theory/near-singular.md`) shows the effect of each tolerance of `charts.rs`,
//! `closing.rs` and `singular.rs` on a sweep if it is tenfold or a tenth. With the feature `vary-tolerances`, which only that sweep
//! enables, each number is multiplied by a factor from `set_factor` or the environment; without it each is the constant in this folder.
//!
//! Units: rad; m; s; a pivot ratio (the smallest pivot of `phi_q W phi_q^T` over its diagonal entry, about the square of the sine of the
//! angle that a loop is away from flat); a measure (that sine itself); units in the last place (of 1: the number's `EPSILON`).

mod bounds;
mod charts;
mod closing;
mod contact;
mod drift;
mod events;
#[cfg(feature = "vary-tolerances")]
mod factor;
mod singular;
mod tolerance;
#[cfg(feature = "vary-tolerances")]
mod vary;

pub(crate) use self::bounds::*;
pub(crate) use self::charts::*;
pub(crate) use self::closing::*;
pub(crate) use self::contact::*;
pub(crate) use self::drift::*;
pub(crate) use self::events::*;
pub(crate) use self::singular::*;
pub(crate) use self::tolerance::is_double;
#[cfg(feature = "vary-tolerances")]
pub use self::vary::{names, names_of_poses, set_factor};
