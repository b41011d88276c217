//! The event of a contact row: impacts, then the next modes.
//!
//! 1. Impacts of all rows that touch, in one problem, until no row approaches.
//! 2. Rows that leave so slowly that rounding hides their flight are at rest: bouncing ends.
//! 3. The next modes by enumeration. A marginal inequality is decided by its rate along the candidate motion.
//! 4. Constraint rows have no rate any more; a friction that sticks stores its place.

use super::booked::{Booked, Struck};
use super::bounds::{look_at_bounds, look_at_falling_bounds};
use super::candidates::{Allowed, Solution};
use super::driven::Slip;
use super::loads::Load;
use super::marginal::is_later;
use super::margins::{PER_ROW, SIGN};
use super::modes::{Mode, Modes};
use super::multipliers::multipliers;
use super::outcome::Outcome;
use super::paradox::lost;
use super::project::{after_flights, end_flights, project, stop};
use super::rows::{Law, Rows, below, indices};
use super::scales::{acceleration, rounding, rounding_of_velocities};
use super::sunk::above;
use super::{Contacts, Modal, change_in_steps, lambda_of};
use crate::dual::Dual;
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Gap, as a fraction of the length of the mechanism, below which a row is closed at the start of a run and in steps without events.
pub(super) const CLOSED: f64 = 1e-9;
/// Error of a gap that closes at the time of an event: so many roundings of that length, ...
const ROUNDED: f64 = 64.0;
/// ... and the product of its rate with so many roundings of the time.
const LATE: f64 = 8.0;
/// Distance, as a fraction of that length, from which a gap that closes at a located event is led to zero.
const NEAR: f64 = 1e-6;
/// Slip, as a fraction of the speed that the free acceleration gives over the length of the mechanism, below which it is zero.
const NO_SLIP: f64 = 1e-10;

/// Commits the event of the guard `index`: impacts, and the modes that apply from now on.
///
/// # Errors
/// [`Cause::Impact`] where impacts have no end or no solution, [`Cause::NoMode`] where no modes satisfy all inequalities.
pub fn switch<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
    index: usize,
) -> Result<Outcome, Fault> {
    switch_after(system, t, u, x, (index, M::S::ZERO))
}

/// Commits an event as [`switch`] does, if the guard has passed zero within a step of the length `step`, s, that was not ended there. A
/// slip that the row can have got since, and a flight as short as a step, count as none.
///
/// # Errors
/// As [`switch`].
pub fn switch_after<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
    (index, step): (usize, M::S),
) -> Result<Outcome, Fault> {
    if change_in_steps(system, u) {
        return Ok(Outcome::default());
    }
    let mut occasion = Occasion::of(index, N);
    if let Occasion::Sign { load, row } = &mut occasion {
        // The reaction is zero: its rate gives the sign.
        let lambda = lambda_of(&system.rows_at(t, u, x), u.modes());
        let rows = moving_rows(system, (t, u), x, &lambda);
        let lambda = multipliers(&rows, &u.modes().of).map_or([Dual::ZERO; N], |found| found.lambda);
        let [reaction, _] = rows.reaction_at(*load, &lambda);
        u.modes_mut().negative[below::<N>(*load)] = reaction.tangents[0] < M::S::ZERO;
        *row = rows.reader(*load);
    }
    Event { system, t, occasion, step }.commit(u, x)
}

/// Finds the modes again after an event of no row: forces, motions or parameters may have jumped.
///
/// # Errors
/// As [`switch`].
pub fn update<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<Outcome, Fault> {
    update_after(system, t, u, x, M::S::ZERO)
}

/// Finds the modes as [`update`] does, after an event within a step of the length `step`, s, that was not ended there. Rows that have
/// passed the ends of their own slips and flights in the step are treated as at the events of these.
///
/// # Errors
/// As [`switch`].
pub fn update_after<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
    step: M::S,
) -> Result<Outcome, Fault> {
    if change_in_steps(system, u) {
        return Ok(Outcome::default());
    }
    Event { system, t, occasion: Occasion::Change, step }.commit(u, x)
}

