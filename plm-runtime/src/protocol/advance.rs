//! General path: steps of any method to the end of an interval, each judged, then committed or made in another way.

use super::cut::Cut;
use super::judge::{Limits, Proposal, Rules, Verdict, judge};
use super::near_singular::{Rescue, is_singular, true_cause};
use super::observer::{Observer, Trigger};
use super::parts::Parts;
use crate::events::{self, Beginning, Detector, Event, History};
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Context, DriftCheck, Method};
use crate::scalar::{Real, Scalar};
use crate::system::{System, Updated};

/// Most consecutive failures of a run, even if the near-singular method could continue each time.
const MOST_FAILURES: u32 = 100;
/// A refused step is shortened only if it is longer than so many units in the last place of the time.
pub(super) const SHORTEST_ULPS: f64 = 64.0;

/// Event detector, history and limits of a run.
pub(crate) struct Guarded<'r, M: System> {
    pub(crate) detector: &'r mut Detector<M::S, M::G>,
    pub(crate) history: &'r mut History<M>,
    pub(crate) limits: Limits<M::S>,
}

/// Result of a proposed step.
pub(crate) enum Made<S> {
    /// The step was committed.
    Step,
    /// The step was refused; a shorter one is tried.
    Shortened,
    /// The step was refused; it will be made in parts.
    Split(Parts<S>),
    /// The step was refused; it will be made up to a change of contact, and from it on.
    Cut(Cut<S>),
    /// The step was refused; the near-singular method continues from its start.
    NearSingular,
    /// The method could make no step; the near-singular method may make one.
    Failed(Fault),
    /// The run ends.
    Ended(Fault),
}

/// A run to the end of its interval.
pub(crate) struct Advance<'r, 'c, M: Mechanism, I, O> {
    pub(crate) method: &'r mut I,
    pub(crate) context: &'r mut Context<'c, M>,
    pub(crate) guarded: Guarded<'r, M>,
    pub(crate) observer: &'r mut O,
    /// The length of a step that was cut while a part of it is made, s.
    pub(crate) cut: Option<M::S>,
}

impl<'c, M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, 'c, M, I, O> {
    /// Advances to the time `end`, from one time event to the next.
    pub(crate) fn run_to(&mut self, end: M::S) -> Result<(), Fault> {
        while self.context.time < end {
            let Context { system, time, held, .. } = &*self.context;
            let instant =
                system.next_time_event(*time, held).filter(|instant| *instant > *time && *instant <= end);
            self.context.end = instant.unwrap_or(end);
            self.run().map_err(|fault| events::at_a_jump(self.context, fault))?;
            match instant {
                Some(instant) if O::ENDS && self.context.time < instant => break,
                Some(_) => self.time_event()?,
                None if O::ENDS && self.context.time < end => break,
                None => {}
            }
        }
        Ok(())
    }

    /// Commits the time event at the time that was reached.
    fn time_event(&mut self) -> Result<(), Fault> {
        let Context { time, held, x, .. } = *self.context;
        let (before, mut after, mut x) = (Beginning { time, held, x }, held, x);
        self.context.system.switch_at_time(self.context.time, &mut after, &mut x)?;
        events::hold(self.context, after)?;
        self.context.x = x;
        self.context.stats.switches += 1;
        self.method.restart();
        self.guarded.detector.forget();
        self.observer.switched(self.context, &before, Trigger::Time);
        Ok(())
    }

    /// Advances to the end of the interval, before which there is no time event.
    fn run(&mut self) -> Result<(), Fault> {
        let before = self.modes();
        self.begin()?;
        self.show_events(before, Trigger::Due);
        self.method.begin(self.context)?;
        self.go_on(Made::Step)
    }

    /// Continues to the end of the interval after a step that another method or path has made.
    pub(crate) fn resume(&mut self, made: Made<M::S>) -> Result<(), Fault> {
        self.method.begin(self.context)?;
        self.go_on(made)
    }

    /// Makes steps to the end of the interval, for which the method is prepared; `made` is the result of the last step.
    pub(crate) fn go_on(&mut self, mut made: Made<M::S>) -> Result<(), Fault> {
        let mut failures = 0;
        loop {
            if let Made::Cut(cut) = &made {
                made = self.make_cut(cut);
            }
            if let Made::Split(parts) = made {
                made = self.split(parts);
            }
            failures = if let Made::Failed(_) = made { failures + 1 } else { 0 };
            match made {
                Made::Ended(fault) => return Err(fault),
                Made::Failed(fault) if failures > MOST_FAILURES => return Err(fault),
                Made::Failed(fault) => self.near_singular(Some(fault))?,
                _ if M::Rescue::holds(self.context) => self.near_singular(None)?,
                _ => {}
            }
            // False for NaN.
            let goes_on = self.context.time < self.context.end;
            if !goes_on {
                return Ok(());
            }
            made = self.step();
        }
    }

