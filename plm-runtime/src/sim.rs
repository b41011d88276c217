//! A running simulation: a mechanism at a moment, a method, and what was done.

mod audit;
mod changes;
mod clock;
mod samples;
mod told;

use self::audit::audit;
pub(crate) use self::clock::Clock;
use self::samples::{Observer, Sampler, Unobserved};
pub use self::told::{Notice, Stats};
use crate::events::{self, Watch};
use crate::fault::{Cause, Fault};
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, Dop853, Method};
use crate::scalar::{Real, Scalar};
use crate::singular::Rescue;
use crate::system::{Accepted, Drift, System};

/// A running simulation.
///
/// It dereferences to the mechanism's state: `sim.arm_angle()`, `sim.input.drive = 1.0`. Any mutable access makes the
/// method forget the rate that it had kept, because state, parameters or inputs may have been changed. The next step looks
/// at what was: a parameter whose value the equations do not allow is a fault, and one that joints read makes it assemble
/// anew from the present pose ([`Mechanism::renew`]).
#[derive(Clone, Copy)]
pub struct Sim<M: Mechanism, I = Dop853<M>> {
    pub(crate) state: M::State,
    pub(crate) method: I,
    pub(crate) stats: Stats,
    pub(crate) watch: Watch<M::S, M::G>,
    pub(crate) limits: Limits<M::S>,
    /// What rounding has left out of the time.
    pub(crate) clock: Clock<M::S>,
    /// The longest step so far, s.
    pub(crate) longest_step: M::S,
    /// Before this time an interval may end.
    latest: M::S,
    /// What the parameters were when they were looked at last.
    parameters: u64,
}

