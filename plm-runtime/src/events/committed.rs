//! Commits of events: at the start of a run or after a change by the caller, at the end of a step, of one condition or of all that are due.

use super::boundary::{Boundary, decide};
use super::derived::{Timed, derive_time, restore_time};
use super::detector::{Detector, Event, Modes};
use super::here::guards_here;
use super::relevant::{bit, refresh};
use super::requirements::required;
use super::thrown::{switch_back, switch_there_and_back};
use super::violated::{Switched, switch_violated};
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// Makes the sides in the discrete state agree with the state.
    #[inline]
    pub(crate) fn begin<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        context: &mut Context<'_, M>,
    ) -> Result<(), Fault> {
        if self.is_known() {
            return Ok(());
        }
        let here = guards_here(context)?;
        let is_new = self.modes == Modes::New;
        let boundary = decide(context, &here, is_new)?;
        if boundary.switched != 0 {
            method.restart();
            let count = if is_new { 0 } else { boundary.switched.count_ones() };
            self.chattering.count(context, boundary.switched, (count, 0))?;
        }
        self.switch_due(method, context, (Some(boundary), S::ZERO))?;
        if boundary.decided != 0 {
            let here = guards_here(context)?;
            let own = |i: usize| {
                if boundary.decided & bit(i) == 0 { self.residual.at(i) } else { here.at(i).min(S::ZERO) }
            };
            self.residual = G::from_fn(own);
        }
        Ok(())
    }

    /// Commits the event of the condition that is due; without dense output, those of all conditions whose guards are violated, after
    /// a step of the length `step`.
    #[inline]
    pub(crate) fn switch<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        context: &mut Context<'_, M>,
        (event, step): (Event, S),
    ) -> Result<(), Fault> {
        if context.system.guard_count() == 0 {
            return Ok(());
        }
        if let Event::Behind { missed } = event {
            if let Some((index, passed_over)) = missed {
                context.stats.passed_over += passed_over;
                required(context, index)?;
            }
            return self.switch_due(method, context, (None, step));
        }
        if !I::DENSE {
            return Ok(());
        }
        let (time, x) = (context.time, context.x);
        let changed = refresh(context.system, time, &mut context.held, &x);
        if changed != 0 {
            self.residual = G::from_fn(|i| if changed & bit(i) == 0 { self.residual.at(i) } else { S::ZERO });
        }
        // A condition that does not matter here has switched with the others.
        let Event::At(index) = event else { return Ok(()) };
        if changed & bit(index) != 0 {
            return Ok(());
        }
        required(context, index)?;
        let (index, moved) = match derive_time(context, index, step)? {
            Timed::Event(first, moved) => (first, moved),
            Timed::Touch(least) => {
                self.residual.set(index, least);
                return Ok(());
            }
        };
        required(context, index)?;
        let thrown = switch_there_and_back(context, index)?;
        // The end of an interval is fixed.
        if context.time >= context.end {
            restore_time(context, moved)?;
        }
        method.restart();
        let here = guards_here(context)?;
        self.residual.set(index, here.at(index).min(S::ZERO));
        let before = core::mem::replace(&mut self.modes, Modes::Known);
        let switched = if matches!(before, Modes::New | Modes::Decided) { (0, 0) } else { (1, thrown) };
        self.chattering.count(context, bit(index), switched)
    }

    /// Commits the events of violated guards at the current state: after a step, or with a `boundary` after a change by the caller, in
    /// which the sides at boundaries have been decided.
    fn switch_due<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        context: &mut Context<'_, M>,
        (boundary, within): (Option<Boundary>, S),
    ) -> Result<(), Fault> {
        let here = guards_here(context)?;
        self.modes = match self.modes {
            Modes::New | Modes::Decided => Modes::Decided,
            Modes::Unknown | Modes::Known => Modes::Known,
        };
        self.release(&here);
        let before = context.x;
        let Some(Switched { conditions, count }) =
            switch_violated(context, &here, (boundary, self.residual), within)?
        else {
            return Ok(());
        };
        let mut thrown = 0;
        if boundary.is_none() {
            for index in (0..G::LEN).filter(|index| conditions & bit(*index) != 0) {
                thrown += switch_back(context, index, &before)?;
            }
        }
        method.restart();
        let here = guards_here(context)?;
        let own =
            |i: usize| if conditions & bit(i) == 0 { self.residual.at(i) } else { here.at(i).min(S::ZERO) };
        self.residual = G::from_fn(own);
        self.chattering.count(context, conditions, (count, thrown))
    }
}
