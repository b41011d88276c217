//! Runs of any size, behind one type.

use plm_run::AnySim;
use plm_runtime::contact::Counts;
use plm_runtime::described::by_number;
use plm_runtime::held::Discrete;
use plm_runtime::sim::Notice;
use plm_runtime::{BodyState, Described, Fault, Linear, Method, Moment, Sim, Statics, Stats};

use crate::numbers::Numbers;
use crate::record::{Watch, record};
use crate::sizes::{Large, PlainSmall, PlainTiny, PlainTinyStates, Small, Tiny};

/// Work on a run of a mechanism from text, whatever room the mechanism takes, and whatever method it runs by.
pub trait OnRun {
    /// Result of the work.
    type Output;

    /// Does it.
    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>;
}

/// A run of some size.
#[derive(Clone)]
pub(crate) enum Running {
    /// Of the smallest size.
    Tiny(Box<AnySim<Tiny>>),
    /// Of the smallest size, without contact.
    PlainTiny(Box<AnySim<PlainTiny>>),
    /// Of the smallest size with states, without contact.
    PlainTinyStates(Box<AnySim<PlainTinyStates>>),
    /// Of the middle size, without contact.
    PlainSmall(Box<AnySim<PlainSmall>>),
    /// Of the middle size.
    Small(Box<AnySim<Small>>),
    /// Of the largest size.
    Large(Box<AnySim<Large>>),
}

/// Evaluates an expression on the simulation of a run, whatever its size.
macro_rules! of_each {
    ($running:expr, $sim:ident => $value:expr) => {
        match $running {
            Running::Tiny($sim) => $value,
            Running::PlainTiny($sim) => $value,
            Running::PlainTinyStates($sim) => $value,
            Running::PlainSmall($sim) => $value,
            Running::Small($sim) => $value,
            Running::Large($sim) => $value,
        }
    };
}

/// Evaluates an expression on the state of a run.
macro_rules! at_state {
    ($running:expr, $state:ident => $value:expr) => {
        of_each!($running, sim => { let $state = sim.state(); $value })
    };
}

impl Running {
    /// Does something with it.
    pub(crate) fn then<W: OnRun>(&mut self, work: W) -> W::Output {
        of_each!(self, sim => work.on(&mut **sim))
    }

    /// The time, s.
    pub(crate) fn time(&self) -> f64 {
        at_state!(self, state => state.time())
    }

    /// Pose and velocity of a body by its number.
    pub(crate) fn body(&self, number: usize) -> Option<BodyState<f64>> {
        at_state!(self, state => state.body(number))
    }

    /// All its numbers.
    pub(crate) fn numbers(&self) -> Numbers {
        at_state!(self, state => state.numbers())
    }

    /// An output by its number, SI; not a number after the last one.
    pub(crate) fn output(&self, number: usize) -> f64 {
        at_state!(self, state => state.output(number)).unwrap_or(f64::NAN)
    }
}

/// Runs to a time.
pub(crate) struct StepTo(pub(crate) f64);

impl OnRun for StepTo {
    type Output = Result<(), Fault>;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        sim.step_to(self.0)
    }
}

/// Runs to a time, s, with samples so often, s, and with one at the end.
pub(crate) struct Record<'a> {
    pub(crate) times: (f64, f64),
    pub(crate) shows_end: bool,
    pub(crate) watch: &'a mut dyn Watch,
}

impl OnRun for Record<'_> {
    type Output = Result<(), Fault>;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        record(sim, self.times, self.shows_end, self.watch)
    }
}

/// Gives an input a value.
pub(crate) struct SetInput(pub(crate) usize, pub(crate) f64);

impl OnRun for SetInput {
    type Output = ();

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) {
        by_number::set_input(sim, self.0, self.1);
    }
}

/// Gives the counters.
pub(crate) struct Counted;

impl OnRun for Counted {
    type Output = Stats;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Stats {
        sim.stats()
    }
}

/// Gives what the user should know.
pub(crate) struct Noticed;

impl OnRun for Noticed {
    type Output = Vec<Notice>;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Vec<Notice> {
        Sim::notices(sim).collect()
    }
}

/// Gives the counters of contact.
pub(crate) struct CountedContacts;

impl OnRun for CountedContacts {
    type Output = Counts;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Counts {
        sim.contact_stats()
    }
}
