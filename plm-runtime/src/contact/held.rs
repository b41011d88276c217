//! Discrete state of contact rows in a generated mechanism: modes, multipliers, counters.
//!
//! Generated code for `N` rows (or reactions that bound frictions, if there are more of these), `rt` being [`generated`](crate::generated); `tests/contact/block.rs` has all of it for one mechanism.
//! `g` is the number of the mechanism's own conditions, `C` is `rt::contact::guard_count(N)`.
//!
//! * The discrete state has `rt::contact::Held<S, N>` as its `contact`: `open()` where it is made, `packed(&first.contact, all.map(|held|
//!   &held.contact), &number)` in `pack_held`. In charts, `Charted::Contact` is this type.
//! * Functions for any [`Scalar`]: gaps and rates of the [`Rows`](super::Rows) at a state; and the rate without contact forces, with the rest
//!   of the rows and the `responses`, what a multiplier of one adds to the rate. They read no multipliers, and of the modes the signs of
//!   reactions alone.
//! * `Rate::rate`: where [`has_forces`](Held::has_forces), that second function, then [`add_forces`](super::add_forces); else the motion, which
//!   reads `u.contact.lambda` as it reads inputs. Where nothing holds ([`slipping`](super::slipping)), the forces of rows that slip by
//!   [`slide`](super::slide) with a function of sweeps, and accelerations with them. The rate by rank and outputs need a copy by
//!   [`with_multipliers`](super::with_multipliers). Where the rate is not affine in the multipliers, the motion with that copy, then
//!   [`settle`](super::settle). Derivatives come from running all of it on [`Dual`](crate::Dual) numbers: multipliers depend on the state.
//! * [`Contacts<N>`](super::Contacts), with `rows` and `kinematics` by `pack` and `pack_held`, `rows_at` and `kinematics_at` without; `sliding`
//!   has the sizes of reactions along a line that `slide` has led to; `project_joints` and `drift_of_joints`
//!   are what `project` and `drift` of the mechanism were without contact. Where there are more reactions than rows, rows that are none
//!   do not exist.
//! * `Constraints`: [`project`](super::project), [`drift`](super::drift).
//! * [`Switched`](crate::Switched): `Guards` has `g + C` numbers, `Contact` is [`WithContact<N>`](crate::switched::WithContact), and the tables have
//!   the number of rows, `C` as `contact_guards`, and `bends` where some are bounded by a reaction in the plane. The runtime makes `Events` of it.
//! * Steps of time: `Contacts` has `motion_at`, the rate without contact forces, the responses and the rows in one pass, and `moves_by_time`.
//! * `Linear`: `held_rows` is [`held_rows`](super::held_rows).
//! * `Labels`: `contact_name` has the rows; `guard_name` of the guard `g + i` that of the row `i / 3`, of each third one that of a row which reads the
//!   reaction `i / 3`.
//! * [`begin`](super::begin) is the last thing of a start. A `renew` needs no more.

use super::booked::Booked;
use super::modes::{Change, Mode, Modes};
use super::outcome::Outcome;
use super::status::{Counts, Status};
use crate::held;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Discrete state of `N` contact rows; changed only at events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<S, const N: usize> {
    /// The modes of the rows.
    pub modes: Modes<S, N>,
    /// The multipliers, N or N m. The rate computes with a copy that has those of its moment; the state of a run has zeros.
    pub lambda: [S; N],
    /// Events of contact since the run began.
    pub counts: Counts,
    /// Impulses and energy of impacts.
    pub booked: Booked<N>,
}

impl<S: Scalar, const N: usize> Held<S, N> {
    /// Every gap is open.
    #[must_use]
    pub fn open() -> Self {
        Self {
            modes: Modes::open(),
            lambda: [S::ZERO; N],
            counts: Counts::default(),
            booked: Booked::nothing(),
        }
    }