/// Finds the modes of a state at the start of a run.
///
/// # Errors
/// As [`switch`]; [`Cause::Sunk`] if a gap is negative.
pub fn begin<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<Outcome, Fault> {
    let event = Event { system, t, occasion: Occasion::Start, step: M::S::ZERO };
    above((system, t), u, x, |_| true)?;
    event.commit(u, x)
}

/// Reason for finding modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Occasion {
    /// Start of a run.
    Start,
    /// An event of no row.
    Change,
    /// The guard of a row has passed zero.
    Guard { row: usize },
    /// The sign of a reaction that bounds a row changes.
    Sign { load: usize, row: Option<usize> },
    /// The determinant of the active rows passes zero.
    Determinant,
}

impl Occasion {
    /// Reason of a guard among those of `rows` rows; the last guard is that of the determinant.
    fn of(index: usize, rows: usize) -> Self {
        match (index / PER_ROW, index % PER_ROW) {
            (row, _) if row >= rows => Self::Determinant,
            (load, SIGN) => Self::Sign { load, row: None },
            (row, _) => Self::Guard { row },
        }
    }

    /// True if the motion has come to the event, false for a start or a jump.
    pub(super) fn comes_by_motion(self) -> bool {
        !matches!(self, Self::Start | Self::Change)
    }

    /// Row of the event.
    pub(super) fn row(self) -> Option<usize> {
        match self {
            Self::Start | Self::Change | Self::Determinant => None,
            Self::Guard { row } => Some(row),
            Self::Sign { row, .. } => row,
        }
    }
}

