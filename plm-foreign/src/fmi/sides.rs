//! Which conditions switch at an event that a solver outside has found.

use alloc::vec;

use plm_runtime::words::{InWords, Words};
use plm_runtime::{Cause, Fault, System, Vector};

use super::Exchanged;

/// A solver finds events to rounding, before or after: what would switch within this time, times that of the run, switches now.
const NEAR: f64 = 1e-10;

/// How far conditions are beyond where they switch, because they were switched a little before.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeftOver<G>(G);

impl<G: Vector<f64>> LeftOver<G> {
    pub(super) fn none() -> Self {
        Self(G::fill(0.0))
    }

    /// The event indicators: guards beyond their bands.
    pub(super) fn indicators<M: Exchanged<G = G>>(&self, system: &M, t: f64, held: &M::U, x: &M::X) -> G {
        let guards = beyond_band(system, t, held, x);
        guards.map2(&self.0, |guard, left_over| guard + left_over)
    }

    /// The state has moved on: what is on its side again needs nothing more.
    pub(super) fn forget<M: Exchanged<G = G>>(&mut self, system: &M, t: f64, held: &M::U, x: &M::X) {
        let guards = beyond_band(system, t, held, x);
        self.0 = self.0.map2(&guards, |left_over, guard| if guard > 0.0 { 0.0 } else { left_over });
    }

    /// Switches what is due, each condition once.
    ///
    /// # Errors
    /// [`Cause::Required`]
    pub(super) fn switch<M: Exchanged<G = G>>(
        &mut self,
        system: &M,
        t: f64,
        held: &mut M::U,
        x: &mut M::X,
    ) -> Result<(), Fault> {
        let mut switched = vec![false; G::LEN];
        // A condition may switch another one.
        for _ in 0..=G::LEN {
            let due = self.due(system, t, held, x);
            let next = switched.iter().enumerate().find(|(index, done)| !**done && due.at(*index) < 0.0);
            let Some(index) = next.map(|(index, _)| index) else { break };
            let beside = self.indicators(system, t, held, x).at(index).abs();
            if system.must_hold(index) {
                return Err(Fault::of_part(t, system.guard_name(index), Cause::Required));
            }
            system.switch(t, held, x, index)?;
            if let Some(done) = switched.get_mut(index) {
                *done = true;
            }
            let guard = beyond_band(system, t, held, x).at(index);
            // The indicator is as far on its side as it was from its zero. A gap that bounces keeps its guard: with more than that, a
            // floor would sink from bounce to bounce.
            self.0.set(index, if guard <= 0.0 { beside - guard } else { 0.0 });
        }
        Ok(())
    }

    /// The indicators now, or in a moment where they are less then.
    fn due<M: Exchanged<G = G>>(&self, system: &M, t: f64, held: &M::U, x: &M::X) -> G {
        let (now, near, mut rate) = (self.indicators(system, t, held, x), NEAR * t.abs().max(1.0), *x);
        if !system.rate(t, held, x, &mut rate).is_good() {
            return now;
        }
        let ahead = x.map2(&rate, |x, rate| x + near * rate);
        let soon = self.indicators(system, t + near, held, &ahead);
        now.map2(&soon, f64::min)
    }
}

impl<G: Vector<f64>> InWords for LeftOver<G> {
    fn each(&mut self, words: &mut impl Words) {
        words.vector(&mut self.0);
    }
}

fn beyond_band<M: System<S = f64>>(system: &M, t: f64, held: &M::U, x: &M::X) -> M::G {
    let mut guards = M::G::fill(0.0);
    system.guards(t, held, x, &mut guards);
    M::G::from_fn(|index| guards.at(index) + system.band(index))
}
