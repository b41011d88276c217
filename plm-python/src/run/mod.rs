//! What a package of Python has of a mechanism: a run by number, by a method that is named, which can be ended on its way.
//!
//! `plm::view::wheel` writes such a package.

mod method;
mod record;
mod saved;
mod state;
mod words;

use plm_analysis::Linearisable;
use plm_foreign::{Error, Foreign, Kind, Status};
use plm_run::{AnySim, OnSim};
use plm_runtime::described::by_number;
use plm_runtime::held::Discrete;
use plm_runtime::{Fault, Method, Moment, Sim, StartValues, System};

use self::record::Recorded;
pub use method::method;
pub use plm_run::{BadOption, Integrator};
pub use record::Record;
pub use words::words;

/// What can be in a package of Python: every mechanism in `f64`.
pub trait Runnable: Foreign + Linearisable + System<U: Discrete> {}

impl<M: Foreign + Linearisable + System<U: Discrete>> Runnable for M {}

/// A run of a mechanism. A copy goes on as the original does, to the bit.
#[derive(Clone)]
pub struct Run<M: Runnable>(Box<AnySim<M>>);

/// Numbers by index, SI.
pub type Numbers = [(usize, f64)];

impl<M: Runnable> Run<M> {
    /// Sets parameters of a declared mechanism, makes the start values of them, sets those that are given, and assembles at a
    /// time, s.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; as [`start_state`](plm_runtime::Mechanism::start_state).
    pub fn start(
        declared: M,
        method: Integrator,
        (parameters, starts): (&Numbers, &Numbers),
        time: f64,
    ) -> Result<Self, Error> {
        let mut mechanism = declared;
        finite(time)?;
        for (index, value) in parameters {
            found(mechanism.set_parameter(*index, finite(*value)?).then_some(()))?;
        }
        let mut values = mechanism.declared_starts();
        for (index, value) in starts {
            finite(*value)?;
            let (mut at, mut is_there) = (0, false);
            values.each(&mut |_, start| {
                if at == *index {
                    start.value = *value;
                    is_there = true;
                }
                at += 1;
            });
            found(is_there.then_some(()))?;
        }
        *mechanism.starts_mut() = values;
        Ok(Self(Box::new(method.start_at(mechanism, time)?)))
    }

    /// The time, s.
    pub fn time(&self) -> f64 {
        self.0.state().time()
    }

    /// A number, SI.
    ///
    /// # Errors
    /// [`Status::NoSuch`], of start values too: they belong to the start.
    pub fn get(&self, kind: Kind, index: usize) -> Result<f64, Error> {
        found(number::<M>(self.0.state(), kind, index))
    }

    /// Sets a parameter, an input or a first-order state, SI. A parameter is looked at when the run goes on.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; [`Status::ReadOnly`] of all others.
    pub fn set(&mut self, kind: Kind, index: usize, value: f64) -> Result<(), Error> {
        finite(value)?;
        self.get(kind, index)?;
        match kind {
            Kind::Parameter | Kind::Input => self.0.then(Set { kind, index, value }),
            Kind::State => found(self.set_first_order(index, value)?.then_some(()))?,
            _ => return Err(Status::ReadOnly.into()),
        }
        Ok(())
    }

    /// Pose and velocity of the centre of gravity of a body: x, y (m), angle (rad), vx, vy (m/s), omega (rad/s).
    ///
    /// # Errors
    /// [`Status::NoSuch`]
    pub fn pose(&self, body: usize) -> Result<[f64; 6], Error> {
        found(M::pose(self.0.state(), body)).map(|pose| pose.components())
    }

    /// Runs for `dt`, s, with the bits of [`Sim::step`], as long as `goes_on` says so, which is asked with the time, s, after
    /// each internal step.
    ///
    /// # Errors
    /// As [`Sim::step`]; the run is then as it was before the call.
    pub fn step(&mut self, dt: f64, goes_on: &mut dyn FnMut(f64) -> bool) -> Result<(), Fault> {
        self.0.then(Step { dt, goes_on })
    }

    /// Runs until a time, s, with the bits of [`Sim::run`], as long as `goes_on` says so. Gives the quantities that are asked for
    /// (of those that [`get`](Self::get) knows) every so many seconds, what has switched, and how it ended. Where it ended early
    /// the last row is where it came to, and it can go on from there.
    pub fn run(
        &mut self,
        (until, every): (f64, f64),
        quantities: &[(Kind, usize)],
        goes_on: &mut dyn FnMut(f64) -> bool,
    ) -> (Record, Result<(), Fault>) {
        let mut record = Record::new(quantities.len());
        let times = (until, every);
        let outcome = self.0.then(Recorded { times, quantities, record: &mut record, goes_on });
        if record.last().is_some_and(|last| last < self.time()) && self.time() < until {
            record.take::<M>(self.0.state(), quantities);
        }
        (record, outcome)
    }
}

/// A number at a moment, SI.
fn number<M: Runnable>(state: &M::State, kind: Kind, index: usize) -> Option<f64> {
    match kind {
        Kind::Parameter => state.mechanism().parameter(index),
        Kind::Input => by_number::input::<M>(state, index),
        Kind::State => M::state(state, index),
        Kind::Output => M::observed(state, index),
        Kind::Contact => M::contacts(&state.held()).mode(index).map(|mode| mode.number() as f64),
        _ => None,
    }
}

fn found<T>(found: Option<T>) -> Result<T, Error> {
    found.ok_or(Status::NoSuch.into())
}

fn finite(value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Status::NotFinite.into()) }
}

/// Sets a parameter or an input.
struct Set {
    kind: Kind,
    index: usize,
    value: f64,
}

impl<M: Runnable> OnSim<M> for Set {
    type Output = ();

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) {
        let Self { kind, index, value } = self;
        if kind == Kind::Parameter {
            by_number::set_running_parameter(sim, index, value);
        } else {
            by_number::set_input(sim, index, value);
        }
    }
}

/// Puts a run into another state.
struct Put<U, X> {
    held: U,
    x: X,
}

impl<M: Runnable> OnSim<M> for Put<M::U, M::X> {
    type Output = ();

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) {
        let (mechanism, time) = (*sim.state().mechanism(), sim.state().time());
        **sim = M::State::new(mechanism, self.held, time, self.x);
    }
}

/// A step; after a fault the run is what it was.
struct Step<'a> {
    dt: f64,
    goes_on: &'a mut dyn FnMut(f64) -> bool,
}

impl<M: Runnable> OnSim<M> for Step<'_> {
    type Output = Result<(), Fault>;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let before = *sim;
        Sim::step_while(sim, self.dt, self.goes_on).inspect_err(|_| *sim = before)
    }
}
