//! Contracts of generated mechanisms beyond their equations: the start, and readable states.

use crate::fault::Fault;
use crate::method::{Dop853, Method};
use crate::protocol::Rescue;
use crate::scalar::Real;
use crate::sim::Sim;
use crate::system::{Drift, Rate, System};

/// A mechanism of which every body has a mass, so that its energies are known.
///
/// No type implements it: methods of energies ask for it where a body was declared without mass, for the message of rustc.
///
/// ```compile_fail,E0277
/// fn energy<State: plm_runtime::HasMasses>(_: &State) {}
/// energy(&1.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "this mechanism has no energy: a body is declared without `mass`",
    label = "needs the mass of every body",
    note = "declare `mass` and `inertia` of every body, or read poses, speeds and accelerations alone"
)]
pub trait HasMasses {}

/// A mechanism with its parameters at one moment: the generated `State`, with methods such as `arm_angle()`.
pub trait Moment: Copy {
    /// The mechanism.
    type M: System;

    /// The mechanism at `time` in the state `x`, with the discrete state `held`: inputs, chart, branches.
    fn new(
        mechanism: Self::M,
        held: <Self::M as Rate>::U,
        time: <Self::M as Rate>::S,
        x: <Self::M as Rate>::X,
    ) -> Self;
    /// The mechanism and its parameters.
    fn mechanism(&self) -> &Self::M;
    /// The discrete state.
    fn held(&self) -> <Self::M as Rate>::U;
    /// The time, s.
    fn time(&self) -> <Self::M as Rate>::S;
    /// The state.
    fn x(&self) -> &<Self::M as Rate>::X;
    /// Moves on to another time and state.
    fn set(&mut self, time: <Self::M as Rate>::S, held: &<Self::M as Rate>::U, x: &<Self::M as Rate>::X);
    /// Mutable access to time, state and discrete state, for code that advances them without a copy.
    fn in_place(&mut self) -> InPlace<'_, Self::M>;
}

/// A [`Moment`] that is moved on where it stands.
pub struct InPlace<'a, M: System> {
    /// The mechanism and its parameters.
    pub system: &'a M,
    /// The discrete state.
    pub held: &'a mut M::U,
    /// The time, s.
    pub time: &'a mut M::S,
    /// The state.
    pub x: &'a mut M::X,
}

/// The [`Moment`] of a system that is written by hand: its state has no names.
#[derive(Clone, Copy, Debug)]
pub struct At<M: System> {
    /// The equations and their parameters.
    pub mechanism: M,
    /// The discrete state.
    pub held: M::U,
    /// The time, s.
    pub time: M::S,
    /// The state.
    pub x: M::X,
}

impl<M: System + Copy> Moment for At<M> {
    type M = M;

    fn new(mechanism: M, held: M::U, time: M::S, x: M::X) -> Self {
        Self { mechanism, held, time, x }
    }
    fn mechanism(&self) -> &M {
        &self.mechanism
    }
    fn held(&self) -> M::U {
        self.held
    }
    fn time(&self) -> M::S {
        self.time
    }
    fn x(&self) -> &M::X {
        &self.x
    }
    fn set(&mut self, time: M::S, held: &M::U, x: &M::X) {
        (self.time, self.held, self.x) = (time, *held, *x);
    }
    fn in_place(&mut self) -> InPlace<'_, M> {
        let Self { mechanism, held, time, x } = self;
        InPlace { system: mechanism, held, time, x }
    }
}

/// Access to a moment: a [`Moment`] itself, as `run` gives it, or a [`Sim`], by its present state. Functions that read a moment accept
/// either.
pub trait AsMoment {
    /// The generated readable state.
    type State: Moment;

    /// The moment.
    fn as_moment(&self) -> &Self::State;
}

impl<T: Moment> AsMoment for T {
    type State = T;

    fn as_moment(&self) -> &T {
        self
    }
}

impl<M: Mechanism, I> AsMoment for Sim<M, I> {
    type State = M::State;

    fn as_moment(&self) -> &M::State {
        self
    }
}

/// A mechanism that can be started.
pub trait Mechanism: System<S: Real> + Copy {
    /// The generated readable state.
    type State: Moment<M = Self>;
    /// How it goes on near singular poses.
    type Rescue: Rescue<Self>;

    /// Bytes of stack that a solution by rank takes, if the mechanism comes to need one ([`workspace`](crate::workspace)).
    const WORKSPACE: usize = 0;

    /// The assembled state at the time `t`, with the inputs as declared.
    ///
    /// # Errors
    /// When the mechanism cannot be assembled, or when locks are redundant.
    fn start_state(&self, t: Self::S) -> Result<(Self::U, Self::X), Fault>;

    /// Checks the parameters; a fault reports the time `t`.
    ///
    /// # Errors
    /// [`Cause::NotAllowed`](crate::Cause::NotAllowed): a parameter that is not a number, or one that makes a mass, an
    /// inertia or a compliance what it cannot be. [`Cause::NotMet`](crate::Cause::NotMet): a requirement of parameters
    /// that does not hold.
    fn check(&self, t: Self::S) -> Result<(), Fault> {
        let _ = t;
        Ok(())
    }

    /// A number that changes with every single parameter that joints, masses or known times read.
    fn fingerprint(&self) -> u64 {
        0
    }

    /// Assembles anew, from the state `x` as the start and with nothing locked, after parameters were changed: joint
    /// coordinates stay as they are where they close the joints, else the joints are closed by the shortest steps.
    ///
    /// # Errors
    /// When the joints cannot be closed, with the part that stays open widest.
    fn renew(&self, t: Self::S, held: &mut Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, held, x);
        Ok(())
    }

    /// Violation of the joints at a state. Joint coordinates cannot drift in a step, so that there
    /// [`Constraints::drift`](crate::Constraints::drift) is nothing; the joints are open all the same after parameters were changed.
    fn opening(&self, t: Self::S, held: &Self::U, x: &Self::X) -> Drift<Self::S> {
        self.drift(t, held, x)
    }

    /// Assembles the mechanism at time zero and makes it ready to run with Dormand-Prince 8(5,3).
    ///
    /// # Errors
    /// As [`start_state`](Self::start_state).
    fn start(self) -> Result<Sim<Self>, Fault> {
        self.start_with(Dop853::default())
    }

    /// Assembles the mechanism at time zero and makes it ready to run with a method of choice.
    ///
    /// # Errors
    /// As [`start_state`](Self::start_state).
    fn start_with<I: Method<Self>>(self, method: I) -> Result<Sim<Self, I>, Fault> {
        use crate::scalar::Scalar as _;
        self.start_at(Self::S::lit(0.0), method)
    }

    /// Assembles the mechanism at a time, in s, and makes it ready to run from there: to go on with old final values where
    /// something depends on the time.
    ///
    /// # Errors
    /// As [`start_state`](Self::start_state).
    fn start_at<I: Method<Self>>(self, time: Self::S, method: I) -> Result<Sim<Self, I>, Fault> {
        let (held, x) = self.start_state(time)?;
        Ok(Sim::new(Self::State::new(self, held, time, x), method))
    }
}
