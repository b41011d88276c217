//! An instance of an FMU, without pointers.

use alloc::vec;
use alloc::vec::Vec;

use plm_runtime::words::{InWords, Words};
use plm_runtime::{Moment, Notice, Vector};

use super::exchange::Look;
use super::method::{Choice, NoMethod, Settings, Steps, Way, emitted, first_event, run};
use super::sides::LeftOver;
use super::{Call, Exchanged, Interface, Mode, Variable, tangent};
use crate::{Error, Kind, Object, Status, saved};

/// A mechanism that is set up, then run: by steps of its own method (co-simulation), or by a solver outside, to which it
/// gives rates and conditions (model exchange).
#[derive(Clone)]
pub struct Instance<M: Exchanged> {
    declared: M,
    pub(super) interface: Interface,
    pub(super) mode: Mode,
    pub(super) object: Object<M>,
    /// The steps that the declaration has emitted.
    steps: Steps<M>,
    settings: Settings,
    /// Inputs as set before the start.
    inputs: Vec<Option<f64>>,
    start_time: f64,
    /// Something was set since the mechanism was assembled.
    is_stale: bool,
    /// The next time at which conditions on it change, s.
    pub(super) instant: Option<f64>,
    pub(super) left_over: LeftOver<M::G>,
    /// The time of the last event, or of the start, s.
    pub(super) since: f64,
    /// Events in a row at which a gap was negative that had not been struck.
    pub(super) lost: u64,
    /// Of model exchange; none before the start.
    pub(super) look: Option<Look<M::X>>,
}

impl<M: Exchanged> Instance<M> {
    /// A mechanism that is not started, without emitted steps.
    pub fn new(declared: M, interface: Interface) -> Self {
        Self::with_steps(declared, Steps::none(), interface)
    }

    /// A mechanism that is not started.
    pub fn with_steps(declared: M, steps: Steps<M>, interface: Interface) -> Self {
        Self {
            declared,
            interface,
            mode: Mode::Instantiated,
            object: Object::new(declared),
            steps,
            settings: Settings::usual::<M>(),
            inputs: vec![None; declared.tables().inputs.len()],
            start_time: 0.0,
            is_stale: true,
            instant: None,
            left_over: LeftOver::none(),
            since: 0.0,
            lost: 0,
            look: None,
        }
    }

    /// As it was made.
    pub fn reset(&mut self) {
        *self = Self::with_steps(self.declared, self.steps, self.interface);
    }

    /// It will start at this time, s; a relative tolerance is that of the methods with error control.
    ///
    /// # Errors
    /// [`Status::NotFinite`]; [`Status::Choice`]: the tolerance is not above 0, or above 0.1.
    pub fn begin_at(&mut self, time: f64, tolerance: Option<f64>) -> Result<(), Error> {
        if !time.is_finite() {
            return Err(Status::NotFinite.into());
        }
        if let Some(tolerance) = tolerance {
            self.object.set_tolerance(tolerance)?;
            self.settings.tolerance = tolerance;
        }
        (self.start_time, self.is_stale) = (time, true);
        Ok(())
    }

