//! [`Events`] of every [`Switched`] mechanism.

use super::{ContactPart, Switched};
use crate::absolute::{self, Absolute, Crossing};
use crate::contact;
use crate::enclosure::Enclosed;
use crate::events::holds;
use crate::fault::{Cause, Fault};
use crate::held::Sides;
use crate::scalar::Scalar;
use crate::system::Events;
use crate::vector::Vector;

impl<M: Switched> Events for M {
    type G = M::Guards;
    const KINKS: usize = M::SWITCHES.kinks;
    const SELECTIVE: bool = M::SWITCHES.selective;
    const CONTACTS: usize = M::SWITCHES.rows;
    const BENDS: bool = M::SWITCHES.bends;

    #[inline]
    fn guard_count(&self) -> usize {
        let table = self.switches();
        table.guards + table.contact_guards
    }

    #[inline]
    fn kink_count(&self) -> usize {
        self.switches().kinks
    }

    #[inline]
    fn contact_count(&self) -> usize {
        self.switches().rows
    }

    #[inline]
    fn guard_of_row(&self, _u: &M::U, row: usize) -> usize {
        self.switches().guards + contact::PER_ROW * row
    }

    #[inline]
    fn may_bend(&self) -> bool {
        self.switches().bends
    }

    fn guards(&self, t: M::S, u: &M::U, x: &M::X, g: &mut M::Guards) {
        let own = self.switches().guards;
        if self.guard_count() < M::Guards::LEN {
            g.as_mut().fill(M::S::lit(1.0));
        }
        self.watch(t, u, x, |all| {
            for (guard, value) in g.as_mut().iter_mut().zip(all).take(own) {
                *guard = *value;
            }
        });
        M::Contact::guards(self, t, u, x, &mut |number, guard| {
            let place = self.place_of_guard(number);
            if let Some(place) = place.and_then(|place| g.as_mut().get_mut(place)) {
                *place = guard;
            }
        });
    }

    fn kinks(&self, t: M::S, u: &M::U, x: &M::X, each: &mut impl FnMut(usize, M::S)) {
        let guards = self.switches().guards;
        self.watch(t, u, x, |all| {
            for (index, value) in all.iter().skip(guards).enumerate() {
                each(index, *value);
            }
        });
    }

    fn guards_within(
        &self,
        t: Enclosed<M::S>,
        u: &M::U,
        x: &impl Fn(usize) -> Enclosed<M::S>,
        each: &mut impl FnMut(usize, Enclosed<M::S>),
    ) -> bool {
        let own = self.switches().guards;
        let known = self.watch_within(t, u, x, &mut |number, value| {
            each(number.checked_sub(own).map_or(number, |kink| M::Guards::LEN + kink), value);
        });
        known
            && M::Contact::guards_within(self, t, u, x, &mut |number, guard| {
                if let Some(place) = self.place_of_guard(number) {
                    each(place, guard);
                }
            })
    }

    fn stay(
        &self,
        u: &M::U,
        places: [(M::S, &M::X); 2],
        within: (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
        end: &M::Guards,
    ) -> bool {
        let table = self.switches();
        let end = |number: usize| {
            let place = self.place_of_guard(number).and_then(|place| end.as_ref().get(place));
            place.copied().unwrap_or(M::S::lit(1.0))
        };
        table.guards + table.kinks == 0 && M::Contact::stay(self, u, places, within, end)
    }

    fn switch(&self, t: M::S, u: &mut M::U, x: &mut M::X, index: usize) -> Result<(), Fault> {
        self.switch_after(t, u, x, (index, M::S::ZERO))
    }

    fn switch_after(
        &self,
        t: M::S,
        u: &mut M::U,
        x: &mut M::X,
        (index, step): (usize, M::S),
    ) -> Result<(), Fault> {
        if self.must_hold(index) {
            return Ok(());
        }
        let of_contact = index.checked_sub(self.switches().guards);
        self.change(t, u, x, |u, x| {
            M::Contact::change_sides(self, t, (u, x), |u| {
                if let (None, Some(side)) = (of_contact, u.sides_mut().get_mut(index)) {
                    *side = -*side;
                }
            })?;
            match of_contact.and_then(|place| self.number_of_guard(place)) {
                Some(number) => M::Contact::switch_after(self, t, (u, x), (number, step)),
                None => M::Contact::update_after(self, t, (u, x), step),
            }
        })
    }

    #[inline]
    fn must_hold(&self, index: usize) -> bool {
        self.is_required(index)
    }

    #[inline]
    fn end(&self, index: usize) -> Option<Cause> {
        self.end_at(index)
    }

    #[inline]
    fn next_time_event(&self, t: M::S, u: &M::U) -> Option<M::S> {
        self.known_times(u, |at, _| at.iter().copied().filter(|at| *at > t).reduce(M::S::min))
    }

    fn instant_name(&self, t: M::S, u: &M::U) -> &'static str {
        self.known_times(u, |at, _| {
            let distances = self.labels().instants.iter().zip(at).map(|(name, at)| (*name, (*at - t).abs()));
            let nearest = distances.reduce(|nearest, next| if next.1 < nearest.1 { next } else { nearest });
            nearest.map_or("", |(name, _)| name)
        })
    }