/// A simulation as it was at one moment; resuming from it gives the same bits again.
#[derive(Clone, Copy)]
pub struct Snapshot<M: Mechanism, I = Dop853<M>>(Sim<M, I>);

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// A simulation that begins in `state`.
    pub fn new(state: M::State, method: I) -> Self {
        Self {
            parameters: state.mechanism().fingerprint(),
            state,
            method,
            stats: Stats::default(),
            watch: Watch::new(),
            limits: Limits { energy_jump: None, change_points: false },
            clock: Clock { time: M::S::ZERO, rest: M::S::ZERO },
            longest_step: M::S::ZERO,
            latest: Self::end_of_time(),
        }
    }

    /// Runs for the communication interval `dt`, in s, and ends exactly there.
    ///
    /// What rounding leaves out of the time is made up for by the intervals that follow: a million of a millisecond end
    /// at 1000 s, in `f32` as well.
    ///
    /// # Errors
    /// When the interval cannot be integrated; the state is then that of the last accepted step.
    #[inline]
    pub fn step(&mut self, dt: M::S) -> Result<(), Fault> {
        let clock = self.clock.after(self.state.time(), dt);
        self.advance(clock.time, dt, &mut Unobserved)?;
        self.clock = clock;
        Ok(())
    }

    /// Runs until the time `until` and gives a sample at the current time and after every `every`, in s.
    ///
    /// Methods with dense output are not made to step shorter by samples. A sample that drifted is settled.
    ///
    /// # Errors
    /// When the run cannot be continued; the samples before that moment have been given. Before all, when `until` has passed,
    /// or when `every` is not positive or too short to move the time.
    pub fn run(&mut self, until: M::S, every: M::S, mut sample: impl FnMut(&M::State)) -> Result<(), Fault> {
        let start = self.state.time();
        let (length, one) = (until - start, M::S::lit(1.0));
        if !(until >= start && until.is_finite()) {
            return Err(self.bad_interval(length));
        }
        let ulp = M::S::EPSILON * start.abs().max(until.abs());
        if !(every > M::S::ZERO && every > M::S::lit(4.0) * ulp) {
            return Err(self.bad_interval(every));
        }
        self.take_changes()?;
        // Rounding must not cost the last sample.
        let last = (length / every * (one + M::S::lit(16.0) * M::S::EPSILON)).floor();
        let time_of = |k: M::S| (start + k * every).min(until);
        sample(&self.state);
        let mut k = one;
        if !I::DENSE {
            while k <= last {
                self.advance(time_of(k), every, &mut Unobserved)?;
                sample(&self.state);
                k = k + one;
            }
            return self.advance(until, length, &mut Unobserved);
        }
        let mut sampler = Sampler { next: one, last, time_of, moment: self.state, sample };
        self.advance(until, length, &mut sampler)
    }

    /// Projects the state onto its constraints.
    ///
    /// After a run that has ended with [`Cause::Drift`] the state is that before the step, which was on its constraints: to
    /// settle it changes nothing.
    ///
    /// # Errors
    /// When the projection does not converge, or a parameter has been changed to what cannot be.
    pub fn settle(&mut self) -> Result<(), Fault> {
        self.take_changes()?;
        let (time, mut x) = (self.state.time(), *self.state.x());
        self.state.mechanism().settle(time, &mut x)?;
        let held = self.state.held();
        self.state.set(time, &held, &x);
        self.stats.settled += 1;
        self.forget();
        Ok(())
    }

    /// How far the state is from its constraints, with the parameters as they are.
    pub fn drift(&self) -> Drift<M::S> {
        self.state.mechanism().opening(self.state.time(), &self.state.held(), self.state.x())
    }

    /// The mechanism at the current moment.
    pub fn state(&self) -> &M::State {
        &self.state
    }

    /// The method and its options.
    pub fn method(&self) -> &I {
        &self.method
    }

    /// The method, to change its options.
    pub fn method_mut(&mut self) -> &mut I {
        &mut self.method
    }

    /// What was done so far.
    pub fn stats(&self) -> Stats {
        Stats { longest_step: self.longest_step.to_f64(), ..self.stats }
    }

    /// What the user should know although the run goes on.
    pub fn notice(&self) -> Option<Notice> {
        let alpha = self.state.mechanism().baumgarte_rate().unwrap_or_default();
        let h_alpha = self.longest_step.to_f64() * alpha;
        if h_alpha > 0.5 {
            return Some(Notice::StiffStabilisation { h_alpha });
        }
        let conditions = self.stats.passed_over;
        (conditions > 0).then_some(Notice::PassedOver { conditions })
    }

    /// Ends the run, before the step, where a loop passes a pose in which it could go on in several ways; if not, the run
    /// goes on as the motion does, and the pose is counted.
    pub fn stop_at_change_points(&mut self, stop: bool) {
        self.limits.change_points = stop;
    }

    /// Ends a step in which kinetic and potential energy less the work of the forces change by more than this fraction of
    /// what moves (the kinetic energy or the work in the step). It guards against formulas, parts and step lengths that
    /// are wrong; 0.1 is a good value. It costs two evaluations of all outputs a step, and is off at first. Prescribed motions do
    /// work that is not accounted for, so that nothing is looked at where there are some.
    pub fn watch_energy(&mut self, fraction: Option<M::S>) {
        self.limits.energy_jump = fraction;
    }

    /// Everything that decides how the run goes on.
    pub fn save(&self) -> Snapshot<M, I> {
        Snapshot(*self)
    }

    /// Goes on from a saved moment.
    pub fn resume(&mut self, snapshot: &Snapshot<M, I>) {
        *self = snapshot.0;
    }

    /// Advances to `end`, which is to be `length` from here; `observer` sees every accepted step.
    fn advance(&mut self, end: M::S, length: M::S, observer: &mut impl Observer<M>) -> Result<(), Fault> {
        let time = self.state.time();
        if !(end >= time && end < self.latest) {
            self.begin(end, length)?;
        }
        let Self { state, method, stats, watch, limits, longest_step, .. } = self;
        let limits = *limits;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut course = Course::new((system, held), (time, x), end, (stats, longest_step));
        let mut outcome = Ok(());
        while outcome.is_ok() && course.time < end {
            let instant = system.next_instant(course.time, &course.held);
            let instant = instant.filter(|instant| *instant > course.time && *instant <= end);
            course.end = instant.unwrap_or(end);
            outcome = stretch(method, &mut course, (watch, limits), observer);
            match outcome {
                Ok(()) if instant.is_some() => outcome = pass(method, &mut course, watch),
                Ok(()) => {}
                Err(fault) => outcome = Err(events::at_a_jump(&course, fault)),
            }
        }
        let (time, held, x) = (course.time, course.held, course.x);
        state.set(time, &held, &x);
        outcome
    }

    /// Something may have been changed from outside.
    fn forget(&mut self) {
        self.method.restart();
        self.watch.forget();
    }
}

