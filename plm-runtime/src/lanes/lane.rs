//! One lane of a batch, as the simulation that it is.

use super::{LANES, Lanes, Pack};
use crate::events::{Beginning, Detector, Event, History, at_a_jump};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, DriftCheck, FixedStep, Formula, Method, Partition};
use crate::protocol::{Advance, Guarded, Limits, Made, Unobserved};
use crate::sim::Sim;
use crate::singular::{Nearness, Rescue};
use crate::system::Step;
use crate::vector::Vector;

/// A simulation on its way through an interval.
pub(super) struct Lane<'a, M: Mechanism<S = f64>, I> {
    pub(super) context: Context<'a, M>,
    pub(super) method: &'a mut I,
    detector: &'a mut Detector<f64, M::G>,
    history: &'a mut History<M>,
    limits: Limits<f64>,
    /// It goes with the others: it started with them and has not stopped.
    pub(super) runs: bool,
    pub(super) outcome: Result<(), Fault>,
    /// So many of the steps that were made since it started are counted.
    counted: u64,
}

impl<'a, M: Pack<S = f64>, I: Method<M>> Lane<'a, M, I> {
    /// The simulation, on its way to `end`; it goes with the others if it `joins` them.
    pub(super) fn new(sim: &'a mut Sim<M, I>, end: f64, joins: bool) -> Self {
        let Sim { state, method, stats, detector, history, limits, longest_step, .. } = sim;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut context = Context::new((system, held), (state.time(), x), end, (stats, longest_step));
        let started =
            joins.then(|| detector.begin(method, &mut context).and_then(|()| method.begin(&mut context)));
        let outcome = started.unwrap_or(Ok(())).map_err(|fault| at_a_jump(&mut context, fault));
        let (limits, runs) = (*limits, joins && outcome.is_ok());
        Self { context, method, detector, history, limits, runs, outcome, counted: 0 }
    }

    /// Does what the judge says of the step from a beginning to the state reached, or goes on after a fault of it; where that is more than
    /// to commit it, the lane goes on without the others.
    pub(super) fn conclude(&mut self, made: Result<Beginning<M>, (Beginning<M>, Fault)>) {
        let mut unobserved = Unobserved;
        let mut advance = self.advance(&mut unobserved);
        let made = match made {
            Ok(from) => advance.conclude(&from, Event::None),
            Err((from, fault)) => advance.fail(&from, fault),
        };
        let goes_on = matches!(made, Made::Step) && !M::Rescue::holds(&self.context);
        if !goes_on {
            self.go_alone(made);
        }
    }

    /// Is there nothing to do after the step from a time and state to the state reached: would the judge accept it as it is, without events?
    #[inline]
    pub(super) fn has_nothing_to_do(&self, from: (f64, &M::X)) -> bool {
        let Context { system, time, held, x, .. } = &self.context;
        let step = self.context.step(from);
        self.limits.energy_jump.is_none()
            && self.history.counts.is_none()
            && self.method.drift_check(system) == DriftCheck::Skip
            && M::Rescue::nearness(&step, self.method.length()) == Nearness::Regular
            && system.is_settled(*time, held, x)
            && (Detector::has_none::<M>(system, held, self.method.change())
                || self.detector.excludes_events(self.history, &step))
    }

    /// Goes on to the end of the interval without the others, after a step.
    pub(super) fn go_alone(&mut self, made: Made<f64>) {
        self.runs = false;
        let outcome = self.advance(&mut Unobserved).go_on(made);
        self.outcome = outcome.map_err(|fault| at_a_jump(&mut self.context, fault));
    }

    /// The lane as a run.
    fn advance<'s>(&'s mut self, observer: &'s mut Unobserved) -> Advance<'s, 'a, M, I, Unobserved> {
        let Self { context, method, detector, history, limits, .. } = self;
        Advance {
            method,
            context,
            guarded: Guarded { detector, history, limits: *limits },
            observer,
            cut: None,
        }
    }
}

/// A lane of a formula.
pub(super) type Fixed<'a, M, F> = Lane<'a, M, FixedStep<f64, F>>;

