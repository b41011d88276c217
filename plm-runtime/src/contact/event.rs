//! The event of a contact row: impacts, then the next modes.
//!
//! 1. Impacts of all rows that touch, in one problem, until no row approaches.
//! 2. Rows that leave more slowly than rounding allows to follow rest: bouncing has an end.
//! 3. The next modes by enumeration. A marginal inequality is decided by its rate along the candidate.
//! 4. Rows that hold have no rate any more; a friction that sticks remembers its place.

use super::candidates::{Allowed, Found, MARGINAL, Margins, Solution, enumerate};
use super::impact::{ImpactLaw, Impulses, impulses};
use super::margins::{PER_ROW, margins, stick};
use super::modes::{Mode, Modes};
use super::multipliers::multipliers;
use super::project::stop;
use super::rows::{Law, Rows};
use super::{Contacts, moved, rows_at};
use crate::dual::Dual;
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::Events;
use crate::vector::Vector;

/// A gap below this fraction of the length of the mechanism is closed.
const CLOSED: f64 = 1e-9;
/// A flight of a height below so many roundings of the length is none.
const LOWEST_FLIGHT: f64 = 1000.0;
/// A slip is none below this fraction of the speed that the free acceleration gives over the length of the mechanism.
const NO_SLIP: f64 = 1e-10;
/// A rate of so many roundings of the largest one, before the impacts of the event, is none.
const RATE_ULPS: f64 = 4096.0;
/// Impacts one after the other, at most.
const MOST_IMPACTS: u32 = 30;
/// Impacts of pairs one after the other, at most.
const MOST_PAIRS: u32 = 1000;
/// A margin that is zero within this time is zero, s: times of events are known so well.
const AT_ONCE: f64 = 1e-10;
/// The rate of a margin is none below this fraction of its terms.
const NO_RATE: f64 = 1e-9;

/// What an event did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Impacts.
    pub impacts: u32,
    /// The rows may go on with other accelerations as well.
    pub is_ambiguous: bool,
}

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
    Event { system, t, due: Some(index / PER_ROW).filter(|row| *row < N) }.commit(u, x)
}

/// Finds the modes of a state where a run begins.
///
/// # Errors
/// As [`switch`]; [`Cause::Sunk`] where a gap is negative.
pub fn begin<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<Outcome, Fault> {
    let event = Event { system, t, due: None };
    let rows = rows_at(system, t, u, x);
    let deepest = (0..N)
        .filter(|i| system.law(*i).is_unilateral())
        .reduce(|a, b| if rows.gap[b] < rows.gap[a] { b } else { a });
    if let Some(row) = deepest.filter(|row| rows.gap[*row] < -event.closed()) {
        return Err(event.fault(row, Cause::Sunk { by: -rows.gap[row].to_f64() }));
    }
    event.commit(u, x)
}

