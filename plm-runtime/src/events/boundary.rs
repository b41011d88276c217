//! Guards that are zero within rounding at the start of a run or after a change by the caller: their rates decide the mode.

use super::rates::rates;
use super::relevant::bit;
use super::requirements::not_met;
use super::rounding::rounding;
use crate::fault::Fault;
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::tolerances::{FAR_FROM_ZERO, STATE_ROUNDED};
use crate::vector::Vector;

/// Conditions whose boundaries the state is on.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Boundary {
    /// Conditions whose sides have been decided, one bit each: their guards are not checked again.
    pub(super) decided: u64,
    /// Conditions that have changed their sides, one bit each.
    pub(super) switched: u64,
}

/// Decides the sides of the conditions whose boundaries the state is on, of the first 64, by the direction of the rate. During a run only
/// guards that are not positive are examined. A requirement that the rate leads away from is not satisfied.
pub(super) fn decide<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    here: &M::G,
    is_new: bool,
) -> Result<Boundary, Fault> {
    let mut boundary = Boundary::default();
    let has_band = |i: usize| context.system.band(i) > M::S::ZERO;
    let asks = |i: usize| bit(i) != 0 && !has_band(i) && (is_new || here.at(i) <= M::S::ZERO);
    let asked = (0..M::G::LEN).filter(|i| asks(*i)).fold(0, |asked, i| asked | bit(i));
    if asked == 0 || !context.system.is_regular(&context.held) {
        return Ok(boundary);
    }
    let (time, x) = (context.time, context.x);
    let noise = rounding((context.system, &context.held), (time, time), &x, here);
    let ulps = STATE_ROUNDED.of::<M::S>() * M::S::EPSILON * time.abs();
    let mut slopes = None;
    for i in (0..M::G::LEN).filter(|i| asked & bit(*i) != 0) {
        let size = here.at(i).abs();
        // The time of an event has rounding errors, in which the state may have gone on.
        let reach = |slope: M::S| noise.at(i) + ulps * slope.abs();
        let far = size > FAR_FROM_ZERO.of::<M::S>() * noise.at(i);
        if far || !noise.at(i).is_finite() {
            continue;
        }
        let slope = match slopes {
            Some(known) => known,
            None => match rates(context) {
                Some(found) => *slopes.insert(found),
                None => return Ok(boundary),
            },
        };
        let slope = slope.at(i);
        if size > reach(slope) {
            continue;
        }
        if slope >= M::S::ZERO {
            boundary.decided |= bit(i);
        } else if context.system.must_hold(i) {
            return Err(not_met(context, i, here));
        } else {
            let before = (context.held, context.x);
            context.system.switch(time, &mut context.held, &mut context.x, i)?;
            // If neither side leads away from the boundary, the value decides.
            if let Some(turned) = rates(context).filter(|turned| turned.at(i) > M::S::ZERO) {
                boundary.decided |= bit(i);
                boundary.switched |= bit(i);
                slopes = Some(turned);
            } else {
                (context.held, context.x) = before;
            }
        }
    }
    Ok(boundary)
}
