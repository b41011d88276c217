//! Model exchange: a solver outside, to which an instance gives rates and conditions.

use alloc::vec::Vec;

use plm_runtime::words::Words;
use plm_runtime::{Cause, Events, Fault, Method, Moment, Vector};

use super::follow::{Way, has_loops};
use super::instance::differs;
use super::late::{Follows, Motion, Place};
use super::sides::{LeftOver, NEAR};
use super::{Exchanged, Instance, Interface};
use crate::{Error, Status};

/// Result of an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Update {
    /// Continuous states have other values, and may mean other coordinates.
    pub states_changed: bool,
    /// The next time at which conditions on it change, s.
    pub next: Option<f64>,
}

/// The last check of the loops: its time and state, and if the loops need other coordinates from there on.
#[derive(Clone, Copy)]
pub(super) struct Look<X> {
    pub(super) time: f64,
    pub(super) x: X,
    pub(super) leaves: bool,
}

impl<X: Vector<f64>> Look<X> {
    pub(super) fn nowhere() -> Self {
        Self { time: 0.0, x: X::fill(0.0), leaves: false }
    }

    pub(super) fn each(words: &mut impl Words, own: &mut Self) {
        words.number(&mut own.time);
        words.vector(&mut own.x);
        words.flag(&mut own.leaves);
    }
}

impl<M: Exchanged> Instance<M> {
    /// The rates of the states.
    ///
    /// # Errors
    /// When they are not determined.
    pub fn rates(&mut self) -> Result<M::X, Error> {
        self.catch_up()?;
        let state = self.state()?;
        let (mechanism, held) = (state.mechanism(), state.held());
        let mut rates = *state.x();
        if !mechanism.is_regular(&held) {
            return Err(Fault::new(state.time(), Cause::NotRegular).into());
        }
        if !mechanism.rate(state.time(), &held, state.x(), &mut rates).is_good() {
            mechanism.rate_by_rank(state.time(), &held, state.x(), &mut rates)?;
        }
        if rates.is_finite() { Ok(rates) } else { Err(Fault::new(state.time(), Cause::NotFinite).into()) }
    }

    /// How far conditions are from where they switch; negative beyond. After them, of a mechanism with loops, 1 as long as they can be
    /// followed in the coordinates that they have, else -1.
    ///
    /// # Errors
    /// [`Status::NotStarted`]; where a loop cannot be followed at all.
    pub fn indicators(&mut self) -> Result<Vec<f64>, Error> {
        self.catch_up()?;
        let state = self.state()?;
        let guards = self.left_over.indicators(state.mechanism(), state.time(), &state.held(), state.x());
        if (0..<M as Events>::G::LEN).any(|index| guards.at(index).is_nan()) {
            return Err(Fault::new(state.time(), Cause::NotFinite).into());
        }
        let leaves = self.look.is_some_and(|look| look.leaves);
        let of_loops = has_loops(self.declared()).then_some(if leaves { -1.0 } else { 1.0 });
        Ok((0..<M as Events>::G::LEN).map(|index| guards.at(index)).chain(of_loops).collect())
    }

    /// A solver has moved on: to a time, or to another state.
    ///
    /// # Errors
    /// [`Status::NotFinite`]; [`Status::Interval`]: a time before the last event.
    pub fn place(&mut self, time: Option<f64>, x: Option<M::X>) -> Result<(), Error> {
        if !(time.is_none_or(f64::is_finite) && x.is_none_or(|x| x.is_finite())) {
            return Err(Status::NotFinite.into());
        }
        let state = self.state()?;
        let (held, time) = (state.held(), time.unwrap_or(state.time()));
        // Before the last event other modes applied; the times of a solver are sums.
        if time < self.since - NEAR * self.since.abs().max(1.0) {
            return Err(Status::Interval.into());
        }
        self.hold(held, time, x.unwrap_or(*state.x()))
    }

    pub(super) fn hold(&mut self, held: M::U, time: f64, x: M::X) -> Result<(), Error> {
        let sim = self.object.sim_mut()?;
        let mechanism = *sim.state().mechanism();
        **sim = M::State::new(mechanism, held, time, x);
        Ok(())
    }

