//! Runs of any size by any method, behind one type.

use plm_run::{AnySim, OnSim};
use plm_runtime::{BodyState, Fault, Method, Moment, Sim, Stats};

use crate::handle::Dynamic;
use crate::record::{See, record};
use crate::system::State;

/// A run of some size by some method.
pub(crate) trait Running {
    /// The time, s.
    fn time(&self) -> f64;
    /// Runs to a time, s.
    fn step_to(&mut self, time: f64) -> Result<(), Fault>;
    /// Runs to a time, s, and shows samples, so often, s.
    fn record(&mut self, until_every: (f64, f64), see: See) -> Result<(), Fault>;
    /// What was done so far.
    fn stats(&self) -> Stats;
    /// Pose and velocity of a body by its number.
    fn body(&self, number: usize) -> Option<BodyState<f64>>;
    /// An output by its number, SI; not a number behind the last one.
    fn output(&self, number: usize) -> f64;
    /// Gives an input a value.
    fn set_input(&mut self, number: usize, value: f64);
}

/// By a method of the catalogue.
pub(crate) struct Any<const NQ: usize, const NC: usize, const N: usize>(
    pub(crate) Box<AnySim<Dynamic<f64, NQ, NC, N>>>,
    pub(crate) Stats,
);

/// By one method.
pub(crate) struct One<const NQ: usize, const NC: usize, const N: usize, I>(
    pub(crate) Box<Sim<Dynamic<f64, NQ, NC, N>, I>>,
);

fn output<const NQ: usize, const NC: usize, const N: usize>(
    state: &State<f64, NQ, NC, N>,
    number: usize,
) -> f64 {
    state.output(number).unwrap_or(f64::NAN)
}

fn set<const NQ: usize, const NC: usize, const N: usize>(
    state: &mut State<f64, NQ, NC, N>,
    number: usize,
    value: f64,
) {
    if let Some(input) = state.in_place().held.input.get_mut(number) {
        *input = value;
    }
}

impl<const NQ: usize, const NC: usize, const N: usize, I> Running for One<NQ, NC, N, I>
where
    I: Method<Dynamic<f64, NQ, NC, N>>,
{
    fn time(&self) -> f64 {
        self.0.state().time()
    }

    fn step_to(&mut self, time: f64) -> Result<(), Fault> {
        self.0.step_to(time)
    }

    fn record(&mut self, until_every: (f64, f64), see: See) -> Result<(), Fault> {
        record(&mut self.0, until_every, see)
    }

    fn stats(&self) -> Stats {
        self.0.stats()
    }

    fn body(&self, number: usize) -> Option<BodyState<f64>> {
        self.0.state().body(number)
    }

    fn output(&self, number: usize) -> f64 {
        output(self.0.state(), number)
    }

    fn set_input(&mut self, number: usize, value: f64) {
        set(&mut self.0, number, value);
    }
}

/// Runs to a time, and gives the counters.
struct StepTo(f64);

impl<const NQ: usize, const NC: usize, const N: usize> OnSim<Dynamic<f64, NQ, NC, N>> for StepTo {
    type Output = (Result<(), Fault>, Stats);

    fn on<I: Method<Dynamic<f64, NQ, NC, N>>>(
        self,
        sim: &mut Sim<Dynamic<f64, NQ, NC, N>, I>,
    ) -> Self::Output {
        (sim.step_to(self.0), sim.stats())
    }
}

/// Runs to a time with samples, and gives the counters.
struct Record<'a>((f64, f64), See<'a>);

impl<const NQ: usize, const NC: usize, const N: usize> OnSim<Dynamic<f64, NQ, NC, N>> for Record<'_> {
    type Output = (Result<(), Fault>, Stats);

    fn on<I: Method<Dynamic<f64, NQ, NC, N>>>(
        self,
        sim: &mut Sim<Dynamic<f64, NQ, NC, N>, I>,
    ) -> Self::Output {
        (record(sim, self.0, self.1), sim.stats())
    }
}

/// Gives an input a value.
struct SetInput(usize, f64);

impl<const NQ: usize, const NC: usize, const N: usize> OnSim<Dynamic<f64, NQ, NC, N>> for SetInput {
    type Output = ();

    fn on<I: Method<Dynamic<f64, NQ, NC, N>>>(self, sim: &mut Sim<Dynamic<f64, NQ, NC, N>, I>) {
        set(sim, self.0, self.1);
    }
}

impl<const NQ: usize, const NC: usize, const N: usize> Running for Any<NQ, NC, N> {
    fn time(&self) -> f64 {
        self.0.state().time()
    }

    fn step_to(&mut self, time: f64) -> Result<(), Fault> {
        let (outcome, stats) = self.0.then(StepTo(time));
        self.1 = stats;
        outcome
    }

    fn record(&mut self, until_every: (f64, f64), see: See) -> Result<(), Fault> {
        let (outcome, stats) = self.0.then(Record(until_every, see));
        self.1 = stats;
        outcome
    }

    fn stats(&self) -> Stats {
        self.1
    }

    fn body(&self, number: usize) -> Option<BodyState<f64>> {
        self.0.state().body(number)
    }

    fn output(&self, number: usize) -> f64 {
        output(self.0.state(), number)
    }

    fn set_input(&mut self, number: usize, value: f64) {
        self.0.then(SetInput(number, value));
    }
}
