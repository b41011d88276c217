//! The method of co-simulation, as a parameter.

use core::fmt;

use plm_runtime::method::{RadauIia5, Ros34Pw2};
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Dop853, Fault, Mechanism, Method, Moment, Rk4, Scalar, Seen, SemiImplicitEuler, Sim};

use super::Exchanged;
use super::mode::place;
use crate::By;

/// A method of co-simulation; its number is its place from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// [`Dop853`], with the tolerance that the simulator hands over.
    Dop853,
    /// [`RadauIia5`], with that tolerance.
    RadauIia5,
    /// [`Rk4`], with steps of a length.
    Rk4,
    /// [`SemiImplicitEuler`], with steps of a length.
    SemiImplicitEuler,
    /// [`Ros34Pw2`], with steps of a length.
    Ros34Pw2,
    /// The step that `emit: step(rk4)` has emitted.
    StepRk4,
    /// The step that `emit: step(semi_implicit_euler)` has emitted.
    StepSemiImplicitEuler,
    /// The step that `emit: step(linearly_implicit)` has emitted.
    StepLinearlyImplicit,
}

impl Choice {
    /// All, in the order of their numbers.
    pub const ALL: [Self; 8] = [
        Self::Dop853,
        Self::RadauIia5,
        Self::Rk4,
        Self::SemiImplicitEuler,
        Self::Ros34Pw2,
        Self::StepRk4,
        Self::StepSemiImplicitEuler,
        Self::StepLinearlyImplicit,
    ];

    /// Its number from 1.
    pub fn number(self) -> i64 {
        (1..).zip(Self::ALL).find(|(_, one)| *one == self).map_or(0, |(number, _)| number)
    }

    /// The one with a number.
    pub fn of(number: i64) -> Option<Self> {
        Self::ALL.get(usize::try_from(number.checked_sub(1)?).ok()?).copied()
    }

    /// Its name, and what it is.
    pub fn words(self) -> (&'static str, &'static str) {
        let by = |by: By, what| (by.called().rust, what);
        match self {
            Self::Dop853 => by(By::Dop853, "order 8, steps by error control"),
            Self::RadauIia5 => by(By::RadauIia5, "order 5, for stiff equations, steps by error control"),
            Self::Rk4 => by(By::Rk4, "order 4, steps of plm(step) at most"),
            Self::SemiImplicitEuler => by(By::SemiImplicitEuler, "order 1, steps of plm(step) at most"),
            Self::Ros34Pw2 => by(By::Ros34Pw2, "order 3, for stiff equations, steps of plm(step) at most"),
            Self::StepRk4 => ("step_rk4", "as emitted by emit: step(rk4)"),
            Self::StepSemiImplicitEuler => {
                ("step_semi_implicit_euler", "as emitted by emit: step(semi_implicit_euler)")
            }
            Self::StepLinearlyImplicit => {
                ("step_linearly_implicit", "as emitted by emit: step(linearly_implicit)")
            }
        }
    }
}

impl InWords for Choice {
    fn each(&mut self, words: &mut impl Words) {
        place(self, &Self::ALL, words);
    }
}

/// A method that cannot be taken.
#[derive(Clone, Copy, Debug)]
pub struct NoMethod {
    pub(super) number: i64,
    /// It is fixed then.
    pub(super) is_running: bool,
}

impl fmt::Display for NoMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match Choice::of(self.number) {
            _ if self.is_running => f.write_str("plm(method) is fixed once the mechanism has started"),
            None => write!(f, "plm(method) is a number from 1 to {}, not {}", Choice::ALL.len(), self.number),
            Some(choice) => {
                let (name, what) = choice.words();
                write!(f, "plm(method) {name}: {what}, which the declaration does not have")
            }
        }
    }
}

impl core::error::Error for NoMethod {}

/// A step of fixed length, s, as a declaration emits it.
pub type Step<M> = Function<<M as Mechanism>::State, Result<(), Fault>>;

/// A function that makes a step of some state.
pub type Function<S, R> = fn(&mut S, f64) -> R;

/// Return of a step: a result of an emitted one, [`Absent`] of one that is not emitted.
pub trait Made: Sized {
    /// The step, where there is one.
    fn step<S>(step: Function<S, Self>) -> Option<Function<S, Result<(), Fault>>>;
}

/// A step that was not emitted.
pub struct Absent;

impl Made for Absent {
    fn step<S>(_: Function<S, Self>) -> Option<Function<S, Result<(), Fault>>> {
        None
    }
}

impl Made for Result<(), Fault> {
    fn step<S>(step: Function<S, Self>) -> Option<Function<S, Result<(), Fault>>> {
        Some(step)
    }
}

/// The steps that a declaration may have emitted. A state's own methods hide those of this trait: so `State::step_rk4` is there in
/// any case.
pub trait Emitted {
    /// The one of RK4.
    fn step_rk4(&mut self, _: f64) -> Absent {
        Absent
    }

    /// The one of the semi-implicit Euler method.
    fn step_semi_implicit_euler(&mut self, _: f64) -> Absent {
        Absent
    }

