//! Events of a mechanism by its tables and routines.
//!
//! A mechanism has tables of its conditions ([`Switches`]), and routines that whoever made it evaluates: rustc's functions, an
//! interpreter, machine code. How conditions change sides, how contact follows, and where times are known is the same for all of them: a
//! mechanism that is [`Switched`] has [`Events`](crate::Events).

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
use crate::system::Rate;
use crate::vector::Vector;

/// A mechanism with conditions and contact by tables and routines.
pub trait Switched: Rate<S: Real, U: Sides<<Self as Rate>::S>> + Sized {
    /// A number for each guard, of conditions and of contact after them.
    type Guards: Vector<Self::S> + AsMut<[Self::S]> + AsRef<[Self::S]>;
    /// Its contact: [`NoContact`], or [`WithContact`].
    type Contact: ContactPart<Self>;
    /// The tables of a mechanism of this type; of one that has its size from a program the most that there is room for.
    const SWITCHES: Switches;

    /// The tables.
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

    /// Gives each of them over an interval with its number; false where that is not known, so that all are looked for by samples.
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

    /// Gives `see` the times at which conditions on the time alone change, s, and the slopes of what they compare.
    #[inline]
    fn known_times<T>(&self, u: &Self::U, see: impl FnOnce(&[Self::S], &[Self::S]) -> T) -> T {
        let _ = u;
        see(&[], &[])
    }

    /// Changes of sides or modes, and the events that follow them.
    ///
    /// # Errors
    /// Those of `changes`; events that follow each other without end.
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

    /// A jump of rows that have another form on each side of a condition ([`Events::jump`](crate::Events::jump)).
    fn jump_of_rows(&self, t: Self::S, u: &Self::U, x: &Self::X, after: Option<&Self::U>) -> Option<Fault> {
        let _ = (t, u, x, after);
        None
    }

    /// Is this condition a requirement?
    #[inline]
    fn is_required(&self, index: usize) -> bool {
        let _ = index;
        false
    }

    /// Why a run ends where this guard passes zero, if it does.
    #[inline]
    fn end_at(&self, index: usize) -> Option<Cause> {
        let _ = index;
        None
    }

    /// Has it rows of contact?
    #[inline]
    fn has_contact(&self) -> bool {
        Self::Contact::ARE_THERE
    }

    /// May rows of contact begin to exist?
    #[inline]
    fn may_appear(&self) -> bool {
        false
    }

    /// The place of a guard of contact among all guards; none of a row that there is only room for.
    #[inline]
    fn place_of_guard(&self, number: usize) -> Option<usize> {
        Some(self.switches().guards + number)
    }

    /// The number of the guard of contact that stands in this place after those of conditions.
    #[inline]
    fn number_of_guard(&self, place: usize) -> Option<usize> {
        Some(place)
    }
}
