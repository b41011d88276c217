//! Steps one after the other: made by the method, looked at by the system, and by the rescue near singular poses.

use super::audit::audit;
use super::kept::Begun;
use super::samples::{Observer, Unobserved, What};
use crate::events::{self, Watch};
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Course, Divided, Method};
use crate::scalar::{Real, Scalar};
use crate::singular::Rescue;
use crate::system::{Accepted, System};

/// Steps of fixed length that fail one after the other, and are divided each time, until the run ends: they are too long.
const MOST_FAILURES: u32 = 100;

/// Advances to the end of the course; no known time lies before it.
pub(super) fn stretch<M: Mechanism, I: Method<M>, O: Observer<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    guarded: Guarded<'_, M>,
    observer: &mut O,
) -> Result<(), Fault> {
    let before = O::SWITCHES.then_some((course.held, course.stats.switches));
    guarded.0.begin(method, course)?;
    tell(course, observer, before, What::Due);
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
        if let Some(fault) = course.senseless.take() {
            return Err(fault);
        }
        if outcome.is_ok() && course.divided.is_none() && !M::Rescue::holds(course) {
            outcome = step(method, course, (&mut *watch, limits), observer, false);
        }
        if let Some(divided) = course.divided.take() {
            outcome = in_parts(method, course, (&mut *watch, limits), (divided, observer));
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

/// One step; it may be refused, and is not made then. The rescue's own may lead over singular poses.
#[inline]
fn step<M: Mechanism, I: Method<M>, O: Observer<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    observer: &mut O,
    by_rescue: bool,
) -> Result<(), Fault> {
    let before = (course.time, course.x);
    let held = course.held;
    course.health = M::S::lit(1.0);
    let due = watch.step(method, course)?;
    if !by_rescue && came_near::<M, I>(course, before, watch) {
        return Ok(());
    }
    let Some(next) = look(method, course, (watch, limits), before)? else { return Ok(()) };
    // Samples within the step belong to what was held over it.
    observer.see(method, course)?;
    // What switches at once makes no step.
    if let Some(kept) = course.kept.as_deref_mut().filter(|_| course.time > before.0) {
        kept.see((&*method, course.system), || Begun { time: before.0, held, x: before.1 });
    }
    next.hold(method, course);
    let before = O::SWITCHES.then_some((course.held, course.stats.switches));
    watch.switch(method, course, due)?;
    tell(course, observer, before, due.map_or(What::Due, What::Condition));
    Ok(())
}

/// Tells an observer of what has switched, who gave what was held `before` and how much had switched then.
#[inline]
fn tell<M: Mechanism>(
    course: &Course<'_, M>,
    observer: &mut impl Observer<M>,
    before: Option<(M::U, u64)>,
    what: What,
) {
    if let Some((held, _)) = before.filter(|(_, switches)| course.stats.switches > *switches) {
        observer.switched(course, &held, what);
    }
}

/// A step that is long beside the turn which the mechanism makes next to a flat pose, in shorter steps of the same formula.
#[cold]
fn in_parts<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    (divided, observer): (Divided<M::S>, &mut impl Observer<M>),
) -> Result<(), Fault> {
    let whole = core::mem::replace(&mut course.end, divided.until);
    let (mut outcome, mut due) = (Ok(()), Some(divided));
    while let (Ok(()), Some(Divided { until, parts })) = (outcome, due) {
        let longest = (until - course.time) / M::S::lit(f64::from(parts));
        let moves = longest > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * until.abs();
        outcome = match method.shorter(longest).filter(|_| moves) {
            Some(mut finer) => follow(&mut finer, course, (&mut *watch, limits), observer),
            None if M::Rescue::take(course) => Ok(()),
            None => Err(course.fault(Cause::NotRegular)),
        };
        due = course.divided.take();
    }
    course.end = whole;
    method.restart();
    if outcome.is_ok() && course.time < course.end { method.begin(course) } else { outcome }
}

