//! A step of fixed length by itself, without a [`Sim`](crate::Sim): what targets run whose code holds the step of a
//! mechanism as straight lines.

use crate::contact::{Solution, Stride};
use crate::events;
use crate::fault::{Cause, Fault};
use crate::mechanism::{InPlace, Mechanism, Moment};
use crate::method::{
    Context, DriftCheck, Estimate, Formula, Length, Rk4Formula, Ros34Pw2Formula, Trial, unhealthy,
};
use crate::protocol::{Limits, Proposal, Rules, Verdict, judge};
use crate::scalar::{Real, Scalar};
use crate::sim::Stats;
use crate::singular::{Nearness, Rescue};
use crate::system::{Health, Rate, Step, System};
use crate::vector::Vector;

/// Drift that is tolerated, as a fraction of the typical coordinate and velocity; of what the scalar can resolve, if that is
/// more.
pub const DRIFT: f64 = 1e-10;

/// Rounding error of the time over steps by themselves. In `f32` a step of a millisecond is rounded to 0.977 ms after 1000 s, and to 0 or 2
/// ms after 20 000 s; so the rest of a step is added to the next one, as [`Sim::step`](crate::Sim::step) does.
///
/// It is no part of a state: two states are equal whatever it is.
#[derive(Clone, Copy, Debug)]
pub struct Remainder<S>(S);

impl<S: Real> Remainder<S> {
    /// Nothing is left out yet.
    #[inline]
    #[must_use]
    pub fn none() -> Self {
        Self(S::ZERO)
    }

    /// The end of a step of `h` from `time`, and the rounding error of that (W. Kahan, Further remarks on reducing truncation errors,
    /// Commun. ACM 8, 1965). A rest has no derivatives.
    #[inline]
    fn after(self, time: S, h: S) -> (S, Self) {
        let (now, length) = (time.plain(), h.plain() + self.0.plain());
        let end = now + length;
        ((time + h).with_plain(end), Self(S::of_plain(length - (end - now))))
    }
}

