//! Events that set states.

use plm_compiler::lowered::Set;
use plm_runtime::contact::{self, Contacts};
use plm_runtime::{Fault, Moment, Real, events};

use super::State;
use crate::capacity::EVENTS;
use crate::handle::{Dynamic, Frame, Held};
use crate::system::contact::store;

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
> Dynamic<S, NQ, NC, N, L, H, R>
{
    /// Do events set states?
    pub(super) fn sets_states(&self) -> bool {
        !self.model.lowered.sets.events.is_empty()
    }

    /// Changes of sides or modes; events that set states follow.
    pub(super) fn followed(
        &self,
        t: S,
        u: &mut Held<S, NQ, L, H, R>,
        x: &mut [S; N],
        changes: impl FnOnce(&mut Held<S, NQ, L, H, R>, &mut [S; N]) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        if self.sets_states() {
            events::change::<Self, EVENTS>(self, t, u, x, changes)
        } else {
            changes(u, x)
        }
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
> events::Sets<EVENTS> for Dynamic<S, NQ, NC, N, L, H, R>
{
    const CONDITIONS: usize = H;

    fn condition_count(&self) -> usize {
        self.model.lowered.switches.guards
    }

    fn sides(u: &mut Held<S, NQ, L, H, R>) -> &mut [S] {
        &mut u.switches
    }

    fn holds(&self, u: &Held<S, NQ, L, H, R>) -> [bool; EVENTS] {
        let mut holds = [S::ZERO; EVENTS];
        self.run(&self.model.sets.holds, &Frame { held: Some(u), ..Frame::at(S::ZERO) }, [&mut holds]);
        holds.map(|holds| holds > S::lit(0.5))
    }

    fn is_at_start(&self, index: usize) -> bool {
        self.model.lowered.sets.at_start.contains(&index)
    }

    fn set(&self, t: S, u: &mut Held<S, NQ, L, H, R>, x: &mut [S; N], index: usize) -> Result<(), Fault> {
        let (q, v) = State::new(*self, *u, t, *x).pose();
        let sets = &self.model.lowered.sets;
        let mut values = vec![S::ZERO; sets.count()];
        let frame = Frame { held: Some(u), x, ..Frame::of_pose(t, &q, &v) };
        self.run(&self.model.sets.values, &frame, [&mut values]);
        let begins: usize = sets.events.iter().take(index).map(Vec::len).sum();
        let Some(targets) = sets.events.get(index) else { return Ok(()) };
        let mut velocities = Vec::new();
        for (target, value) in targets.iter().zip(values.into_iter().skip(begins)) {
            match *target {
                Set::State(state) => store(x, 2 * NQ + state, value),
                Set::Velocity(velocity) => velocities.push((velocity, value)),
            }
        }
        if velocities.is_empty() {
            return Ok(());
        }
        let v = events::with_velocities::<S, Self, NQ, NC>(self, t, (&q, &v), &velocities)?;
        self.enter(t, u, (&q, &v), x);
        Ok(())
    }

    fn settle(
        &self,
        t: S,
        before: &Held<S, NQ, L, H, R>,
        u: &mut Held<S, NQ, L, H, R>,
        x: &mut [S; N],
    ) -> Result<(), Fault> {
        let Some(contacts) = &self.model.contacts else { return Ok(()) };
        let rows = &contacts.lowered.rows;
        if contacts.exist.is_some() || rows.iter().any(|row| row.moved_by_states) {
            let stays = |row: usize| rows.get(row).is_none_or(|row| !row.moved_by_states);
            let existed = core::array::from_fn(|row| stays(row) && self.exists(before, row));
            contact::appear::<Self, R>(self, t, (u, x), existed)?;
        }
        contact::update::<Self, R>(self, t, u, x)?;
        Ok(())
    }
}