/// Steps to the end of the course, until one is to be divided or the rescue takes over.
fn follow<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    (watch, limits): Guarded<'_, M>,
    observer: &mut impl Observer<M>,
) -> Result<(), Fault> {
    watch.begin(method, course)?;
    method.begin(course)?;
    while course.time < course.end
        && course.divided.is_none()
        && course.senseless.is_none()
        && !M::Rescue::holds(course)
    {
        step(method, course, (&mut *watch, limits), observer, false)?;
    }
    Ok(())
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
    let (mut rescue, mut refused) = (M::Rescue::new(), 0);
    while course.time < course.end && M::Rescue::holds(course) {
        course.check_steps(method.most_steps())?;
        let before = (course.time, course.held, course.x);
        let outcome = step(&mut rescue, course, (&mut *watch, limits), observer, true);
        // The cause is that which the mechanism's own coordinates tell, but where the rescue knows that the motion ends.
        outcome.map_err(|fault| match failed {
            Err(cause) if !matches!(fault.cause, Cause::LockedAt { .. }) => {
                Fault { time: fault.time, ..cause }
            }
            _ => fault,
        })?;
        if course.time <= before.0 {
            // What is held is the pose; the step was refused.
            course.held = before.1;
            refused += 1;
            if refused > MOST_FAILURES {
                return Err(failed.err().unwrap_or(course.fault(Cause::StepTooSmall { step: 0.0 })));
            }
            continue;
        }
        refused = 0;
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
    // The turn is behind, and the step before it was chosen without it.
    if let Some(h) = rescue.followed() {
        method.shorten(h + h);
    }
    if course.time < course.end { method.begin(course) } else { Ok(()) }
}

/// Can a fault come from a pose at which the mechanism's own coordinates are not regular?
fn is_singular(fault: &Fault) -> bool {
    use Cause::{
        Drift, Locked, NotConverged, NotFinite, Singular, StepTooLong, StepTooSmall, TurnedTooFar, Workspace,
    };
    let cause = &fault.cause;
    matches!(
        cause,
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

/// What ends a run although its state could be continued.
#[derive(Clone, Copy)]
pub(crate) struct Limits<S> {
    /// The energy jumps by more than this fraction.
    pub(super) energy_jump: Option<S>,
    /// A loop can go on in several ways.
    pub(super) change_points: bool,
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
        Ok(_) if method.estimate().is_senseless() => {
            let fault = method.estimate().fault(course.system, before.0, course.time - before.0);
            refuse(course, before, watch);
            course.senseless = Some(fault);
            Ok(None)
        }
        Ok(accepted) => {
            course.stats.errs(method.estimate().error);
            Ok(Some(Next { accepted, held, x }))
        }
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

/// Has the last step led over nearly singular poses, or next to them by too far? It is taken back then.
#[inline]
pub(crate) fn came_near<M: Mechanism, I: Method<M>>(
    course: &mut Course<'_, M>,
    before: (M::S, M::X),
    watch: &mut Watch<M::S, M::G>,
) -> bool {
    let leg = course.leg((before.0, &before.1));
    let parts = if I::DENSE { 1 } else { M::Rescue::parts(&leg, I::CAUTION) };
    let due = parts > 1 || M::Rescue::is_due(&leg, I::DENSE);
    if due {
        let until = course.time;
        refuse(course, before, watch);
        if parts > 1 {
            course.divided = Some(Divided { until, parts });
        } else {
            M::Rescue::take(course);
            course.rescued = course.rescued.map(|_| until);
        }
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
        } else if self.accepted.turned {
            method.turned();
        }
    }
}

/// Holds what applies after the known time that was reached.
pub(super) fn pass<M: Mechanism, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    watch: &mut Watch<M::S, M::G>,
    observer: &mut impl Observer<M>,
) -> Result<(), Fault> {
    let (before, mut after) = (course.held, course.held);
    course.system.pass(course.time, &mut after);
    events::hold(course, after)?;
    course.stats.switches += 1;
    method.restart();
    watch.forget();
    observer.switched(course, &before, What::Time);
    Ok(())
}
