//! Eight lanes as one mechanism in one state.

use super::lane::{Fixed, set_column};
use super::{LANES, Lanes, Pack};
use crate::method::{Formula, Partition, coarseness, looked_at};
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// Eight states as one.
pub(super) type Wide<M, L> = <<M as Pack>::Packed<L> as Rate>::X;
/// Discrete state of eight lanes, as one.
pub(super) type WideHeld<M, L> = <<M as Pack>::Packed<L> as Rate>::U;

/// The lanes as one mechanism in one state.
pub(super) struct Side<M: Pack<S = f64>, L: Lanes> {
    mechanism: M::Packed<L>,
    held: WideHeld<M, L>,
    pub(super) x: Wide<M, L>,
    /// Typical sizes of the numbers of a state.
    typical: Wide<M, L>,
    /// Which lanes are computed: those in the chart of most.
    pub(super) joined: [bool; LANES],
    /// 1 in those of them that make steps without a look where none is due, 0 elsewhere.
    coasting: L,
    /// 1 in the lanes that have not stopped, 0 elsewhere.
    pub(super) running: L,
    /// True if lanes were checked together, and their own discrete states do not have the result yet.
    looked: bool,
}

impl<M: Pack<S = f64>, L: Lanes> Side<M, L> {
    pub(super) fn new<F: Formula>(lanes: &[Fixed<M, F>; LANES]) -> Self {
        let systems = lanes.each_ref().map(|lane| lane.context.system);
        let typical = systems.map(Rate::typical);
        let (held, joined) = hold(lanes);
        let mut side = Self {
            mechanism: systems[0].pack(systems, L::of),
            held,
            x: Vector::from_fn(|k| L::of(lanes.each_ref().map(|lane| lane.context.x.at(k)))),
            typical: Vector::from_fn(|k| L::of(typical.map(|one| one.at(k)))),
            joined,
            coasting: L::lit(0.0),
            running: L::lit(0.0),
            looked: false,
        };
        side.count(lanes);
        side
    }

    /// The states after a step of all lanes, its health in each, and in which it is so short that its error needs no estimate:
    /// in the others the health is zero.
    #[inline]
    pub(super) fn step<F: Formula>(
        &self,
        (time, partition, _): (f64, &Partition<f64>, u64),
    ) -> (Wide<M, L>, L) {
        let (mut next, zero, h) = (self.x, L::lit(0.0), L::lit(partition.h));
        let all = (&self.mechanism, &self.held);
        let (health, coarseness) = looked_at::<F, _, _>(all, (L::lit(time), h), &mut next, |next, stages| {
            coarseness::<F, M::Packed<L>>(&self.typical, h, [&self.x, next], stages)
        });
        (next, L::select(zero.lt(coarseness), zero, health.0))
    }

    /// Checks the states after a step if that is due: 1 in the lanes that go on from them as they are, 0 where more is to be done.
    #[inline]
    pub(super) fn coast(&mut self, time: f64, next: &Wide<M, L>, health: L) -> L {
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let short = M::are_short(&self.typical, &self.held, [&self.x, next]) * self.coasting;
        let fits = L::select(L::lit(f64::HEALTHY).lt(health), short, zero);
        // Zero times a value that is not finite is NaN.
        let sum = next.fold(zero, |sum, number| number.mul_add(zero, sum));
        let fits = L::select(sum.lt(one), fits, zero);
        let calm = fits * M::are_calm(&self.typical, L::lit(time), &self.held, next);
        if !L::any(calm.lt(fits)) {
            return calm;
        }
        self.looked = true;
        calm + M::look(&self.mechanism, L::lit(time), &mut self.held, next, fits - calm)
    }

    /// Copies continuation data to the discrete states of the lanes.
    #[inline]
    pub(super) fn tell<F: Formula>(&mut self, lanes: &mut [Fixed<M, F>; LANES]) {
        if !self.looked {
            return;
        }
        for (i, lane) in lanes.iter_mut().enumerate().filter(|&(i, _)| self.joined[i]) {
            M::take_held(&mut lane.context.held, &self.held, |wide: L| wide.values()[i]);
        }
        self.looked = false;
    }

    /// A lane has made a step by itself to the state `next`; it was at a place before.
    pub(super) fn renew<F: Formula>(
        &mut self,
        next: &mut Wide<M, L>,
        (i, before): (usize, Option<usize>),
        lanes: &[Fixed<M, F>; LANES],
    ) {
        let (lane, joined) = (&lanes[i % LANES], self.joined[i % LANES]);
        set_column(next, i, &lane.context.x);
        if lane.place() != before || !lane.runs {
            (self.held, self.joined) = hold(lanes);
            self.count(lanes);
        } else if joined {
            M::put_held(&mut self.held, &lane.context.held, |wide: &mut L, one| wide.put(i, one));
        }
    }

    /// Counts which lanes go with the others, and which run.
    fn count<F: Formula>(&mut self, lanes: &[Fixed<M, F>; LANES]) {
        let number = |is: bool| if is { 1.0 } else { 0.0 };
        let mut joined = self.joined.into_iter();
        let coasts = |lane: &Fixed<M, F>| number(joined.next() == Some(true) && lane.coasts());
        self.coasting = L::of(lanes.each_ref().map(coasts));
        self.running = L::of(lanes.each_ref().map(|lane| number(lane.runs)));
    }
}

/// Packs the discrete states of the lanes into one, in the chart of most, with which lanes are in that chart.
fn hold<M: Pack<S = f64>, L: Lanes, F: Formula>(
    lanes: &[Fixed<M, F>; LANES],
) -> (WideHeld<M, L>, [bool; LANES]) {
    hold_together::<M, L>(lanes.each_ref().map(|lane| (&lane.context.held, lane.place())))
}

/// Packs discrete states, each in the chart that it can share, into one in the chart of most, with which lanes are in that chart.
pub(super) fn hold_together<M: Pack<S = f64>, L: Lanes>(
    lanes: [(&M::U, Option<usize>); LANES],
) -> (WideHeld<M, L>, [bool; LANES]) {
    let joins = |place: Option<usize>, first: &M::U| place.is_some() && place == M::chart(first);
    let joined_by = |first: &M::U| lanes.iter().filter(|(_, place)| joins(*place, first)).count();
    let (first, _) = lanes.iter().max_by_key(|(held, _)| joined_by(held)).unwrap_or(&lanes[0]);
    (M::pack_held(first, lanes.map(|lane| lane.0), L::of), lanes.map(|(_, place)| joins(place, first)))
}
