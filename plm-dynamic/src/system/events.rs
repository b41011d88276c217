//! Events: guards of conditions and of rows of contact, kinks, known times.

use plm_compiler::lowered::End;
use plm_runtime::absolute::{self, Crossing};
use plm_runtime::charts::OfLoops;
use plm_runtime::contact::{self, Contacts};
use plm_runtime::{Cause, Enclosed, Events, Fault, Moment, Real, events};

use super::State;
use crate::capacity::KINKS;
use crate::code::with_room;
use crate::handle::{Beside, Dynamic, Frame, Held};
use crate::places::{Argument, Array};
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
    /// Gives `see` guards, then kinks, at a state.
    fn watch<T>(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], see: impl FnOnce(&[S]) -> T) -> T {
        let switches = &self.model.lowered.switches;
        with_room(switches.guards + switches.kinks, |all| {
            if all.is_empty() {
            } else if self.conditions_read_multipliers() {
                self.watch_holding(t, &self.loaded(t, u, x), x, all);
            } else {
                self.watch_holding(t, u, x, all);
            }
            see(all)
        })
    }

    /// The same where multipliers that conditions read are held.
    fn watch_holding(&self, t: S, u: &Held<S, NQ, L, H, R>, x: &[S; N], all: &mut [S]) {
        if self.model.lowered.switches.read_solution {
            let state = State::new(*self, *u, t, *x);
            let (a, lambda) = state.solved();
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

    /// Sets the sides of conditions on the time alone.
    pub(super) fn take_sides_at_time(&self, t: S, u: &mut Held<S, NQ, L, H, R>) {
        let guards = self.model.lowered.switches.guards;
        let before = *u;
        self.instants(&before, |at, slopes| {
            for ((side, at), slope) in u.switches.iter_mut().skip(guards).zip(at).zip(slopes) {
                *side = if (*at <= t) == (*slope > S::ZERO) { S::lit(1.0) } else { S::lit(-1.0) };
            }
        });
    }

    /// Guards of contact.
    fn contact_guards(&self) -> usize {
        self.model.contacts.as_ref().map_or(0, crate::contact::Contacts::guards)
    }

    /// The place of a guard of contact among all guards; none of a row that there is only room for.
    fn place_of_guard(&self, number: usize) -> Option<usize> {
        let (own, count) = (self.model.lowered.switches.guards, self.contact_guards());
        match number {
            _ if number == contact::PER_ROW * R => Some(own + count - 1),
            _ if number + 1 < count => Some(own + number),
            _ => None,
        }
    }

    /// The number of the guard of contact that stands in this place behind those of the conditions.
    fn number_of_guard(&self, place: usize) -> Option<usize> {
        let count = self.contact_guards();
        let last = (place + 1 == count).then_some(contact::PER_ROW * R);
        last.or_else(|| (place + 1 < count).then_some(place))
    }

    /// Rows that exist, where that is a question.
    fn existing(&self, u: &Held<S, NQ, L, H, R>) -> Option<[bool; R]> {
        self.model.contacts.as_ref()?.exist.as_ref()?;
        Some(core::array::from_fn(|row| self.exists(u, row)))
    }

    /// Looks at rows that have begun to exist.
    fn look_at_appearance(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        existed: Option<[bool; R]>,
    ) -> Result<(), Fault> {
        existed.map_or(Ok(()), |existed| contact::appear::<Self, R>(self, t, (u, x), existed))
    }

    /// Gives `see` the times at which conditions change, s, and the slopes of what they compare.
    pub(super) fn instants<T>(&self, u: &Held<S, NQ, L, H, R>, see: impl FnOnce(&[S], &[S]) -> T) -> T {
        let switches = &self.model.lowered.switches;
        let count = switches.all.len() - switches.guards;
        with_room(2 * count, |both| {
            let (at, slopes) = both.split_at_mut(count);
            if count > 0 {
                let frame = Frame { held: Some(u), ..Frame::at(S::ZERO) };
                self.run(&self.model.switches.instants, &frame, [&mut *at, &mut *slopes]);
            }
            see(at, slopes)
        })
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
> Events for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type G = [S; H];
    const KINKS: usize = KINKS;
    const SELECTIVE: bool = true;

    const CONTACTS: usize = R;
    const BENDS: bool = true;

    fn guard_count(&self) -> usize {
        self.model.lowered.switches.guards + self.contact_guards()
    }

    fn contact_count(&self) -> usize {
        self.model.contacts.as_ref().map_or(0, |contacts| contacts.lowered.rows.len())
    }

    fn guard_of_row(&self, _u: &Self::U, row: usize) -> usize {
        self.model.lowered.switches.guards + contact::PER_ROW * row
    }

    fn may_bend(&self) -> bool {
        let reactions = self.model.contacts.iter().flat_map(|contacts| &contacts.lowered.reactions);
        reactions.into_iter().any(|reaction| reaction.in_plane)
    }

    fn guards(&self, t: S, u: &Self::U, x: &[S; N], g: &mut [S; H]) {
        let own = self.model.lowered.switches.guards;
        *g = [S::lit(1.0); H];
        self.watch(t, u, x, |all| {
            for (guard, value) in g.iter_mut().zip(all).take(own) {
                *guard = *value;
            }
        });
        if self.has_contacts() {
            contact::guards::<Self, R>(self, t, u, x, &mut |index, guard| {
                if let Some(place) = self.place_of_guard(index) {
                    store(g, place, guard);
                }
            });
        }
    }

    fn kink_count(&self) -> usize {
        self.model.lowered.switches.kinks
    }

    fn kinks(&self, t: S, u: &Self::U, x: &[S; N], each: &mut impl FnMut(usize, S)) {
        let guards = self.model.lowered.switches.guards;
        self.watch(t, u, x, |all| {
            for (index, value) in all.iter().skip(guards).enumerate() {
                each(index, *value);
            }
        });
    }

    fn guards_within(
        &self,
        t: Enclosed<S>,
        u: &Self::U,
        x: &impl Fn(usize) -> Enclosed<S>,
        each: &mut impl FnMut(usize, Enclosed<S>),
    ) -> bool {
        let switches = &self.model.lowered.switches;
        let is_free = matches!(u.of_loops, OfLoops::Free { .. });
        if self.conditions_read_multipliers() || switches.read_solution || is_free {
            return false;
        }
        let watched = switches.guards + switches.kinks;
        if let Some(code) = self.guards_of_state(u).filter(|_| watched > 0) {
            let frame = Frame { held: Some(u), ..Frame::at(S::ZERO) };
            // Nothing but the state and the time moves.
            let argument = |argument: Argument| match argument {
                Argument::Time => t,
                Argument::Element(Array::X, place) => x(place),
                _ => Enclosed::constant(self.read(argument, &frame)),
            };
            with_room(watched, |all: &mut [Enclosed<S>]| {
                code.interpret(argument, &mut [&mut *all], |_, _| {});
                for (index, value) in all.iter().enumerate() {
                    let kink = index.checked_sub(switches.guards);
                    each(kink.map_or(index, |kink| H + kink), *value);
                }
            });
        }
        !self.has_contacts()
            || contact::guards_within::<Self, R>(self, t, u, x, &mut |index, guard| {
                if let Some(place) = self.place_of_guard(index) {
                    each(place, guard);
                }
            })
    }

    fn stay(
        &self,
        u: &Self::U,
        places: [(S, &[S; N]); 2],
        within: (Enclosed<S>, &impl Fn(usize) -> Enclosed<S>),
        end: &[S; H],
    ) -> bool {
        let switches = &self.model.lowered.switches;
        let end = |index: usize| {
            let place = self.place_of_guard(index).and_then(|place| end.get(place));
            place.copied().unwrap_or(S::lit(1.0))
        };
        let are_alone = self.has_contacts() && switches.guards + switches.kinks == 0;
        are_alone && contact::stay::<Self, R>(self, u, places, within, end)
    }

    fn switch(&self, t: S, u: &mut Self::U, x: &mut [S; N], index: usize) -> Result<(), Fault> {
        self.switch_behind(t, u, x, (index, S::ZERO))
    }

    fn switch_behind(
        &self,
        t: S,
        u: &mut Self::U,
        x: &mut [S; N],
        (index, step): (usize, S),
    ) -> Result<(), Fault> {
        if self.must_hold(index) {
            return Ok(());
        }
        self.followed(t, u, x, |u, x| {
            let existed = self.existing(u);
            let of_contact = index.checked_sub(self.model.lowered.switches.guards);
            if let (None, Some(side)) = (of_contact, u.switches.get_mut(index)) {
                *side = -*side;
            }
            self.look_at_appearance(t, u, x, existed)?;
            match of_contact.and_then(|index| self.number_of_guard(index)) {
                _ if !self.has_contacts() => {}
                Some(index) => {
                    contact::switch_behind::<Self, R>(self, t, u, x, (index, step))?;
                }
                None => {
                    contact::update_behind::<Self, R>(self, t, u, x, step)?;
                }
            }
            Ok(())
        })
    }

    fn must_hold(&self, index: usize) -> bool {
        self.model.lowered.switches.all.get(index).is_some_and(|switch| switch.must_hold)
    }

    fn end(&self, index: usize) -> Option<Cause> {
        let switches = &self.model.lowered.switches;
        match switches.all.get(index).filter(|_| index < switches.guards)?.end.as_ref()? {
            End::Pole(by) => Some(Cause::Pole { by }),
            End::Domain(of) => Some(Cause::Domain { of }),
        }
    }

    fn next_time_event(&self, t: S, u: &Self::U) -> Option<S> {
        self.instants(u, |at, _| at.iter().copied().filter(|at| *at > t).reduce(S::min))
    }

    fn switch_at_time(&self, t: S, u: &mut Self::U, x: &mut [S; N]) -> Result<(), Fault> {
        let switches = &self.model.lowered.switches;
        if switches.all.len() == switches.guards {
            return Ok(());
        }
        self.followed(t, u, x, |u, x| {
            let existed = self.existing(u);
            self.take_sides_at_time(t, u);
            self.look_at_appearance(t, u, x, existed)?;
            if self.has_contacts() {
                contact::update::<Self, R>(self, t, u, x)?;
            }
            Ok(())
        })
    }

    fn state_was_set(&self, t: S, u: &mut Self::U, x: &mut [S; N]) -> Result<(), Fault> {
        if self.has_contacts() { contact::state_was_set::<Self, R>(self, t, u, x) } else { Ok(()) }
    }

    fn contacts(u: &Self::U) -> contact::Status<'_> {
        u.contact.status()
    }

    fn change_contact(u: &mut Self::U, change: contact::Change) {
        u.contact.modes.change = change;
    }

    fn stride<const EVALUATIONS: usize>(
        &self,
        stride: &contact::Stride<S>,
        u: &mut Self::U,
        x: &mut [S; N],
        behind: impl FnOnce(&mut Self::U, &mut [S; N], &contact::Solution<S>) -> Result<(), Fault>,
    ) -> Result<contact::Solution<S>, Fault> {
        contact::step::<Self, R, EVALUATIONS>(self, stride, u, x, behind)
    }

    fn matters(&self, u: &Self::U, index: usize, unknown: u64) -> bool {
        let switches = &self.model.lowered.switches;
        let number = match index.checked_sub(H) {
            Some(kink) if kink < switches.kinks => switches.guards + kink,
            None if index < switches.guards => index,
            None if index < self.guard_count() => return true,
            _ => return false,
        };
        if switches.roots.is_empty() {
            return true;
        }
        let root = switches.roots.get(number).copied().unwrap_or(1);
        events::holds(&switches.nodes, root, &u.switches, unknown)
    }

    fn jump(&self, t: S, u: &Self::U, x: &[S; N], after: Option<&Self::U>) -> Option<Fault> {
        let jumps = &self.model.lowered.switches.jumps;
        if jumps.is_empty() {
            return None;
        }
        let (q, v) = State::new(*self, *u, t, *x).pose();
        let mut terms = vec![S::ZERO; 5 * jumps.len()];
        let frame = Frame { held: Some(u), x, ..Frame::of_pose(t, &q, &v) };
        self.run(&self.model.switches.terms, &frame, [&mut terms]);
        let crossings = jumps.iter().zip(terms.as_chunks::<5>().0).filter_map(|(jump, &terms)| {
            let side = |u: &Self::U| u.switches.get(jump.switch).copied();
            let changes = after.is_some_and(|after| side(after) != side(u));
            (changes || after.is_none()).then_some(Crossing { row: jump.row, terms, changes })
        });
        absolute::jump::<S, Self, NQ, NC>(self, t, (&q, &v), crossings)
    }
}
