//! A step of fixed length by itself, without a [`Sim`](crate::Sim): what targets run whose code holds the step of a
//! mechanism as straight lines.

use crate::events;
use crate::fault::{Cause, Fault};
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Course, Ros34Pw2Formula, Trial, drift_of_size, excess, not_finite};
use crate::scalar::{Real, Scalar};
use crate::sim::Stats;
use crate::singular::Rescue;
use crate::system::{Health, System};
use crate::vector::Vector;

/// Drift that is tolerated, as a fraction of the typical coordinate and velocity; of what the scalar can resolve, if that is
/// more.
const DRIFT: f64 = 1e-10;

/// Takes a mechanism on by a step of `h`, in s. The formula takes the state from the time to that plus `h`.
///
/// The new state is settled if it drifted. Conditions that are past their guards switch at the end of the step, as do those
/// that the time alone decides: what changes within a step acts from its end.
///
/// # Errors
/// When the step cannot be made, or its end cannot be the continuation of its beginning; where the equations are nearly
/// singular ([`Cause::NotRegular`]), for which a single step has no second way. The mechanism stays as it was.
#[inline]
pub fn step<T, M>(
    moment: &mut T,
    h: M::S,
    formula: impl FnOnce(&M, M::S, &M::U, &mut M::X) -> Result<Health<M::S>, Fault>,
) -> Result<(), Fault>
where
    M: Mechanism,
    T: Moment<M = M>,
{
    let (system, held, before) = (moment.mechanism(), moment.held(), (moment.time(), *moment.x()));
    let (time, mut x) = before;
    let end = time + h;
    if !system.is_regular(&held) {
        return Err(not_regular(time));
    }
    // False for what is not a number.
    let moves = end > time;
    if !moves {
        return Err(Fault::new(time.to_f64(), Cause::StepTooSmall { step: h.to_f64() }));
    }
    let health = formula(system, time, &held, &mut x)?;
    if !(health.is_good() && x.is_finite()) {
        return Err(unhealthy(system, &held, before, &x));
    }
    let (mut stats, mut longest) = (Stats::default(), h);
    let mut course = Course::new((system, held), (end, x), end, (&mut stats, &mut longest));
    course.health = health.0;
    arrive(&mut course, before)?;
    let (held, x) = (course.held, course.x);
    moment.set(end, &held, &x);
    Ok(())
}

/// What is looked at behind a step.
#[inline]
fn arrive<M: Mechanism>(course: &mut Course<'_, M>, before: (M::S, M::X)) -> Result<(), Fault> {
    let (system, end) = (course.system, course.time);
    let fraction = M::S::lit(DRIFT).max(M::S::lit(64.0) * M::S::EPSILON);
    let drift = system.drift(end, &course.x);
    if excess(drift, drift_of_size(system, fraction)) > M::S::lit(1.0) {
        system.settle(end, &mut course.x)?;
    }
    if M::Rescue::is_due(&course.leg((before.0, &before.1)), false) {
        return Err(not_regular(before.0));
    }
    system.accept(end, &mut course.held, &mut course.x)?;
    if !system.is_regular(&course.held) {
        return Err(not_regular(before.0));
    }
    events::switch_past(course)?;
    if system.next_instant(before.0, &course.held).is_some_and(|instant| instant <= end) {
        let mut after = course.held;
        system.pass(end, &mut after);
        events::hold(course, after)?;
    }
    Ok(())
}

/// Why the rates of a step are of no use.
#[cold]
fn unhealthy<M: System<S: Real>>(system: &M, held: &M::U, (time, x): (M::S, M::X), next: &M::X) -> Fault {
    let mut rate = x;
    match system.rate_by_rank(time, held, &x, &mut rate) {
        Err(fault) => fault,
        Ok(()) if !next.is_finite() => not_finite(system, time, next),
        Ok(()) => not_regular(time),
    }
}

#[cold]
fn not_regular<S: Real>(time: S) -> Fault {
    Fault::new(time.to_f64(), Cause::NotRegular)
}

/// Whether linearised equations can be solved, whose pivots were taken from products that were larger by `growth`.
///
/// # Errors
/// Where a pivot is nothing but rounding; `rows` is the number of states.
#[inline]
pub fn solvable<S: Real>(t: S, growth: S, rows: usize) -> Result<(), Fault> {
    // False for what is not a number.
    let is_small = growth * (S::lit(64.0) * S::EPSILON) < S::lit(1.0);
    if is_small { Ok(()) } else { Err(singular(t, rows)) }
}

/// The fault of linear equations that cannot be solved.
#[cold]
pub fn singular<S: Real>(t: S, rows: usize) -> Fault {
    Fault::new(t.to_f64(), Cause::Singular { rows })
}

/// Goes on from `x` to a state that a step of `h` at `t` has led to.
///
/// # Errors
/// When the estimate of its error is out of all proportion.
#[inline]
pub fn take<M: System<S: Real>>(
    system: &M,
    (t, h): (M::S, M::S),
    x: &mut M::X,
    trial: &Trial<M::X>,
) -> Result<(), Fault> {
    let error = trial.worst(x, &system.typical());
    *x = trial.x;
    if error > M::S::lit(Ros34Pw2Formula::WORST_ERROR) {
        let cause = Cause::StepTooLong { step: h.to_f64(), error: error.to_f64() };
        return Err(Fault::new(t.to_f64(), cause));
    }
    Ok(())
}
