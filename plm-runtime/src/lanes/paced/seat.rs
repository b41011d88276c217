//! A run in a lane: what only its own numbers decide.

use core::borrow::BorrowMut;

use super::super::Pack;
use crate::events::{Beginning, Event, at_a_jump};
use crate::fault::Fault;
use crate::mechanism::Moment;
use crate::method::{Context, Embedded, ErrorControl, Going, Pair, Span};
use crate::protocol::{Advance, Guarded, Made, Rescue, Unobserved};
use crate::scalar::Scalar;
use crate::sim::{Clock, Sim};
use crate::stats::Stats;

/// A run by a pair.
pub(super) type Run<M, P> = Sim<M, Embedded<M, P>>;

/// A run on its way to the end of an interval.
pub(super) struct Seat<M: Pack<S = f64>, P: Pair, B> {
    pub(super) run: B,
    /// Its place in the order in which runs came.
    pub(super) number: usize,
    /// End of the interval, s.
    pub(super) end: f64,
    /// The clock there.
    pub(super) clock: Clock<f64>,
    /// Steps tried before the interval.
    before: u64,
    /// Method and counters before the first step was prepared, until a step was made.
    untouched: Option<(Embedded<M, P>, Stats)>,
    /// Discrete state at the beginning of the last step, if that step has changed it.
    pub(super) was: Option<M::U>,
    /// The last step is about to be judged.
    is_judged: bool,
    /// Then, the beginning of the step before it, if there was one.
    before_last: Option<Beginning<M>>,
    /// Its lane has its parameters and inputs.
    pub(super) was_packed: bool,
}

/// The last of several steps that were made in a lane, and their number.
pub(super) struct Lately<M: Pack<S = f64>, P: Pair> {
    pub(super) going: Going<f64, M::X>,
    pub(super) last: Span<f64, M::X>,
    pub(super) stages: P::Stages<M::X>,
    pub(super) by_error: bool,
    pub(super) time: f64,
    pub(super) held: M::U,
    /// The discrete state at the beginning of the last step, if that step has changed it.
    pub(super) was: Option<M::U>,
    pub(super) steps: u64,
    pub(super) rejected: u64,
    pub(super) longest: f64,
}

impl<M: Pack<S = f64>, P: Pair, B: BorrowMut<Run<M, P>>> Seat<M, P, B> {
    /// A run on its way through an interval of `dt`, s, or the run itself where it has to be made alone: mechanisms with conditions, kinks or rows of contact,
    /// and those whose drift is to be checked; runs with limits or counts of their own; intervals with a time event.
    pub(super) fn new(mut run: B, number: usize, dt: f64) -> Result<Self, B> {
        let sim = run.borrow_mut();
        // One whose change cannot be is found as it was, and says so itself.
        let _ = sim.take_changes();
        let (time, mechanism) = (sim.state.time(), sim.state.mechanism());
        let clock = sim.clock.after(time, dt);
        let end = clock.time;
        let plain = !M::WATCHED
            && M::CONTACTS == 0
            && mechanism.guard_count() == 0
            && mechanism.kink_count() == 0
            && !mechanism.may_bend()
            && mechanism.states() > 0;
        let free = || mechanism.next_time_event(time, &sim.state.held()).is_none_or(|instant| instant > end);
        let joins = plain
            && !sim.changed
            && sim.limits.energy_jump.is_none()
            && sim.history.counts.is_none()
            && end > time
            && end.is_finite()
            && free();
        if !joins {
            return Err(run);
        }
        let before = sim.stats.steps + sim.stats.rejected;
        Ok(Self {
            run,
            number,
            end,
            clock,
            before,
            untouched: None,
            was: None,
            is_judged: false,
            before_last: None,
            was_packed: false,
        })
    }

    pub(super) fn sim(&self) -> &Run<M, P> {
        self.run.borrow()
    }

    /// Its time, the end of the interval, s, its state, and how many more steps may be tried.
    pub(super) fn moment(&self) -> (f64, f64, M::X, f64) {
        let Sim { state, method, stats, .. } = self.sim();
        let tried = stats.steps + stats.rejected - self.before;
        (state.time(), self.end, *state.x(), method.most_steps.saturating_sub(tried) as f64)
    }

    /// The tolerance and the longest step of its method.
    pub(super) fn options(&self) -> [f64; 2] {
        let method = &self.sim().method;
        [ErrorControl::<M>::tolerance(method).unwrap_or(method.rtol), method.longest_step]
    }

    /// The chart in which its next step may be made with others; none where it may not.
    pub(super) fn place(&self) -> Option<usize> {
        let sim = self.sim();
        M::chart(&sim.state.held()).filter(|_| sim.method.is_regular())
    }

