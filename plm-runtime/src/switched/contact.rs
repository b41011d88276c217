//! Contact of a mechanism that is switched: none, or so many rows.

use super::Switched;
use crate::contact::{self, Change, Contacts, Modal, Solution, Status, Stride};
use crate::enclosure::Enclosed;
use crate::fault::Fault;
use crate::system::Rate;

/// The part of [`Events`](crate::Events) that belongs to contact.
pub trait ContactPart<M: Switched + ?Sized> {
    /// Has a mechanism of this type rows of contact?
    const ARE_THERE: bool;
    /// Which rows exist, where that is a question.
    type Existing;

    /// Gives each guard of contact with its number.
    fn guards(system: &M, t: M::S, u: &M::U, x: &M::X, each: &mut impl FnMut(usize, M::S));

    /// The same over an interval; false where that is not known.
    fn guards_within(
        system: &M,
        t: Enclosed<M::S>,
        u: &M::U,
        x: &impl Fn(usize) -> Enclosed<M::S>,
        each: &mut impl FnMut(usize, Enclosed<M::S>),
    ) -> bool;

    /// As [`Events::stay`](crate::Events::stay).
    fn stay(
        system: &M,
        u: &M::U,
        places: [(M::S, &M::X); 2],
        within: (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
        end: impl Fn(usize) -> M::S,
    ) -> bool;

    /// The rows that exist.
    fn existing(system: &M, u: &M::U) -> Self::Existing;

    /// Looks at rows that have begun to exist.
    ///
    /// # Errors
    /// Where one is beyond its bound.
    fn appear(system: &M, t: M::S, at: (&M::U, &M::X), existed: Self::Existing) -> Result<(), Fault>;

    /// The next modes, as the guard of this number has passed zero within a step of this length.
    ///
    /// # Errors
    /// Where no modes apply.
    fn switch_behind(
        system: &M,
        t: M::S,
        at: (&mut M::U, &mut M::X),
        event: (usize, M::S),
    ) -> Result<(), Fault>;

    /// The next modes behind another event within a step of this length.
    ///
    /// # Errors
    /// Where no modes apply.
    fn update_behind(system: &M, t: M::S, at: (&mut M::U, &mut M::X), step: M::S) -> Result<(), Fault>;

    /// As [`Events::state_was_set`](crate::Events::state_was_set).
    ///
    /// # Errors
    /// Where no modes apply.
    fn state_was_set(system: &M, t: M::S, at: (&mut M::U, &mut M::X)) -> Result<(), Fault>;

    /// What the rows do.
    fn status(u: &M::U) -> Status<'_>;

    /// Decides when modes change.
    fn set_change(u: &mut M::U, change: Change);

    /// As [`Events::stride`](crate::Events::stride).
    ///
    /// # Errors
    /// Those of the step, and of `behind`.
    fn stride<const EVALUATIONS: usize>(
        system: &M,
        stride: &Stride<M::S>,
        at: (&mut M::U, &mut M::X),
        behind: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<Solution<M::S>, Fault>;
}

/// Without contact.
#[derive(Clone, Copy, Debug)]
pub struct NoContact;

/// With contact of so many places for rows.
#[derive(Clone, Copy, Debug)]
pub struct WithContact<const N: usize>;

impl<M: Switched> ContactPart<M> for NoContact {
    const ARE_THERE: bool = false;
    type Existing = ();

    #[inline]
    fn guards(_: &M, _: M::S, _: &M::U, _: &M::X, _: &mut impl FnMut(usize, M::S)) {}

    #[inline]
    fn guards_within(
        _: &M,
        _: Enclosed<M::S>,
        _: &M::U,
        _: &impl Fn(usize) -> Enclosed<M::S>,
        _: &mut impl FnMut(usize, Enclosed<M::S>),
    ) -> bool {
        true
    }

    #[inline]
    fn stay(
        _: &M,
        _: &M::U,
        _: [(M::S, &M::X); 2],
        _: (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
        _: impl Fn(usize) -> M::S,
    ) -> bool {
        false
    }

    #[inline]
    fn existing(_: &M, _: &M::U) {}

    #[inline]
    fn appear(_: &M, _: M::S, _: (&M::U, &M::X), (): ()) -> Result<(), Fault> {
        Ok(())
    }

    #[inline]
    fn switch_behind(_: &M, _: M::S, _: (&mut M::U, &mut M::X), _: (usize, M::S)) -> Result<(), Fault> {
        Ok(())
    }

    #[inline]
    fn update_behind(_: &M, _: M::S, _: (&mut M::U, &mut M::X), _: M::S) -> Result<(), Fault> {
        Ok(())
    }

    #[inline]
    fn state_was_set(_: &M, _: M::S, _: (&mut M::U, &mut M::X)) -> Result<(), Fault> {
        Ok(())
    }

    #[inline]
    fn status(_: &M::U) -> Status<'_> {
        Status::default()
    }

    #[inline]
    fn set_change(_: &mut M::U, _: Change) {}

    fn stride<const EVALUATIONS: usize>(
        system: &M,
        stride: &Stride<M::S>,
        (u, x): (&mut M::U, &mut M::X),
        behind: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<Solution<M::S>, Fault> {
        contact::smooth_stride::<M, EVALUATIONS>(system, stride, (u, x), behind)
    }
}

impl<M: Switched + Contacts<N>, const N: usize> ContactPart<M> for WithContact<N>
where
    <M as Rate>::U: Modal<<M as Rate>::S, N>,
{
    const ARE_THERE: bool = true;
    type Existing = Option<[bool; N]>;

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
    fn existing(system: &M, u: &M::U) -> Option<[bool; N]> {
        system.may_appear().then(|| core::array::from_fn(|row| system.exists(u, row)))
    }

    #[inline]
    fn appear(system: &M, t: M::S, at: (&M::U, &M::X), existed: Option<[bool; N]>) -> Result<(), Fault> {
        existed.map_or(Ok(()), |existed| contact::appear::<M, N>(system, t, at, existed))
    }

    #[inline]
    fn switch_behind(
        system: &M,
        t: M::S,
        (u, x): (&mut M::U, &mut M::X),
        event: (usize, M::S),
    ) -> Result<(), Fault> {
        if !system.has_contact() {
            return Ok(());
        }
        contact::switch_behind::<M, N>(system, t, u, x, event).map(|_| ())
    }

    #[inline]
    fn update_behind(system: &M, t: M::S, (u, x): (&mut M::U, &mut M::X), step: M::S) -> Result<(), Fault> {
        if !system.has_contact() {
            return Ok(());
        }
        contact::update_behind::<M, N>(system, t, u, x, step).map(|_| ())
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
        behind: impl FnOnce(&mut M::U, &mut M::X, &Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<Solution<M::S>, Fault> {
        contact::step::<M, N, EVALUATIONS>(system, stride, u, x, behind)
    }
}