impl<M: Pack<S = f64>, F: Formula> Fixed<'_, M, F> {
    /// The division of the interval into steps.
    pub(super) fn partition(&self) -> Partition<f64> {
        self.method.partition
    }

    /// The chart in which its steps may be made with the others'; none where they may not.
    pub(super) fn place(&self) -> Option<usize> {
        let regular = !self.method.was_unhealthy && !M::Rescue::holds(&self.context);
        M::chart(&self.context.held).filter(|_| self.runs && regular)
    }

    /// True if its steps may be made with the others' as long as nothing is to be checked.
    pub(super) fn coasts(&self) -> bool {
        self.limits.energy_jump.is_none()
    }

    /// Makes the step `number` with the others if one that is [watched](Pack::WATCHED) needs no more. The states before and after it are
    /// computed only if they are checked.
    #[inline]
    pub(super) fn coast(
        &mut self,
        (time, partition, number): (f64, &Partition<f64>, u64),
        health: f64,
        states: impl FnOnce() -> [M::X; 2],
    ) -> bool {
        let Self { context: Context { system, held, .. }, method, detector, history, .. } = self;
        let check = method.drift_check();
        let coasts = if check == DriftCheck::Skip && !M::Rescue::POSSIBLE && M::G::LEN == 0 {
            true
        } else {
            let [from, to] = &states();
            let step =
                Step { system: *system, held, from: (time, from), to: (partition.next_time, to), health };
            M::Rescue::nearness(&step, Method::<M>::length(&**method)) == Nearness::Regular
                && !check.fails((*system, held), partition.next_time, to)
                && detector.excludes_events(history, &step)
        };
        if coasts {
            self.count_steps(number + 1);
        }
        coasts
    }

    /// Counts the steps up to `number` that were made with the others.
    #[inline]
    pub(super) fn count_steps(&mut self, number: u64) {
        let steps = if self.runs { number - self.counted } else { 0 };
        self.context.stats.steps += steps;
        self.context.stats.evaluations += steps * F::STAGES;
        self.method.skip_checks(steps);
        self.counted = number;
    }

    /// Makes the step `number` of the partition from the state `x`, to `next` if that is known, with its health, and checks it.
    pub(super) fn step(
        &mut self,
        (time, partition, number): (f64, &Partition<f64>, u64),
        x: M::X,
        next: Option<(M::X, f64)>,
    ) {
        self.count_steps(number);
        self.counted += 1;
        (self.context.time, self.context.x, self.method.partition) = (time, x, *partition);
        self.context.health = next.map_or(1.0, |next| next.1.min(1.0));
        let next = next.map(|next| next.0);
        let made = if M::Rescue::holds(&self.context) { Made::NearSingular } else { self.propose(next) };
        self.runs = matches!(made, Made::Step) && !M::Rescue::holds(&self.context);
        if !self.runs {
            // Near a singular pose, and where the step is split, it goes on without the others.
            let outcome = self.advance(&mut Unobserved).resume(made);
            self.outcome = outcome.map_err(|fault| at_a_jump(&mut self.context, fault));
        }
    }

    fn propose(&mut self, next: Option<M::X>) -> Made<f64> {
        let Self { context, method, .. } = self;
        let from = Beginning::of(context);
        let mut x = context.x;
        let made = match next {
            Some(next) => {
                x = next;
                method.is_short();
                context.stats.evaluations += F::STAGES;
                Ok(())
            }
            None => method.step(context, &mut x),
        };
        match made.and_then(|()| method.land(context, x)) {
            Ok(()) => self.advance(&mut Unobserved).conclude(&from, Event::None),
            Err(fault) => self.advance(&mut Unobserved).fail(&from, fault),
        }
    }
}

/// The values of one lane.
#[inline]
pub(super) fn column<L: Lanes, X: Vector<f64>>(wide: &impl Vector<L>, lane: usize) -> X {
    X::from_fn(|k| wide.at(k).values()[lane % LANES])
}

/// Gives one lane its values.
#[inline]
pub(super) fn set_column<L: Lanes, Y: Vector<L>>(wide: &mut Y, lane: usize, x: &impl Vector<f64>) {
    for k in 0..Y::LEN {
        let mut number = wide.at(k);
        number.put(lane, x.at(k));
        wide.set(k, number);
    }
}
