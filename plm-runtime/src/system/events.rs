//! Events of a motion: guards, kinks, time events, and what they change.

use crate::contact;
use crate::enclosure::Enclosed;
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::Rate;
use crate::vector::Vector;

/// Events, at which the discrete state changes and the state may be reset. Without any, `type G = [S; 0]` is all of it.
pub trait Events: Rate {
    /// A number for every switching condition; `[S; 0]` costs nothing.
    type G: Vector<Self::S>;

    /// Number of switching conditions; the guards after them are 1.
    #[inline]
    fn guard_count(&self) -> usize {
        Self::G::LEN
    }

    /// How far every switching condition is from switching: positive as long as the side of it that `u` holds applies.
    ///
    /// Only conditions at which the rate jumps have a guard. A relay that is on down to `low` and off up to `high` gives
    /// x - low while `u` holds it on, and high - x while `u` holds it off.
    fn guards(&self, t: Self::S, u: &Self::U, x: &Self::X, g: &mut Self::G) {
        let _ = (t, u, x, g);
    }

    /// Commits the event of the condition `index`, whose guard has passed zero: `u` gets the mode that applies from now on, of two or more,
    /// in which that guard is not negative. The event may reset the state `x`, velocities too; it then also updates the data of `u` that
    /// depends on the state.
    ///
    /// # Errors
    /// When no mode applies: the run ends, and the state is that before the event.
    fn switch(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X, index: usize) -> Result<(), Fault> {
        let _ = (t, u, x, index);
        Ok(())
    }

    /// As [`switch`](Self::switch), of the condition `index` whose guard has passed zero within a step of the length `step`, s: methods
    /// without dense output do not locate events, and so far the motion has gone on. The length is zero where nothing has.
    ///
    /// # Errors
    /// As [`switch`](Self::switch).
    fn switch_after(
        &self,
        t: Self::S,
        u: &mut Self::U,
        x: &mut Self::X,
        (index, step): (usize, Self::S),
    ) -> Result<(), Fault> {
        let _ = step;
        self.switch(t, u, x, index)
    }

    /// A condition switches where its guard passes zero and goes on to below minus this: within the band nothing does.
    fn band(&self, index: usize) -> Self::S {
        let _ = index;
        Self::S::lit(0.0)
    }

    /// The condition with this index is a requirement: where its guard passes zero the run ends with a fault.
    fn must_hold(&self, index: usize) -> bool {
        let _ = index;
        false
    }

    /// Why the run ends where the guard with this index passes zero in a step, if it does: at a pole, at the end of a domain.
    fn end(&self, index: usize) -> Option<Cause> {
        let _ = index;
        None
    }

    /// The first time after `t` at which the rate is known to jump or to bend; steps end there.
    fn next_time_event(&self, t: Self::S, u: &Self::U) -> Option<Self::S> {
        let _ = (t, u);
        None
    }

