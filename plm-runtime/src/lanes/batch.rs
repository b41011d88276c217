//! Eight simulations side by side, with steps of equal length.

use core::array;
use core::fmt;
use core::marker::PhantomData;
use core::ops::{Deref, DerefMut};

use super::lane::{Lane, column, set_column};
use super::{LANES, Lanes, Pack, Rate, Unwatched};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{FixedStep, Formula, Plan, Rk4Formula};
use crate::scalar::Scalar;
use crate::sim::{Clock, Sim};
use crate::vector::Vector;

/// Eight simulations of one mechanism, with parameters, inputs and states of their own: their rates are computed at once,
/// in numbers `L` of eight lanes.
///
/// Each ends with the bits that it would have if it ran alone. A lane that needs more than straight-line code makes that
/// step alone: where a solution without pivoting is unhealthy, and as long as it is in another chart than most. One that
/// stops with a fault does not stop the others.
///
/// It dereferences to the array of simulations.
#[derive(Clone, Copy)]
pub struct Batch<M: Mechanism<S = f64>, L, F = Rk4Formula> {
    sims: [Sim<M, FixedStep<f64, F>>; LANES],
    lanes: PhantomData<L>,
}

impl<M: Mechanism<S = f64, State: fmt::Debug>, L, F> fmt::Debug for Batch<M, L, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.sims).finish()
    }
}

impl<M, L, F> Batch<M, L, F>
where
    M: Pack<S = f64, G = [f64; 0]>,
    L: Lanes,
    F: Formula,
{
    /// The simulations, fresh ones or such that have run.
    pub fn new(sims: [Sim<M, FixedStep<f64, F>>; LANES]) -> Self {
        Self { sims, lanes: PhantomData }
    }

    /// Assembles the mechanisms at time zero and makes them ready to run.
    ///
    /// # Errors
    /// When one of them cannot be assembled.
    pub fn start(mechanisms: &[M; LANES], method: FixedStep<f64, F>) -> Result<Self, Fault> {
        let mut sims = [mechanisms[0].start_with(method)?; LANES];
        for (sim, mechanism) in sims.iter_mut().zip(mechanisms) {
            *sim = mechanism.start_with(method)?;
        }
        Ok(Self::new(sims))
    }

    /// Runs all for the communication interval `dt`, in s; gives what [`Sim::step`] would give for each.
    ///
    /// Those that have the latest time, and as long steps as the first of these, go together, the others alone.
    pub fn step(&mut self, dt: f64) -> [Result<(), Fault>; LANES] {
        for sim in self.sims.iter_mut().filter(|sim| !sim.is_unchanged()) {
            // One whose change cannot be is found as it was, and goes alone: it says so itself.
            let _ = sim.take_changes();
        }
        let (joins, clock) = self.together(dt);
        let mut lanes = {
            let mut joins = joins.into_iter();
            self.sims.each_mut().map(|sim| Lane::new(sim, clock.time, joins.next() == Some(true)))
        };
        run::<M, L, F>(&mut lanes);
        let reached = lanes.map(|mut lane| {
            lane.close();
            (lane.course.time, lane.course.held, lane.course.x, lane.outcome)
        });
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
        let Some(first) = self.sims.iter().find(latest) else { return ([false; LANES], clock) };
        let joins = |sim: &Sim<M, FixedStep<f64, F>>| {
            let free = sim.state.mechanism().next_instant(time, &sim.state.held()).is_none();
            free && sim.is_unchanged() && latest(&sim) && sim.method.longest_step == first.method.longest_step
        };
        (self.sims.each_ref().map(joins), clock)
    }
}

/// The lanes as one mechanism in one state.
struct Side<M: Pack<S = f64>, L: Lanes> {
    mechanism: Unwatched<M::Packed<L>>,
    held: <M::Packed<L> as Rate>::U,
    x: <M::Packed<L> as Rate>::X,
    /// Which lanes are computed: those in the chart of most.
    joined: [bool; LANES],
}

impl<M: Pack<S = f64, G = [f64; 0]>, L: Lanes> Side<M, L> {
    fn new<F: Formula>(lanes: &[Lane<M, F>; LANES]) -> Self {
        let systems = lanes.each_ref().map(|lane| lane.course.system);
        let (held, joined) = hold(lanes);
        Self {
            mechanism: Unwatched(systems[0].pack(systems, L::of)),
            held,
            x: Vector::from_fn(|k| L::of(lanes.each_ref().map(|lane| lane.course.x.at(k)))),
            joined,
        }
    }

