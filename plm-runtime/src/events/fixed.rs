//! Guards over fixed steps: the time within one at which contact changes; other events do not end a step, and conditions that come and go
//! within one are counted as missed.

use super::marks::Marks;
use super::relevant::Relevant;
use super::root::{Point, root};
use super::search::{Found, Search};
use super::{Beginning, History};
use super::{Detector, Event, guards_here};
use crate::contact::{Change, Mode, guard_count};
use crate::fault::Fault;
use crate::method::{Context, Method, Path};
use crate::scalar::Real;
use crate::system::{Step, System};
use crate::vector::Vector;

/// Error of the time at which a row changes its mode, as a fraction of a step.
const CHANGING: f64 = 1e-9;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// True if a fixed step stays in the known guard-free region.
    #[inline]
    pub(crate) fn excludes_events<M: System<S = S, G = G>>(
        &self,
        history: &History<M>,
        step: &Step<'_, M>,
    ) -> bool {
        step.system.guard_count() == 0
            || history.beginning.as_ref().is_some_and(|centre| self.guard_free.holds(centre, step))
    }

    /// True if no guard can leave its side in steps of a method: there are none, or only those of contact, whose modes the
    /// steps decide.
    #[inline]
    pub(crate) fn has_none<M: System<S = S, G = G>>(system: &M, held: &M::U, change: Change) -> bool {
        let (rows, guards) = (system.contact_count(), system.guard_count());
        let are_of_contact = change == Change::InSteps && rows > 0 && guards == guard_count(rows);
        guards == 0 || are_of_contact && system.is_regular(held)
    }

    /// Event at the end of a step: without dense output it follows from the guards there, unless the step stays in the
    /// guard-free region.
    #[inline]
    pub(crate) fn look_after<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &I,
        context: &Context<'_, M>,
        history: &mut History<M>,
        (start, event): (&Beginning<M>, Event),
    ) -> Result<Event, Fault> {
        if method.is_dense() || Self::has_none(context.system, &context.held, method.change()) {
            return Ok(event);
        }
        let step = context.step((start.time, &start.x));
        let holds = history.beginning.as_ref().is_some_and(|centre| self.guard_free.holds(centre, &step));
        if holds || self.guard_free.renew(&mut history.beginning, &step) {
            return Ok(Event::None);
        }
        guards_here(context)?;
        Ok(Event::Behind { missed: self.missed(context, start) })
    }

    /// Fraction of a step without dense output at which the first row of contact leaves its mode: a gap closes or opens, a slip ends or
    /// begins; none if none does.
    pub(crate) fn changes_mode<M: System<S = S, G = G>>(
        &self,
        context: &Context<'_, M>,
        start: &Beginning<M>,
    ) -> Option<S> {
        let Context { system, time, held, x, .. } = *context;
        // What an event has left of a violated guard is its new zero.
        let over = |guards: &G, index: usize| guards.at(index) - self.residual.at(index);
        let at_end = super::guards(system, time, &held, &x);
        // Forces pass a pole where contact has no unique acceleration, the last guard: there is no mode beyond it.
        let is_unique = over(&at_end, system.guard_count().checked_sub(1)?) >= S::ZERO;
        if !is_unique {
            return None;
        }
        let has_mode = |row: &usize| M::contacts(&held).mode(*row).is_some_and(|mode| mode != Mode::Off);
        let rows = (0..system.contact_count()).filter(has_mode).map(|row| system.guard_of_row(&held, row));
        let guards = rows.flat_map(|first| [first, first + 1]);
        let mut sinking = guards.filter(|index| over(&at_end, *index) < S::ZERO).peekable();
        sinking.peek()?;
        let at_start = super::guards(system, start.time, &held, &start.x);
        let path = Path::between((start.time, &start.x), (time, &x), M::NQ);
        let share = |index: usize| {
            let mut guard =
                |share: S| over(&super::guards(system, path.time(share), &held, &path.at(share)), index);
            let [from, to] = [(S::ZERO, &at_start), (S::lit(1.0), &at_end)]
                .map(|(at, guards)| Point { at, value: over(guards, index) });
            if from.value > S::ZERO { root(from, to, S::lit(CHANGING), &mut guard) } else { S::ZERO }
        };
        sinking.map(share).reduce(S::min)
    }

    /// Conditions that came and went within a step without dense output: one of them (that ends the run, or else the
    /// first), and their number.
    #[cold]
    fn missed<M: System<S = S, G = G>>(
        &self,
        context: &Context<'_, M>,
        start: &Beginning<M>,
    ) -> Option<(usize, u64)> {
        let path = Path::between((start.time, &start.x), (context.time, &context.x), M::NQ);
        let (system, held) = (context.system, context.held);
        let search = Search::new((system, held), path, &self.residual, Relevant::ALL);
        if !matches!(search.first(), Found::Crossing(..)) {
            return None;
        }
        let leaves = |index: usize| matches!(search.of_one(index).first(), Found::Crossing(..));
        let count = system.guard_count();
        let all = Marks::of_all((0..count).filter(|i| M::SELECTIVE && leaves(*i)));
        let (relevant, mut missed) = (Relevant::of(system, &held, all), None);
        for index in (0..count).filter(|i| relevant.has(*i)) {
            let search = search.of_one(index);
            if !search.is_violated(S::lit(1.0), index) && matches!(search.first(), Found::Crossing(..)) {
                let (first, count) = missed.unwrap_or((index, 0));
                let ends = context.system.must_hold(index) || context.system.end(index).is_some();
                let told = if ends { index } else { first };
                missed = Some((told, count + 1));
            }
        }
        missed
    }
}
