//! `Switched`: tables and routines of conditions and contact.

use plm_compiler::lowered::End;
use plm_runtime::charts::OfLoops;
use plm_runtime::switched::{self, WithContact};
use plm_runtime::{Cause, Common, Enclosed, Fault, Moment, Real, Switched, Switches, contact, events};

use super::State;
use crate::capacity::{EVENTS, KINKS};
use crate::code::Zeros;
use crate::handle::{Beside, Dynamic, Frame, Held};
use crate::places::{Argument, Array};

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
    /// Writes guards, then kinks, with the multipliers that conditions read taken from the discrete state.
    fn watch_holding(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], all: &mut [S]) {
        if self.model.lowered.switches.read_solution {
            let state = State::new(*self, *u, t, *x);
            let (a, lambda) = state.solved(&Common::new());
            let full = state.absolute();
            let in_chart = matches!(u.of_loops, OfLoops::InChart { .. });
            let code = self.model.in_charts.first().filter(|_| in_chart).map(|chart| &chart.guards);
            let x: &[S] = if code.is_some() { x } else { &full };
            let beside = Beside { a: &a, lambda: &lambda, ..Beside::NONE };
            let frame = Frame { beside: Some(&beside), ..Frame::of_state(t, u, x) };
            self.run(code.unwrap_or(&self.model.absolute.guards), &frame, [all]);
            return;
        }
        let Some(code) = self.guards_of_state(u) else { return all.fill(S::lit(1.0)) };
        if matches!(u.of_loops, OfLoops::Free { .. }) {
            let full = State::new(*self, *u, t, *x).absolute();
            self.run(code, &Frame::of_state(t, u, &full), [all]);
        } else {
            self.run(code, &Frame::of_state(t, u, x), [all]);
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
    const P: usize,
> Switched for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type Guards = [S; H];
    type Contact = WithContact<R>;
    const SWITCHES: Switches =
        Switches { kinks: KINKS, selective: true, rows: R, bends: true, ..Switches::NONE };

    fn switches(&self) -> &'static Switches {
        &self.model.switches.table
    }

    fn watch<T>(&self, t: S, u: &Self::U, x: &[S; N], see: impl FnOnce(&[S]) -> T) -> T {
        let switches = self.switches();
        let mut room = Zeros::new();
        let all = room.of(switches.guards + switches.kinks);
        if all.is_empty() {
        } else if self.conditions_read_multipliers() {
            self.watch_holding(t, &self.loaded(t, u, x), x, all);
        } else {
            self.watch_holding(t, u, x, all);
        }
        see(all)
    }

    fn watch_within(
        &self,
        t: Enclosed<S>,
        u: &Self::U,
        x: &impl Fn(usize) -> Enclosed<S>,
        each: &mut impl FnMut(usize, Enclosed<S>),
    ) -> bool {
        let switches = self.switches();
        let is_free = matches!(u.of_loops, OfLoops::Free { .. });
        if self.conditions_read_multipliers() || self.model.lowered.switches.read_solution || is_free {
            return false;
        }
        let watched = switches.guards + switches.kinks;
        let Some(code) = self.guards_of_state(u).filter(|_| watched > 0) else { return true };
        let frame = Frame { held: Some(u), ..Frame::at(S::ZERO) };
        // Nothing but the state and the time moves.
        let argument = |argument: Argument| match argument {
            Argument::Time => t,
            Argument::Element(Array::X, place) => x(place),
            _ => Enclosed::constant(self.read(argument, &frame)),
        };
        let mut room = Zeros::<Enclosed<S>>::new();
        let all = room.of(watched);
        code.interpret(&argument, &mut [&mut *all], &mut |_, _| {});
        for (number, value) in all.iter().enumerate() {
            each(number, *value);
        }
        true
    }

    fn known_times<T>(&self, u: &Self::U, see: impl FnOnce(&[S], &[S]) -> T) -> T {
        let count = self.switches().times;
        let mut room = Zeros::new();
        let (at, slopes) = room.of(2 * count).split_at_mut(count);
        if count > 0 {
            let frame = Frame { held: Some(u), ..Frame::at(S::ZERO) };
            self.run(&self.model.switches.instants, &frame, [&mut *at, &mut *slopes]);
        }
        see(at, slopes)
    }

    fn change(
        &self,
        t: S,
        u: &mut Self::U,
        x: &mut [S; N],
        changes: impl FnOnce(&mut Self::U, &mut [S; N]) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        if self.sets_states() {
            events::change::<Self, EVENTS>(self, t, u, x, changes)
        } else {
            changes(u, x)
        }
    }

    fn jump_of_rows(&self, t: S, u: &Self::U, x: &[S; N], after: Option<&Self::U>) -> Option<Fault> {
        let jumps = self.switches().jumps;
        if jumps.is_empty() {
            return None;
        }
        let (q, v) = State::new(*self, *u, t, *x).pose();
        let mut terms = vec![S::ZERO; 5 * jumps.len()];
        let frame = Frame { held: Some(u), x, ..Frame::of_pose(t, &q, &v) };
        self.run(&self.model.switches.terms, &frame, [&mut terms]);
        switched::jump::<Self, NQ, NC>(self, t, (&q, &v), (u, after), &terms)
    }

    fn is_required(&self, index: usize) -> bool {
        self.model.lowered.switches.all.get(index).is_some_and(|switch| switch.must_hold)
    }

    fn end_at(&self, index: usize) -> Option<Cause> {
        let switches = &self.model.lowered.switches;
        match switches.all.get(index).filter(|_| index < switches.guards)?.end.as_ref()? {
            End::Pole(by) => Some(Cause::Pole { by }),
            End::Domain(of) => Some(Cause::Domain { of }),
        }
    }

    fn has_contact(&self) -> bool {
        self.has_contacts()
    }

    fn may_appear(&self) -> bool {
        self.model.contacts.as_ref().is_some_and(|contacts| contacts.exist.is_some())
    }

    fn place_of_guard(&self, number: usize) -> Option<usize> {
        let &Switches { guards: own, contact_guards: count, .. } = self.switches();
        match number {
            _ if number == contact::PER_ROW * R => Some(own + count - 1),
            _ if number + 1 < count => Some(own + number),
            _ => None,
        }
    }

    fn number_of_guard(&self, place: usize) -> Option<usize> {
        let count = self.switches().contact_guards;
        let last = (place + 1 == count).then_some(contact::PER_ROW * R);
        last.or_else(|| (place + 1 < count).then_some(place))
    }
}
