//! Contract of switched mechanisms: their tables and routines, and the part of contact in their events.

use super::Switches;
use crate::contact::{self, Change, Solution, Status, Stride};
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
    /// Its contact: [`NoContact`](super::NoContact), or [`WithContact`](super::WithContact).
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

/// Part of [`Events`](crate::Events) that belongs to contact; the defaults are those of a mechanism without
/// contact.
pub trait ContactPart<M: Switched> {
    /// True if mechanisms of this type have contact rows.
    const ARE_THERE: bool = false;

    /// Gives each guard of contact with its number.
    #[inline]
    fn guards(system: &M, t: M::S, u: &M::U, x: &M::X, each: &mut impl FnMut(usize, M::S)) {
        let _ = (system, t, u, x, each);
    }

    /// Gives each guard of contact over an interval with its number. Returns false if there are no
    /// enclosures.
    #[inline]
    fn guards_within(
        system: &M,
        t: Enclosed<M::S>,
        u: &M::U,
        x: &impl Fn(usize) -> Enclosed<M::S>,
        each: &mut impl FnMut(usize, Enclosed<M::S>),
    ) -> bool {
        let _ = (system, t, u, x, each);
        true
    }

    /// As [`Events::stay`](crate::Events::stay).
    #[inline]
    fn stay(
        system: &M,
        u: &M::U,
        places: [(M::S, &M::X); 2],
        within: (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
        end: impl Fn(usize) -> M::S,
    ) -> bool {
        let _ = (system, u, places, within, end);
        false
    }

    /// Changes sides of conditions, and checks the rows that begin to exist by them.
    ///
    /// # Errors
    /// If a row begins to exist with a negative gap, or open as a constraint.
    #[inline]
    fn change_sides(
        system: &M,
        t: M::S,
        (u, x): (&mut M::U, &M::X),
        change: impl FnOnce(&mut M::U),
    ) -> Result<(), Fault> {
        let _ = (system, t, x);
        change(u);
        Ok(())
    }

    /// Finds the next modes after the guard of this number has passed zero within a step of this length.
    ///
    /// # Errors
    /// If no modes apply.
    #[inline]
    fn switch_after(
        system: &M,
        t: M::S,
        at: (&mut M::U, &mut M::X),
        event: (usize, M::S),
    ) -> Result<(), Fault> {
        let _ = (system, t, at, event);
        Ok(())
    }

    /// Finds the next modes after another event within a step of this length.
    ///
    /// # Errors
    /// If no modes apply.
    #[inline]
    fn update_after(system: &M, t: M::S, at: (&mut M::U, &mut M::X), step: M::S) -> Result<(), Fault> {
        let _ = (system, t, at, step);
        Ok(())
    }

    /// As [`Events::state_was_set`](crate::Events::state_was_set).
    ///
    /// # Errors
    /// If no modes apply.
    #[inline]
    fn state_was_set(system: &M, t: M::S, at: (&mut M::U, &mut M::X)) -> Result<(), Fault> {
        let _ = (system, t, at);
        Ok(())
    }

    /// Modes of the rows, counts, impulses and energies.
    #[inline]
    fn status(u: &M::U) -> Status<'_> {
        let _ = u;
        Status::default()
    }

    /// Sets the times at which modes change.
    #[inline]
    fn set_change(u: &mut M::U, change: Change) {
        let _ = (u, change);
    }

    /// As [`Events::stride`](crate::Events::stride).
    ///
    /// # Errors
    /// Those of the step, and of `after`.
    fn stride<const EVALUATIONS: usize>(
        system: &M,
        stride: &Stride<M::S>,
        at: (&mut M::U, &mut M::X),
        after: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<Solution<M::S>, Fault> {
        contact::smooth_stride::<M, EVALUATIONS>(system, stride, at, after)
    }
}