    /// The way from the last check to where the solver is; `None` if it is there, or if no loops are to be followed.
    fn way(&self) -> Result<Option<Way<'_, M>>, Error> {
        let state = self.state()?;
        let to = (state.time(), *state.x());
        let Some(Look { time, x, .. }) = self.look.filter(|_| self.follows_loops()) else { return Ok(None) };
        let is_there = time == to.0 && !differs(&x, &to.1);
        Ok((!is_there).then_some(Way { system: state.mechanism(), from: (time, x), to }))
    }

    /// The event of contact rows where a step of co-simulation has ended early.
    fn strike(&mut self) -> Result<Update, Error> {
        let state = self.state()?;
        let (mut held, mut x) = (state.held(), *state.x());
        if state.mechanism().contact_count() > 0 {
            LeftOver::none().switch(state.mechanism(), state.time(), (&mut held, &mut x), 0.0)?;
        }
        let (states_changed, time) = (differs(&x, state.x()), state.time());
        if states_changed || held != state.held() {
            self.hold(held, time, x)?;
        }
        Ok(Update { states_changed, next: None })
    }

    fn follows_loops(&self) -> bool {
        self.interface == Interface::ModelExchange && has_loops(self.declared())
    }

    /// Follows the loops to where the solver is.
    ///
    /// # Errors
    /// A fault if a loop cannot be followed.
    pub fn catch_up(&mut self) -> Result<(), Error> {
        let Some(way) = self.way()? else { return Ok(()) };
        let (time, x) = way.to;
        let reached = way.follow(self.state()?.held())?;
        self.look = Some(Look { time: reached.time, x: reached.x, leaves: reached.leaves });
        self.hold(reached.held, time, x)
    }

    /// Records that the loops have been checked at the present state.
    pub(super) fn looked(&mut self) -> Result<(), Error> {
        let state = self.state()?;
        self.look = Some(Look { time: state.time(), x: *state.x(), leaves: false });
        Ok(())
    }

    /// Discrete state where the solver is, and the state, with charts and branches of loops as they are to be after a step; whether
    /// they have changed.
    fn arrived(&self) -> Result<(M::U, M::X, bool), Error> {
        let state = self.state()?;
        if let Some(way) = self.way()? {
            let reached = way.arrive(state.held())?;
            return Ok((reached.held, reached.x, reached.leaves));
        }
        let (mut held, mut x) = (state.held(), *state.x());
        let accepted = state.mechanism().update(state.time(), &mut held, &mut x)?;
        Ok((held, x, accepted.moved))
    }

    /// A solver has made a step: checks charts and branches of loops. True if an event is to follow, because states will change.
    ///
    /// # Errors
    /// When the state cannot be the continuation of the one before.
    pub fn accept(&mut self) -> Result<bool, Error> {
        self.catch_up()?;
        let (held, x, moved) = self.arrived()?;
        if self.indicators()?.iter().take(<M as Events>::G::LEN).any(|indicator| *indicator < 0.0) {
            return Ok(true);
        }
        let sim = self.object.sim()?;
        let state = sim.state();
        let (mechanism, time) = (state.mechanism(), state.time());
        let (drift, limit) = (mechanism.drift(time, &held, &x), sim.method().drift_limit(mechanism));
        let mut left_over = self.left_over;
        left_over.forget(mechanism, time, &held, &x);
        if moved || drift.phi > limit.phi || drift.phi_dot > limit.phi_dot || differs(&x, state.x()) {
            return Ok(true);
        }
        self.left_over = left_over;
        // If loops were already followed to this place, the data along the way are more accurate.
        if !self.follows_loops() || self.way()?.is_some() {
            self.hold(held, time, x)?;
            self.looked()?;
        }
        Ok(false)
    }

    /// An event of model exchange: parameters that were changed, charts, known times, conditions. In co-simulation steps see to
    /// all that, but for impacts: outputs jump there, and a simulator reads them after the event.
    ///
    /// # Errors
    /// A requirement that does not hold, a jump, or parameters that cannot be.
    pub fn update(&mut self) -> Result<Update, Error> {
        if self.interface != Interface::ModelExchange {
            return self.strike();
        }
        let (held, before) = (self.state()?.held(), *self.state()?.x());
        self.object.sim_mut()?.project()?;
        if self.state()?.held() != held || differs(&before, self.state()?.x()) {
            self.looked()?;
        }
        let (held, x, _) = self.arrived()?;
        let mechanism = *self.state()?.mechanism();
        let here = (self.state()?.time(), x);
        let late = self.left_over.late(&Motion { system: &mechanism, held: &held }, &here);
        let due = self.left_over.of_open_gaps(&mechanism, &here, &held);
        let Passed { since, mut held, mut x, left_over } = self.passed(held, &here, late)?;
        let tolerance = self.object.tolerance().unwrap_or(0.0);
        let mut follows = Follows { since, late, tolerance, lost: self.lost };
        follows.end_flights(&mechanism, (here.0, &mut held, &mut x), &due)?;
        self.hold(held, here.0, x)?;
        // A gap that has closed away from zero is led there.
        self.object.sim_mut()?.project()?;
        (held, x) = (self.state()?.held(), *self.state()?.x());
        self.looked()?;
        (self.left_over, self.since, self.lost) = (left_over, here.0, follows.lost);
        self.instant = mechanism.next_time_event(here.0, &held).filter(|instant| *instant > here.0);
        Ok(Update { states_changed: differs(&before, &x), next: self.instant })
    }

    /// The motion after all switches that are due at a place; `late` is about how long ago they were due, s.
    fn passed(&self, held: M::U, here: &Place<M>, late: f64) -> Result<Passed<M>, Error> {
        let (mechanism, is_due) = (self.state()?.mechanism(), self.instant.is_some_and(|at| here.0 >= at));
        let motion = Motion { system: mechanism, held: &held };
        let before = self.left_over.before(&motion, here, (late, self.since));
        let Some(there) = before else {
            let ((mut after, mut x), mut left_over) = ((held, here.1), self.left_over);
            if is_due {
                mechanism.switch_at_time(here.0, &mut after, &mut x)?;
            }
            left_over.switch(mechanism, here.0, (&mut after, &mut x), late)?;
            let jump = mechanism.jump(here.0, &held, &here.1, Some(&after));
            return jump
                .map_or(Ok(Passed { since: here.0, held: after, x, left_over }), |fault| Err(fault.into()));
        };
        let state = motion.on(&there, here.0)?;
        let (mut held, mut x) = (state.held(), *state.x());
        if is_due {
            mechanism.switch_at_time(here.0, &mut held, &mut x)?;
        }
        let left_over = LeftOver::after(mechanism, (here.0, x), &held);
        Ok(Passed { since: there.0, held, x, left_over })
    }
}

/// After what has switched.
struct Passed<M: Exchanged> {
    /// Nothing had switched until then, s.
    since: f64,
    held: M::U,
    x: M::X,
    left_over: LeftOver<M::G>,
}
