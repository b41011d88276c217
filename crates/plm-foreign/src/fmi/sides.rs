//! Which conditions switch at an event that a solver outside has found.

use alloc::vec;

use plm_runtime::contact::Mode;
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Cause, Fault, System, Vector};

use super::Exchanged;
use super::late::{Motion, Place};

/// A solver finds events to rounding, before or after: what would switch within this time, times that of the run, switches now.
pub(super) const NEAR: f64 = 1e-10;

fn near(t: f64) -> f64 {
    NEAR * t.abs().max(1.0)
}

/// How long the motion may have gone on beyond a condition, s. A slip that was found to rounding may have turned by that; a gap was found
/// where its guard says.
fn step<M: Exchanged>(system: &M, (t, held): (f64, &M::U), (index, late): (usize, f64)) -> f64 {
    let status = M::contacts(held);
    let slips =
        |row: usize| system.guard_of_row(held, row) == index && status.mode(row).is_some_and(Mode::slips);
    match late > near(t) {
        true => 2.0 * late,
        false if (0..system.contact_count()).any(slips) => 2.0 * near(t),
        false => 0.0,
    }
}

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

    /// The state has moved on: a condition that is on its side again needs nothing more.
    pub(super) fn forget<M: Exchanged<G = G>>(&mut self, system: &M, t: f64, held: &M::U, x: &M::X) {
        let guards = beyond_band(system, t, held, x);
        self.0 = self.0.map2(&guards, |left_over, guard| if guard > 0.0 { 0.0 } else { left_over });
    }

    /// The event indicators of gaps that are open; 1 in the places of all others.
    pub(super) fn of_open_gaps<M: Exchanged<G = G>>(&self, system: &M, (t, x): &Place<M>, held: &M::U) -> G {
        let (mut open, indicators) = (G::fill(1.0), self.indicators(system, *t, held, x));
        for row in (0..system.contact_count()).filter(|row| M::contacts(held).mode(*row) == Some(Mode::Open))
        {
            let guard = system.guard_of_row(held, row);
            open.set(guard, indicators.at(guard));
        }
        open
    }

    /// How long ago the indicators that are negative were zero, s: about that, and zero where none is.
    pub(super) fn late<M: Exchanged<G = G>>(&self, motion: &Motion<M>, here: &Place<M>) -> f64 {
        let of = |(t, x): &Place<M>| self.indicators(motion.system, *t, motion.held, x);
        let indicators = of(here);
        if !(0..G::LEN).any(|index| indicators.at(index) < 0.0) {
            return 0.0;
        }
        let slopes = motion.slopes(here, of).unwrap_or(G::fill(0.0));
        let ago = |index: usize| {
            let (beyond, slope) = (indicators.at(index), slopes.at(index));
            // What comes back says nothing of when it has left.
            if slope < 0.0 { beyond / slope } else { near(here.0) }
        };
        let due = (0..G::LEN).filter(|index| indicators.at(*index) < 0.0);
        due.map(ago).fold(0.0, f64::max)
    }

    /// A place on the way to here at which the due conditions had not passed their zeros, if they have by more than rounding.
    pub(super) fn before<M: Exchanged<G = G>>(
        &self,
        motion: &Motion<M>,
        here: &Place<M>,
        (late, since): (f64, f64),
    ) -> Option<Place<M>> {
        let of = |(t, x): &Place<M>| self.indicators(motion.system, *t, motion.held, x);
        let due = of(here);
        let holds = |at: &Place<M>| {
            let indicators = of(at);
            (0..G::LEN).all(|index| due.at(index) >= 0.0 || indicators.at(index) >= 0.0)
        };
        if late > near(here.0) { motion.before(here, (late, since), holds) } else { None }
    }

    /// After a run, which has switched the due conditions: values beyond zero are rounding.
    pub(super) fn after<M: Exchanged<G = G>>(system: &M, (t, x): Place<M>, held: &M::U) -> Self {
        Self(beyond_band(system, t, held, &x).map(|guard| if guard < 0.0 { -2.0 * guard } else { 0.0 }))
    }

    /// Switches the due conditions, each once; `late` is about how long ago they were due, s.
    ///
    /// # Errors
    /// [`Cause::Required`]
    pub(super) fn switch<M: Exchanged<G = G>>(
        &mut self,
        system: &M,
        t: f64,
        (held, x): (&mut M::U, &mut M::X),
        late: f64,
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
            let step = step(system, (t, held), (index, late));
            system.switch_after(t, held, x, (index, step))?;
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
        let (now, near, mut rate) = (self.indicators(system, t, held, x), near(t), *x);
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
