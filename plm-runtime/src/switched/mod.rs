//! Events of a mechanism from tables and routines.
//!
//! A mechanism has tables of its conditions ([`Switches`]), and routines that are evaluated by compiled code, an interpreter or machine
//! code. Changes of sides, contact and times of events are common to all of them: a mechanism that is [`Switched`] has
//! [`Events`](crate::Events).

mod contact;
mod events;
mod table;

pub use self::contact::{ContactPart, NoContact, WithContact};
pub use self::events::{jump, take_sides_at_time};
pub use self::table::Switches;
use crate::enclosure::Enclosed;
use crate::fault::{Cause, Fault};
use crate::held::Sides;
use crate::scalar::Real;
use crate::system::{Labels, Rate};
use crate::vector::Vector;

/// A mechanism with conditions and contact, from tables and routines.
pub trait Switched: Rate<S: Real, U: Sides<<Self as Rate>::S>> + Labels + Sized {
    /// A number for each guard: those of conditions, then those of contact.
    type Guards: Vector<Self::S> + AsMut<[Self::S]> + AsRef<[Self::S]>;
    /// Its contact: [`NoContact`], or [`WithContact`].
    type Contact: ContactPart<Self>;
    /// Tables of a mechanism of this type; for a mechanism that has its size from a program, the largest sizes that there is room for.
    const SWITCHES: Switches;

    /// Tables of this mechanism.
    #[inline]
    fn switches(&self) -> &'static Switches {
        const { &Self::SWITCHES }
    }

    /// Gives `see` the guards of conditions, then the kinks.
    #[inline]
    fn watch<T>(&self, t: Self::S, u: &Self::U, x: &Self::X, see: impl FnOnce(&[Self::S]) -> T) -> T {
        let _ = (t, u, x);
        see(&[])
    }

    /// Gives each guard and kink over an interval with its number. Returns false if there are no enclosures; all of them are then
    /// searched by samples.
    #[inline]
    fn watch_within(
        &self,
        t: Enclosed<Self::S>,
        u: &Self::U,
        x: &impl Fn(usize) -> Enclosed<Self::S>,
        each: &mut impl FnMut(usize, Enclosed<Self::S>),
    ) -> bool {
        let _ = (t, u, x, each);
        self.switches().guards + self.switches().kinks == 0
    }

    /// Gives `see` the times at which conditions on the time alone change, s, and the slopes of the compared values.
    #[inline]
    fn known_times<T>(&self, u: &Self::U, see: impl FnOnce(&[Self::S], &[Self::S]) -> T) -> T {
        let _ = u;
        see(&[], &[])
    }

    /// Makes changes of sides or modes, and commits the events that follow them.
    ///
    /// # Errors
    /// Those of `changes`; a fault if events follow each other without end.
    #[inline]
    fn change(
        &self,
        t: Self::S,
        u: &mut Self::U,
        x: &mut Self::X,
        changes: impl FnOnce(&mut Self::U, &mut Self::X) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let _ = t;
        changes(u, x)
    }

    /// Jump of rows that have another form on each side of a condition ([`Events::jump`](crate::Events::jump)).
    fn jump_of_rows(&self, t: Self::S, u: &Self::U, x: &Self::X, after: Option<&Self::U>) -> Option<Fault> {
        let _ = (t, u, x, after);
        None
    }

    /// True if this condition is a requirement.
    #[inline]
    fn is_required(&self, index: usize) -> bool {
        let _ = index;
        false
    }

    /// Cause by which a run ends if this guard passes zero; `None` if it continues.
    #[inline]
    fn end_at(&self, index: usize) -> Option<Cause> {
        let _ = index;
        None
    }

    /// True if the mechanism has contact rows.
    #[inline]
    fn has_contact(&self) -> bool {
        Self::Contact::ARE_THERE
    }

    /// True if contact rows may begin to exist.
    #[inline]
    fn may_appear(&self) -> bool {
        false
    }

    /// Index of a guard of contact among all guards; `None` for a row that there is only room for.
    #[inline]
    fn place_of_guard(&self, number: usize) -> Option<usize> {
        Some(self.switches().guards + number)
    }

    /// Number of the guard of contact with this index after those of conditions.
    #[inline]
    fn number_of_guard(&self, place: usize) -> Option<usize> {
        Some(place)
    }
}
