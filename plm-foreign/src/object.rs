//! A mechanism with a run of it, by number, without pointers.

use plm_runtime::words::{InWords, Words, mechanism};
use plm_runtime::{Dop853, Fault, Moment, Sim, StartValues};

use crate::{Foreign, Kind, Status, Trouble, saved};

/// A mechanism as it is set up, and a run of it once it is started.
///
/// A copy goes on as the original does, to the bit. What fails changes nothing.
#[derive(Clone, Copy)]
pub struct Object<M: Foreign> {
    mechanism: M,
    sim: Option<Sim<M>>,
    /// Relative tolerance and longest step of its runs.
    options: (f64, f64),
}

impl<M: Foreign> Object<M> {
    /// A mechanism that is not started.
    pub fn new(mechanism: M) -> Self {
        let Dop853 { rtol, longest_step, .. } = Dop853::<M>::default();
        Self { mechanism, sim: None, options: (rtol, longest_step) }
    }

    /// The relative tolerance of steps, from now on and in runs that follow; 1e-9 at first. The absolute one of each state is this times
    /// its typical size.
    ///
    /// # Errors
    /// [`Status::Choice`]: it is not above 0, or above 0.1.
    pub fn set_tolerance(&mut self, rtol: f64) -> Result<(), Trouble> {
        self.choose((rtol, self.options.1), rtol > 0.0 && rtol <= 0.1)
    }

    /// The longest step, s, from now on and in runs that follow; infinite at first.
    ///
    /// # Errors
    /// [`Status::Choice`]: it is not above 0.
    pub fn set_longest_step(&mut self, step: f64) -> Result<(), Trouble> {
        self.choose((self.options.0, step), step > 0.0)
    }

    fn choose(&mut self, options: (f64, f64), is_good: bool) -> Result<(), Trouble> {
        if !is_good {
            return Err(Status::Choice.into());
        }
        self.options = options;
        if let Some(sim) = &mut self.sim {
            (sim.method_mut().rtol, sim.method_mut().longest_step) = options;
        }
        Ok(())
    }

    /// Assembles it at the time 0 with parameters and start values as they are set. Inputs stay as they were set in a run
    /// before.
    ///
    /// # Errors
    /// As [`start_state`](plm_runtime::Mechanism::start_state); a run before stays.
    pub fn start(&mut self) -> Result<(), Trouble> {
        self.start_at(0.0)
    }

    /// The same at a time, s.
    ///
    /// # Errors
    /// As [`start`](Self::start).
    pub fn start_at(&mut self, time: f64) -> Result<(), Trouble> {
        let (held, x) = match &self.sim {
            None => self.mechanism.start_state(time)?,
            Some(before) => self.mechanism.start_with_inputs(time, &before.state().held())?,
        };
        let method = Dop853::new(self.options.0).with_longest_step(self.options.1);
        self.sim = Some(Sim::new(M::State::new(self.mechanism, held, time, x), method));
        Ok(())
    }

    /// Runs for `dt`, s, and ends exactly there.
    ///
    /// # Errors
    /// As [`Sim::step`]; the run is then as it was before the call.
    pub fn step(&mut self, dt: f64) -> Result<(), Trouble> {
        self.advance(|sim| sim.step(dt))
    }

    /// Runs until the time `until`, s, and ends exactly there.
    ///
    /// # Errors
    /// As [`Sim::step_to`]; the run is then as it was before the call.
    pub fn step_to(&mut self, until: f64) -> Result<(), Trouble> {
        self.advance(|sim| sim.step_to(until))
    }

    fn advance(&mut self, step: impl FnOnce(&mut Sim<M>) -> Result<(), Fault>) -> Result<(), Trouble> {
        let sim = self.sim.as_mut().ok_or(Status::NotStarted)?;
        let before = *sim;
        step(sim).map_err(|fault| {
            *sim = before;
            fault.into()
        })
    }

