//! The general path: steps of any method to the end of an interval, each judged, then committed or made in another way.

use super::judge::{DriftCheck, Limits, Rules, Verdict, judge};
use crate::events::{self, Event, Watch};
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::sim::{Begun, Kept, Observer, Trigger};
use crate::singular::Rescue;
use crate::system::{Accepted, System};

/// So many failures one after the other end a run, although the near-singular method could go on each time.
const MOST_FAILURES: u32 = 100;
/// A step that is refused is not shortened below so many units in the last place of the time.
const SHORTEST_ULPS: f64 = 64.0;

/// What a run keeps besides its state and its method.
pub(crate) struct Guarded<'r, M: System> {
    pub(crate) watch: &'r mut Watch<M::S, M::G>,
    pub(crate) kept: &'r mut Kept<M>,
    pub(crate) limits: Limits<M::S>,
}

/// What became of a proposed step.
pub(crate) enum Made<S> {
    /// It was committed.
    Step,
    /// It was refused; a shorter one is tried.
    Shortened,
    /// It was refused, and is to be made in parts.
    Split(Parts<S>),
    /// It was refused, and the state given to the near-singular method.
    NearSingular,
    /// There is none; the near-singular method may have one.
    Failed(Fault),
    /// The run ends.
    Ended(Fault),
}

/// A step that is to be made in parts.
pub(crate) struct Parts<S> {
    /// Its end, s.
    until: S,
    /// So many at least.
    count: u32,
}

/// A run on its way to the end of its course.
pub(crate) struct Advance<'r, 'c, M: Mechanism, I, O> {
    pub(crate) method: &'r mut I,
    pub(crate) course: &'r mut Course<'c, M>,
    pub(crate) guarded: Guarded<'r, M>,
    pub(crate) observer: &'r mut O,
}

impl<'c, M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, 'c, M, I, O> {
    /// Advances to the time `end`, from time event to time event.
    pub(crate) fn run_to(&mut self, end: M::S) -> Result<(), Fault> {
        while self.course.time < end {
            let Course { system, time, held, .. } = &*self.course;
            let instant =
                system.next_instant(*time, held).filter(|instant| *instant > *time && *instant <= end);
            self.course.end = instant.unwrap_or(end);
            self.run().map_err(|fault| events::at_a_jump(self.course, fault))?;
            match instant {
                Some(instant) if O::ENDS && self.course.time < instant => break,
                Some(_) => self.time_event()?,
                None if O::ENDS && self.course.time < end => break,
                None => {}
            }
        }
        Ok(())
    }

    /// Commits the time event that was reached.
    fn time_event(&mut self) -> Result<(), Fault> {
        let Course { time, held, x, .. } = *self.course;
        let (before, mut after, mut x) = (Begun { time, held, x }, held, x);
        self.course.system.pass(self.course.time, &mut after, &mut x)?;
        events::hold(self.course, after)?;
        self.course.x = x;
        self.course.stats.switches += 1;
        self.method.restart();
        self.guarded.watch.forget();
        self.observer.switched(self.course, &before, Trigger::Time);
        Ok(())
    }

    /// Advances to the end of the course; no time event lies before it.
    fn run(&mut self) -> Result<(), Fault> {
        let before = self.modes();
        self.begin()?;
        self.show_events(before, Trigger::Due);
        self.method.begin(self.course)?;
        self.go_on(Made::Step)
    }

    /// Advances to the end of the course behind a step that was made by others.
    pub(crate) fn resume(&mut self, made: Made<M::S>) -> Result<(), Fault> {
        self.method.begin(self.course)?;
        self.go_on(made)
    }

    fn go_on(&mut self, mut made: Made<M::S>) -> Result<(), Fault> {
        let mut failures = 0;
        loop {
            if let Made::Split(parts) = made {
                made = self.split(parts);
            }
            failures = if let Made::Failed(_) = made { failures + 1 } else { 0 };
            match made {
                Made::Ended(fault) => return Err(fault),
                Made::Failed(fault) if failures > MOST_FAILURES => return Err(fault),
                Made::Failed(fault) => self.near_singular(Some(fault))?,
                _ if M::Rescue::holds(self.course) => self.near_singular(None)?,
                _ => {}
            }
            // False for what is not a number.
            let goes_on = self.course.time < self.course.end;
            if !goes_on {
                return Ok(());
            }
            made = self.step();
        }
    }

    /// Proposes a step, and does what the judge says of it.
    #[inline]
    fn step(&mut self) -> Made<M::S> {
        let Self { method, course, guarded, .. } = self;
        let from = Begun { time: course.time, held: course.held, x: course.x };
        course.health = M::S::lit(1.0);
        match guarded.watch.step(*method, course) {
            Ok(event) => self.conclude(&from, event),
            Err(fault) => {
                self.refuse(&from);
                Made::Failed(fault)
            }
        }
    }

