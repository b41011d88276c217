//! Runs with their derivatives in any number of directions, a few in each run on dual numbers (A. Griewank, A. Walther, Evaluating
//! Derivatives, 2nd ed., SIAM 2008, 3.2).

use nalgebra::{DMatrix, DVector};
use plm_runtime::start::follow;
use plm_runtime::{Described, Dual, Fault, Mechanism, Moment, Rate, Sim, StartValues, Statics, Vector};

use crate::optimise::mechanism::{Integration, LANES, Lifted, Number, Optimisable};
use crate::optimise::signal::{Numbers, Schedule, Signal, set_inputs};

/// A number that a run is derived by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// A parameter by its number; start values that are declared by it follow.
    Parameter(usize),
    /// A start value by its number.
    Start(usize),
    /// A number of the state in which the run begins, by its place.
    State(usize),
    /// The value of a signal in one of its pieces.
    Input(usize, usize),
    /// The duration that all times are fractions of.
    Duration,
}

/// Start of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Begin<M: Rate> {
    /// At the assembled start.
    Start,
    /// In this state.
    At(M::U, M::X),
}

/// A run: a mechanism with its numbers, where it begins, and what drives it.
pub(crate) struct Shot<'a, M: Rate> {
    pub(crate) mechanism: &'a M,
    pub(crate) begin: Begin<M>,
    /// Time at which it begins, s.
    pub(crate) time: f64,
    pub(crate) schedule: Schedule<'a>,
    /// Outputs that are read at each sample, by number among [`Described::observables`].
    pub(crate) outputs: &'a [usize],
    /// The duration, s, of which all times are fractions in the direction [`Direction::Duration`].
    pub(crate) duration: f64,
}

/// Outputs of a run and its last state with their derivatives, a column for each direction; SI.
#[derive(Clone, Debug)]
pub(crate) struct Flow {
    /// The outputs of the first sample, then of the next.
    pub(crate) outputs: DVector<f64>,
    pub(crate) outputs_by: DMatrix<f64>,
    /// The last state, by place.
    pub(crate) end: DVector<f64>,
    pub(crate) end_by: DMatrix<f64>,
    /// The coordinates that the last state is counted in.
    pub(crate) chart: Vec<&'static str>,
}

/// Plain numbers.
struct Plain<'a>(&'a [Signal]);

impl Numbers<f64> for Plain<'_> {
    fn time(&self, time: f64) -> f64 {
        time
    }
    fn value(&self, signal: usize, piece: usize) -> f64 {
        value(self.0, signal, piece)
    }
}

/// Numbers with derivatives in some of the directions.
struct Derived<'a> {
    signals: &'a [Signal],
    directions: &'a [Direction],
    duration: f64,
}

impl Derived<'_> {
    fn variable(&self, value: f64, direction: Direction) -> Number {
        self.directions
            .iter()
            .position(|own| *own == direction)
            .map_or(Dual::constant(value), |k| Dual::variable(value, k))
    }
}

impl Numbers<Number> for Derived<'_> {
    fn time(&self, time: f64) -> Number {
        let Dual { value, tangents } = self.variable(time, Direction::Duration);
        Dual { value, tangents: tangents.map(|tangent| tangent * time / self.duration) }
    }
    fn value(&self, signal: usize, piece: usize) -> Number {
        self.variable(value(self.signals, signal, piece), Direction::Input(signal, piece))
    }
}

fn value(signals: &[Signal], signal: usize, piece: usize) -> f64 {
    signals.get(signal).and_then(|signal| signal.values.get(piece)).copied().unwrap_or(f64::NAN)
}

/// The names of the coordinates of a state: they differ between charts.
pub(crate) fn chart<M: Rate + plm_runtime::Labels>(mechanism: &M, held: &M::U) -> Vec<&'static str> {
    (0..M::NQ).map(|place| mechanism.name_in_chart(held, place)).collect()
}

/// The state in which a run begins.
fn started<L: Described + Statics>(
    mechanism: &L,
    time: f64,
    signals: &[Signal],
    numbers: &impl Numbers<L::S>,
) -> Result<L::State, Fault> {
    let mut held = mechanism.unstarted();
    set_inputs::<L>(&mut held, time, signals, numbers);
    let time = numbers.time(time);
    let (held, x) = mechanism.start_with_inputs(time, &held)?;
    Ok(Moment::new(*mechanism, held, time, x))
}

