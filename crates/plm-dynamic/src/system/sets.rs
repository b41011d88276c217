//! Events that set states.

use plm_compiler::lowered::Set;
use plm_runtime::contact::{self, Contacts};
use plm_runtime::{Fault, Moment, Real, events};

use super::State;
use crate::capacity::EVENTS;
use crate::code::Code;
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
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// Do events that follow conditions set states?
    pub(super) fn sets_states(&self) -> bool {
        !self.model.lowered.sets.events.is_empty()
    }

    /// Sets what events set as a run begins, each by the state that the one before has left.
    pub(super) fn set_at_start(
        &self,
        t: S,
        u: &mut Held<S, NQ, L, H, R>,
        x: &mut [S; N],
    ) -> Result<(), Fault> {
        let (sets, code) = (&self.model.lowered.sets, &self.model.sets);
        (0..sets.at_start.len())
            .try_for_each(|index| self.set_of((&sets.at_start, &code.values_at_start), t, u, x, index))
    }

    /// Sets what one of these events sets, by the routine of the values of all of them.
    fn set_of(
        &self,
        (events, values): (&[Vec<Set>], &'static Code),
        t: S,
        u: &mut Held<S, NQ, L, H, R>,
        x: &mut [S; N],
        index: usize,
    ) -> Result<(), Fault> {
        let (q, v) = State::new(*self, *u, t, *x).pose();
        let mut set = vec![S::ZERO; events.iter().map(Vec::len).sum()];
        self.run(values, &Frame { held: Some(u), x, ..Frame::of_pose(t, &q, &v) }, [&mut set]);
        let begins: usize = events.iter().take(index).map(Vec::len).sum();
        let Some(targets) = events.get(index) else { return Ok(()) };
        let mut velocities = Vec::new();
        for (target, value) in targets.iter().zip(set.into_iter().skip(begins)) {
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
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> events::Sets<EVENTS> for Dynamic<S, NQ, NC, N, L, H, R, P>
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

    fn set(&self, t: S, u: &mut Held<S, NQ, L, H, R>, x: &mut [S; N], index: usize) -> Result<(), Fault> {
        self.set_of((&self.model.lowered.sets.events, &self.model.sets.values), t, u, x, index)
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