    /// Proposes a step, and carries out the judge's verdict.
    #[inline]
    pub(crate) fn step(&mut self) -> Made<M::S> {
        if self.coasts() {
            return self.coast();
        }
        let Self { method, context, guarded, .. } = self;
        let from = Beginning::of(context);
        context.health = M::S::lit(1.0);
        match guarded.detector.step(*method, context) {
            Ok(event) => self.conclude(&from, event),
            Err(fault) => self.fail(&from, fault),
        }
    }

    /// Returns to the start of a step that could not be made.
    #[cold]
    pub(crate) fn fail(&mut self, from: &Beginning<M>, fault: Fault) -> Made<M::S> {
        let reached = Some(self.context.time).filter(|time| *time > from.time);
        self.refuse(from);
        self.divide(reached.or_else(|| self.method.next_time()), fault)
    }

    /// A step to a time that has a fault: one of fixed length is made in parts first, because it leads far astray before a loop is near a
    /// singular pose. Where no pose is singular, the length that fails is the user's.
    fn divide(&self, until: Option<M::S>, fault: Fault) -> Made<M::S> {
        let helps = M::Rescue::POSSIBLE && self.method.next_time().is_some() && is_singular(&fault);
        match until.filter(|until| helps && *until > self.context.time) {
            Some(until) => Made::Split(Parts { until, count: 2, fault: Some(fault) }),
            None => Made::Failed(fault),
        }
    }

    /// Carries out the judge's verdict on the proposed step, from its beginning to the state reached.
    pub(crate) fn conclude(&mut self, from: &Beginning<M>, event: Event) -> Made<M::S> {
        let Self { method, context, guarded, .. } = self;
        let (length, limits) = (method.length(), guarded.limits);
        let mut rules = Rules { length, drift: method.drift_check(context.system), limits };
        let mut drifted = false;
        let (mut held, mut x) = (context.held, context.x);
        let mut proposal = Proposal::of(context, (from.time, &from.x), (&mut held, &mut x));
        let accepted = loop {
            match judge(&mut proposal, method.estimate(), &rules) {
                Verdict::Accept(accepted) => break accepted,
                Verdict::Project => {
                    if let Err(fault) = project_end(context) {
                        return self.fail(from, fault);
                    }
                    (rules.drift, drifted, *proposal.x) = (DriftCheck::Skip, true, context.x);
                }
                Verdict::Shorten(fault) => return self.shorten(from, fault),
                Verdict::Split(count) => {
                    let until = context.time;
                    self.refuse(from);
                    return Made::Split(Parts { until, count, fault: None });
                }
                Verdict::NearSingular => {
                    let until = context.time;
                    self.refuse(from);
                    M::Rescue::take(self.context);
                    self.context.rescued = self.context.rescued.map(|_| until);
                    return Made::NearSingular;
                }
                Verdict::Refuse(fault) => {
                    self.refuse(from);
                    self.method.restart();
                    return Made::Ended(fault);
                }
            }
        };
        match guarded.detector.look_after(&**method, context, guarded.history, (from, event)) {
            Ok(event) => match self.change(from, &event) {
                Some(cut) => {
                    self.refuse(from);
                    Made::Cut(cut)
                }
                None => self
                    .commit(from, (held, x), (accepted, drifted), event)
                    .map_or_else(Made::Failed, |()| Made::Step),
            },
            Err(fault) => self.fail(from, fault),
        }
    }

    /// Commits a step; `behind` are the discrete state and the state after it. Updates charts, revolutions, counters and the memory of
    /// the method, whose end was projected if it had `drifted`; then commits the events there.
    #[inline]
    fn commit(
        &mut self,
        from: &Beginning<M>,
        behind: (M::U, M::X),
        (Updated { moved, turned, passed }, drifted): (Updated, bool),
        event: Event,
    ) -> Result<(), Fault> {
        // Samples within the step need the modes during it. An observer may end the run after this step; the events are still committed
        // with the end of the interval that the step was made for.
        let end = self.context.end;
        self.observer.see(self.method, self.context)?;
        let stop = core::mem::replace(&mut self.context.end, end);
        let Self { method, context, guarded, .. } = self;
        // An event at the start of a step makes no step.
        if context.time > from.time {
            guarded.history.see((&**method, context.system), || *from);
        }
        (context.held, context.x) = behind;
        context.stats.errs(method.estimate().error);
        context.stats.charts += u64::from(moved);
        context.stats.change_points += u64::from(passed.is_some());
        method.keep(drifted);
        if moved {
            method.restart();
        } else if turned {
            method.turned();
        }
        let before = self.modes();
        let step = self.cut.unwrap_or(self.context.time - from.time);
        self.guarded.detector.switch(self.method, self.context, (event, step))?;
        self.context.end = stop;
        self.show_events(
            before,
            if let Event::At(index) = event { Trigger::Condition(index) } else { Trigger::Due },
        );
        Ok(())
    }

