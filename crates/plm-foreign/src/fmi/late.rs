//! Conditions that an external solver reports late.
//!
//! A solver may read indicators at the ends of its steps alone, or find their zeros by halves. Until then the motion has gone on in modes
//! that no longer applied: what slips has a velocity to the other side, what falls has penetrated. So the motion is traced back to where
//! the conditions were on their sides, and a run leads on from there, with the events that come on that way.

use plm_runtime::contact::Mode;
use plm_runtime::{Fault, Moment, Rate, Scalar, Vector};

use super::Exchanged;
use super::method::{Settings, run};

/// Parts of a way by Kutta's formula.
const PARTS: u32 = 8;
/// Ways of four times the length that are tried.
const MOST_TRIED: u32 = 16;
/// A way begins beyond the zero by this part of it.
const BEYOND: f64 = 1.25;
/// There and back again leads to where it began, but for this fraction of the typical size and this one of the way: else the equations
/// are too stiff to go back by.
const OFF: (f64, f64) = (1e-9, 1e-4);
/// The time of differences by the time, s, and of differences of these.
const APART: [f64; 2] = [1e-7, 1e-4];
/// A solver with a tolerance raises and lowers a flight by some times that, at each of its ends.
const FLIGHTS: f64 = 10.0;
/// A solver that is late by up to a step lifts a flight of so many steps by more than it is high, if it is of first order.
const SHORT: f64 = 3.0;

/// The motion at a constant discrete state.
pub(super) struct Motion<'a, M: Exchanged> {
    pub(super) system: &'a M,
    pub(super) held: &'a M::U,
}

/// Point of a motion: time, s, and state.
pub(super) type Place<M> = (f64, <M as Rate>::X);

impl<M: Exchanged> Motion<'_, M> {
    fn rate(&self, (t, x): &Place<M>) -> Option<M::X> {
        let mut rate = *x;
        let health = self.system.rate(*t, self.held, x, &mut rate);
        (health.is_good() && rate.is_finite()).then_some(rate)
    }

    /// By a time on, or back where that is negative.
    fn led(&self, from: &Place<M>, by: f64) -> Option<Place<M>> {
        let h = by / f64::from(PARTS);
        let mut at = *from;
        for _ in 0..PARTS {
            let (t, x) = at;
            let along = |k: &M::X, part: f64| (t + part * h, x.map2(k, |x, k| x + part * h * k));
            let first = self.rate(&at)?;
            let second = self.rate(&along(&first, 0.5))?;
            let third = self.rate(&along(&second, 0.5))?;
            let fourth = self.rate(&along(&third, 1.0))?;
            let sum = first.map2(&second, |a, b| a + 2.0 * b).map2(&third, |a, b| a + 2.0 * b);
            at = along(&sum.map2(&fourth, |a, b| (a + b) / 6.0), 1.0);
        }
        Some((from.0 + by, at.1))
    }

    /// How fast numbers of the state change.
    pub(super) fn slopes(&self, at: &Place<M>, of: impl Fn(&Place<M>) -> M::G) -> Option<M::G> {
        let [h, _] = APART.map(|h| h * at.0.abs().max(1.0));
        let rate = self.rate(at)?;
        let ahead = (at.0 + h, at.1.map2(&rate, |x, rate| x + h * rate));
        Some(of(&ahead).map2(&of(at), |ahead, here| (ahead - here) / h))
    }

    /// A place on the way to here at which `holds` says that conditions are on their sides, where they have gone beyond for about so long
    /// a time; none where there is none since the last event, or no way back.
    pub(super) fn before(
        &self,
        here: &Place<M>,
        (late, since): (f64, f64),
        holds: impl Fn(&Place<M>) -> bool,
    ) -> Option<Place<M>> {
        let most = here.0 - since;
        let mut by = BEYOND * late;
        for _ in 0..MOST_TRIED {
            by = by.min(most);
            let there = self.led(here, -by)?;
            if holds(&there) {
                return self.returns(here, &there).then_some(there);
            }
            if by >= most {
                return None;
            }
            by *= 4.0;
        }
        None
    }

    /// Does the way from there lead here?
    fn returns(&self, here: &Place<M>, there: &Place<M>) -> bool {
        let Some((_, again)) = self.led(there, here.0 - there.0) else { return false };
        let typical = self.system.typical();
        // False for NaN.
        (0..M::X::LEN).all(|i| {
            let (off, way) = (again.at(i) - here.1.at(i), here.1.at(i) - there.1.at(i));
            off.abs() <= OFF.0 * typical.at(i) + OFF.1 * way.abs()
        })
    }

    /// The run from a place on to a time.
    ///
    /// # Errors
    /// As [`Sim::step_to`](plm_runtime::Sim::step_to).
    pub(super) fn on(&self, from: &Place<M>, until: f64) -> Result<M::State, Fault> {
        let state = M::State::new(*self.system, *self.held, from.0, from.1);
        run::<M>(Settings::usual::<M>(), state, (until, false)).map(|(state, _)| state)
    }

    /// The flight of an open gap whose guard this is: its height above zero, and how long it is; none where nothing pulls it back.
    fn flight(&self, at: &Place<M>, guard: usize) -> Option<(f64, f64)> {
        let gap = |at: &Place<M>| guards(self.system, at, self.held).at(guard);
        let slope = |at: &Place<M>| Some(self.slopes(at, |at| guards(self.system, at, self.held))?.at(guard));
        let h = APART[1];
        let rate = slope(at)?;
        let pull = (rate - slope(&self.led(at, h)?)?) / h;
        let height = gap(at).max(0.0) + rate * rate / (2.0 * pull);
        (pull > 0.0).then(|| (height, 2.0 * Scalar::sqrt(2.0 * height / pull)))
    }

    /// By how much a gap is off where the state is off by a tolerance of its typical sizes.
    fn resolved(&self, at: &Place<M>, guard: usize, tolerance: f64) -> f64 {
        let (typical, here) = (self.system.typical(), guards(self.system, at, self.held).at(guard));
        (0..M::NQ).fold(0.0, |sum, i| {
            let mut x = at.1;
            x.set(i, x.at(i) + tolerance * typical.at(i));
            sum + (guards(self.system, &(at.0, x), self.held).at(guard) - here).abs()
        })
    }
}