    /// Computes what the next step begins with; nothing where that takes more than a healthy solution.
    pub(super) fn ready(&mut self) -> Option<Going<f64, M::X>> {
        let before = self.before;
        let Sim { state, method, stats, longest_step, .. } = self.run.borrow_mut();
        if let Some(going) = method.going() {
            return Some(going);
        }
        let untouched = (*method, *stats);
        let (time, held, x) = (state.time(), state.held(), *state.x());
        let told = (&mut *stats, &mut *longest_step);
        let mut context = Context::new((state.mechanism(), held), (time, x), self.end, told).after(before);
        let going = method.ready(&mut context).ok().filter(|_| <f64 as Scalar>::HEALTHY < context.health);
        if going.is_none() {
            (*method, *stats) = untouched;
        } else if untouched.0.is_at_start() {
            self.untouched = Some(untouched);
        }
        going
    }

    /// Takes over the steps that were made in a lane, up to the beginning of the next one.
    pub(super) fn take(&mut self, lately: &Lately<M, P>) {
        let (is_judged, before_last) = (core::mem::take(&mut self.is_judged), self.before_last.take());
        let sim = self.run.borrow_mut();
        if lately.steps == 0 {
            if let Some((method, stats)) = self.untouched.take() {
                (sim.method, sim.stats) = (method, stats);
            }
            return;
        }
        self.untouched = None;
        let Lately { going, last, stages, by_error, time, held, was, steps, rejected, longest } = *lately;
        let at_end = u64::from(P::rate_at_end(&stages).is_none());
        sim.stats.steps += steps;
        sim.stats.rejected += rejected;
        sim.stats.evaluations += P::EVALUATIONS * (steps + rejected) + at_end * steps;
        sim.longest_step = sim.longest_step.max(longest);
        let beginning = Beginning { time: last.time, held: was.unwrap_or(held), x: last.from };
        sim.history.beginning = if is_judged { before_last } else { Some(beginning) };
        sim.state.set(time, &held, &last.to);
        sim.method.go_on(going, stages, by_error);
        sim.method.has_made(last);
    }

    /// Stores the beginning of the step before the last one, which is about to be judged: by its time, state and whether it has looked, and
    /// by the discrete state after it.
    pub(super) fn remember(&mut self, last: Option<(f64, M::X, bool)>, held: M::U) {
        let stored = self.sim().history.beginning;
        let was = self.was;
        self.is_judged = true;
        self.before_last = last.map_or(stored, |(time, x, looked)| {
            Some(Beginning { time, held: was.filter(|_| looked).unwrap_or(held), x })
        });
    }

    /// Makes a step alone; the outcome where the run has ended by it.
    pub(super) fn step(&mut self) -> Option<Result<(), Fault>> {
        self.go(|advance| {
            if M::Rescue::holds(advance.context) {
                return Made::Step;
            }
            advance.step()
        })
    }

    /// Judges the step to the state reached, from a time and state; the outcome where the run has ended by it.
    pub(super) fn judge(&mut self, (time, x): (f64, M::X)) -> Option<Result<(), Fault>> {
        self.go(|advance| {
            let from = Beginning { time, held: advance.context.held, x };
            advance.conclude(&from, Event::None)
        })
    }

    /// Goes on after a step that is made alone; the outcome where the run has ended by it.
    fn go(
        &mut self,
        step: impl FnOnce(&mut Advance<'_, '_, M, Embedded<M, P>, Unobserved>) -> Made<f64>,
    ) -> Option<Result<(), Fault>> {
        let (before, end) = (self.before, self.end);
        self.untouched = None;
        let Sim { state, method, stats, detector, limits, longest_step, history, .. } = self.run.borrow_mut();
        let (held, start) = (state.held(), (state.time(), *state.x()));
        let mut context =
            Context::new((state.mechanism(), held), start, end, (stats, longest_step)).after(before);
        let guarded = Guarded { detector, history, limits: *limits };
        let mut unobserved = Unobserved;
        let (context, observer) = (&mut context, &mut unobserved);
        let mut advance = Advance { method, context, guarded, observer, cut: None };
        let made = step(&mut advance);
        let goes_on = matches!(made, Made::Step | Made::Shortened) && !M::Rescue::holds(advance.context);
        let outcome =
            if goes_on { (advance.context.time >= end).then_some(Ok(())) } else { Some(advance.go_on(made)) };
        let outcome = outcome.map(|outcome| outcome.map_err(|fault| at_a_jump(context, fault)));
        let (time, held, x) = (context.time, context.held, context.x);
        state.set(time, &held, &x);
        outcome
    }
}