/// An event at a time.
pub(super) struct Event<'a, M: Contacts<N>, const N: usize> {
    pub(super) system: &'a M,
    pub(super) t: M::S,
    pub(super) occasion: Occasion,
    /// Longest time since the guard passed zero, s.
    pub(super) step: M::S,
}

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    fn commit(&self, u: &mut M::U, x: &mut M::X) -> Result<Outcome, Fault> {
        let laws = core::array::from_fn(|row| self.system.law(row));
        let mut rows = self.system.rows_at(self.t, u, x);
        look_at_falling_bounds(self.system, self.t, (u, x), &rows)?;
        look_at_bounds(self.system, self.t, u, &rows)?;
        if let Some((row, p)) = lost(&rows, u.modes()).filter(|_| self.occasion.comes_by_motion()) {
            return Err(self.fault(row, Cause::NotUnique { p: p.to_f64() }));
        }
        self.settle_rest(&mut rows, u, x)?;
        // Computed before the impacts: after them rates may be rounding alone.
        let none = rounding(&rows).max(rounding_of_velocities(self.system, (self.t, u), x));
        let (mut struck, mut slowest) = (Struck::nothing(), None);
        let (solution, is_ambiguous) = loop {
            self.impacts(&laws, (none, slowest, &mut rows), u, x, &mut struck)?;
            if let Occasion::Sign { load, .. } = self.occasion {
                let load = below::<N>(load);
                rows.load[load] = Load::Turned { negative: u.modes().negative[load] };
            }
            let slips = self.slips(&mut rows, u, x);
            let allowed = self.allowed(&laws, (none, struck.count, &slips), &rows, (u, x));
            let (solution, is_ambiguous) = self.choose(&rows, &allowed, u, x)?;
            let sinks = |i: usize, slow: M::S| {
                allowed[i] == Allowed::Touching && rows.rate[i] < -slow && solution.opens(i)
            };
            if slowest.is_some() || !indices::<N>().any(|i| sinks(i, none)) {
                break (solution, is_ambiguous);
            }
            // Slow approaches are no impacts for rows that close. A row that opens would penetrate, and its event would recur at once.
            let slow = none.max(self.no_slip(acceleration::<M, N>(&rows, u)));
            if !indices::<N>().any(|i| sinks(i, slow)) {
                break (solution, is_ambiguous);
            }
            slowest = Some(slow);
        };
        let impacts = struck.count;
        let before = *u.modes();
        let orientation = M::S::lit(1.0) / solution.determinant;
        let Solution { modes: of, carried, negative, .. } = solution;
        // A row that continues to stick stays in its place.
        let sticks_on = |i: usize| before.of[i] == Mode::Sticks && of[i] == Mode::Sticks;
        let place = Vector::from_fn(|i| if sticks_on(i) { before.place[i] } else { rows.gap[i] });
        let after = Modes { of, carried, place, orientation, negative, change: before.change };
        *u.modes_mut() = after;
        self.arrive((&laws, &rows), (&before, impacts), u, x)?;
        let mut outcome = Outcome { impacts, newton: solution.newton, is_ambiguous, ..Outcome::default() };
        outcome.is_undetermined = after.are_undetermined();
        outcome.doubts = struck.doubts;
        let begins = self.occasion == Occasion::Start;
        if !begins {
            outcome.compare(&before, &after);
        }
        u.count(&outcome, begins);
        if let Some(booked) = u.booked() {
            if begins {
                *booked = Booked::nothing();
            }
            booked.book(self.t.to_f64(), &struck);
        }
        Ok(outcome)
    }

    /// Moves the state to the modes that apply from now on; `before` are the modes before the event, `rows` the rows after the impacts.
    fn arrive(
        &self,
        (laws, rows): (&[Law<M::S>; N], &Rows<M::S, N>),
        (before, impacts): (&Modes<M::S, N>, u32),
        u: &M::U,
        x: &mut M::X,
    ) -> Result<(), Fault> {
        let after = u.modes();
        let begins = self.occasion == Occasion::Start;
        let closes = |i: usize| laws[i].is_unilateral() && before.is_open(i) && !after.is_open(i);
        if !begins && (impacts > 0 || indices::<N>().any(closes)) {
            end_flights(self.system, (self.t, u, rows), x);
        }
        // A gap that closes may be some tolerances away from zero: it is led there, so that no step has to. After a step of fixed
        // length a larger gap is left to the next steps.
        let most = M::S::lit(if self.step > M::S::ZERO { CLOSED } else { NEAR }) * self.system.length();
        let is_far = |i: usize| laws[i].is_unilateral() && rows.gap[i].abs() > most;
        if indices::<N>().any(|i| after.of[i] == Mode::Closed && is_far(i)) {
            stop(self.system, (self.t, u, &self.system.rows_at(self.t, u, x)), x);
            return Ok(());
        }
        project(self.system, self.t, u, x)
    }

    /// True for gaps that are closed, and for frictions that exist.
    pub(super) fn touches(&self, laws: &[Law<M::S>; N], rows: &Rows<M::S, N>, u: &M::U) -> [bool; N] {
        let modes = u.modes();
        core::array::from_fn(|i| {
            let was_closed = modes.of[i] == Mode::Closed || modes.carried[i];
            let is_due = self.occasion.row() == Some(i);
            if !self.system.exists(u, i) {
                return false;
            }
            let is_later = || is_later((rows.gap[i], rows.rate[i]), self.t, self.system.length());
            let is_near = || rows.gap[i] <= self.near(rows.rate[i]) && !is_later();
            !laws[i].is_unilateral() || was_closed || is_due || is_near()
        })
    }

    /// Gap below which a row of this rate is closed. After the start it is the rounding of state and time for a gap that closes at the
    /// time of the event: a gap that closes later, however soon, has an impact of its own.
    fn near(&self, rate: M::S) -> M::S {
        if self.occasion == Occasion::Start {
            return M::S::lit(CLOSED) * self.system.length();
        }
        let late = M::S::lit(LATE) * M::S::EPSILON * self.t.abs();
        late.mul_add((-rate).max(M::S::ZERO), M::S::lit(ROUNDED) * M::S::EPSILON * self.system.length())
    }

    /// Modes that each row may have, by its gap and its rate.
    fn allowed(
        &self,
        laws: &[Law<M::S>; N],
        (none, impacts, slips): (M::S, u32, &[Slip; N]),
        rows: &Rows<M::S, N>,
        (u, x): (&M::U, &M::X),
    ) -> [Allowed; N] {
        let (touches, acceleration) = (self.touches(laws, rows, u), acceleration::<M, N>(rows, u));
        let returns = self.returns_at_once(rows, (u, x), |i| laws[i].is_unilateral() && touches[i]);
        let is_due = |i: usize| self.occasion.row() == Some(i) || self.has_passed(rows, i, u);
        let rests = |i: usize| {
            let short = if is_due(i) { self.short(rows, i) } else { M::S::ZERO };
            laws[i].is_unilateral()
                && touches[i]
                && (returns[i] || rows.rate[i] <= self.resting(rows, i).max(none).max(short))
        };
        let behind = after_flights(rows, rests);
        core::array::from_fn(|i| {
            if let Some(mode) = laws[i].fixed(self.system.exists(u, i)) {
                return Allowed::Only(mode);
            }
            if laws[i].is_unilateral() {
                return if rests(i) { Allowed::Touching } else { Allowed::Only(Mode::Open) };
            }
            match slips[i] {
                Slip::To(mode) => return Allowed::Only(mode),
                Slip::Rests => return Allowed::Resting,
                Slip::ByForces => {}
            }
            let has_slipped = is_due(i) && impacts == 0 && u.modes().of[i].slips();
            let since = if has_slipped { self.step * acceleration } else { M::S::ZERO };
            let none = none.max(self.no_slip(acceleration)).max(since);
            match rows.rate[i] {
                // It slips only by flights that are ignored.
                slip if slip.abs() > none && behind[i].abs() <= none => Allowed::Resting,
                slip if slip > none => Allowed::Only(Mode::Forwards),
                slip if slip < -none => Allowed::Only(Mode::Backwards),
                _ if rows.turns(i, none, self.system.length()) => {
                    let forwards = rows.free[i] > M::S::ZERO;
                    Allowed::Only(if forwards { Mode::Forwards } else { Mode::Backwards })
                }
                _ => Allowed::Resting,
            }
        })
    }

    /// True if the motion has passed the end of a slip or of a flight in the step, which another event of that step ended first.
    fn has_passed(&self, rows: &Rows<M::S, N>, row: usize, u: &M::U) -> bool {
        let (row, zero) = (below::<N>(row), M::S::ZERO);
        let beyond = match u.modes().of[row] {
            Mode::Open => rows.gap[row],
            mode @ (Mode::Forwards | Mode::Backwards) => mode.sign::<M::S>() * rows.rate[row],
            Mode::Closed | Mode::Off | Mode::Sticks => zero,
        };
        self.step > zero && beyond < zero
    }

    /// Speed below which a friction does not slip.
    fn no_slip(&self, acceleration: M::S) -> M::S {
        M::S::lit(NO_SLIP) * (acceleration * self.system.length()).sqrt()
    }

    pub(super) fn fault(&self, row: usize, cause: Cause) -> Fault {
        Fault::of_part(self.t.to_f64(), self.system.contact_name(row), cause)
    }
}

/// The rows with their rates of change under the contact forces `lambda`.
pub(super) fn moving_rows<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u): (M::S, &M::U),
    x: &M::X,
    lambda: &[M::S; N],
) -> Rows<Dual<M::S, 1>, N> {
    let mut motion = *x;
    let _ = system.free_rate(t, u, x, &mut motion);
    let response = system.response(t, u, x, lambda);
    motion.add([(M::S::lit(1.0), &response)]);
    let moving = |i: usize| Dual { value: x.at(i), tangents: [motion.at(i)] };
    system.rows(Dual::variable(t, 0), u, &moving, &Dual::constant)
}