/// An event at a time.
struct Event<'a, M: Contacts<N>, const N: usize> {
    system: &'a M,
    t: M::S,
    /// The row whose guard has passed zero.
    due: Option<usize>,
}

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    fn commit(&self, u: &mut M::U, x: &mut M::X) -> Result<Outcome, Fault> {
        let laws = core::array::from_fn(|row| self.system.law(row));
        // Before the impacts, behind which rates may be rounding alone.
        let none = rounding(&rows_at(self.system, self.t, u, x));
        let impacts = self.impacts(&laws, none, u, x)?;
        let rows = rows_at(self.system, self.t, u, x);
        let allowed = self.allowed(&laws, none, &rows, u);
        let (solution, is_ambiguous) = match enumerate(&rows, &allowed, |solution, margins| {
            self.admits(u, x, solution, margins)
        }) {
            Found::Modes(solution, is_ambiguous) => (solution, is_ambiguous),
            Found::Nothing => {
                return Err(self.fault(self.row(&allowed), Cause::NoMode { touching: touching(&allowed) }));
            }
            Found::TooMany => {
                return Err(
                    self.fault(self.row(&allowed), Cause::TooManyContacts { touching: touching(&allowed) })
                );
            }
        };
        let place = rows.gap;
        let orientation = if solution.determinant < M::S::ZERO { M::S::lit(-1.0) } else { M::S::lit(1.0) };
        *M::modes_mut(u) = Modes { of: solution.modes, carried: solution.carried, place, orientation };
        stop(self.system, self.t, u, x);
        Ok(Outcome { impacts, is_ambiguous })
    }

    /// Impacts of all rows that touch, until none approaches.
    fn impacts(&self, laws: &[Law<M::S>; N], none: M::S, u: &M::U, x: &mut M::X) -> Result<u32, Fault> {
        let law = self.system.impact_law();
        let most = if law == ImpactLaw::Sequential { MOST_PAIRS } else { MOST_IMPACTS };
        let mut count = 0;
        loop {
            let rows = rows_at(self.system, self.t, u, x);
            let touches = self.touches(laws, &rows, u);
            let approaches = |i: &usize| {
                touches[*i] && laws[*i].is_unilateral() && rows.rate[*i] < -self.resting(&rows, *i).max(none)
            };
            let Some(row) = (0..N).find(approaches) else { return Ok(count) };
            if count >= most {
                return Err(self.fault(row, Cause::Impact { tried: count }));
            }
            count += 1;
            let Impulses::Found(impulses) = impulses(&rows, laws, (law, touches)) else {
                return Err(self.fault(row, Cause::Impact { tried: count }));
            };
            moved(self.system, (self.t, u), x, &impulses);
        }
    }

    /// Gaps that are closed, and frictions.
    fn touches(&self, laws: &[Law<M::S>; N], rows: &Rows<M::S, N>, u: &M::U) -> [bool; N] {
        let modes = M::modes(u);
        core::array::from_fn(|i| {
            let was_closed = modes.of[i] == Mode::Closed || modes.carried[i];
            !laws[i].is_unilateral() || was_closed || self.due == Some(i) || rows.gap[i] <= self.closed()
        })
    }

    /// The modes that each row may have, by its gap and its rate.
    fn allowed(&self, laws: &[Law<M::S>; N], none: M::S, rows: &Rows<M::S, N>, u: &M::U) -> [Allowed; N] {
        let touches = self.touches(laws, rows, u);
        core::array::from_fn(|i| {
            if laws[i].is_unilateral() {
                let rests = touches[i] && rows.rate[i] <= self.resting(rows, i).max(none);
                return if rests { Allowed::Touching } else { Allowed::Only(Mode::Open) };
            }
            let none = none.max(self.no_slip(rows, u));
            match rows.rate[i] {
                slip if slip > none => Allowed::Only(Mode::Forwards),
                slip if slip < -none => Allowed::Only(Mode::Backwards),
                _ => Allowed::Resting,
            }
        })
    }

    /// Are the inequalities of a combination met, those that are marginal also from here on?
    fn admits(&self, u: &M::U, x: &M::X, solution: &Solution<M::S, N>, margins: &Margins<M::S, N>) -> bool {
        let mut held = *u;
        let modes = M::modes_mut(&mut held);
        (modes.of, modes.carried) = (solution.modes, solution.carried);
        let mut motion = *x;
        let _ = self.system.free_rate(self.t, &held, x, &mut motion);
        let response = self.system.response(self.t, &held, x, &solution.lambda);
        motion.add([(M::S::lit(1.0), &response)]);
        let rows: Rows<Dual<M::S, 1>, N> = self
            .system
            .rows(Dual::variable(self.t, 0), &held, &|i| Dual { value: x.at(i), tangents: [motion.at(i)] });
        go_on(&rows, solution, margins)
    }

    fn closed(&self) -> M::S {
        M::S::lit(CLOSED) * self.system.length()
    }

    /// Slower than this a row rests: its flight would be lower than rounding.
    fn resting(&self, rows: &Rows<M::S, N>, row: usize) -> M::S {
        let height = M::S::lit(LOWEST_FLIGHT) * M::S::EPSILON * self.system.length();
        (M::S::lit(2.0) * rows.free[row].abs() * height).sqrt()
    }

    /// Slower than this a friction does not slip.
    fn no_slip(&self, rows: &Rows<M::S, N>, u: &M::U) -> M::S {
        let speed = (Self::acceleration(rows, u) * self.system.length()).sqrt();
        M::S::lit(NO_SLIP) * speed
    }

    /// The largest term of an acceleration of the rows, with the forces of the modes until now.
    fn acceleration(rows: &Rows<M::S, N>, u: &M::U) -> M::S {
        let lambda = multipliers(rows, &M::modes(u).of).map_or([M::S::ZERO; N], |found| found.lambda);
        (0..N).fold(M::S::ZERO, |largest, i| {
            let terms = rows.delassus[i].iter().zip(&lambda);
            terms.fold(largest.max(rows.free[i].abs()), |largest, (d, lambda)| {
                largest.max((*d * *lambda).abs())
            })
        })
    }

    /// The row that a fault names.
    fn row(&self, allowed: &[Allowed; N]) -> usize {
        let first = allowed.iter().position(|row| *row == Allowed::Touching);
        self.due.or(first).unwrap_or(0)
    }

    fn fault(&self, row: usize, cause: Cause) -> Fault {
        Fault::of_part(self.t.to_f64(), self.system.row_name(row), cause)
    }
}