    /// Does what the judge says of the step that was proposed, from its beginning to the state of the course.
    pub(crate) fn conclude(&mut self, from: &Begun<M>, event: Event) -> Made<M::S> {
        let Self { method, course, guarded, .. } = self;
        let (length, limits) = (I::LENGTH, guarded.limits);
        let mut rules = Rules { length, drift: method.drift_check(), limits };
        let mut drifted = false;
        let (mut held, mut x) = (course.held, course.x);
        let mut proposal = course.proposal((from.time, &from.x), (&mut held, &mut x));
        let accepted = loop {
            match judge(&mut proposal, method.estimate(), &rules) {
                Verdict::Accept(accepted) => break accepted,
                Verdict::Project => {
                    if let Err(fault) = course.project() {
                        self.refuse(from);
                        return Made::Failed(fault);
                    }
                    (rules.drift, drifted, *proposal.x) = (DriftCheck::Skip, true, course.x);
                }
                Verdict::Shorten(fault) => return self.shorten(from, fault),
                Verdict::Split(count) => {
                    let until = course.time;
                    self.refuse(from);
                    return Made::Split(Parts { until, count });
                }
                Verdict::NearSingular => {
                    let until = course.time;
                    self.refuse(from);
                    M::Rescue::take(self.course);
                    self.course.rescued = self.course.rescued.map(|_| until);
                    return Made::NearSingular;
                }
                Verdict::Refuse(fault) => {
                    self.refuse(from);
                    self.method.restart();
                    return Made::Ended(fault);
                }
            }
        };
        match guarded.watch.look_behind::<M, I>(course, guarded.kept, from, event) {
            Ok(event) => self
                .commit(from, (held, x), (accepted, drifted), event)
                .map_or_else(Made::Failed, |()| Made::Step),
            Err(fault) => {
                self.refuse(from);
                Made::Failed(fault)
            }
        }
    }

    /// Commits a step, with the discrete state and the state behind it: charts, revolutions, counters, what the method keeps of its
    /// end, which was projected if it had `drifted`; then the events there.
    #[inline]
    fn commit(
        &mut self,
        from: &Begun<M>,
        behind: (M::U, M::X),
        (Accepted { moved, turned, passed }, drifted): (Accepted, bool),
        event: Event,
    ) -> Result<(), Fault> {
        // Samples within the step belong to the modes that were held over it.
        self.observer.see(self.method, self.course)?;
        let Self { method, course, guarded, .. } = self;
        // What switches at once makes no step.
        if course.time > from.time {
            guarded.kept.see((&**method, course.system), || *from);
        }
        (course.held, course.x) = behind;
        course.stats.errs(method.estimate().error);
        course.stats.charts += u64::from(moved);
        course.stats.change_points += u64::from(passed.is_some());
        method.keep(drifted);
        if moved {
            method.restart();
        } else if turned {
            method.turned();
        }
        let before = self.modes();
        self.guarded.watch.switch(self.method, self.course, event)?;
        self.show_events(
            before,
            if let Event::At(index) = event { Trigger::Condition(index) } else { Trigger::Due },
        );
        Ok(())
    }

    /// Discrete state, state and number of events, for an observer that sees events.
    fn modes(&self) -> Option<(Begun<M>, u64)> {
        let Course { time, held, x, .. } = *self.course;
        O::SWITCHES.then_some((Begun { time, held, x }, self.course.stats.switches))
    }

    /// Shows the events since `before`.
    #[inline]
    fn show_events(&mut self, before: Option<(Begun<M>, u64)>, trigger: Trigger) {
        if let Some((before, _)) = before.filter(|(_, switches)| self.course.stats.switches > *switches) {
            self.observer.switched(self.course, &before, trigger);
        }
    }

    /// Makes sure that the modes of the conditions are those of the state.
    fn begin(&mut self) -> Result<(), Fault> {
        self.guarded.watch.begin(self.method, self.course)
    }

    /// Goes back to where a step began.
    fn refuse(&mut self, from: &Begun<M>) {
        let Self { course, guarded, .. } = self;
        // What switches at once had made none.
        let made = u64::from(course.time > from.time);
        (course.time, course.x) = (from.time, from.x);
        course.stats.steps -= made;
        course.stats.rejected += made;
        guarded.watch.forget();
    }

    /// Refuses a step for which a shorter one is tried.
    #[cold]
    fn shorten(&mut self, from: &Begun<M>, fault: Fault) -> Made<M::S> {
        let (h, time) = (self.course.time - from.time, self.course.time);
        self.refuse(from);
        let is_long = h > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * time.abs();
        if !(self.method.shorten(h) && is_long) {
            return Made::Failed(fault);
        }
        self.begin().map_or_else(Made::Failed, |()| Made::Shortened)
    }