    /// Discrete state, state and number of events, if the observer shows events.
    fn modes(&self) -> Option<(Beginning<M>, u64)> {
        let Context { time, held, x, .. } = *self.context;
        O::SWITCHES.then_some((Beginning { time, held, x }, self.context.stats.switches))
    }

    /// Shows the events since `before`.
    #[inline]
    fn show_events(&mut self, before: Option<(Beginning<M>, u64)>, trigger: Trigger) {
        if let Some((before, _)) = before.filter(|(_, switches)| self.context.stats.switches > *switches) {
            self.observer.switched(self.context, &before, trigger);
        }
    }

    /// Makes the modes of the conditions agree with the state.
    pub(super) fn begin(&mut self) -> Result<(), Fault> {
        self.guarded.detector.begin(self.method, self.context)
    }

    /// Returns to the start of a step.
    fn refuse(&mut self, from: &Beginning<M>) {
        let Self { context, guarded, .. } = self;
        // An event at the start of the step made none.
        let made = u64::from(context.time > from.time);
        (context.time, context.x) = (from.time, from.x);
        context.stats.steps -= made;
        context.stats.rejected += made;
        guarded.detector.forget();
    }

    /// Refuses a step, and asks the method for a shorter one.
    #[cold]
    fn shorten(&mut self, from: &Beginning<M>, fault: Fault) -> Made<M::S> {
        let (h, time) = (self.context.time - from.time, self.context.time);
        self.refuse(from);
        let is_long = h > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * time.abs();
        let has_shorter = self.method.shorten(h);
        if !has_shorter {
            self.method.restart();
        }
        if !(has_shorter && is_long) {
            return self.divide(Some(time), fault);
        }
        self.begin().map_or_else(Made::Failed, |()| Made::Shortened)
    }

    /// This run with another method and other limits.
    pub(super) fn with<'s, J>(
        &'s mut self,
        method: &'s mut J,
        limits: Limits<M::S>,
    ) -> Advance<'s, 'c, M, J, O> {
        let Guarded { detector, history, .. } = &mut self.guarded;
        let guarded = Guarded { detector: &mut **detector, history: &mut **history, limits };
        let (context, cut) = (&mut *self.context, self.cut);
        Advance { method, context, guarded, observer: &mut *self.observer, cut }
    }

    /// Makes steps by the near-singular method, until the mechanism's own coordinates are regular again. After a fault it does so only
    /// if the fault may come from a singular pose.
    #[cold]
    fn near_singular(&mut self, failed: Option<Fault>) -> Result<(), Fault> {
        if let Some(fault) = failed {
            if !(is_singular(&fault) && M::Rescue::take(self.context)) {
                return Err(fault);
            }
            self.guarded.detector.forget();
            self.begin()?;
        }
        // The energy check needs the mechanism's own coordinates.
        let limits = Limits { energy_jump: None, ..self.guarded.limits };
        let (mut rescue, mut refused) = (M::Rescue::new(), 0);
        while self.context.time < self.context.end && M::Rescue::holds(self.context) {
            self.context.check_steps(self.method.most_steps())?;
            let from = Beginning::of(self.context);
            let made = self.with(&mut rescue, limits).step();
            if let Made::Failed(fault) | Made::Ended(fault) = made {
                return Err(true_cause(failed, fault));
            }
            if self.context.time <= from.time {
                // The discrete state contains the pose.
                self.context.held = from.held;
                refused += 1;
                if refused > MOST_FAILURES {
                    return Err(failed.unwrap_or(self.context.fault(Cause::StepTooSmall { step: 0.0 })));
                }
                continue;
            }
            refused = 0;
            if let Some(part) = rescue.passed() {
                if limits.change_points {
                    let fault = Fault::of_part(self.context.time.to_f64(), part, Cause::ChangePoint);
                    (self.context.time, self.context.held, self.context.x) = (from.time, from.held, from.x);
                    return Err(fault);
                }
                self.context.stats.change_points += 1;
            }
        }
        self.method.restart();
        // The length of the step before the turn did not take the turn into account.
        if let Some(h) = rescue.followed() {
            self.method.shorten(h + h);
        }
        if self.context.time < self.context.end { self.method.begin(self.context) } else { Ok(()) }
    }
}

/// Projects the state that was reached onto the constraints.
pub(super) fn project_end<M: System<S: Real>>(context: &mut Context<'_, M>) -> Result<(), Fault> {
    let (time, mut x) = (context.time, context.x);
    events::before_projection(context, time, &x)?;
    context.project(time, &mut x)?;
    context.x = x;
    Ok(())
}