    /// The one of ROS34PW2.
    fn step_linearly_implicit(&mut self, _: f64) -> Absent {
        Absent
    }
}

impl<S: Moment> Emitted for S {}

/// Those of them that there are, in the order of [`Choice`].
#[derive(Clone, Copy)]
pub struct Steps<M: Exchanged>([Option<Step<M>>; 3]);

impl<M: Exchanged> Steps<M> {
    /// Of these, each its own or one of [`Emitted`].
    pub fn new<A: Made, B: Made, C: Made>(
        rk4: Function<M::State, A>,
        semi_implicit_euler: Function<M::State, B>,
        linearly_implicit: Function<M::State, C>,
    ) -> Self {
        Self([A::step(rk4), B::step(semi_implicit_euler), C::step(linearly_implicit)])
    }

    /// None.
    pub fn none() -> Self {
        Self([None; 3])
    }

    /// How a choice makes a communication step; none where it is not there.
    pub(super) fn way(&self, choice: Choice) -> Option<Way<M>> {
        let emitted = |place: usize| self.0.get(place).copied().flatten().map(Way::Emitted);
        match choice {
            Choice::StepRk4 => emitted(0),
            Choice::StepSemiImplicitEuler => emitted(1),
            Choice::StepLinearlyImplicit => emitted(2),
            method => Some(Way::Run(method)),
        }
    }
}

/// How a communication step is made.
pub(super) enum Way<M: Exchanged> {
    /// As a run by a method.
    Run(Choice),
    /// By emitted steps.
    Emitted(Step<M>),
}

/// Settings of a method.
#[derive(Clone, Copy)]
pub(super) struct Settings {
    pub(super) choice: Choice,
    /// Steps of fixed length, s.
    pub(super) step: f64,
    /// Relative.
    pub(super) tolerance: f64,
}

impl Settings {
    /// As declared: none is handed over.
    pub(super) fn usual<M: Exchanged>() -> Self {
        Self { choice: Choice::Dop853, step: 1e-3, tolerance: Dop853::<M>::default().rtol }
    }
}

impl InWords for Settings {
    fn each(&mut self, words: &mut impl Words) {
        self.choice.each(words);
        words.numbers([&mut self.step, &mut self.tolerance]);
    }
}

/// Result of a communication step: its end, and true if that is at an event.
pub(super) type End<S> = (S, bool);

/// Runs from a state to a time, s, by a method that begins there; on request to the first event before it.
pub(super) fn run<M: Exchanged>(
    settings: Settings,
    state: M::State,
    (until, to_event): (f64, bool),
) -> Result<End<M::State>, Fault> {
    let Settings { choice, step, tolerance } = settings;
    match choice {
        Choice::RadauIia5 => to::<M, _>(Sim::new(state, RadauIia5::new(tolerance)), until, to_event),
        Choice::Rk4 => to::<M, _>(Sim::new(state, Rk4::new(step)), until, to_event),
        Choice::SemiImplicitEuler => {
            to::<M, _>(Sim::new(state, SemiImplicitEuler::new(step)), until, to_event)
        }
        Choice::Ros34Pw2 => to::<M, _>(Sim::new(state, Ros34Pw2::new(step)), until, to_event),
        _ => to::<M, _>(Sim::new(state, Dop853::new(tolerance)), until, to_event),
    }
}

fn to<M: Exchanged, I: Method<M>>(
    mut sim: Sim<M, I>,
    until: f64,
    to_event: bool,
) -> Result<End<M::State>, Fault> {
    let event = if to_event { first_event(&sim, until)? } else { None };
    sim.step_to(event.unwrap_or(until))?;
    Ok((*sim.state(), event.is_some()))
}

/// The time of the first event before another one, s.
///
/// # Errors
/// A fault before any event.
pub(super) fn first_event<M: Exchanged, I: Method<M>>(
    sim: &Sim<M, I>,
    until: f64,
) -> Result<Option<f64>, Fault> {
    let (now, mut ahead, mut event) = (sim.state().time(), sim.clone(), None);
    let outcome = Sim::watch(&mut ahead, until, until - now, |seen| {
        if let Seen::Switched(state) = seen {
            event = event.or(Some(state.time()).filter(|time| *time > now && *time < until));
        }
    });
    if event.is_none() {
        outcome?;
    }
    Ok(event)
}

/// From a state to a time, s, by equal steps of a length at most.
pub(super) fn emitted<M: Exchanged>(
    step: Step<M>,
    longest: f64,
    (mut state, until): (M::State, f64),
) -> Result<M::State, Fault> {
    let start = state.time();
    let length = until - start;
    // What rounding makes of the interval costs no step.
    let (steps, mut k) = (Scalar::floor((length / longest - 1e-6).max(0.0)) + 1.0, 1.0);
    while k <= steps {
        let end = if k < steps { start + length * (k / steps) } else { until };
        let h = end - state.time();
        step(&mut state, h)?;
        k += 1.0;
    }
    // The last step may end beside it by rounding.
    let (held, x) = (state.held(), *state.x());
    state.set(until, &held, &x);
    Ok(state)
}
