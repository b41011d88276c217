//! What methods with error control share: the rate that is kept, the length of the next step.

use super::{Course, not_finite};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Rate at the current state, kept from the last step or evaluated.
pub(super) fn rate_here<M: System<S: Real>>(
    kept: &mut Option<M::X>,
    course: &mut Course<'_, M>,
) -> Result<M::X, Fault> {
    if let Some(rate) = *kept {
        return Ok(rate);
    }
    let x = course.x;
    let mut rate = x;
    course.rate(course.time, &x, &mut rate)?;
    if !(x.is_finite() && rate.is_finite()) {
        return Err(not_finite(course.system, course.time, &rate));
    }
    *kept = Some(rate);
    Ok(rate)
}

/// Length of the next step, and whether it is the last: the proposal, stretched by 1 % at most to hit the end rather than be
/// followed by a tiny one. It is counted down from the steps that are left of `most`.
pub(super) fn next_step<M: System<S: Real>>(
    (left, most): (&mut u64, u64),
    course: &Course<'_, M>,
    proposal: M::S,
) -> Result<(M::S, bool), Fault> {
    // Where nothing is integrated, steps are looks at what moves as it is told to: as many as it takes.
    if *left == 0 && M::X::LEN > 0 {
        return Err(course.fault(Cause::TooManySteps { steps: most }));
    }
    *left = left.saturating_sub(1);
    let rest = course.end - course.time;
    if M::S::lit(1.01) * proposal >= rest {
        Ok((rest, true))
    } else if proposal > shortest(course) {
        Ok((proposal, false))
    } else {
        Err(course.fault(Cause::StepTooSmall { step: proposal.to_f64() }))
    }
}

/// A step of so many units in the last place of the time hardly moves it.
pub(super) fn shortest<M: System<S: Real>>(course: &Course<'_, M>) -> M::S {
    M::S::lit(16.0) * M::S::EPSILON * course.time.abs().max(course.end.abs())
}