    /// The mode that it is in.
    pub fn mode(&self) -> Mode {
        self.mode
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
    pub fn renew(&mut self) -> Result<(), Error> {
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
        (self.is_stale, self.since, self.lost) = (false, self.start_time, 0);
        self.looked()
    }

    /// Sets a variable.
    ///
    /// # Errors
    /// [`Status::ReadOnly`]: it is computed, or it cannot be set in this mode: a start value of a mechanism that runs, a
    /// parameter in Continuous-Time Mode, a state in another one; as [`Object::set`].
    pub fn set(&mut self, variable: Variable, value: f64) -> Result<(), Error> {
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
            Variable::Step if !is_running && value > 0.0 && value.is_finite() => {
                self.settings.step = value;
                Ok(())
            }
            Variable::Step if !is_running => Err(Status::Choice.into()),
            Variable::Method | Variable::Contact(_) => Err(Status::NoSuch.into()),
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
    pub fn get(&mut self, variable: Variable) -> Result<f64, Error> {
        match variable {
            Variable::Parameter(index) => return self.object.get(Kind::Parameter, index),
            Variable::Start(index) => return self.object.get(Kind::Start, index),
            Variable::Step => return Ok(self.settings.step),
            Variable::Method | Variable::Contact(_) => return Err(Status::NoSuch.into()),
            _ => self.renew()?,
        }
        match variable {
            Variable::Input(index) => self.object.get(Kind::Input, index),
            Variable::Output(index) => {
                self.catch_up()?;
                self.object.get(Kind::Output, index)
            }
            Variable::State(index) => Ok(self.state()?.x().at(index)),
            Variable::Rate(index) => Ok(self.rates()?.at(index)),
            Variable::Indicator(index) => self.indicators()?.get(index).copied().ok_or(Status::NoSuch.into()),
            _ => self.object.time(),
        }
    }

    /// The outputs of these indices, none where there is no such output.
    ///
    /// # Errors
    /// As [`Self::get`].
    pub fn outputs(&mut self, indices: &[usize]) -> Result<Vec<Option<f64>>, Error> {
        self.renew()?;
        self.catch_up()?;
        let mut values = Vec::with_capacity(indices.len());
        M::observe(self.state()?, indices.iter().copied(), &mut |value| values.push(value));
        Ok(values)
    }

    /// The value of a variable that is a whole number: of the method, of what a row of contact does.
    ///
    /// # Errors
    /// [`Status::NoSuch`] of all others; when the mechanism cannot be assembled.
    pub fn integer(&mut self, variable: Variable) -> Result<i64, Error> {
        match variable {
            Variable::Method => Ok(self.settings.choice.number()),
            Variable::Contact(row) => {
                self.renew()?;
                let mode = M::contacts(&self.state()?.held()).mode(row).ok_or(Status::NoSuch)?;
                i64::try_from(mode.number()).map_err(|_| Status::NoSuch.into())
            }
            _ => Err(Status::NoSuch.into()),
        }
    }

    /// Notices of a run that goes on.
    pub fn notice(&self) -> Option<Notice> {
        self.object.sim().ok()?.notice()
    }

    /// The moment.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn state(&self) -> Result<&M::State, Error> {
        Ok(self.object.sim()?.state())
    }

    /// Derivatives along seeds.
    ///
    /// # Errors
    /// [`Status::NoSuch`] where a variable is not the time, a state, an input or a parameter, or not a rate or an output.
    pub fn tangents(&mut self, knowns: &[(Variable, f64)], unknowns: &[Variable]) -> Result<Vec<f64>, Error> {
        self.renew()?;
        self.catch_up()?;
        tangent::along::<M>(self.state()?, knowns, unknowns)
    }

    /// The method of co-simulation.
    pub fn method(&self) -> Choice {
        self.settings.choice
    }

    /// Takes a method by its number.
    ///
    /// # Errors
    /// It runs already; no such method, or one whose step the declaration has not emitted.
    pub fn set_method(&mut self, number: i64) -> Result<(), NoMethod> {
        let choice =
            Choice::of(number).filter(|choice| !self.is_running() && self.steps.way(*choice).is_some());
        self.settings.choice = choice.ok_or(NoMethod { number, is_running: self.is_running() })?;
        Ok(())
    }

    /// Runs until a time, s; where that is asked for to the first event before it alone, and gives whether there was one. Emitted steps
    /// know of no event.
    ///
    /// # Errors
    /// As [`Object::step_to`]; the run is then as it was.
    pub fn step_to(&mut self, until: f64, to_event: bool) -> Result<bool, Error> {
        let now = self.object.time()?;
        let goes = until > now && until.is_finite();
        let way = self.steps.way(self.settings.choice).filter(|_| goes);
        let (state, event) = match way {
            None | Some(Way::Run(Choice::Dop853)) => {
                let event = if goes && to_event { first_event(self.object.sim()?, until)? } else { None };
                return self.object.step_to(event.unwrap_or(until)).map(|()| event.is_some());
            }
            Some(way) => {
                // Takes parameters that were changed.
                self.object.step_to(now)?;
                let (state, step) = (*self.state()?, self.settings.step);
                match way {
                    Way::Run(_) => run::<M>(self.settings, state, (until, to_event))?,
                    Way::Emitted(one) => (emitted::<M>(one, step, (state, until))?, false),
                }
            }
        };
        self.hold(state.held(), state.time(), *state.x())?;
        Ok(event)
    }

    /// Bytes of it, saved.
    pub fn saved_size(&self) -> usize {
        saved::size(self.clone())
    }

    /// Writes everything that decides how it goes on; `bytes` are just as many as [`saved_size`](Self::saved_size).
    ///
    /// # Errors
    /// [`Status::Memory`]: they are not.
    pub fn save(&self, bytes: &mut [u8]) -> Result<(), Error> {
        saved::write::<M, _>(self, bytes)
    }

    /// An instance as it was saved of one like this.
    ///
    /// # Errors
    /// As [`Object::saved`].
    pub fn saved(&self, bytes: &[u8]) -> Result<Self, Error> {
        let mut saved = Self::with_steps(self.declared, self.steps, self.interface);
        saved.object = Object::to_be_read(self.declared);
        saved::read::<M>(&mut saved, bytes)?;
        self.is_like(&saved).map(|()| saved)
    }

    /// May its state be that of another one?
    ///
    /// # Errors
    /// [`Status::OtherMechanism`]
    pub fn is_like(&self, other: &Self) -> Result<(), Error> {
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
        self.settings.each(words);
        for input in &mut self.inputs {
            words.perhaps(input, 0.0, Words::number);
        }
        words.number(&mut self.start_time);
        words.flag(&mut self.is_stale);
        words.perhaps(&mut self.instant, 0.0, Words::number);
        self.left_over.each(words);
        words.number(&mut self.since);
        words.word(&mut self.lost);
        words.perhaps(&mut self.look, Look::nowhere(), Look::each);
    }
}

pub(super) fn differs<X: Vector<f64>>(one: &X, other: &X) -> bool {
    (0..X::LEN).any(|index| one.at(index).to_bits() != other.at(index).to_bits())
}
