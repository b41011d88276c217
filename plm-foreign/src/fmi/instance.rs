//! An instance of an FMU, without pointers.

use alloc::vec;
use alloc::vec::Vec;

use plm_runtime::words::{InWords, Words};
use plm_runtime::{Cause, Fault, Method, Moment, Seen, Sim, Vector};

use super::sides::LeftOver;
use super::{Call, Exchanged, Interface, Mode, Variable, tangent};
use crate::{Kind, Object, Status, Trouble, saved};

/// A mechanism that is set up, then run: by steps of its own method (co-simulation), or by a solver outside, to which it
/// gives rates and conditions (model exchange).
#[derive(Clone)]
pub struct Instance<M: Exchanged> {
    declared: M,
    pub(super) interface: Interface,
    pub(super) mode: Mode,
    object: Object<M>,
    /// Inputs as set before the start.
    inputs: Vec<Option<f64>>,
    start_time: f64,
    /// Something was set since the mechanism was assembled.
    is_stale: bool,
    /// The next time at which conditions on it change, s.
    instant: Option<f64>,
    left_over: LeftOver<M::G>,
}

/// What an event has led to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Update {
    /// Continuous states have other values, and may mean other coordinates.
    pub states_changed: bool,
    /// The next time at which conditions on it change, s.
    pub next: Option<f64>,
}

impl<M: Exchanged> Instance<M> {
    /// A mechanism that is not started.
    pub fn new(declared: M, interface: Interface) -> Self {
        Self {
            declared,
            interface,
            mode: Mode::Instantiated,
            object: Object::new(declared),
            inputs: vec![None; M::TABLES.inputs.len()],
            start_time: 0.0,
            is_stale: true,
            instant: None,
            left_over: LeftOver::none(),
        }
    }

    /// As it was made.
    pub fn reset(&mut self) {
        *self = Self::new(self.declared, self.interface);
    }

    /// It will start at this time, s.
    ///
    /// # Errors
    /// [`Status::NotFinite`]
    pub fn begin_at(&mut self, time: f64) -> Result<(), Trouble> {
        if !time.is_finite() {
            return Err(Status::NotFinite.into());
        }
        (self.start_time, self.is_stale) = (time, true);
        Ok(())
    }

    /// Is it past its initialisation?
    fn is_running(&self) -> bool {
        !matches!(self.mode, Mode::Instantiated | Mode::Initialization)
    }

    /// A function has been called: the mode after it.
    pub fn pass(&mut self, call: Call) {
        self.mode = call.leads(self.interface, self.mode);
    }

    /// Assembles it where something was set since, unless it runs.
    ///
    /// # Errors
    /// When it cannot be assembled.
    pub fn renew(&mut self) -> Result<(), Trouble> {
        if self.is_running() || !self.is_stale {
            return Ok(());
        }
        self.object.start_at(self.start_time)?;
        for (index, value) in self.inputs.iter().enumerate() {
            if let Some(value) = value {
                self.object.set(Kind::Input, index, *value)?;
            }
        }
        // Sides of conditions may depend on inputs.
        self.object.start_at(self.start_time)?;
        self.is_stale = false;
        Ok(())
    }

    /// Sets a variable.
    ///
    /// # Errors
    /// [`Status::ReadOnly`]: it is computed, or it cannot be set in this mode: a start value of a mechanism that runs, a
    /// parameter in Continuous-Time Mode, a state in another one; as [`Object::set`].
    pub fn set(&mut self, variable: Variable, value: f64) -> Result<(), Trouble> {
        let (is_running, is_continuous) = (self.is_running(), self.mode == Mode::ContinuousTime);
        self.is_stale |= !is_running;
        match variable {
            Variable::Parameter(index) if !is_continuous => self.object.set(Kind::Parameter, index, value),
            Variable::Start(index) if !is_running => self.object.set(Kind::Start, index, value),
            Variable::State(index) if is_continuous => {
                let mut x = *self.state()?.x();
                x.set(index, value);
                self.place(None, Some(x))
            }
            Variable::Input(index) if is_running => self.object.set(Kind::Input, index, value),
            Variable::Input(_) if !value.is_finite() => Err(Status::NotFinite.into()),
            Variable::Input(index) => {
                *self.inputs.get_mut(index).ok_or(Status::NoSuch)? = Some(value);
                Ok(())
            }
            _ => Err(Status::ReadOnly.into()),
        }
    }

