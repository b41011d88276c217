//! Steps that end at the first event in them.

use super::derived::moved_end;
use super::detector::{Detector, Event};
use super::ends::Ends;
use super::here::guards_here;
use super::history::Reached;
use super::refined::{Refined, advance_to, meet, refine};
use super::thrown::leads_away;
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::Real;
use crate::system::System;
use crate::tolerances::NO_STEP;
use crate::vector::Vector;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// Makes a step as the method proposes it; with dense output it ends where the first condition leaves its side.
    #[inline]
    pub(crate) fn step<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        context: &mut Context<'_, M>,
    ) -> Result<Event, Fault> {
        if !I::DENSE || context.system.guard_count() == 0 && context.system.kink_count() == 0 {
            method.advance(context)?;
            return Ok(Event::None);
        }
        Ok(self.located(method, context)?.map_or(Event::None, Event::At))
    }

    /// The condition that ends the step, if any. A separate function, so that a build without optimisation copies the method only for
    /// systems with guards.
    #[inline]
    fn located<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        context: &mut Context<'_, M>,
    ) -> Result<Option<usize>, Fault> {
        if M::S::HAS_DERIVATIVES && core::mem::take(&mut self.has_passed) {
            method.restart();
        }
        let before = Reached::of(method, context);
        let start = before.state.time;
        method.advance(context)?;
        self.guard_free.forget();
        // An event that would end a step so early that time hardly advances happens at once.
        let least = NO_STEP.of::<S>() * S::EPSILON * start.abs().max(context.end.abs());
        let mut beyond_kinks = false;
        loop {
            let end = guards_here(context)?;
            let asked = ((&before.state, &end), (least, beyond_kinks));
            let (mut ends, mut time) = self.ends(method, context, asked.0, asked.1)?;
            if let Ends::Due(index) = ends
                && time - start <= least
                && self.passes_dip(method, context, (&before, index))
            {
                (ends, time) = self.ends(method, context, asked.0, asked.1)?;
            }
            let due = if let Ends::Due(index) = ends { Some(index) } else { None };
            if time >= context.time {
                self.arrive(end);
                return Ok(due);
            }
            context.stats.steps -= 1;
            context.stats.rejected += 1;
            before.restore(method, context);
            let is_at_once = time - start <= least;
            // An event at once needs no step, unless the state leads away from it first: then the shortest step ends after it.
            let stood = |index| (index, self.residual.at(index));
            if is_at_once && !due.is_some_and(|index| leads_away(context, stood(index))) {
                return Ok(due);
            }
            let time = if is_at_once { (start + least + least).min(context.end) } else { time };
            advance_to(method, context, time)?;
            // The state at an event moves with the formula of the step, not with its rate.
            let at_end = due.filter(|_| context.time >= time);
            if let Some(moved) = at_end.and_then(|index| moved_end(context, index, time - start)) {
                context.stats.steps -= 1;
                before.restore(method, context);
                advance_to(method, context, time + moved)?;
            }
            self.has_passed = ends == Ends::BeyondKink;
            if ends != Ends::BeforeKink {
                // A shorter step that is rejected nevertheless has not come as far: the next one will find the crossing again.
                let mut due = due.filter(|_| context.time >= time);
                due = due.filter(|index| !(is_at_once && leads_away(context, stood(*index))));
                if let Some(index) = due.filter(|index| context.system.must_hold(*index)) {
                    due = meet(method, context, &before, index)?.then_some(index);
                } else if let Some(index) = due.filter(|_| context.system.contact_count() > 0)
                    && refine(context, start, index)? == Refined::Far
                {
                    due = meet(method, context, &before, index)?.then_some(index);
                    if due.is_some() {
                        refine(context, start, index)?;
                    }
                }
                self.arrive(guards_here(context)?);
                return Ok(due);
            }
            beyond_kinks = true;
        }
    }
}
