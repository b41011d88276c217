//! Eight simulations side by side, with steps of equal length.

use core::array;
use core::fmt;
use core::marker::PhantomData;
use core::ops::{Deref, DerefMut};

use super::lane::{Fixed, Lane, column};
use super::side::{Side, Wide};
use super::{LANES, Lanes, Pack};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{FixedStep, Formula, Method, Partition, Rk4};
use crate::scalar::Scalar;
use crate::sim::{Clock, Sim};

/// Eight simulations of one mechanism, with parameters, inputs and states of their own: their rates are computed at once,
/// in numbers `L` of eight lanes.
///
/// Each ends with the bits that it would have if it ran alone. A lane that needs more than straight-line code makes that
/// step alone: where a solution without pivoting is unhealthy, where an event is possible, and as long as it is in another chart than
/// most. One that stops with a fault does not stop the others.
///
/// Mechanisms with contact rows, each with modes of its own, go together with [`MoreauJean`](crate::MoreauJean): the motion of all is
/// computed at once, and the small problem of the rows lane by lane. Its steps have one evaluation there. With a [`FixedStep`] they make all
/// steps alone.
///
/// With pairs that control their error ([`Embedded`](crate::method::Embedded)) each has steps of its own; mechanisms with conditions,
/// contact or absolute coordinates go alone there.
///
/// It dereferences to the array of simulations.
#[derive(Clone, Copy)]
pub struct Batch<M: Mechanism<S = f64>, L, I = Rk4<f64>> {
    pub(super) sims: [Sim<M, I>; LANES],
    lanes: PhantomData<L>,
}

impl<M: Mechanism<S = f64, State: fmt::Debug>, L, I> fmt::Debug for Batch<M, L, I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.sims).finish()
    }
}

impl<M: Pack<S = f64>, L: Lanes, I: Method<M>> Batch<M, L, I> {
    /// The simulations, fresh ones or such that have run.
    pub fn new(sims: [Sim<M, I>; LANES]) -> Self {
        Self { sims, lanes: PhantomData }
    }

    /// Assembles the mechanisms at time zero and makes them ready to run.
    ///
    /// # Errors
    /// When one of them cannot be assembled.
    pub fn start(mechanisms: &[M; LANES], method: I) -> Result<Self, Fault> {
        let first = mechanisms[0].start_with(method)?;
        let mut sims = array::from_fn(|_| first.clone());
        for (sim, mechanism) in sims.iter_mut().zip(mechanisms).skip(1) {
            *sim = mechanism.start_with(first.method().clone())?;
        }
        Ok(Self::new(sims))
    }
}

impl<M: Pack<S = f64>, L: Lanes, F: Formula> Batch<M, L, FixedStep<f64, F>> {
    /// Runs all for the communication interval `dt`, in s; gives what [`Sim::step`] would give for each.
    ///
    /// Those that have the latest time, and as long steps as the first of these, go together, the others alone.
    pub fn step(&mut self, dt: f64) -> [Result<(), Fault>; LANES] {
        for sim in self.sims.iter_mut().filter(|sim| sim.changed) {
            // One whose change cannot be is found as it was, and goes alone: it says so itself.
            let _ = sim.take_changes();
        }
        let (joins, clock) = self.together(dt);
        let mut lanes = {
            let mut joins = joins.into_iter();
            self.sims.each_mut().map(|sim| Lane::new(sim, clock.time, joins.next() == Some(true)))
        };
        run::<M, L, F>(&mut lanes);
        let reached = lanes.map(|lane| (lane.context.time, lane.context.held, lane.context.x, lane.outcome));
        array::from_fn(|i| {
            let (sim, (time, held, x, outcome)) = (&mut self.sims[i], &reached[i]);
            if !joins[i] {
                return sim.step(dt);
            }
            sim.state.set(*time, held, x);
            if outcome.is_ok() {
                sim.clock = clock;
            }
            *outcome
        })
    }