impl<S> PartialEq for Remainder<S> {
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

/// A [`Moment`] that is taken on by steps by themselves.
pub trait Stepped: Moment {
    /// The moment where it stands, and what rounding has left out of its time. [`Moment::set`] and [`Moment::in_place`] forget that.
    fn stepped(&mut self) -> (InPlace<'_, Self::M>, &mut Remainder<<Self::M as Rate>::S>);
}

/// Takes a mechanism on by a step of `h`, in s. The formula takes the state from the time to that plus `h`.
///
/// The new state is projected if it drifted. Conditions that are past their guards switch at the end of the step, as do those
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
    T: Stepped<M = M>,
{
    let (InPlace { system, held, time, x }, remainder) = moment.stepped();
    let (end, left_out) = remainder.after(*time, h);
    let (before, end) = ((*time, *x), end_of(system, held, (*time, h), end)?);
    let mut next = before.1;
    let health = formula(system, before.0, held, &mut next)?;
    if !(health.is_good() && next.is_finite()) {
        return Err(unhealthy(system, held, before, next));
    }
    let step = Step { system, held, from: (before.0, &before.1), to: (end, &next), health: health.0 };
    if !is_uneventful(&step) {
        // A copy: what is lent to a call stands in memory, and the state of a step without events stays in registers.
        next = arrive(system, held, (health.0, before), (end, next))?;
    }
    (*time, *x, *remainder) = (end, next, left_out);
    Ok(())
}

/// Takes a mechanism on by a step of `h`, in s, by the time stepping of Moreau and Jean with `theta`, 1/2 to 1, and so many evaluations of
/// the equations of motion: that of [`MoreauJean`](crate::MoreauJean). After it all is as after any [`step`].
///
/// # Errors
/// As [`step`].
#[inline]
pub fn moreau_jean<T, M, const EVALUATIONS: usize>(
    moment: &mut T,
    h: M::S,
    theta: M::S,
) -> Result<Solution<M::S>, Fault>
where
    M: Mechanism,
    T: Stepped<M = M>,
{
    const { assert!(EVALUATIONS > 0, "a step takes one evaluation or more") }
    let (InPlace { system, held, time, x }, remainder) = moment.stepped();
    let (end, left_out) = remainder.after(*time, h);
    let (before, end) = ((*time, *x), end_of(system, held, (*time, h), end)?);
    let (mut next, stride) = (before.1, Stride { t: before.0, h, theta });
    let solution =
        system.stride::<EVALUATIONS>(&stride, held, &mut next, |held, next, Solution { health, .. }| {
            if !(health.is_good() && next.is_finite()) {
                return Err(unhealthy(system, held, before, *next));
            }
            let step = Step {
                system,
                held: &*held,
                from: (before.0, &before.1),
                to: (end, &*next),
                health: health.0,
            };
            if !is_uneventful(&step) {
                *next = arrive(system, held, (health.0, before), (end, *next))?;
            }
            Ok(())
        })?;
    (*time, *x, *remainder) = (end, next, left_out);
    Ok(solution)
}

/// The `end` of a step of `h` from `time`, where one can begin. A step may be shorter than the rounding of the time: some of them together move it.
#[inline]
fn end_of<M: Mechanism>(system: &M, held: &M::U, (time, h): (M::S, M::S), end: M::S) -> Result<M::S, Fault> {
    if !system.is_regular(held) {
        return Err(not_regular(time));
    }
    // False for NaN.
    let moves = h > M::S::ZERO && end >= time;
    if moves { Ok(end) } else { Err(Fault::new(time.to_f64(), Cause::StepTooSmall { step: h.to_f64() })) }
}

/// True if nothing is to be done after a step. All conditions are evaluated at its end; of a loop in a good chart, only whether the state
/// is still near the last checked one.
#[inline]
fn is_uneventful<M: Mechanism>(step: &Step<'_, M>) -> bool {
    let &Step { system, held, from: (start, _), to: (end, x), .. } = step;
    system.is_settled(end, held, x)
        && !drifts(system, held, (end, x))
        && matches!(M::Rescue::nearness(step, Length::Alone), Nearness::Regular)
        && events::are_satisfied(system, end, held, x)
        && is_before_instants(system, held, (start, end))
}

/// Is the state too far from its constraints? A step with rows of contact has projected it.
#[inline]
fn drifts<M: System<S: Real>>(system: &M, held: &M::U, (t, x): (M::S, &M::X)) -> bool {
    let tolerance = M::S::lit(DRIFT).max(M::S::lit(64.0) * M::S::EPSILON);
    system.contact_count() == 0
        && DriftCheck::Above { tolerance, above: M::S::lit(1.0) }.fails((system, held), t, x)
}

/// Does no condition change in a step that the time alone decides?
#[inline]
fn is_before_instants<M: System<S: Real>>(system: &M, held: &M::U, (before, end): (M::S, M::S)) -> bool {
    system.next_time_event(before, held).is_none_or(|instant| instant > end)
}

/// Does what the judge says of a step, and commits its discrete state; the state then.
#[cold]
fn arrive<M: Mechanism>(
    system: &M,
    held: &mut M::U,
    (health, before): (M::S, (M::S, M::X)),
    (end, mut x): (M::S, M::X),
) -> Result<M::X, Fault> {
    if drifts(system, held, (end, &x)) {
        system.project(end, held, &mut x)?;
    }
    let rules = Rules { length: Length::Alone, drift: DriftCheck::Skip, limits: Limits::NONE };
    let mut after = *held;
    let mut proposal =
        Proposal { system, from: (before.0, &before.1), end, held: &mut after, x: &mut x, health };
    match judge(&mut proposal, Estimate::NONE, &rules) {
        Verdict::Accept(_) => {}
        Verdict::Project | Verdict::Split(_) | Verdict::NearSingular => return Err(not_regular(before.0)),
        Verdict::Shorten(fault) | Verdict::Refuse(fault) => return Err(fault),
    }
    if !system.is_regular(&after) {
        return Err(not_regular(before.0));
    }
    let violated = events::violated(system, end, &after, &x);
    if violated.is_some() || !is_before_instants(system, &after, (before.0, end)) {
        let (mut stats, mut longest) = (Stats::default(), end - before.0);
        let mut context = Context::new((system, after), (end, x), end, (&mut stats, &mut longest));
        context.health = health;
        switched(&mut context, before.0, violated.as_ref())?;
        (after, x) = (context.held, context.x);
    }
    *held = after;
    Ok(x)
}

/// Commits the events at the end of a step: of guards that are violated, and of the time.
fn switched<M: Mechanism>(
    context: &mut Context<'_, M>,
    before: M::S,
    violated: Option<&M::G>,
) -> Result<(), Fault> {
    if let Some(violated) = violated {
        events::switch_at_end(context, (violated, context.time - before))?;
    }
    if !is_before_instants(context.system, &context.held, (before, context.time)) {
        let (mut after, mut x) = (context.held, context.x);
        context.system.switch_at_time(context.time, &mut after, &mut x)?;
        events::hold(context, after)?;
        context.x = x;
    }
    Ok(())
}

#[cold]
fn not_regular<S: Real>(time: S) -> Fault {
    Fault::new(time.to_f64(), Cause::NotRegular)
}

/// W. Kutta's step outside the straight-line case: in another chart than the first, or with angles of many revolutions.
#[cold]
#[inline(never)]
pub fn rk4<M: System>(system: &M, t: M::S, u: &M::U, mut x: M::X, h: M::S) -> (M::X, Health<M::S>) {
    let health = Rk4Formula::plain_step(system, t, u, &mut x, h);
    (x, health)
}

/// Checks that linearised equations can be solved, by the `growth` of the products from which their pivots were taken.
///
/// # Errors
/// A fault if a pivot is nothing but rounding; `rows` is the number of states.
#[inline]
pub fn solvable<S: Real>(t: S, growth: S, rows: usize) -> Result<(), Fault> {
    // False for NaN.
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
    if error > M::S::lit(Ros34Pw2Formula::WORST_ERROR) {
        return Err(trial.largest(x, &system.typical()).fault(system, t, h));
    }
    *x = trial.x;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Remainder;

    /// Plain sums end at 991.14 s, and gain twice the time after 20 000 s.
    #[test]
    fn a_million_milliseconds_are_1000_s_in_f32() {
        for from in [0.0_f32, 1000.0, 20_000.0, 40_000.0] {
            let (mut time, mut remainder) = (from, Remainder::none());
            for _ in 0..1_000_000 {
                (time, remainder) = remainder.after(time, 1e-3);
            }
            assert!((time - from - 1000.0).abs() <= 4e-3, "{from}: {time}");
        }
    }
}