    /// The time of the run, s.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn time(&self) -> Result<f64, Trouble> {
        Ok(self.sim()?.state().time())
    }

    /// A number, SI.
    ///
    /// # Errors
    /// [`Status::NoSuch`]; [`Status::NotStarted`] of inputs, states and outputs.
    pub fn get(&self, kind: Kind, index: usize) -> Result<f64, Trouble> {
        let found = match kind {
            Kind::Parameter => self.mechanism.parameter(index),
            Kind::Input => {
                let mut held = self.sim()?.state().held();
                M::input(M::inputs(&mut held), index).copied()
            }
            Kind::State => M::state(self.sim()?.state(), index),
            Kind::Output => M::observed(self.sim()?.state(), index),
            Kind::Start => {
                let (mut copy, mut found) = (self.mechanism, None);
                each_start(&mut copy, index, |value| found = Some(*value));
                found
            }
            Kind::Body => None,
        };
        found.ok_or(Status::NoSuch.into())
    }

    /// Sets a number, SI. A parameter is looked at when the run goes on, or starts.
    ///
    /// # Errors
    /// [`Status::NotFinite`]; [`Status::ReadOnly`] of states and outputs; [`Status::NoSuch`]; [`Status::NotStarted`] of inputs.
    pub fn set(&mut self, kind: Kind, index: usize, value: f64) -> Result<(), Trouble> {
        if !value.is_finite() {
            return Err(Status::NotFinite.into());
        }
        let found = match kind {
            Kind::Parameter => self.set_parameter(index, value),
            Kind::Input => set_input(self.sim.as_mut().ok_or(Status::NotStarted)?, index, value),
            Kind::Start => each_start(&mut self.mechanism, index, |start| *start = value),
            Kind::State | Kind::Output | Kind::Body => return Err(Status::ReadOnly.into()),
        };
        if found { Ok(()) } else { Err(Status::NoSuch.into()) }
    }

    fn set_parameter(&mut self, index: usize, value: f64) -> bool {
        let found = self.mechanism.set_parameter(index, value);
        if let Some(sim) = self.sim.as_mut().filter(|_| found) {
            let state = sim.state();
            let (mut mechanism, held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
            mechanism.set_parameter(index, value);
            **sim = M::State::new(mechanism, held, time, x);
        }
        found
    }

    /// Pose and velocity of the centre of gravity of a body: x, y (m), angle (rad), vx, vy (m/s), omega (rad/s).
    ///
    /// # Errors
    /// [`Status::NotStarted`], [`Status::NoSuch`]
    pub fn pose(&self, body: usize) -> Result<[f64; 6], Trouble> {
        let pose = M::pose(self.sim()?.state(), body).ok_or(Status::NoSuch)?;
        Ok([pose.x, pose.y, pose.angle, pose.vx, pose.vy, pose.omega])
    }

    /// Bytes of the run, saved; other ones once it has started.
    pub fn saved_size(&self) -> usize {
        saved::size(*self)
    }

    /// Writes everything that decides how the run goes on, for files and other processes; `bytes` are just as many as
    /// [`saved_size`](Self::saved_size).
    ///
    /// # Errors
    /// [`Status::Memory`]: they are not.
    pub fn save(&self, bytes: &mut [u8]) -> Result<(), Trouble> {
        saved::write::<M, _>(self, bytes)
    }

    /// A run as it was saved, of a mechanism as declared: it goes on with the same bits, on every machine.
    ///
    /// # Errors
    /// [`Status::Damaged`], [`Status::OtherVersion`], [`Status::OtherMechanism`]
    pub fn saved(declared: M, bytes: &[u8]) -> Result<Self, Trouble> {
        let mut object = Self::new(declared);
        object.start()?;
        saved::read::<M>(&mut object, bytes)?;
        Ok(object)
    }

    /// The mechanism as it is set up.
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The run.
    ///
    /// # Errors
    /// [`Status::NotStarted`]
    pub fn sim(&self) -> Result<&Sim<M>, Trouble> {
        self.sim.as_ref().ok_or(Status::NotStarted.into())
    }

    /// The run, to be changed.
    #[cfg(feature = "fmi")]
    pub(crate) fn sim_mut(&mut self) -> Result<&mut Sim<M>, Trouble> {
        self.sim.as_mut().ok_or(Status::NotStarted.into())
    }
}

/// The mechanism as it is set up, the options, whether it has started, and the run if it has: into a started one all can be read.
impl<M: Foreign> InWords for Object<M> {
    fn each(&mut self, words: &mut impl Words) {
        mechanism(&mut self.mechanism, words);
        words.numbers([&mut self.options.0, &mut self.options.1]);
        let mut has_started = self.sim.is_some();
        words.flag(&mut has_started);
        match &mut self.sim {
            Some(sim) if has_started => sim.each(words),
            sim => *sim = None,
        }
    }
}

/// Gives `each` the start value with this number; false if there is none.
fn each_start<M: Foreign>(mechanism: &mut M, index: usize, mut each: impl FnMut(&mut f64)) -> bool {
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

fn set_input<M: Foreign>(sim: &mut Sim<M>, index: usize, value: f64) -> bool {
    let state = sim.state();
    let (mechanism, mut held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    let Some(input) = M::input(M::inputs(&mut held), index) else { return false };
    *input = value;
    **sim = M::State::new(mechanism, held, time, x);
    true
}