    /// Name of the condition on the time alone that changes at the time `t`, s, or next to it, as
    /// [`guard_name`](crate::Labels::guard_name) has those of the conditions on the state.
    fn instant_name(&self, t: Self::S, u: &Self::U) -> &'static str {
        let _ = (t, u);
        ""
    }

    /// Commits the time event at a time that was reached, or that a parameter or an input has moved: `u` gets the modes that apply from now on.
    /// It may reset the state, as [`switch`](Self::switch).
    ///
    /// # Errors
    /// As [`switch`](Self::switch).
    fn switch_at_time(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, u, x);
        Ok(())
    }

    /// Most kinks: numbers at whose zeros the rate has a corner; a step ends there if that matters.
    const KINKS: usize = 0;

    /// Number of kinks.
    #[inline]
    fn kink_count(&self) -> usize {
        Self::KINKS
    }

    /// Gives each of these numbers with its index.
    fn kinks(&self, t: Self::S, u: &Self::U, x: &Self::X, each: &mut impl FnMut(usize, Self::S)) {
        let _ = (t, u, x, each);
    }

    /// Guards over an interval, and kinks after them: gives each with its index, for a time and components of the state that move. False if
    /// a system cannot, and then conditions that last shorter than a small part of a step can be missed.
    fn guards_within(
        &self,
        t: Enclosed<Self::S>,
        u: &Self::U,
        x: &impl Fn(usize) -> Enclosed<Self::S>,
        each: &mut impl FnMut(usize, Enclosed<Self::S>),
    ) -> bool
    where
        Self::S: Real,
    {
        let _ = (t, u, x, each);
        false
    }

    /// True if no guard passes zero in a step, and no kink matters there, as is known without its dense output: `places` are time and state
    /// at its beginning and about its middle, `within` is what they are anywhere, `end` the guards at its end. False says nothing.
    fn stay(
        &self,
        u: &Self::U,
        places: [(Self::S, &Self::X); 2],
        within: (Enclosed<Self::S>, &impl Fn(usize) -> Enclosed<Self::S>),
        end: &Self::G,
    ) -> bool
    where
        Self::S: Real,
    {
        let _ = (u, places, within, end);
        false
    }

    /// True if some conditions or kinks matter only while others have a certain side, as [`matters`](Self::matters) reports; of 64 sides at
    /// most.
    const SELECTIVE: bool = false;

    /// Would the rate be another function if the condition `index` had its other side than `u` holds, or can it be so if those
    /// other conditions change theirs whose bits are set in `unknown`? What does not matter is not located. Its side is brought up
    /// to date after every step, so that it is right when it comes to matter. Kinks follow after the conditions.
    fn matters(&self, u: &Self::U, index: usize, unknown: u64) -> bool {
        let _ = (u, index, unknown);
        true
    }

    /// Number of [contact rows](crate::contact). Simulations of a mechanism with some step one by one, each in modes of its own.
    const CONTACTS: usize = 0;

    /// Number of contact rows: `CONTACTS`, or fewer of a system that has its size from a program.
    #[inline]
    fn contact_count(&self) -> usize {
        Self::CONTACTS
    }

    /// The first guard of a contact row, that of its gap where it is open; the guards of contact stand after all others.
    #[inline]
    fn guard_of_row(&self, u: &Self::U, row: usize) -> usize {
        self.guard_count() - Self::contacts(u).guard_count() + contact::PER_ROW * row
    }

    /// May contact forces bend sharply within a step? Those do that the size of a reaction in the plane bounds, where it passes near zero.
    const BENDS: bool = false;

    /// Contact forces of this system may bend sharply: `BENDS`, or false of a system from text without such a bound.
    #[inline]
    fn may_bend(&self) -> bool {
        Self::BENDS
    }

    /// Status of the contact rows.
    fn contacts(u: &Self::U) -> contact::Status<'_> {
        let _ = u;
        contact::Status::default()
    }

    /// Decides when the modes of contact rows change; nothing without any.
    fn change_contact(u: &mut Self::U, change: contact::Change) {
        let _ = (u, change);
    }

    /// A step of [`MoreauJean`](crate::MoreauJean) with so many evaluations of the equations of motion, and with the modes that it leads to:
    /// [`contact::step`], without rows [`contact::smooth_step`].
    ///
    /// # Errors
    /// As [`contact::step`].
    fn stride<const EVALUATIONS: usize>(
        &self,
        stride: &contact::Stride<Self::S>,
        u: &mut Self::U,
        x: &mut Self::X,
        after: impl FnOnce(&mut Self::U, &mut Self::X, &contact::Solution<Self::S>) -> Result<(), Fault>,
    ) -> Result<contact::Solution<Self::S>, Fault>
    where
        Self: Sized,
        Self::S: Real,
    {
        contact::smooth_stride::<Self, EVALUATIONS>(self, stride, (u, x), after)
    }

    /// Updates those parts of the discrete state that depend on the state, which the caller may have set: contact rows in force may have
    /// been moved away.
    ///
    /// # Errors
    /// As [`switch`](Self::switch).
    fn state_was_set(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, u, x);
        Ok(())
    }

    /// A jump that the discrete state demands: of rows whose condition has another side in `after` than in `u`; without that, of
    /// rows at whose boundary the state is.
    fn jump(&self, t: Self::S, u: &Self::U, x: &Self::X, after: Option<&Self::U>) -> Option<Fault> {
        let _ = (t, u, x, after);
        None
    }
}
