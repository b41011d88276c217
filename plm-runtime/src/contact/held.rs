//! Discrete state of contact rows in a generated mechanism: modes, multipliers, counters.
//!
//! Generated code for `N` rows (or reactions that bound frictions, if there are more of these) has the following parts. `rt` is
//! [`generated`](crate::generated), `g` is the number of the mechanism's own conditions, `C` is `rt::contact::guard_count(N)`.
//! `tests/contact/block.rs` shows all of it for one mechanism.
//!
//! * The discrete state has `rt::contact::Held<S, N>` as its `contact`: `open()` where it is made, `packed(&first.contact, all.map(|held|
//!   &held.contact), &number)` in `pack_held`. In charts, `Charted::Contact` is this type.
//! * Functions for any [`Scalar`]: gaps and rates of the [`Rows`](super::Rows) at a state; and the rate without contact forces, with the
//!   other parts of the rows and the `responses`, the changes of the rate by unit multipliers. They read no multipliers, and of the modes
//!   only the signs of reactions.
//! * `Rate::rate`: if [`has_forces`](Held::has_forces), that second function, then [`add_forces`](super::add_forces); else the motion,
//!   which reads `u.contact.lambda` as it reads inputs. If no row is a constraint ([`slipping`](super::slipping)),
//!   [`slide`](super::slide) with a function of sweeps gives the forces of slipping rows and the accelerations. The rate by rank and
//!   outputs need a copy by [`with_multipliers`](super::with_multipliers). If the rate is not affine in the multipliers: the motion with
//!   that copy, then [`settle`](super::settle). Derivatives come from running all of it on [`Dual`](crate::Dual) numbers, since
//!   multipliers depend on the state.
//! * [`Contacts<N>`](super::Contacts), with `rows` and `kinematics` by `pack` and `pack_held`, `rows_at` and `kinematics_at` without;
//!   `sliding` returns the sizes of reactions along a line from `slide`; `project_joints` and `drift_of_joints` are `project` and `drift`
//!   of the mechanism without contact. If there are more reactions than rows, the surplus rows do not exist.
//! * `Constraints`: [`project`](super::project), [`drift`](super::drift).
//! * [`Switched`](crate::Switched): `Guards` has `g + C` numbers, `Contact` is [`WithContact<N>`](crate::switched::WithContact), and the
//!   tables have the number of rows, `C` as `contact_guards`, and `bends` if a reaction in the plane bounds a row. The runtime derives
//!   `Events`.
//! * Time steps: `Contacts` has `motion_at`, the rate without contact forces, the responses and the rows in one pass, and
//!   `moves_by_time`.
//! * `Linear`: `held_rows` is [`held_rows`](super::held_rows).
//! * `Labels`: in the table, `contacts` has the rows; the guard `g + i` has the name of the row `i / 3`, each third one that of a row which
//!   reads the reaction `i / 3`.
//! * [`begin`](super::begin) is the last call of a start. `renew` needs no more.

use super::booked::Booked;
use super::modes::{Change, Mode, Modes};
use super::outcome::Outcome;
use super::status::{Counts, Status};
use crate::held;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Discrete state of `N` contact rows: constant during a step, changed only at events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<S, const N: usize> {
    /// The modes of the rows.
    pub modes: Modes<S, N>,
    /// Multipliers, N or N m. The rate uses a copy with those at its state; in the state of a run they are zero.
    pub lambda: [S; N],
    /// Events of contact since the run began.
    pub counts: Counts,
    /// Impulses and energy of impacts.
    pub booked: Booked<N>,
}

impl<S: Scalar, const N: usize> Held<S, N> {
    /// State with all gaps open.
    #[must_use]
    pub fn open() -> Self {
        Self {
            modes: Modes::open(),
            lambda: [S::ZERO; N],
            counts: Counts::default(),
            booked: Booked::nothing(),
        }
    }

    /// The states `all` as one state in other numbers, each made by `number`. The modes are those of `first`.
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

    /// True if some row is a constraint or slips; else all multipliers are zero, as stored.
    pub fn has_forces(&self) -> bool {
        self.modes.of.iter().any(|mode| mode.holds() || mode.slips())
    }
}

impl<S, const N: usize> Held<S, N> {
    /// Status of the rows.
    pub fn status(&self) -> Status<'_> {
        let (counts, booked) = (self.counts, &self.booked);
        let (impulses, energy) = (&booked.impulses()[..], booked.energy());
        Status { modes: &self.modes.of, carried: &self.modes.carried, counts, impulses, energy }
    }
}

/// Words of the modes, the rows that others carry, the signs of reactions, the time of changes, places, orientation, multipliers, and of
/// impulses and energy of impacts. Counters are left out.
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

/// A discrete state that contains the modes of `N` contact rows.
pub trait Modal<S, const N: usize> {
    /// The modes.
    fn modes(&self) -> &Modes<S, N>;

    /// The modes, mutable.
    fn modes_mut(&mut self) -> &mut Modes<S, N>;

    /// Modes of the rows, counts, impulses and energies.
    fn status(&self) -> Status<'_> {
        Status::default()
    }

    /// Counts an event; the counters restart at zero if a run begins.
    fn count(&mut self, outcome: &Outcome, begins: bool) {
        let _ = (outcome, begins);
    }

    /// Record of impacts, if the state has one.
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
    fn status(&self) -> Status<'_> {
        Status { modes: &self.of, carried: &self.carried, ..Status::default() }
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
