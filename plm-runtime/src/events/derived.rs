//! Derivatives of the time of an event and of the state there.
//!
//! An event occurs at the zero of its guard: t(p) with g(t(p), x(t(p), p), p) = 0, so that t' = -g' / (dg/dt), where g' are the derivatives
//! at a fixed time. State and time move along the rate before the event by t'. The change at the event and the rate after it are evaluated
//! with derivatives; together they give the jump of the derivatives (M. A. Aizerman, F. R. Gantmakher, Determination of stability by linear
//! approximation of a periodic solution of a system of differential equations with discontinuous right-hand sides, Q. J. Mech. Appl. Math.
//! 11, 1958).

use super::boundary::rates_of_both;
use super::guards;
use super::rounding::rounding;
use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Corrections of the time: slopes of guards that are difference quotients have half of all digits, so that one is not enough.
const CORRECTIONS: usize = 2;
/// A guard, or its change, counts as zero up to so many times its rounding.
const MANY: f64 = 1e3;
/// A guard that goes beyond its boundary by at most so many times its rounding touches it.
const GRAZE: f64 = 8.0;
/// Distance before the end of a step, as a fraction of it, at which a second slope gives the second derivative of a guard.
const BACK: f64 = 1e-3;
/// Relative difference of derivatives below which two event times are equal.
const SAME: f64 = 1e-6;

/// Result of [`derive_time`].
pub(super) enum Timed<S> {
    /// This event, whose time has moved by so much.
    Event(usize, S),
    /// No event, for numbers with one-sided derivatives: the guard is beyond its boundary by rounding, and goes no farther than this value.
    Touch(S),
}

/// Gives the time reached, at which the event `index` ends a step of this length, and the state there the derivatives that follow from the
/// motion of the event. Their values stay, to the bit. An event that another one causes at once has the time of that one. Numbers with
/// one-sided derivatives have the first event of those at this time.
///
/// # Errors
/// [`Cause::Grazes`] if the guard does not cross its boundary, and [`Cause::AtOnce`] if another event happens at this time whose time has
/// other derivatives.
pub(super) fn derive_time<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    index: usize,
    step: M::S,
) -> Result<Timed<M::S>, Fault> {
    let mut moved = M::S::ZERO;
    if !M::S::HAS_DERIVATIVES {
        return Ok(Timed::Event(index, moved));
    }
    let index = match own_time(context, index, step)? {
        Time::Own(index, _) => index,
        Time::OfAnother => return Ok(Timed::Event(index, moved)),
        Time::Never(depth) => return Ok(Timed::Touch(-depth)),
    };
    for _ in 0..CORRECTIONS {
        let here = guards(context.system, context.time, &context.held, &context.x);
        let Some((rate, slopes)) = rates_of_both(context) else { break };
        let ahead = time_to(&here, &slopes, index);
        moved = moved + ahead;
        context.time = context.time + ahead;
        context.x = context.x.map2(&rate, |x, rate| x + ahead * rate);
    }
    Ok(Timed::Event(index, moved))
}

/// Change of the time at which an event ends a step of this length, for a repetition of the step: its value is zero, and it has
/// derivatives. `None` for numbers without derivatives, and if [`derive_time`] has to decide.
pub(super) fn moved_end<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    index: usize,
    step: M::S,
) -> Option<M::S> {
    if !M::S::HAS_DERIVATIVES {
        return None;
    }
    match own_time(context, index, step) {
        Ok(Time::Own(own, ahead)) if own == index => Some(ahead),
        _ => None,
    }
}

/// Time of an event.
enum Time<S> {
    /// The time at which the guard of this event has come to its boundary, and its distance ahead, which has derivatives only.
    Own(usize, S),
    /// The time of another event, which moved the guard to its boundary.
    OfAnother,
    /// No time: the guard stays away from its boundary, apart from so much rounding.
    Never(S),
}

/// Time of the event `index`, or of the event that has to happen first.
fn own_time<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    index: usize,
    step: M::S,
) -> Result<Time<M::S>, Fault> {
    let (time, x) = (context.time, context.x);
    let here = guards(context.system, time, &context.held, &x);
    let Some((rate, slopes)) = rates_of_both(context) else { return Ok(Time::OfAnother) };
    let rounded = rounding((context.system, &context.held), (time, time), &x, &here);
    let noise = |i: usize| M::S::lit(MANY) * rounded.at(i);
    let falls = |i: usize, within: M::S| -(within * slopes.at(i)) > noise(i);
    let vanishes = |i: usize| here.at(i).abs() <= noise(i);
    let fault = |context: &Context<'_, M>, index: usize, cause| {
        Err(Fault::of_part(time.to_f64(), context.system.guard_name(index), cause))
    };
    let of_all = |i: usize| time_to(&here, &slopes, i);
    let own = |i: usize| Time::Own(i, of_all(i));
    if !falls(index, step) {
        let has_come = vanishes(index) && falls(index, M::S::lit(1.0));
        return Ok(if has_come { own(index) } else { Time::OfAnother });
    }
    let meets = |i: &usize| *i != index && vanishes(*i) && falls(*i, step);
    let differs = |i: &usize| !of_all(index).has_derivatives_of(of_all(*i), SAME);
    let mut first = index;
    if let Some(other) = (0..M::G::LEN).filter(meets).find(differs) {
        let is_sooner = |i: usize, first: usize| of_all(i).goes() < of_all(first).goes();
        if of_all(index).goes().is_none() {
            return fault(context, index, Cause::AtOnce { other: context.system.guard_name(other) });
        }
        let others = (0..M::G::LEN).filter(meets);
        first = others.fold(index, |first, i| if is_sooner(i, first) { i } else { first });
    }
    let depth = M::S::lit(GRAZE) * rounded.at(first);
    if grazes(context, (first, step), (&rate, &slopes), depth) {
        return match here.at(first).goes() {
            Some(away) if away > 0.0 => Ok(Time::Never(depth + depth)),
            Some(0.0) => Ok(own(first)),
            _ => fault(context, first, Cause::Grazes),
        };
    }
    Ok(own(first))
}

/// Time to the zero of a guard: its value is zero, its derivatives are those of the time of the event.
fn time_to<S: Real, G: Vector<S>>(here: &G, slopes: &G, index: usize) -> S {
    -here.at(index).as_zero() / slopes.at(index)
}

/// True if a guard turns back before it is farther beyond its boundary than `noise`. A parabola reaches slope^2/(2 bend).
fn grazes<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    (index, step): (usize, M::S),
    (rate, slopes): (&M::X, &M::G),
    noise: M::S,
) -> bool {
    let (time, x, slope) = (context.time, context.x, slopes.at(index));
    let back = M::S::lit(BACK) * step;
    (context.time, context.x) = (time - back, x.map2(rate, |x, rate| x - back * rate));
    let before = rates_of_both(context);
    (context.time, context.x) = (time, x);
    let bend = before.map_or(M::S::ZERO, |(_, before)| (slope - before.at(index)).abs() / back);
    slope * slope <= M::S::lit(2.0) * bend * noise
}

/// Moves the state after an event back along the rate there by `moved`, the change of its time, since the step ends at a fixed time.
pub(super) fn restore_time<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    moved: M::S,
) -> Result<(), Fault> {
    if M::S::HAS_DERIVATIVES {
        let (time, x) = (context.time, context.x);
        let mut rate = x;
        context.rate(time, &x, &mut rate)?;
        (context.time, context.x) = (time - moved, x.map2(&rate, |x, rate| x - moved * rate));
    }
    Ok(())
}
