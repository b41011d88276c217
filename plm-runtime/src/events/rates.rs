//! Rates of change of guards at a state.

use super::here::guards;
use crate::enclosure::{Enclosed, Interval};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Rate of change of each guard at the state, per second; `None` if there is no rate.
pub(super) fn rates<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<M::G> {
    rates_of_both(context).map(|(_, slopes)| slopes)
}

/// Rates of change of the state and of each guard.
pub(super) fn rates_of_both<M: System<S: Real>>(context: &mut Context<'_, M>) -> Option<(M::X, M::G)> {
    let (time, x) = (context.time, context.x);
    let mut rate = x;
    context.rate(time, &x, &mut rate).ok()?;
    let moving = |s: M::S, slope: M::S| Enclosed { slope: Interval::point(slope), ..Enclosed::constant(s) };
    let mut slopes = M::G::fill(M::S::ZERO);
    let known = context.system.guards_within(
        moving(time, M::S::lit(1.0)),
        &context.held,
        &|i| moving(x.at(i), rate.at(i)),
        &mut |i, guard| {
            let Interval { low, high } = guard.slope;
            if i < M::G::LEN {
                slopes.set(i, M::S::lit(0.5) * (low + high));
            }
        },
    );
    if known {
        return Some((rate, slopes));
    }
    // By a difference quotient, if the system cannot enclose its guards.
    let h = M::S::EPSILON.sqrt() * (M::S::lit(1.0) + time.abs());
    let ahead = x.map2(&rate, |x, rate| x + h * rate);
    let guards = |t, x| guards(context.system, t, &context.held, x);
    let (here, ahead) = (guards(time, &x), guards(time + h, &ahead));
    Some((rate, ahead.map2(&here, |ahead, here| (ahead - here) / h)))
}
