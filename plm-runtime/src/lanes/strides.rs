//! Steps of Moreau and Jean of eight simulations side by side: the motion of all at once, rows of contact and checks lane by lane.

use core::array;

use super::batch::Batch;
use super::lane::Lane;
use super::side::{Wide, WideHeld, hold_together};
use super::{LANES, Lanes, Pack};
use crate::contact::{Proposed, Solution, Stride};
use crate::events::Beginning;
use crate::fault::Fault;
use crate::mechanism::Moment;
use crate::method::{Context, Method, MoreauJean};
use crate::protocol::{Made, Rescue};
use crate::sim::Sim;
use crate::vector::Vector;

/// A lane of these steps.
type Strider<'a, M> = Lane<'a, M, MoreauJean<f64>>;

impl<M: Pack<S = f64>, L: Lanes> Batch<M, L, MoreauJean<f64>> {
    /// Runs all for the communication interval `dt`, in s; gives what [`Sim::step`] would give for each.
    ///
    /// Those that have rows of contact, and no condition on the time alone that changes within the interval, go together, whatever their
    /// times and the lengths of their steps; the others alone.
    pub fn step(&mut self, dt: f64) -> [Result<(), Fault>; LANES] {
        let clocks = self.sims.each_mut().map(|sim| {
            // One whose change cannot be is found as it was, and goes alone: it says so itself.
            let _ = sim.take_changes();
            sim.clock.after(sim.state.time(), dt)
        });
        let joins: [bool; LANES] = array::from_fn(|i| joins(&self.sims[i], clocks[i].time));
        let mut i = 0..LANES;
        let mut lanes = self.sims.each_mut().map(|sim| {
            let i = i.next().unwrap_or(0);
            Lane::new(sim, clocks[i].time, joins[i])
        });
        run::<M, L>(&mut lanes);
        let reached = lanes.map(|lane| (lane.context.time, lane.context.held, lane.context.x, lane.outcome));
        array::from_fn(|i| {
            let (sim, (time, held, x, outcome)) = (&mut self.sims[i], &reached[i]);
            if !joins[i] {
                return sim.step(dt);
            }
            sim.state.set(*time, held, x);
            if outcome.is_ok() {
                sim.clock = clocks[i];
            }
            *outcome
        })
    }
}

/// Does a simulation make its steps to `end` with the others?
fn joins<M: Pack<S = f64>>(sim: &Sim<M, MoreauJean<f64>>, end: f64) -> bool {
    let time = sim.state.time();
    let is_free = || {
        let instant = sim.state.mechanism().next_time_event(time, &sim.state.held());
        instant.is_none_or(|instant| instant > end)
    };
    M::CONTACTS > 0 && !sim.changed && end > time && end.is_finite() && is_free()
}

/// Runs all lanes to the ends of their intervals.
fn run<M: Pack<S = f64>, L: Lanes>(lanes: &mut [Strider<M>; LANES]) {
    for lane in lanes.iter_mut().filter(|lane| lane.runs) {
        if M::Rescue::holds(&lane.context) {
            lane.go_alone(Made::Step);
        }
    }
    let mut side = Side::<M, L>::new(lanes);
    while lanes.iter().any(|lane| lane.runs) {
        side.step(lanes);
    }
}

/// The lanes as one mechanism, with their discrete states.
struct Side<M: Pack<S = f64>, L: Lanes> {
    mechanism: M::Packed<L>,
    held: WideHeld<M, L>,
    x: Wide<M, L>,
    /// The charts of the lanes.
    places: [Option<usize>; LANES],
    /// Which lanes are in the chart of most.
    joined: [bool; LANES],
    /// Results of their steps.
    made: [Option<Result<Solution<f64>, Fault>>; LANES],
}

impl<M: Pack<S = f64>, L: Lanes> Side<M, L> {
    fn new(lanes: &[Strider<M>; LANES]) -> Self {
        let (systems, places) = (lanes.each_ref().map(|lane| lane.context.system), places(lanes));
        let (held, joined) = hold(lanes, &places);
        let x = Vector::from_fn(|k| L::of(lanes.each_ref().map(|lane| lane.context.x.at(k))));
        Self { mechanism: systems[0].pack(systems, L::of), held, x, places, joined, made: [None; LANES] }
    }

