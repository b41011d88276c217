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
    /// Steps that were made for all lanes at once, and needed nothing more.
    coasted: u64,
}

impl<'a, M: Pack<S = f64, G = [f64; 0]>, F: Formula> Lane<'a, M, F> {
    /// The simulation, on its way to `end`; it goes with the others if it `joins` them.
    pub(super) fn new(sim: &'a mut Sim<M, FixedStep<f64, F>>, end: f64, joins: bool) -> Self {
        let Sim { state, method, stats, watch, limits, longest_step, .. } = sim;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut course = Course::new((system, held), (state.time(), x), end, (stats, longest_step));
        let outcome = if joins { method.begin(&mut course) } else { Ok(()) };
        Self { course, method, watch, limits: *limits, runs: joins && outcome.is_ok(), outcome, coasted: 0 }
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

    /// Makes the next step with the others and without a look at it, if none is due; to a state at which [`Pack::is_calm`]. The
    /// states before and after it are asked for where they are looked at.
    #[inline]
    pub(super) fn coast(
        &mut self,
        (time, plan): (f64, &Plan<f64>),
        health: f64,
        states: impl FnOnce() -> [M::X; 2],
    ) -> bool {
        let Self { course: Course { system, held, .. }, method, limits, .. } = self;
        let coasts = if limits.audit() {
            false
        } else if method.coasts() && !M::Rescue::DOUBTS {
            method.keep(false);
            true
        } else {
            let [from, to] = &states();
            let leg = Leg { system: *system, held, from: (time, from), to: (plan.next_time, to), health };
            !M::Rescue::doubts(&leg) && method.coast(*system, plan.next_time, to)
        };
        self.coasted += u64::from(coasts);
        coasts
    }

    /// Makes the next step of the plan from the state `x`, to `next` if that is known, with its health, and looks at it.
    pub(super) fn step(&mut self, time: f64, plan: &Plan<f64>, x: M::X, next: Option<(M::X, f64)>) {
        (self.course.time, self.course.x, self.method.plan) = (time, x, *plan);
        self.course.health = next.map_or(1.0, |next| next.1.min(1.0));
        let next = next.map(|next| next.0);
        self.outcome = if M::Rescue::holds(&self.course) { Ok(()) } else { self.land(next) };
        self.runs = self.outcome.is_ok() && self.course.divided.is_none() && !M::Rescue::holds(&self.course);
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

    /// Counts the steps that were made with the others.
    pub(super) fn close(&mut self) {
        self.course.stats.steps += self.coasted;
        self.course.stats.evaluations += self.coasted * F::STAGES;
    }
}

/// The values of one lane.
pub(super) fn column<L: Lanes, X: Vector<f64>>(wide: &impl Vector<L>, lane: usize) -> X {
    X::from_fn(|k| wide.at(k).values()[lane % LANES])
}

/// Gives one lane its values.
pub(super) fn set_column<L: Lanes, Y: Vector<L>>(wide: &mut Y, lane: usize, x: &impl Vector<f64>) {
    for k in 0..Y::LEN {
        let mut number = wide.at(k);
        number.put(lane, x.at(k));
        wide.set(k, number);
    }
}
