//! Event detection: finds the changes of modes of conditions, and limits their number in a short time.
//!
//! The discrete state contains the mode of every condition and is constant during a step, so that the rate is smooth. A guard is
//! positive while the mode of its condition applies. The detector finds the first guard that passes zero on the dense output, repeats
//! the step so that it ends exactly there, and commits the event: another mode, and another state if the event resets it.
//!
//! The step is repeated because the next one starts from its end: the repeated step has the accuracy of every other step and satisfies
//! the constraints, while the dense output is of lower order and violates them.

mod boundary;
mod chattering;
mod derived;
mod dips;
mod enclosure;
mod ends;
mod fixed;
mod guard_free;
mod here;
mod history;
mod jumps;
mod kinks;
mod marks;
mod passing;
mod piece;
mod quartic;
mod relevant;
mod root;
mod rounding;
mod sampled;
mod search;
mod sets;
mod stays;
mod thrown;
mod touch;
mod violated;
mod words;

use self::boundary::{Boundary, Refined, advance_to, decide, meet, refine};
use self::chattering::Chattering;
use self::derived::{Timed, derive_time, moved_end, restore_time};
use self::ends::Ends;
use self::guard_free::GuardFree;
use self::here::{guards, guards_here};
use self::history::Reached;
pub(crate) use self::history::{Beginning, History};
pub(crate) use self::jumps::{at_a_jump, before_projection, hold};
use self::marks::{MOST_GUARDS, Marks};
pub use self::relevant::holds;
pub(crate) use self::relevant::refresh;
pub use self::sets::{Sets, begin, change, take_sides, with_velocities};
use self::thrown::{is_of_state, leads_away, switch_back, switch_there_and_back};
pub use self::violated::SUNK;
pub use self::violated::switch_where_due;
use self::violated::{Switched, required, switch_violated};
pub(crate) use self::violated::{are_satisfied, switch_at_end, switch_each, violated};
use crate::fault::Fault;
use crate::method::{Context, Method};
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Longest step, in units in the last place of the time, that counts as none.
const LEAST_ULPS: f64 = 32.0;

/// The event at the end of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Event {
    /// No condition is triggered.
    None,
    /// This condition is triggered; the detector has ended the step there.
    At(usize),
    /// The detector has not ended the step: conditions whose guards are violated at its end switch there. Others were `missed`: they
    /// came and went within the step.
    Behind {
        /// One of them, by its index, and their number.
        missed: Option<(usize, u64)>,
    },
}

/// Agreement of the modes in the discrete state with the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Modes {
    /// Nothing has been decided yet: a condition on its boundary begins in the mode that the motion leads to.
    New,
    /// The modes were decided at the start, and no step has been made.
    Decided,
    /// State, parameters or inputs may have changed since.
    Unknown,
    /// The modes are those of the state.
    Known,
}

/// Event detector, with the data about guards that is stored between two steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Detector<S, G> {
    modes: Modes,
    /// Residual of each guard: the value by which it was violated when its event was committed; zero for most.
    residual: G,
    /// Guard-free region, for steps of fixed length.
    guard_free: GuardFree<S>,
    /// Counter of switches in a short time.
    chattering: Chattering<S>,
    /// True if the last step of numbers with derivatives has crossed a kink.
    has_passed: bool,
}

impl<S: Real, G: Vector<S>> Detector<S, G> {
    pub(crate) fn new() -> Self {
        const {
            assert!(
                G::LEN <= MOST_GUARDS,
                "a mechanism has at most 256 guards, and 64 without the feature `std`: those of conditions, and three of each row of contact"
            );
        };
        Self {
            modes: Modes::New,
            residual: G::fill(S::ZERO),
            guard_free: GuardFree::new(),
            chattering: Chattering::new(),
            has_passed: false,
        }
    }

    /// Records that state, parameters or inputs may have changed.
    pub(crate) fn forget(&mut self) {
        self.modes = match self.modes {
            Modes::New | Modes::Decided => Modes::New,
            Modes::Unknown | Modes::Known => Modes::Unknown,
        };
        self.guard_free.forget();
        self.residual = G::fill(S::ZERO);
    }

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
        if !boundary.switched.is_empty() {
            method.restart();
            let count = if is_new { 0 } else { boundary.switched.count() };
            self.chattering.count(context, boundary.switched, (count, 0))?;
        }
        self.switch_due(method, context, (Some(boundary), S::ZERO))?;
        if !boundary.decided.is_empty() {
            let here = guards_here(context)?;
            let own = |i: usize| {
                if boundary.decided.has(i) { here.at(i).min(S::ZERO) } else { self.residual.at(i) }
            };
            self.residual = G::from_fn(own);
        }
        Ok(())
    }

    /// True if the sides in the discrete state are those that apply.
    #[inline]
    pub(crate) fn is_known(&self) -> bool {
        G::LEN == 0 || matches!(self.modes, Modes::Decided | Modes::Known)
    }

    /// Makes a step as the method proposes it; with dense output it ends where the first condition leaves its side.
    #[inline]
    pub(crate) fn step<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        context: &mut Context<'_, M>,
    ) -> Result<Event, Fault> {
        if !method.is_dense() || context.system.guard_count() == 0 && context.system.kink_count() == 0 {
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
        let least = S::lit(LEAST_ULPS) * S::EPSILON * start.abs().max(context.end.abs());
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
        if !method.is_dense() {
            return Ok(());
        }
        let (time, x) = (context.time, context.x);
        let changed = refresh(context.system, time, &mut context.held, &x);
        if !changed.is_empty() {
            self.residual = G::from_fn(|i| if changed.has(i) { S::ZERO } else { self.residual.at(i) });
        }
        // A condition that does not matter here has switched with the others.
        let Event::At(index) = event else { return Ok(()) };
        if changed.has(index) {
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
        self.chattering.count(context, Marks::of(index), switched)
    }

    /// Records that the state reached has these guards.
    fn arrive(&mut self, guards: G) {
        self.modes = Modes::Known;
        self.release(&guards);
    }

    /// Drops the residuals of guards that are satisfied again.
    fn release(&mut self, guards: &G) {
        self.residual = self.residual.map2(guards, |left, g| if g < S::ZERO { left } else { S::ZERO });
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
            for index in (0..G::LEN).filter(|index| conditions.has(*index)) {
                thrown += switch_back(context, index, &before)?;
            }
        }
        method.restart();
        let here = guards_here(context)?;
        let own = |i: usize| if conditions.has(i) { here.at(i).min(S::ZERO) } else { self.residual.at(i) };
        self.residual = G::from_fn(own);
        self.chattering.count(context, conditions, (count, thrown))
    }
}
