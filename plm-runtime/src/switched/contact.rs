//! Contact part of a switched mechanism: without contact, or with a number of rows.

use super::Switched;
use crate::contact::{self, Change, Contacts, Modal, Solution, Status, Stride};
use crate::enclosure::Enclosed;
use crate::fault::Fault;
use crate::system::Rate;

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

/// Mechanisms without contact.
#[derive(Clone, Copy, Debug)]
pub struct NoContact;

/// Mechanisms with contact, and room for `N` rows.
#[derive(Clone, Copy, Debug)]
pub struct WithContact<const N: usize>;

impl<M: Switched> ContactPart<M> for NoContact {}

impl<M: Switched + Contacts<N>, const N: usize> ContactPart<M> for WithContact<N>
where
    <M as Rate>::U: Modal<<M as Rate>::S, N>,
{
    const ARE_THERE: bool = true;

    #[inline]
    fn guards(system: &M, t: M::S, u: &M::U, x: &M::X, each: &mut impl FnMut(usize, M::S)) {
        if system.has_contact() {
            contact::guards::<M, N>(system, t, u, x, each);
        }
    }

    #[inline]
    fn guards_within(
        system: &M,
        t: Enclosed<M::S>,
        u: &M::U,
        x: &impl Fn(usize) -> Enclosed<M::S>,
        each: &mut impl FnMut(usize, Enclosed<M::S>),
    ) -> bool {
        !system.has_contact() || contact::guards_within::<M, N>(system, t, u, x, each)
    }

    #[inline]
    fn stay(
        system: &M,
        u: &M::U,
        places: [(M::S, &M::X); 2],
        within: (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
        end: impl Fn(usize) -> M::S,
    ) -> bool {
        system.has_contact() && contact::stay::<M, N>(system, u, places, within, end)
    }

    #[inline]
    fn change_sides(
        system: &M,
        t: M::S,
        (u, x): (&mut M::U, &M::X),
        change: impl FnOnce(&mut M::U),
    ) -> Result<(), Fault> {
        if !system.may_appear() {
            change(u);
            return Ok(());
        }
        let existed = core::array::from_fn(|row| system.exists(u, row));
        change(u);
        contact::appear::<M, N>(system, t, (u, x), existed)
    }

    #[inline]
    fn switch_after(
        system: &M,
        t: M::S,
        (u, x): (&mut M::U, &mut M::X),
        event: (usize, M::S),
    ) -> Result<(), Fault> {
        if !system.has_contact() {
            return Ok(());
        }
        contact::switch_after::<M, N>(system, t, u, x, event).map(|_| ())
    }

    #[inline]
    fn update_after(system: &M, t: M::S, (u, x): (&mut M::U, &mut M::X), step: M::S) -> Result<(), Fault> {
        if !system.has_contact() {
            return Ok(());
        }
        contact::update_after::<M, N>(system, t, u, x, step).map(|_| ())
    }

    #[inline]
    fn state_was_set(system: &M, t: M::S, (u, x): (&mut M::U, &mut M::X)) -> Result<(), Fault> {
        if !system.has_contact() {
            return Ok(());
        }
        contact::state_was_set::<M, N>(system, t, u, x)
    }

    #[inline]
    fn status(u: &M::U) -> Status<'_> {
        u.status()
    }

    #[inline]
    fn set_change(u: &mut M::U, change: Change) {
        u.modes_mut().change = change;
    }

    fn stride<const EVALUATIONS: usize>(
        system: &M,
        stride: &Stride<M::S>,
        (u, x): (&mut M::U, &mut M::X),
        after: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<Solution<M::S>, Fault> {
        contact::step::<M, N, EVALUATIONS>(system, stride, u, x, after)
    }
}