    /// A lane has made a step by itself to the state `next`; it was at a place before.
    fn renew<F: Formula>(
        &mut self,
        next: &mut <M::Packed<L> as Rate>::X,
        (i, before): (usize, Option<usize>),
        lanes: &[Lane<M, F>; LANES],
    ) {
        let (course, joined) = (&lanes[i % LANES].course, self.joined[i % LANES]);
        set_column(next, i, &course.x);
        if lanes[i % LANES].place() != before {
            (self.held, self.joined) = hold(lanes);
        } else if joined {
            M::put_held(&mut self.held, &course.held, |wide: &mut L, one| wide.put(i, one));
        }
    }
}

/// What the lanes hold, as one, in the chart of most, and which lanes are in that.
fn hold<M: Pack<S = f64, G = [f64; 0]>, L: Lanes, F: Formula>(
    lanes: &[Lane<M, F>; LANES],
) -> (<M::Packed<L> as Rate>::U, [bool; LANES]) {
    let held = lanes.each_ref().map(|lane| &lane.course.held);
    let joins = |lane: &Lane<M, F>, first: &Lane<M, F>| {
        let place = lane.place();
        place.is_some() && place == M::chart(&first.course.held)
    };
    let joined_by = |first: &Lane<M, F>| lanes.iter().filter(|other| joins(other, first)).count();
    let first = lanes.iter().max_by_key(|lane| joined_by(lane)).unwrap_or(&lanes[0]);
    (M::pack_held(&first.course.held, held, L::of), lanes.each_ref().map(|lane| joins(lane, first)))
}

/// Runs all lanes to the end of the interval.
fn run<M: Pack<S = f64, G = [f64; 0]>, L: Lanes, F: Formula>(lanes: &mut [Lane<M, F>; LANES]) {
    let Some(first) = lanes.iter().find(|lane| lane.runs) else { return };
    let (mut time, end, mut plan) = (first.course.time, first.course.end, first.plan());
    let mut side = Side::<M, L>::new(lanes);
    while time < end {
        step(lanes, &mut side, time, &plan);
        time = plan.next_time;
        plan.next();
    }
    for (i, lane) in lanes.iter_mut().enumerate().filter(|(_, lane)| lane.runs) {
        (lane.course.time, lane.course.x) = (end, column(&side.x, i));
    }
}

/// One step of all lanes.
#[inline]
fn step<M: Pack<S = f64, G = [f64; 0]>, L: Lanes, F: Formula>(
    lanes: &mut [Lane<M, F>; LANES],
    side: &mut Side<M, L>,
    time: f64,
    plan: &Plan<f64>,
) {
    let mut next = side.x;
    let health = F::plain_step(&side.mechanism, L::lit(time), &side.held, &mut next, L::lit(plan.h)).0;
    // Of a lane that is not a number, others need not be: each says so itself.
    let calm = M::are_calm(L::lit(plan.next_time), &side.held, &next);
    let calm = L::select(L::lit(f64::HEALTHY).lt(health), calm, L::lit(0.0));
    let (health, calm, all_finite) = (health.values(), calm.values(), next.is_finite());
    // Who is joined may change on the way.
    let joined = side.joined;
    for i in 0..LANES {
        let lane = &mut lanes[i];
        let states = || [column(&side.x, i), column(&next, i)];
        let trusted = joined[i] && all_finite && calm[i] > 0.0;
        if !lane.runs || (trusted && lane.coast((time, plan), health[i], states)) {
            continue;
        }
        let ([from, to], place) = (states(), lane.place());
        let healthy = joined[i] && f64::HEALTHY < health[i];
        lane.step(time, plan, from, healthy.then_some((to, health[i])));
        side.renew(&mut next, (i, place), lanes);
    }
    side.x = next;
}

impl<M: Mechanism<S = f64>, L, F> Deref for Batch<M, L, F> {
    type Target = [Sim<M, FixedStep<f64, F>>; LANES];

    fn deref(&self) -> &Self::Target {
        &self.sims
    }
}

impl<M: Mechanism<S = f64>, L, F> DerefMut for Batch<M, L, F> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.sims
    }
}