/// Rounding of the rates.
fn rounding<S: Real, const N: usize>(rows: &Rows<S, N>) -> S {
    let largest = rows.rate.iter().fold(S::ZERO, |largest, rate| largest.max(rate.abs()));
    S::lit(RATE_ULPS) * S::EPSILON * largest
}

fn touching<const N: usize>(allowed: &[Allowed; N]) -> usize {
    allowed.iter().filter(|row| **row == Allowed::Touching).count()
}

/// True if every margin is positive, or zero and not falling.
fn go_on<S: Real, const N: usize>(
    rows: &Rows<Dual<S, 1>, N>,
    solution: &Solution<S, N>,
    margins: &Margins<S, N>,
) -> bool {
    let Some(found) = multipliers(rows, &solution.modes) else { return false };
    let lambda = found.lambda;
    (0..N).all(|i| {
        let (value, Some(terms)) = (margins.value[i], margins.size[i]) else { return true };
        let acceleration = rows.acceleration(i, &lambda);
        let (margin, size) = match solution.modes[i] {
            Mode::Closed => (lambda[i], size(rows, i, &lambda) / rows.delassus[i][i].value),
            Mode::Sticks => {
                let [lower, upper] = stick(rows, i, &lambda);
                let nearer = if lower.value < upper.value { lower } else { upper };
                (nearer, size(rows, i, &lambda) / rows.delassus[i][i].value)
            }
            Mode::Backwards => (-acceleration, size(rows, i, &lambda)),
            _ => (acceleration, size(rows, i, &lambda)),
        };
        let slope = margin.tangents[0];
        let none = (S::lit(MARGINAL) * terms).max(S::lit(AT_ONCE) * slope.abs());
        value > none || value >= -none && slope >= -S::lit(NO_RATE) * size
    })
}

/// The size of the terms of the rate of an acceleration.
fn size<S: Real, const N: usize>(rows: &Rows<Dual<S, 1>, N>, row: usize, lambda: &[Dual<S, 1>; N]) -> S {
    let terms = rows.delassus[row].iter().zip(lambda);
    let moved = |sum: S, (d, lambda): (&Dual<S, 1>, &Dual<S, 1>)| {
        sum + (d.value * lambda.value).abs() + (d.value * lambda.tangents[0]).abs()
    };
    terms.fold(rows.free[row].value.abs() + rows.free[row].tangents[0].abs(), moved)
}

/// Guards of the rows in the modes held, for [`Events::guards`].
pub fn guards<M: Contacts<N> + Events, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &M::X,
    g: &mut M::G,
) {
    let (rows, modes) = (rows_at(system, t, u, x), M::modes(u));
    if !margins(&rows, (modes, modes.orientation), &mut |i, margin| g.set(i, margin)) {
        g.set(PER_ROW * N, M::S::lit(-1.0));
    }
}
