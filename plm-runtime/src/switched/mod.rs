//! Events of a mechanism from tables and routines.
//!
//! A mechanism has tables of its conditions ([`Switches`]), and routines that are evaluated by compiled code, an interpreter or machine
//! code. Changes of sides, contact and times of events are common to all of them: a mechanism that is [`Switched`] has
//! [`Events`](crate::Events).

mod contact;
mod contract;
mod events;
mod table;

pub use self::contact::{NoContact, WithContact};
pub use self::contract::{ContactPart, Switched};
pub use self::events::{jump, take_sides_at_time};
pub use self::table::Switches;
