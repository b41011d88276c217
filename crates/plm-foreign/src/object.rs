//! A mechanism with a run of it, by number, without pointers.

use plm_runtime::described::mechanism_in_words;
use plm_runtime::linearised::Linearised;
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Cause, Fault, Moment, Rate, Scalar, Sim, StartValues, Vector};

use crate::{By, Choice, Error, Foreign, Kind, Run, Status, saved};

/// A mechanism as it is set up, and a run of it once it is started, by one of the methods of `R`.
///
/// A copy goes on as the original does, to the bit. What fails changes nothing.
#[derive(Clone, Copy)]
pub struct ObjectBy<M, R> {
    mechanism: M,
    run: Option<R>,
    choice: Choice,
    /// A parameter was set since the last check of the run.
    is_changed: bool,
}

/// One by the usual method alone.
pub type Object<M> = ObjectBy<M, Sim<M>>;

impl<M: Foreign, R: Run<M>> ObjectBy<M, R> {
    /// A mechanism that is not started; its method is the first of `R`.
    pub fn new(mechanism: M) -> Self {
        let choice = Choice { by: R::USUAL, rtol: f64::NAN, longest_step: f64::INFINITY };
        Self { mechanism, run: None, choice, is_changed: false }
    }

    /// The method of integration, from now on and in runs that follow. A run goes on from where it is, without what another
    /// method remembers.
    ///
    /// # Errors
    /// [`Status::Choice`]: the library does not have it.
    pub fn set_method(&mut self, by: By) -> Result<(), Error> {
        self.choose(Choice { by, ..self.choice }, R::has(by))
    }

    /// The relative tolerance of steps, from now on and in runs that follow; that of the method at first (1e-9, or 1e-8). The
    /// absolute one of each state is this times its typical size. Methods with steps of fixed length have none.
    ///
    /// # Errors
    /// [`Status::Choice`]: it is not above 0, or above 0.1.
    pub fn set_tolerance(&mut self, rtol: M::S) -> Result<(), Error> {
        let rtol = rtol.to_f64();
        self.choose(Choice { rtol, ..self.choice }, rtol > 0.0 && rtol <= 0.1)
    }

    /// The longest step, s, from now on and in runs that follow; infinite at first. Methods with steps of fixed length make one
    /// step an interval then.
    ///
    /// # Errors
    /// [`Status::Choice`]: it is not above 0.
    pub fn set_longest_step(&mut self, step: M::S) -> Result<(), Error> {
        let longest_step = step.to_f64();
        self.choose(Choice { longest_step, ..self.choice }, longest_step > 0.0)
    }

    /// The relative tolerance, if one was set.
    #[cfg(feature = "fmi")]
    pub(crate) fn tolerance(&self) -> Option<f64> {
        Some(self.choice.rtol).filter(|rtol| !rtol.is_nan())
    }

    fn choose(&mut self, choice: Choice, is_good: bool) -> Result<(), Error> {
        if !is_good {
            return Err(Status::Choice.into());
        }
        if let Some(run) = &mut self.run {
            if run.by() == choice.by {
                run.take(&choice);
            } else {
                let mut looked_at = run.clone();
                if self.is_changed {
                    // A new run takes its parameters for checked ones.
                    looked_at.step_to(looked_at.state().time())?;
                }
                *run = R::new(*looked_at.state(), &choice).ok_or(Status::Choice)?;
                self.is_changed = false;
            }
        }
        self.choice = choice;
        Ok(())
    }

    /// Assembles it at the time 0 with parameters and start values as they are set. Inputs stay as they were set in a run
    /// before.
    ///
    /// # Errors
    /// As [`start_state`](plm_runtime::Mechanism::start_state); a run before stays.
    pub fn start(&mut self) -> Result<(), Error> {
        self.start_at(M::S::ZERO)
    }

    /// Starts at a time, s.
    ///
    /// # Errors
    /// As [`start`](Self::start); [`Status::NotFinite`]
    pub fn start_at(&mut self, time: M::S) -> Result<(), Error> {
        if !time.is_finite() {
            return Err(Status::NotFinite.into());
        }
        let (held, x) = match &self.run {
            None => self.mechanism.start_state(time)?,
            Some(before) => self.mechanism.start_with_inputs(time, &before.state().held())?,
        };
        let state = M::State::new(self.mechanism, held, time, x);
        (self.run, self.is_changed) = (Some(R::new(state, &self.choice).ok_or(Status::Choice)?), false);
        Ok(())
    }

    /// Runs for `dt`, s, and ends exactly there.
    ///
    /// # Errors
    /// As [`Sim::step`]; the run is then as it was before the call.
    pub fn step(&mut self, dt: M::S) -> Result<(), Error> {
        self.advance(|run| run.step(dt))
    }