/// Steps of fixed length that fail one after the other, and are divided each time, until the run ends: they are too long.
const MOST_FAILURES: u32 = 100;

/// Advances to the end of the course; no known time lies before it.
fn stretch<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    guarded: Guarded<'_, M>,
    observer: &mut impl Observer<M>,
) -> Result<(), Fault> {
    guarded.0.begin(method, course)?;
    method.begin(course)?;
    go_on(method, course, guarded, (Ok(()), observer))
}

/// Advances to the end of the course from a step that may have failed.
pub(crate) fn alone<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    guarded: Guarded<'_, M>,
    failed: Result<(), Fault>,
) -> Result<(), Fault> {
    method.begin(course)?;
    go_on(method, course, guarded, (failed, &mut Unobserved))
}

/// Steps to the end of the course; near singular poses, and where one fails that cannot be shortened, by the rescue.
fn go_on<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    (mut outcome, observer): (Result<(), Fault>, &mut impl Observer<M>),
) -> Result<(), Fault> {
    let mut failures = 0;
    while course.time < course.end {
        if outcome.is_ok() && !M::Rescue::holds(course) {
            outcome = step(method, course, (&mut *watch, limits), observer);
        }
        failures = if outcome.is_ok() { 0 } else { failures + 1 };
        if failures > MOST_FAILURES {
            return outcome;
        }
        if M::Rescue::holds(course) || outcome.is_err() {
            rescue(method, course, (&mut *watch, limits), (outcome, observer))?;
            outcome = Ok(());
        }
    }
    outcome
}

/// One step; it may be refused, and is not made then.
#[inline]
fn step<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    observer: &mut impl Observer<M>,
) -> Result<(), Fault> {
    let before = (course.time, course.x);
    course.health = M::S::lit(1.0);
    let due = watch.step(method, course)?;
    if came_near(course, before, watch) {
        return Ok(());
    }
    let Some(next) = look(method, course, (watch, limits), before)? else { return Ok(()) };
    // Samples within the step belong to what was held over it.
    observer.see(method, course)?;
    next.hold(method, course);
    watch.switch(method, course, due)
}

/// Steps near singular poses, until the mechanism's own coordinates are regular again; also where they are said to be
/// singular by what a step has led to.
#[cold]
fn rescue<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    (failed, observer): (Result<(), Fault>, &mut impl Observer<M>),
) -> Result<(), Fault> {
    if let Err(fault) = failed {
        if !(is_singular(&fault) && M::Rescue::take(course)) {
            return Err(fault);
        }
        watch.forget();
        watch.begin(method, course)?;
    }
    // The energy is that of the mechanism's own coordinates.
    let limits = Limits { energy_jump: None, ..limits };
    let mut rescue = M::Rescue::new();
    while course.time < course.end && M::Rescue::holds(course) {
        let before = (course.time, course.held, course.x);
        let outcome = step(&mut rescue, course, (&mut *watch, limits), observer);
        // The cause is that which the mechanism's own coordinates tell.
        outcome.map_err(|fault| failed.err().map_or(fault, |cause| Fault { time: fault.time, ..cause }))?;
        if course.time <= before.0 {
            // What is held is the pose; the step was refused.
            course.held = before.1;
            continue;
        }
        if let Some(part) = rescue.passed() {
            if limits.change_points {
                let fault = Fault::of_part(course.time.to_f64(), part, Cause::ChangePoint);
                (course.time, course.held, course.x) = before;
                return Err(fault);
            }
            course.stats.change_points += 1;
        }
    }
    method.restart();
    if course.time < course.end { method.begin(course) } else { Ok(()) }
}