    /// The states `all` as one in other numbers, each made by `number`. The modes are those of the `first`.
    pub fn packed<T: Scalar, const K: usize>(
        first: &Self,
        all: [&Self; K],
        number: &impl Fn([S; K]) -> T,
    ) -> Held<T, N> {
        let Self { modes: Modes { of, carried, negative, change, .. }, counts, booked, .. } = *first;
        let place = Vector::from_fn(|row| number(Vector::from_fn(|k| all[k].modes.place[row])));
        let orientation = number(Vector::from_fn(|k| all[k].modes.orientation));
        let lambda = Vector::from_fn(|row| number(Vector::from_fn(|k| all[k].lambda[row])));
        let modes = Modes { of, carried, place, orientation, negative, change };
        Held { modes, lambda, counts, booked }
    }

    /// Some row pushes or rubs; else multipliers are zero, as they are held.
    pub fn has_forces(&self) -> bool {
        self.modes.of.iter().any(|mode| mode.holds() || mode.slips())
    }
}

impl<S, const N: usize> Held<S, N> {
    /// What the rows do.
    pub fn status(&self) -> Status<'_> {
        let (counts, booked) = (self.counts, &self.booked);
        let (impulses, energy) = (&booked.impulses()[..], booked.energy());
        Status { modes: &self.modes.of, carried: &self.modes.carried, counts, impulses, energy }
    }
}

/// Modes, rows that others hold, signs of reactions, when they change, places, orientation, multipliers, impulses and energy of impacts. What was counted
/// is not shown.
impl<S: Real, const N: usize> InWords for Held<S, N> {
    fn each(&mut self, words: &mut impl Words) {
        let Modes { of, carried, place, orientation, negative, change } = &mut self.modes;
        for mode in of {
            let mut number = mode.number();
            words.word(&mut number);
            *mode = Mode::of_number(number);
        }
        for flag in carried.iter_mut().chain(negative) {
            words.flag(flag);
        }
        let mut in_steps = *change == Change::InSteps;
        words.flag(&mut in_steps);
        *change = if in_steps { Change::InSteps } else { Change::AtEvents };
        words.numbers(place);
        words.number(orientation);
        words.numbers(&mut self.lambda);
        self.booked.each(words);
    }
}

/// A discrete state that has the modes of `N` contact rows.
pub trait Modal<S, const N: usize> {
    /// The modes.
    fn modes(&self) -> &Modes<S, N>;

    /// The modes, to be changed.
    fn modes_mut(&mut self) -> &mut Modes<S, N>;

    /// Modes of the rows, counts, impulses and energies.
    fn status(&self) -> Status<'_> {
        Status::default()
    }

    /// Counts an event; from zero on where a run begins.
    fn count(&mut self, outcome: &Outcome, begins: bool) {
        let _ = (outcome, begins);
    }

    /// What was booked of impacts, where that is kept.
    fn booked(&mut self) -> Option<&mut Booked<N>> {
        None
    }
}

impl<S, const N: usize> Modal<S, N> for Modes<S, N> {
    fn modes(&self) -> &Self {
        self
    }
    fn modes_mut(&mut self) -> &mut Self {
        self
    }
}

impl<S, const N: usize> Modal<S, N> for Held<S, N> {
    fn modes(&self) -> &Modes<S, N> {
        &self.modes
    }
    fn modes_mut(&mut self) -> &mut Modes<S, N> {
        &mut self.modes
    }
    fn status(&self) -> Status<'_> {
        Self::status(self)
    }
    fn count(&mut self, outcome: &Outcome, begins: bool) {
        if begins {
            self.counts = Counts::default();
        }
        self.counts.add(outcome);
    }
    fn booked(&mut self) -> Option<&mut Booked<N>> {
        Some(&mut self.booked)
    }
}

impl<S, I, W, T, L, const N: usize> Modal<S, N> for held::Held<I, W, T, L, Held<S, N>> {
    fn modes(&self) -> &Modes<S, N> {
        &self.contact.modes
    }
    fn modes_mut(&mut self) -> &mut Modes<S, N> {
        &mut self.contact.modes
    }
    fn status(&self) -> Status<'_> {
        self.contact.status()
    }
    fn count(&mut self, outcome: &Outcome, begins: bool) {
        self.contact.count(outcome, begins);
    }
    fn booked(&mut self) -> Option<&mut Booked<N>> {
        self.contact.booked()
    }
}