    /// Runs until the time `until`, s, and ends exactly there.
    ///
    /// # Errors
    /// As [`Sim::step_to`]; the run is then as it was before the call.
    pub fn step_to(&mut self, until: M::S) -> Result<(), Error> {
        self.advance(|run| run.step_to(until))
    }

    fn advance(&mut self, step: impl FnOnce(&mut R) -> Result<(), Fault>) -> Result<(), Error> {
        let run = self.run.as_mut().ok_or(Status::NotStarted)?;
        let before = run.clone();
        if let Err(fault) = step(run) {
            *run = before;
            return Err(fault.into());
        }
        self.is_changed = false;
        Ok(())
    }

    /// Makes a step by itself, which the declaration orders (`emit: step(...)`): `state.step_rk4(h)`. Parameters that were set since the
    /// last step are checked before it.
    ///
    /// # Errors
    /// As the step; the run is then as it was before the call.
    pub fn step_alone(&mut self, step: impl FnOnce(&mut M::State) -> Result<(), Fault>) -> Result<(), Error> {
        if self.is_changed {
            return self.advance(|run| {
                run.step_to(run.state().time())?;
                step(run.state_mut())
            });
        }
        // The state stays as it was where the step cannot be made.
        Ok(step(self.run.as_mut().ok_or(Status::NotStarted)?.state_mut())?)
    }

    /// The time of the run, s.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn time(&self) -> Result<M::S, Error> {
        Ok(self.state()?.time())
    }

    /// A number, SI.
    ///
    /// # Errors
    /// [`Status::NoSuch`]; [`Status::NotStarted`] of inputs, states and outputs.
    pub fn get(&self, kind: Kind, index: usize) -> Result<M::S, Error> {
        let found = match kind {
            Kind::Parameter => self.mechanism.parameter(index),
            Kind::Input => {
                let mut held = self.state()?.held();
                M::input(M::inputs(&mut held), index).copied()
            }
            Kind::State => M::state(self.state()?, index),
            Kind::Output => M::observed(self.state()?, index),
            Kind::Integrated => {
                let x = self.state()?.x();
                (index < <M as Rate>::X::LEN).then(|| x.at(index))
            }
            Kind::Rate => {
                let rates = self.rates()?;
                (index < <M as Rate>::X::LEN).then(|| rates.at(index))
            }
            Kind::Start => {
                let (mut copy, mut found) = (self.mechanism, None);
                each_start(&mut copy, index, |value| found = Some(*value));
                found
            }
            Kind::Contact => {
                let mode = M::contacts(&self.state()?.held()).mode(index);
                mode.map(|mode| M::S::lit(f64::from(mode.number() as u32)))
            }
            Kind::Body => None,
        };
        found.ok_or(Status::NoSuch.into())
    }

    /// Sets a number, SI. A parameter is checked when the run goes on, or starts.
    ///
    /// # Errors
    /// [`Status::NotFinite`]; [`Status::ReadOnly`] of states and outputs; [`Status::NoSuch`]; [`Status::NotStarted`] of inputs.
    pub fn set(&mut self, kind: Kind, index: usize, value: M::S) -> Result<(), Error> {
        if !value.is_finite() {
            return Err(Status::NotFinite.into());
        }
        let found = match kind {
            Kind::Parameter => self.set_parameter(index, value),
            Kind::Input => {
                let run = self.run.as_mut().ok_or(Status::NotStarted)?;
                // A state that may be changed makes the method begin anew.
                let state = with_input::<M>(run.state(), index, value);
                state.map(|state| *run.state_mut() = state).is_some()
            }
            Kind::Start => each_start(&mut self.mechanism, index, |start| *start = value),
            Kind::State | Kind::Output | Kind::Body | Kind::Integrated | Kind::Rate | Kind::Contact => {
                return Err(Status::ReadOnly.into());
            }
        };
        if found { Ok(()) } else { Err(Status::NoSuch.into()) }
    }

    fn set_parameter(&mut self, index: usize, value: M::S) -> bool {
        let found = self.mechanism.set_parameter(index, value);
        if let Some(run) = self.run.as_mut().filter(|_| found) {
            let state = run.state();
            let (mut mechanism, held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
            mechanism.set_parameter(index, value);
            *run.state_mut() = M::State::new(mechanism, held, time, x);
            self.is_changed = true;
        }
        found
    }

    /// Pose and velocity of the centre of gravity of a body: x, y (m), angle (rad), vx, vy (m/s), omega (rad/s).
    ///
    /// # Errors
    /// [`Status::NotStarted`], [`Status::NoSuch`]
    pub fn pose(&self, body: usize) -> Result<[M::S; 6], Error> {
        let pose = M::pose(self.state()?, body).ok_or(Status::NoSuch)?;
        Ok([pose.x, pose.y, pose.angle, pose.vx, pose.vy, pose.omega])
    }

    /// The rates of all that is integrated, SI.
    ///
    /// # Errors
    /// [`Status::NotStarted`]; when they are not determined.
    pub fn rates(&self) -> Result<M::X, Error> {
        let state = self.state()?;
        let (mechanism, held) = (state.mechanism(), state.held());
        let mut rates = *state.x();
        if !mechanism.is_regular(&held) {
            return Err(Fault::new(state.time().to_f64(), Cause::NotRegular).into());
        }
        if !mechanism.rate(state.time(), &held, state.x(), &mut rates).is_good() {
            mechanism.rate_by_rank(state.time(), &held, state.x(), &mut rates)?;
        }
        Ok(rates)
    }

    /// The mechanism near this moment as a linear system.
    ///
    /// # Errors
    /// [`Status::NotStarted`]; as [`Linearised::new`].
    pub fn linearised(&self) -> Result<Linearised<'_, M>, Error> {
        Ok(Linearised::new(self.state()?)?)
    }

    /// Bytes of the run, saved; other ones once it has started.
    pub fn saved_size(&self) -> usize {
        saved::size(self.clone())
    }

    /// Writes everything that decides how the run goes on, for files and other processes; `bytes` are just as many as
    /// [`saved_size`](Self::saved_size).
    ///
    /// # Errors
    /// [`Status::Memory`]: they are not.
    pub fn save(&self, bytes: &mut [u8]) -> Result<(), Error> {
        saved::write::<M, _>(self, bytes)
    }

    /// A run as it was saved, of any mechanism of the type: it goes on with the same bits, on every machine. Nothing is assembled.
    ///
    /// # Errors
    /// [`Status::Damaged`], [`Status::OtherVersion`], [`Status::OtherMechanism`], the last too where it is by a method that is
    /// not among those of `R`.
    pub fn saved(declared: M, bytes: &[u8]) -> Result<Self, Error> {
        let mut object = Self::to_be_read(declared);
        let outcome = saved::read::<M>(&mut object, bytes);
        if R::has(object.choice.by) { outcome.map(|()| object) } else { Err(Status::OtherMechanism.into()) }
    }

    /// One into which everything can be read: with a run at no moment, which was never assembled.
    pub(crate) fn to_be_read(declared: M) -> Self {
        let mut object = Self::new(declared);
        object.run = R::new(object.blank(), &object.choice);
        object
    }

    /// A state at no moment.
    fn blank(&self) -> M::State {
        M::State::new(self.mechanism, self.mechanism.unstarted(), M::S::ZERO, M::X::fill(M::S::ZERO))
    }

    /// The mechanism as it is set up.
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The mechanism at the moment of the run.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn state(&self) -> Result<&M::State, Error> {
        Ok(self.run.as_ref().ok_or(Status::NotStarted)?.state())
    }
}