/// Can a fault come from a pose at which the mechanism's own coordinates are not regular?
fn is_singular(fault: &Fault) -> bool {
    use Cause::{Locked, NotConverged, NotFinite, Singular, StepTooSmall, TurnedTooFar};
    let cause = &fault.cause;
    matches!(
        cause,
        Locked
            | TurnedTooFar { .. }
            | StepTooSmall { .. }
            | NotConverged { .. }
            | NotFinite
            | Singular { .. }
    )
}

/// What ends a run although its state could be continued.
#[derive(Clone, Copy)]
pub(crate) struct Limits<S> {
    /// The energy jumps by more than this fraction.
    energy_jump: Option<S>,
    /// A loop can go on in several ways.
    change_points: bool,
}

impl<S> Limits<S> {
    /// Every step is compared with the one before.
    #[inline]
    pub(crate) fn audit(&self) -> bool {
        self.energy_jump.is_some()
    }
}

/// Guards and limits of a run.
type Guarded<'w, M> = (&'w mut Watch<<M as System>::S, <M as System>::G>, Limits<<M as System>::S>);

/// A step that was refused is not shortened below so many units in the last place of the time.
const SHORTEST_ULPS: f64 = 64.0;

/// What a look at the state reached has found.
pub(crate) struct Next<M: System> {
    accepted: Accepted,
    held: M::U,
    x: M::X,
}

/// Lets the system look at the state reached. One that it refuses is not kept: none, if a shorter step is to be tried.
pub(crate) fn look<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    before: (M::S, M::X),
) -> Result<Option<Next<M>>, Fault> {
    let (mut held, mut x) = (course.held, course.x);
    let audited = limits.energy_jump.map_or(Ok(()), |fraction| audit(course, fraction, &before));
    match audited.and_then(|()| course.system.accept(course.time, &mut held, &mut x)) {
        Ok(Accepted { passed: Some(part), .. }) if limits.change_points => {
            let fault = Fault::of_part(course.time.to_f64(), part, Cause::ChangePoint);
            (course.time, course.x) = before;
            method.restart();
            watch.forget();
            Err(fault)
        }
        Ok(accepted) => Ok(Some(Next { accepted, held, x })),
        Err(fault) => {
            let (h, time) = (course.time - before.0, course.time);
            refuse(course, before, watch);
            if method.shorten(h) && h > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * time.abs() {
                watch.begin(method, course)?;
                return Ok(None);
            }
            Err(fault)
        }
    }
}

/// Has the last step led over nearly singular poses? It is taken back then.
#[inline]
pub(crate) fn came_near<M: Mechanism>(
    course: &mut Course<'_, M>,
    before: (M::S, M::X),
    watch: &mut Watch<M::S, M::G>,
) -> bool {
    let due = M::Rescue::is_due(course);
    if due {
        course.rescued = Some(course.time);
        refuse(course, before, watch);
    }
    due
}

/// Goes back to where a step began; what switched at once had made none.
fn refuse<M: Mechanism>(course: &mut Course<'_, M>, before: (M::S, M::X), watch: &mut Watch<M::S, M::G>) {
    let made = u64::from(course.time > before.0);
    (course.time, course.x) = before;
    course.stats.steps -= made;
    course.stats.rejected += made;
    watch.forget();
}

impl<M: Mechanism> Next<M> {
    /// Goes on with it.
    pub(crate) fn hold<I: Method<M>>(self, method: &mut I, course: &mut Course<'_, M>) {
        (course.held, course.x) = (self.held, self.x);
        course.stats.charts += u64::from(self.accepted.moved);
        course.stats.change_points += u64::from(self.accepted.passed.is_some());
        if self.accepted.moved {
            method.restart();
        }
    }
}

/// Holds what applies after the known time that was reached.
fn pass<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    watch: &mut Watch<M::S, M::G>,
) -> Result<(), Fault> {
    let mut after = course.held;
    course.system.pass(course.time, &mut after);
    events::hold(course, after)?;
    course.stats.switches += 1;
    method.restart();
    watch.forget();
    Ok(())
}
