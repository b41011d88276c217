//! One lane of a batch, as the simulation that it is.

use super::{LANES, Lanes, Pack};
use crate::events::Watch;
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, FixedStep, Formula, Method, Plan};
use crate::sim::{Limits, Sim, alone, came_near, look};
use crate::singular::Rescue;
use crate::system::Leg;
use crate::vector::Vector;

/// A simulation on its way through an interval.
pub(super) struct Lane<'a, M: Mechanism<S = f64>, F> {
    pub(super) course: Course<'a, M>,
    method: &'a mut FixedStep<f64, F>,
    watch: &'a mut Watch<f64, M::G>,
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
        let Sim { state, method, stats, watch, limits, longest_step, .. } = sim;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut course = Course::new((system, held), (state.time(), x), end, (stats, longest_step));
        let outcome = if joins { method.begin(&mut course) } else { Ok(()) };
        Self { course, method, watch, limits: *limits, runs: joins && outcome.is_ok(), outcome, counted: 0 }
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
        !self.limits.audit()
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
        let coasts = if method.coasts() && !M::Rescue::DOUBTS {
            true
        } else {
            let [from, to] = &states();
            let leg = Leg { system: *system, held, from: (time, from), to: (plan.next_time, to), health };
            let whole = M::Rescue::parts(&leg, <FixedStep<f64, F> as Method<M>>::CAUTION) == 1;
            whole && !M::Rescue::doubts(&leg) && method.needs_no_settling(*system, plan.next_time, to)
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
        self.outcome = if M::Rescue::holds(&self.course) { Ok(()) } else { self.land(next) };
        let Course { divided, senseless, .. } = &self.course;
        let goes_on = divided.is_none() && senseless.is_none();
        self.runs = self.outcome.is_ok() && goes_on && !M::Rescue::holds(&self.course);
        if !self.runs {
            // Near a singular pose it goes on without the others.
            let Self { course, method, watch, limits, outcome, .. } = self;
            *outcome = alone(*method, course, (&mut **watch, *limits), *outcome);
        }
    }

    fn land(&mut self, next: Option<M::X>) -> Result<(), Fault> {
        let Self { course, method, watch, limits, .. } = self;
        let before = (course.time, course.x);
        let mut x = course.x;
        match next {
            Some(next) => {
                x = next;
                method.is_short();
                course.stats.evaluations += F::STAGES;
            }
            None => method.step(course, &mut x)?,
        }
        method.land(course, x)?;
        if came_near::<M, FixedStep<f64, F>>(course, before, watch) {
            return Ok(());
        }
        if let Some(next) = look(*method, course, (&mut **watch, *limits), before)? {
            next.hold(*method, course);
        }
        Ok(())
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