impl<M: Foreign> Object<M> {
    /// The run.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn sim(&self) -> Result<&Sim<M>, Error> {
        self.run.as_ref().ok_or(Status::NotStarted.into())
    }

    /// The run, to be changed.
    #[cfg(feature = "fmi")]
    pub(crate) fn sim_mut(&mut self) -> Result<&mut Sim<M>, Error> {
        self.run.as_mut().ok_or(Status::NotStarted.into())
    }
}

/// The mechanism as it is set up, the method and its options, whether it has started, and the run if it has: into one that has a
/// run all can be read.
impl<M: Foreign, R: Run<M>> InWords for ObjectBy<M, R> {
    fn each(&mut self, words: &mut impl Words) {
        mechanism_in_words(&mut self.mechanism, words);
        self.choice.each(words);
        words.flag(&mut self.is_changed);
        let mut has_started = self.run.is_some();
        words.flag(&mut has_started);
        if let Some(other) = self.run.as_ref().filter(|run| run.by() != self.choice.by) {
            self.run = R::new(*other.state(), &self.choice);
        }
        match &mut self.run {
            Some(run) if has_started => run.each(words),
            run => *run = None,
        }
    }
}

/// Gives `each` the start value with this number; false if there is none.
fn each_start<M: Foreign>(mechanism: &mut M, index: usize, mut each: impl FnMut(&mut M::S)) -> bool {
    let (mut at, mut found) = (0, false);
    mechanism.starts_mut().each(&mut |_, start| {
        if at == index {
            each(&mut start.value);
            found = true;
        }
        at += 1;
    });
    found
}

/// A state with another value of an input, if there is one of this number.
fn with_input<M: Foreign>(state: &M::State, index: usize, value: M::S) -> Option<M::State> {
    let (mechanism, mut held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    *M::input(M::inputs(&mut held), index)? = value;
    Some(M::State::new(mechanism, held, time, x))
}