    /// The same run with another method, or with another view of it.
    fn with<'s, J>(&'s mut self, method: &'s mut J, limits: Limits<M::S>) -> Advance<'s, 'c, M, J, O> {
        let Guarded { watch, kept, .. } = &mut self.guarded;
        let guarded = Guarded { watch: &mut **watch, kept: &mut **kept, limits };
        Advance { method, course: &mut *self.course, guarded, observer: &mut *self.observer }
    }

    /// Makes a step that is long beside the turn next to a flat pose in shorter steps of the same formula.
    #[cold]
    fn split(&mut self, parts: Parts<M::S>) -> Made<M::S> {
        let whole = core::mem::replace(&mut self.course.end, parts.until);
        let mut made = Made::Split(parts);
        while let Made::Split(Parts { until, count }) = made {
            let longest = (until - self.course.time) / M::S::lit(f64::from(count));
            let moves = longest > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * until.abs();
            made = match self.method.shorter(longest).filter(|_| moves) {
                Some(mut finer) => self.with(&mut finer, self.guarded.limits).follow(),
                None if M::Rescue::take(self.course) => Made::NearSingular,
                None => Made::Failed(self.course.fault(Cause::NotRegular)),
            };
        }
        self.course.end = whole;
        self.method.restart();
        if let (Made::Step, true) = (&made, self.course.time < whole)
            && let Err(fault) = self.method.begin(self.course)
        {
            return Made::Failed(fault);
        }
        made
    }

    /// Steps to the end of the course, until one is refused or only the near-singular method can go on.
    fn follow(&mut self) -> Made<M::S> {
        if let Err(fault) = self.begin().and_then(|()| self.method.begin(self.course)) {
            return Made::Failed(fault);
        }
        while self.course.time < self.course.end {
            if M::Rescue::holds(self.course) {
                return Made::NearSingular;
            }
            match self.step() {
                Made::Step | Made::Shortened => {}
                refused => return refused,
            }
        }
        Made::Step
    }

    /// Steps of the near-singular method, until the mechanism's own coordinates are regular again. Behind a fault only where it may
    /// come from a singular pose.
    #[cold]
    fn near_singular(&mut self, failed: Option<Fault>) -> Result<(), Fault> {
        if let Some(fault) = failed {
            if !(is_singular(&fault) && M::Rescue::take(self.course)) {
                return Err(fault);
            }
            self.guarded.watch.forget();
            self.begin()?;
        }
        // The energy is that of the mechanism's own coordinates.
        let limits = Limits { energy_jump: None, ..self.guarded.limits };
        let (mut rescue, mut refused) = (M::Rescue::new(), 0);
        while self.course.time < self.course.end && M::Rescue::holds(self.course) {
            self.course.check_steps(self.method.most_steps())?;
            let from: Begun<M> = Begun { time: self.course.time, held: self.course.held, x: self.course.x };
            let made = self.with(&mut rescue, limits).step();
            if let Made::Failed(fault) | Made::Ended(fault) = made {
                return Err(true_cause(failed, fault));
            }
            if self.course.time <= from.time {
                // The discrete state holds the pose.
                self.course.held = from.held;
                refused += 1;
                if refused > MOST_FAILURES {
                    return Err(failed.unwrap_or(self.course.fault(Cause::StepTooSmall { step: 0.0 })));
                }
                continue;
            }
            refused = 0;
            if let Some(part) = rescue.passed() {
                if limits.change_points {
                    let fault = Fault::of_part(self.course.time.to_f64(), part, Cause::ChangePoint);
                    (self.course.time, self.course.held, self.course.x) = (from.time, from.held, from.x);
                    return Err(fault);
                }
                self.course.stats.change_points += 1;
            }
        }
        self.method.restart();
        // The step before the turn was chosen without it.
        if let Some(h) = rescue.followed() {
            self.method.shorten(h + h);
        }
        if self.course.time < self.course.end { self.method.begin(self.course) } else { Ok(()) }
    }
}

/// The cause of a fault near a singular pose: that which the mechanism's own coordinates told, but where the motion ends there.
fn true_cause(failed: Option<Fault>, fault: Fault) -> Fault {
    match failed {
        Some(cause) if !matches!(fault.cause, Cause::LockedAt { .. }) => Fault { time: fault.time, ..cause },
        _ => fault,
    }
}

/// Can a fault come from a pose at which the mechanism's own coordinates are not regular?
fn is_singular(fault: &Fault) -> bool {
    use Cause::{
        Drift, Locked, NotConverged, NotFinite, Singular, StepTooLong, StepTooSmall, TurnedTooFar, Workspace,
    };
    matches!(
        fault.cause,
        Locked
            | TurnedTooFar { .. }
            | StepTooSmall { .. }
            | StepTooLong { .. }
            | NotConverged { .. }
            | NotFinite
            | Singular { .. }
            | Drift { .. }
            | Workspace { .. }
    )
}