    /// Which simulations have the same steps before them, and the time at the end of those.
    fn together(&self, dt: f64) -> ([bool; LANES], Clock<f64>) {
        let time = self.sims.iter().fold(f64::NEG_INFINITY, |time, sim| time.max(sim.state.time()));
        let at_latest = self.sims.iter().find(|sim| sim.state.time() == time);
        let none = Clock { time, rest: 0.0 };
        let clock = at_latest.map_or(none, |sim| sim.clock).after(time, dt);
        let end = clock.time;
        let latest = |sim: &&Sim<M, _>| {
            sim.state.time() == time && end > time && end.is_finite() && sim.clock.after(time, dt) == clock
        };
        let first = self.sims.iter().find(latest).filter(|_| M::CONTACTS == 0);
        let Some(first) = first else { return ([false; LANES], clock) };
        let joins = |sim: &Sim<M, FixedStep<f64, F>>| {
            let free = sim.state.mechanism().next_time_event(time, &sim.state.held()).is_none();
            free && !sim.changed && latest(&sim) && sim.method.longest_step == first.method.longest_step
        };
        (self.sims.each_ref().map(joins), clock)
    }
}

/// Runs all lanes to the end of the interval.
fn run<M: Pack<S = f64>, L: Lanes, F: Formula>(lanes: &mut [Fixed<M, F>; LANES]) {
    let Some(first) = lanes.iter().find(|lane| lane.runs) else { return };
    let (mut time, end, mut partition, mut number) =
        (first.context.time, first.context.end, first.partition(), 0);
    let mut side = Side::<M, L>::new(lanes);
    while time < end {
        step(lanes, &mut side, (time, &partition, number));
        time = partition.next_time;
        partition.next();
        number += 1;
    }
    side.tell(lanes);
    for (i, lane) in lanes.iter_mut().enumerate().filter(|(_, lane)| lane.runs) {
        lane.count_steps(number);
        (lane.context.time, lane.context.x) = (end, column(&side.x, i));
    }
}

/// One step of all lanes: its beginning, the partition, and how many were made before.
#[inline]
fn step<M: Pack<S = f64>, L: Lanes, F: Formula>(
    lanes: &mut [Fixed<M, F>; LANES],
    side: &mut Side<M, L>,
    at: (f64, &Partition<f64>, u64),
) {
    let (mut next, health) = side.step::<F>(at);
    let coasts = side.coast(at.1.next_time, &next, health);
    if M::WATCHED || L::any(coasts.lt(side.running)) {
        apart(lanes, side, (&mut next, health, coasts), at);
    }
    side.x = next;
}

/// Makes the step of those lanes that do not coast (1 in those that do), in ordinary numbers, each as it would be made alone.
#[inline(never)]
fn apart<M: Pack<S = f64>, L: Lanes, F: Formula>(
    lanes: &mut [Fixed<M, F>; LANES],
    side: &mut Side<M, L>,
    (next, health, coasts): (&mut Wide<M, L>, L, L),
    at: (f64, &Partition<f64>, u64),
) {
    side.tell(lanes);
    // Who is joined may change on the way.
    let (joined, health, coasts) = (side.joined, health.values(), coasts.values());
    for i in 0..LANES {
        let lane = &mut lanes[i];
        let states = || [column(&side.x, i), column(next, i)];
        if !lane.runs || (coasts[i] > 0.0 && (!M::WATCHED || lane.coast(at, health[i], states))) {
            continue;
        }
        let ([from, to], place) = (states(), lane.place());
        let healthy = joined[i] && f64::HEALTHY < health[i];
        lane.step(at, from, healthy.then_some((to, health[i])));
        side.renew(next, (i, place), lanes);
    }
}

impl<M: Mechanism<S = f64>, L, I> Deref for Batch<M, L, I> {
    type Target = [Sim<M, I>; LANES];

    fn deref(&self) -> &Self::Target {
        &self.sims
    }
}

impl<M: Mechanism<S = f64>, L, I> DerefMut for Batch<M, L, I> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.sims
    }
}