impl<M: Optimisable> Shot<'_, M> {
    /// Runs without derivatives, and shows the state at each sample.
    ///
    /// # Errors
    /// Those of assembly and of the run.
    pub(crate) fn run<D: Integration<M>>(
        &self,
        integration: &D,
        see: &mut impl FnMut(usize, &M::State),
    ) -> Result<M::State, Fault> {
        let numbers = Plain(self.schedule.signals);
        let state = match self.begin {
            Begin::Start => started(self.mechanism, self.time, self.schedule.signals, &numbers)?,
            Begin::At(mut held, x) => {
                set_inputs::<M>(&mut held, self.time, self.schedule.signals, &numbers);
                Moment::new(*self.mechanism, held, self.time, x)
            }
        };
        let mut sim = Sim::new(state, integration.plain());
        if matches!(self.begin, Begin::At(..)) {
            sim.project()?;
        }
        self.schedule.follow(&mut sim, &numbers, see)?;
        Ok(*sim.state())
    }

    /// Runs with derivatives in all directions.
    ///
    /// # Errors
    /// Those of assembly and of the run; where there are no derivatives.
    pub(crate) fn derive<D: Integration<M>>(
        &self,
        integration: &D,
        directions: &[Direction],
    ) -> Result<Flow, Fault> {
        let rows = self.outputs.len() * self.schedule.samples.len();
        let size = <M::X as Vector<f64>>::LEN;
        let mut flow = Flow {
            outputs: DVector::zeros(rows),
            outputs_by: DMatrix::zeros(rows, directions.len()),
            end: DVector::zeros(size),
            end_by: DMatrix::zeros(size, directions.len()),
            chart: Vec::new(),
        };
        // Once at least, for the values.
        for first in (0..directions.len().max(1)).step_by(LANES) {
            let last = directions.len().min(first + LANES);
            self.pass(integration, directions.get(first..last).unwrap_or_default(), first, &mut flow)?;
        }
        Ok(flow)
    }

    /// Runs with derivatives in a few directions, which are columns from `first` on.
    fn pass<D: Integration<M>>(
        &self,
        integration: &D,
        directions: &[Direction],
        first: usize,
        flow: &mut Flow,
    ) -> Result<(), Fault> {
        let numbers = Derived { signals: self.schedule.signals, directions, duration: self.duration };
        let (lifted, state) = self.lifted(&numbers)?;
        let mut sim = Sim::new(state, integration.derived());
        if matches!(self.begin, Begin::At(..)) {
            sim.project()?;
        }
        let Flow { outputs, outputs_by, end, end_by, chart: names } = flow;
        let width = self.outputs.len();
        let mut see = |sample: usize, state: &<Lifted<M> as Mechanism>::State| {
            let mut place = sample * width;
            <Lifted<M> as Described>::observe(state, self.outputs.iter().copied(), &mut |number| {
                put(place, number, (outputs, outputs_by), (first, directions.len()));
                place += 1;
            });
        };
        self.schedule.follow(&mut sim, &numbers, &mut see)?;
        for place in 0..end.len() {
            let number = Some(sim.state().x().at(place));
            put(place, number, (end, end_by), (first, directions.len()));
        }
        *names = chart(&lifted, &sim.state().held());
        Ok(())
    }

    /// The mechanism and the state in which it begins, in numbers with derivatives.
    fn lifted(&self, numbers: &Derived<'_>) -> Result<(Lifted<M>, <Lifted<M> as Mechanism>::State), Fault> {
        let unstarted = self.mechanism.unstarted();
        let held = if let Begin::At(held, _) = &self.begin { held } else { &unstarted };
        let (mut lifted, mut held) = self.mechanism.lift::<LANES>(held);
        derive_parameters::<M>(&mut lifted, numbers);
        derive_starts::<M>(&mut lifted, numbers);
        let state = match &self.begin {
            Begin::Start => started(&lifted, self.time, self.schedule.signals, numbers)?,
            Begin::At(_, x) => {
                set_inputs::<Lifted<M>>(&mut held, self.time, self.schedule.signals, numbers);
                let x = Vector::from_fn(|place| numbers.variable(x.at(place), Direction::State(place)));
                Moment::new(lifted, held, numbers.time(self.time), x)
            }
        };
        Ok((lifted, state))
    }
}

/// Puts a number and its derivatives into a row.
fn put(
    row: usize,
    number: Option<Number>,
    (values, by): (&mut DVector<f64>, &mut DMatrix<f64>),
    (first, count): (usize, usize),
) {
    let Dual { value, tangents } = number.unwrap_or(Dual::constant(f64::NAN));
    values[row] = value;
    for (k, tangent) in tangents.into_iter().take(count).enumerate() {
        by[(row, first + k)] = tangent;
    }
}

/// Makes parameters variables; start values that are declared by them follow.
fn derive_parameters<M: Optimisable>(lifted: &mut Lifted<M>, numbers: &Derived<'_>) {
    let before = lifted.declared_starts();
    for direction in numbers.directions {
        if let Direction::Parameter(index) = *direction
            && let Some(place) = lifted.parameter_mut(index)
        {
            *place = numbers.variable(place.value, *direction);
        }
    }
    let after = lifted.declared_starts();
    follow(lifted.starts_mut(), before, after);
}

/// Makes start values variables.
fn derive_starts<M: Optimisable>(lifted: &mut Lifted<M>, numbers: &Derived<'_>) {
    let mut index = 0;
    lifted.starts_mut().each(&mut |_, start| {
        let direction = Direction::Start(index);
        if numbers.directions.contains(&direction) {
            start.value = numbers.variable(start.value.value, direction);
        }
        index += 1;
    });
}