fn guards<M: Exchanged>(system: &M, (t, x): &Place<M>, held: &M::U) -> M::G {
    let mut guards = M::G::fill(0.0);
    system.guards(*t, held, x, &mut guards);
    guards
}

/// Limits of what a solver outside can follow.
pub(super) struct Follows {
    /// Nothing had switched until then, s.
    pub(super) since: f64,
    /// How late it has handed an event over, s.
    pub(super) late: f64,
    /// Its tolerance; zero if it has given none.
    pub(super) tolerance: f64,
    /// Events in a row at which a gap was negative that had not been struck.
    pub(super) lost: u64,
}

impl Follows {
    /// Number of such events from which on the flight is lower than the error of the solver: a single one may come from a start that
    /// penetrates by rounding.
    const LOST: u64 = 2;

    /// Was a row struck at the event?
    fn struck<M: Exchanged>(&self, held: &M::U, row: usize) -> bool {
        M::contacts(held).impulse(row).is_some_and(|impulse| impulse.time >= self.since)
    }

    /// The open gaps that were `due`, and are open without an impact: the solver has gone below zero where the motion has not.
    fn lost<'a, M: Exchanged>(
        &'a self,
        system: &'a M,
        held: &'a M::U,
        due: &'a M::G,
    ) -> impl Fn(usize) -> bool + 'a {
        move |row| {
            let is_open = M::contacts(held).mode(row) == Some(Mode::Open);
            is_open && due.at(system.guard_of_row(held, row)) < 0.0 && !self.struck::<M>(held, row)
        }
    }

    /// Ends flights that the solver cannot follow: those of gaps that were struck, where they are lower than its tolerance makes of the gap,
    /// or as short as it was late, three times; and those that it has lost. `due` are the indicators of open gaps before the event.
    ///
    /// # Errors
    /// As [`Events::switch`](plm_runtime::Events::switch).
    pub(super) fn end_flights<M: Exchanged>(
        &mut self,
        system: &M,
        (t, held, x): (f64, &mut M::U, &mut M::X),
        due: &M::G,
    ) -> Result<(), Fault> {
        let any = (0..system.contact_count()).any(self.lost(system, held, due));
        self.lost = if any { self.lost + 1 } else { 0 };
        for row in 0..system.contact_count() {
            let is_lost = self.lost >= Self::LOST && self.lost(system, held, due)(row);
            let is_struck = self.struck::<M>(held, row) && M::contacts(held).mode(row) == Some(Mode::Open);
            if !is_lost && !is_struck {
                continue;
            }
            let (guard, at) = (system.guard_of_row(held, row), (t, *x));
            let motion = Motion { system, held: &*held };
            let Some((height, length)) = motion.flight(&at, guard) else { continue };
            let lowest = FLIGHTS * motion.resolved(&at, guard, self.tolerance);
            if is_lost || height <= lowest || length <= SHORT * self.late {
                system.switch_after(t, held, x, (guard, BEYOND * length))?;
            }
        }
        Ok(())
    }
}
