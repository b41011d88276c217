//! One lane of a batch, as the simulation that it is.

use super::{LANES, Lanes, Pack};
use crate::events::{Event, Watch};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, FixedStep, Formula, Method, Plan};
use crate::protocol::{Advance, DriftCheck, Guarded, Limits, Made};
use crate::sim::{Begun, Kept, Sim, Unobserved};
use crate::singular::{Nearness, Rescue};
use crate::system::Leg;
use crate::vector::Vector;

/// A simulation on its way through an interval.
pub(super) struct Lane<'a, M: Mechanism<S = f64>, F> {
    pub(super) course: Course<'a, M>,
    method: &'a mut FixedStep<f64, F>,
    watch: &'a mut Watch<f64, M::G>,
    kept: &'a mut Kept<M>,
    limits: Limits<f64>,
    /// It goes with the others: it started with them and has not stopped.
    pub(super) runs: bool,
    pub(super) outcome: Result<(), Fault>,
    /// So many of the steps that were made since it started are counted.
    counted: u64,
}

impl<'a, M: Pack<S = f64, G = [f64; 0]>, F: Formula> Lane<'a, M, F> {
    /// The simulation, on its way to `end`; it goes with the others if it `joins` them.
    pub(super) fn new(sim: &'a mut Sim<M, FixedStep<f64, F>>, end: f64, joins: bool) -> Self {
        let Sim { state, method, stats, watch, kept, limits, longest_step, .. } = sim;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut course = Course::new((system, held), (state.time(), x), end, (stats, longest_step));
        let outcome = if joins { method.begin(&mut course) } else { Ok(()) };
        let (limits, runs) = (*limits, joins && outcome.is_ok());
        Self { course, method, watch, kept, limits, runs, outcome, counted: 0 }
    }

    /// The division of the interval into steps.
    pub(super) fn plan(&self) -> Plan<f64> {
        self.method.plan
    }

    /// The chart in which its steps may be made with the others'; none where they may not.
    pub(super) fn place(&self) -> Option<usize> {
        let regular = !self.method.careful && !M::Rescue::holds(&self.course);
        M::chart(&self.course.held).filter(|_| self.runs && regular)
    }

    /// Its steps may be made with the others' where nothing is to be looked at.
    pub(super) fn coasts(&self) -> bool {
        self.limits.energy_jump.is_none()
    }

    /// Makes the step `number` with the others if one that is [watched](Pack::WATCHED) needs no more. The states before and
    /// after it are asked for where they are looked at.
    #[inline]
    pub(super) fn coast(
        &mut self,
        (time, plan, number): (f64, &Plan<f64>, u64),
        health: f64,
        states: impl FnOnce() -> [M::X; 2],
    ) -> bool {
        let Self { course: Course { system, held, .. }, method, .. } = self;
        let check = method.drift_check();
        let coasts = if check == DriftCheck::Skip && !M::Rescue::POSSIBLE {
            true
        } else {
            let [from, to] = &states();
            let leg = Leg { system: *system, held, from: (time, from), to: (plan.next_time, to), health };
            let length = <FixedStep<f64, F> as Method<M>>::LENGTH;
            M::Rescue::nearness(&leg, length) == Nearness::Regular
                && !check.fails(*system, plan.next_time, to)
        };
        if coasts {
            self.catch_up(number + 1);
        }
        coasts
    }

    /// Counts the steps up to `number` that were made with the others.
    #[inline]
    pub(super) fn catch_up(&mut self, number: u64) {
        let steps = if self.runs { number - self.counted } else { 0 };
        self.course.stats.steps += steps;
        self.course.stats.evaluations += steps * F::STAGES;
        self.method.keep_on(steps);
        self.counted = number;
    }

    /// Makes the step `number` of the plan from the state `x`, to `next` if that is known, with its health, and looks at it.
    pub(super) fn step(
        &mut self,
        (time, plan, number): (f64, &Plan<f64>, u64),
        x: M::X,
        next: Option<(M::X, f64)>,
    ) {
        self.catch_up(number);
        self.counted += 1;
        (self.course.time, self.course.x, self.method.plan) = (time, x, *plan);
        self.course.health = next.map_or(1.0, |next| next.1.min(1.0));
        let next = next.map(|next| next.0);
        let made = if M::Rescue::holds(&self.course) { Made::NearSingular } else { self.propose(next) };
        self.runs = matches!(made, Made::Step) && !M::Rescue::holds(&self.course);
        if !self.runs {
            // Near a singular pose, and in parts of the step, it goes on without the others.
            self.outcome = self.advance(&mut Unobserved).resume(made);
        }
    }

    fn propose(&mut self, next: Option<M::X>) -> Made<f64> {
        let Self { course, method, .. } = self;
        let from = Begun { time: course.time, held: course.held, x: course.x };
        let mut x = course.x;
        let made = match next {
            Some(next) => {
                x = next;
                method.is_short();
                course.stats.evaluations += F::STAGES;
                Ok(())
            }
            None => method.step(course, &mut x),
        };
        match made.and_then(|()| method.land(course, x)) {
            Ok(()) => self.advance(&mut Unobserved).conclude(&from, Event::None),
            Err(fault) => Made::Failed(fault),
        }
    }

    /// The lane as a run.
    fn advance<'s>(
        &'s mut self,
        observer: &'s mut Unobserved,
    ) -> Advance<'s, 'a, M, FixedStep<f64, F>, Unobserved> {
        let Self { course, method, watch, kept, limits, .. } = self;
        Advance { method, course, guarded: Guarded { watch, kept, limits: *limits }, observer }
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