    fn switch_at_time(&self, t: M::S, u: &mut M::U, x: &mut M::X) -> Result<(), Fault> {
        if self.switches().times == 0 {
            return Ok(());
        }
        self.change(t, u, x, |u, x| {
            M::Contact::change_sides(self, t, (u, x), |u| take_sides_at_time(self, t, u))?;
            M::Contact::update_after(self, t, (u, x), M::S::ZERO)
        })
    }

    fn matters(&self, u: &M::U, index: usize, unknown: u64) -> bool {
        let table = self.switches();
        let number = match index.checked_sub(M::Guards::LEN) {
            Some(kink) if kink < table.kinks => table.guards + kink,
            None if index < table.guards => index,
            None => return index < self.guard_count(),
            Some(_) => return false,
        };
        let root = table.roots.get(number).copied().unwrap_or(1);
        !table.selective || holds(table.nodes, root, u.sides(), unknown)
    }

    #[inline]
    fn contacts(u: &M::U) -> contact::Status<'_> {
        M::Contact::status(u)
    }

    #[inline]
    fn change_contact(u: &mut M::U, change: contact::Change) {
        M::Contact::set_change(u, change);
    }

    fn stride<const EVALUATIONS: usize>(
        &self,
        stride: &contact::Stride<M::S>,
        u: &mut M::U,
        x: &mut M::X,
        after: impl FnOnce(&mut M::U, &mut M::X, &contact::Solution<M::S>) -> Result<(), Fault>,
    ) -> Result<contact::Solution<M::S>, Fault> {
        M::Contact::stride::<EVALUATIONS>(self, stride, (u, x), after)
    }

    #[inline]
    fn state_was_set(&self, t: M::S, u: &mut M::U, x: &mut M::X) -> Result<(), Fault> {
        M::Contact::state_was_set(self, t, (u, x))
    }

    #[inline]
    fn jump(&self, t: M::S, u: &M::U, x: &M::X, after: Option<&M::U>) -> Option<Fault> {
        self.jump_of_rows(t, u, x, after)
    }
}

/// Sets the sides of conditions on the time alone.
#[inline]
pub fn take_sides_at_time<M: Switched>(system: &M, t: M::S, u: &mut M::U) {
    let guards = system.switches().guards;
    let before = *u;
    system.known_times(&before, |at, slopes| {
        for ((side, at), slope) in u.sides_mut().iter_mut().skip(guards).zip(at).zip(slopes) {
            *side = M::S::lit(if (*at <= t) == (*slope > M::S::ZERO) { 1.0 } else { -1.0 });
        }
    });
}

/// Jump of rows of constraints that differ between the sides of their conditions. `terms` has five numbers for each: the
/// differences of phi, of its rate and of the rate of that; the distance from the boundary, and its rate.
pub fn jump<M, const NQ: usize, const NC: usize>(
    system: &M,
    t: M::S,
    (q, v): (&[M::S; NQ], &[M::S; NQ]),
    (u, after): (&M::U, Option<&M::U>),
    terms: &[M::S],
) -> Option<Fault>
where
    M: Switched + Absolute<M::S, NQ, NC>,
{
    let crossings = system.switches().jumps.iter().zip(terms.as_chunks::<5>().0);
    let crossings = crossings.filter_map(|(&(row, condition), &terms)| {
        let side = |u: &M::U| u.sides().get(condition).copied();
        let changes = after.is_some_and(|after| side(after) != side(u));
        (changes || after.is_none()).then_some(Crossing { row, terms, changes })
    });
    absolute::jump::<M::S, M, NQ, NC>(system, t, (q, v), crossings)
}