    /// A step of all lanes that run.
    fn step(&mut self, lanes: &mut [Strider<M>; LANES]) {
        let mut next = lanes.each_ref().map(|lane| lane.context.x);
        self.propose(lanes, &mut next);
        let mut have_changed = false;
        for (i, lane) in lanes.iter_mut().enumerate().filter(|(_, lane)| lane.runs) {
            let coasts = match &self.made[i] {
                Some(made) => lane.land(made, next[i]),
                None => lane.step_alone(),
            };
            have_changed |= !coasts;
        }
        self.x = Vector::from_fn(|k| L::of(lanes.each_ref().map(|lane| lane.context.x.at(k))));
        if have_changed {
            self.renew(lanes);
        }
    }

    /// Steps of the lanes in the chart of most, to their next discrete states and to the states `next`.
    fn propose(&mut self, lanes: &mut [Strider<M>; LANES], next: &mut [M::X; LANES]) {
        let strides = lanes.each_ref().map(|lane| lane.method.stride(lane.context.time));
        let number = |of: fn(&Stride<f64>) -> f64| L::of(strides.each_ref().map(of));
        let stride =
            Stride { t: number(|one| one.t), h: number(|one| one.h), theta: number(|one| one.theta) };
        let mut proposed = [const { None }; LANES];
        let all = proposed.iter_mut().zip(lanes).zip(next).zip(strides).zip(&mut self.made).zip(self.joined);
        for (((((proposed, lane), x), stride), made), joined) in all {
            *made = None;
            if lane.runs && joined {
                let (system, held) = (lane.context.system, &mut lane.context.held);
                *proposed = Some(Proposed { system, stride, held, x, made });
            }
        }
        M::packed_steps((&self.mechanism, &self.held), (&stride, &self.x), proposed, L::value);
    }

    /// Packs again the discrete states of lanes that have done more than to make a step.
    #[inline(never)]
    fn renew(&mut self, lanes: &[Strider<M>; LANES]) {
        let places = places(lanes);
        if places != self.places {
            (self.held, self.joined) = hold(lanes, &places);
            self.places = places;
            return;
        }
        for i in (0..LANES).filter(|i| self.joined[*i]) {
            M::put_held(&mut self.held, &lanes[i].context.held, |wide: &mut L, one| wide.put(i, one));
        }
    }
}

/// The charts in which lanes can make their steps with others; none where they cannot.
fn places<M: Pack<S = f64>>(lanes: &[Strider<M>; LANES]) -> [Option<usize>; LANES] {
    lanes.each_ref().map(|lane| M::chart(&lane.context.held).filter(|_| lane.runs))
}

fn hold<M: Pack<S = f64>, L: Lanes>(
    lanes: &[Strider<M>; LANES],
    places: &[Option<usize>; LANES],
) -> (WideHeld<M, L>, [bool; LANES]) {
    hold_together::<M, L>(array::from_fn(|i| (&lanes[i].context.held, places[i])))
}

impl<M: Pack<S = f64>> Strider<'_, M> {
    /// Goes on after a step to `next` that was made with the others; whether there was nothing else to do.
    fn land(&mut self, made: &Result<Solution<f64>, Fault>, next: M::X) -> bool {
        self.context.health = 1.0;
        let (time, x) = (self.context.time, self.context.x);
        let landed = self.method.land_with_rows(&mut self.context, made, next);
        if landed.is_ok() && self.has_nothing_to_do((time, &x)) {
            self.runs = self.context.time < self.context.end;
            return true;
        }
        // The discrete state where a step began is asked for with dense output alone.
        self.end(landed, Beginning { time, held: self.context.held, x });
        false
    }

    /// Makes a step by itself.
    fn step_alone(&mut self) -> bool {
        self.context.health = 1.0;
        let Context { time, held, x, .. } = self.context;
        let landed = Method::<M>::advance(self.method, &mut self.context);
        self.end(landed, Beginning { time, held, x });
        false
    }

    fn end(&mut self, landed: Result<(), Fault>, from: Beginning<M>) {
        self.conclude(landed.map(|()| from).map_err(|fault| (from, fault)));
        self.runs &= self.context.time < self.context.end;
    }
}