    /// The value of a variable.
    ///
    /// # Errors
    /// When the mechanism cannot be assembled, or its rate cannot be computed.
    pub fn get(&mut self, variable: Variable) -> Result<f64, Trouble> {
        match variable {
            Variable::Parameter(index) => return self.object.get(Kind::Parameter, index),
            Variable::Start(index) => return self.object.get(Kind::Start, index),
            _ => self.renew()?,
        }
        match variable {
            Variable::Input(index) => self.object.get(Kind::Input, index),
            Variable::Output(index) => self.object.get(Kind::Output, index),
            Variable::State(index) => Ok(self.state()?.x().at(index)),
            Variable::Rate(index) => Ok(self.rates()?.at(index)),
            Variable::Indicator(index) => Ok(self.indicators()?.at(index)),
            _ => self.object.time(),
        }
    }

    /// The moment.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn state(&self) -> Result<&M::State, Trouble> {
        Ok(self.object.sim()?.state())
    }

    /// The rates of the states.
    ///
    /// # Errors
    /// When they are not determined.
    pub fn rates(&self) -> Result<M::X, Trouble> {
        let state = self.state()?;
        let (mechanism, held) = (state.mechanism(), state.held());
        let mut rates = *state.x();
        if !mechanism.is_regular(&held) {
            return Err(Fault::new(state.time(), Cause::NotRegular).into());
        }
        if !mechanism.rate(state.time(), &held, state.x(), &mut rates).is_good() {
            mechanism.rate_by_rank(state.time(), &held, state.x(), &mut rates)?;
        }
        Ok(rates)
    }

    /// How far conditions are from where they switch; negative beyond.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn indicators(&self) -> Result<M::G, Trouble> {
        let state = self.state()?;
        Ok(self.left_over.indicators(state.mechanism(), state.time(), &state.held(), state.x()))
    }

    /// Derivatives along seeds.
    ///
    /// # Errors
    /// [`Status::NoSuch`] where a variable is not the time, a state, an input or a parameter, or not a rate or an output.
    pub fn tangents(
        &mut self,
        knowns: &[(Variable, f64)],
        unknowns: &[Variable],
    ) -> Result<Vec<f64>, Trouble> {
        self.renew()?;
        tangent::along::<M>(self.state()?, knowns, unknowns)
    }

    /// A solver has moved on: to a time, or to another state.
    ///
    /// # Errors
    /// [`Status::NotFinite`]
    pub fn place(&mut self, time: Option<f64>, x: Option<M::X>) -> Result<(), Trouble> {
        if !(time.is_none_or(f64::is_finite) && x.is_none_or(|x| x.is_finite())) {
            return Err(Status::NotFinite.into());
        }
        let state = self.state()?;
        let (held, time) = (state.held(), time.unwrap_or(state.time()));
        self.hold(held, time, x.unwrap_or(*state.x()))
    }

    fn hold(&mut self, held: M::U, time: f64, x: M::X) -> Result<(), Trouble> {
        let sim = self.object.sim_mut()?;
        let mechanism = *sim.state().mechanism();
        **sim = M::State::new(mechanism, held, time, x);
        Ok(())
    }

    /// A solver has made a step: looks at charts and branches of loops. True where an event is to follow, because states
    /// will change.
    ///
    /// # Errors
    /// When the state cannot be the continuation of the one before.
    pub fn accept(&mut self) -> Result<bool, Trouble> {
        let sim = self.object.sim()?;
        let state = sim.state();
        let (mechanism, time, mut held, mut x) = (state.mechanism(), state.time(), state.held(), *state.x());
        let accepted = mechanism.accept(time, &mut held, &mut x)?;
        let (drift, limit) = (mechanism.drift(time, &x), sim.method().drift_limit(mechanism));
        let mut left_over = self.left_over;
        left_over.forget(mechanism, time, &held, &x);
        if accepted.moved || drift.phi > limit.phi || drift.phi_dot > limit.phi_dot || differs(&x, state.x())
        {
            return Ok(true);
        }
        self.hold(held, time, x)?;
        self.left_over = left_over;
        Ok(false)
    }

    /// An event of model exchange: parameters that were changed, charts, known times, conditions. In co-simulation steps see to
    /// all that.
    ///
    /// # Errors
    /// A requirement that does not hold, a jump, or parameters that cannot be.
    pub fn update(&mut self) -> Result<Update, Trouble> {
        if self.interface != Interface::ModelExchange {
            return Ok(Update { states_changed: false, next: None });
        }
        let before = *self.state()?.x();
        self.object.sim_mut()?.settle()?;
        let state = self.state()?;
        let (mechanism, time, mut held, mut x) = (*state.mechanism(), state.time(), state.held(), *state.x());
        mechanism.accept(time, &mut held, &mut x)?;
        let sides = held;
        if self.instant.is_some_and(|instant| time >= instant) {
            mechanism.pass(time, &mut held);
        }
        let mut left_over = self.left_over;
        left_over.switch(&mechanism, time, &mut held, &x)?;
        if let Some(fault) = mechanism.jump(time, &sides, &x, Some(&held)) {
            return Err(fault.into());
        }
        self.hold(held, time, x)?;
        self.left_over = left_over;
        self.instant = mechanism.next_instant(time, &held).filter(|instant| *instant > time);
        Ok(Update { states_changed: differs(&before, &x), next: self.instant })
    }

    /// Runs until a time, s; where that is asked for to the first event before it alone, and gives whether there was one.
    ///
    /// # Errors
    /// As [`Object::step_to`]; the run is then as it was.
    pub fn step_to(&mut self, until: f64, to_event: bool) -> Result<bool, Trouble> {
        if !to_event {
            return self.object.step_to(until).map(|()| false);
        }
        let (now, mut ahead) = (self.object.time()?, *self.object.sim()?);
        if until.partial_cmp(&now) != Some(core::cmp::Ordering::Greater) {
            return self.object.step_to(until).map(|()| false);
        }
        let mut event = None;
        let outcome = Sim::watch(&mut ahead, until, until - now, |seen| {
            if let Seen::Switched(state) = seen {
                event = event.or(Some(state.time()).filter(|time| *time > now && *time < until));
            }
        });
        if let Some(time) = event {
            return self.object.step_to(time).map(|()| true);
        }
        outcome?;
        self.object.step_to(until).map(|()| false)
    }

    /// Bytes of it, saved.
    pub fn saved_size(&self) -> usize {
        saved::size(self.clone())
    }

    /// Writes everything that decides how it goes on; `bytes` are just as many as [`saved_size`](Self::saved_size).
    ///
    /// # Errors
    /// [`Status::Memory`]: they are not.
    pub fn save(&self, bytes: &mut [u8]) -> Result<(), Trouble> {
        saved::write::<M, _>(self, bytes)
    }

    /// An instance as it was saved of one like this.
    ///
    /// # Errors
    /// As [`Object::saved`].
    pub fn saved(&self, bytes: &[u8]) -> Result<Self, Trouble> {
        let mut saved = Self::new(self.declared, self.interface);
        saved.object = Object::to_be_read(self.declared);
        saved::read::<M>(&mut saved, bytes)?;
        self.is_like(&saved).map(|()| saved)
    }

    /// May its state be that of another one?
    ///
    /// # Errors
    /// [`Status::OtherMechanism`]
    pub fn is_like(&self, other: &Self) -> Result<(), Trouble> {
        if self.interface == other.interface { Ok(()) } else { Err(Status::OtherMechanism.into()) }
    }

    /// The mechanism as it was declared.
    pub fn declared(&self) -> &M {
        &self.declared
    }
}

/// Interface and mode, the object, inputs before the start, and what is between two events.
impl<M: Exchanged> InWords for Instance<M> {
    fn each(&mut self, words: &mut impl Words) {
        self.interface.each(words);
        self.mode.each(words);
        self.object.each(words);
        for input in &mut self.inputs {
            words.perhaps(input, 0.0, Words::number);
        }
        words.number(&mut self.start_time);
        words.flag(&mut self.is_stale);
        words.perhaps(&mut self.instant, 0.0, Words::number);
        self.left_over.each(words);
    }
}

fn differs<X: Vector<f64>>(one: &X, other: &X) -> bool {
    (0..X::LEN).any(|index| one.at(index).to_bits() != other.at(index).to_bits())
}
