//! Decides from the lengths whether a mechanism reaches the singular pose next to its state.

use super::critical::{Critical, Rows};
use super::distance::SingularityDistance;
use super::lock::{Ends, resolution};
use super::{ExtendedPrecision, size};
use crate::absolute::split;
use crate::double_double::DoubleDouble;
use crate::fault::Fault;
use crate::linalg::{dot, largest};
use crate::method::Context;
use crate::scalar::Real;
use crate::tolerances::{NEARBY, UNCERTAIN};
use crate::vector::Vector;

/// Derivatives of what joints are open by at a singular pose, over the mechanism's length, that are not rounding.
const MISSED: f64 = 1e-6;

/// How a mechanism meets a singular pose.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meeting {
    /// It comes to the pose, with joints that are open by less than the lengths are rounded.
    Reached,
    /// It comes to the pose, and would miss it with the lengths beside these by which the run is derived.
    ReachedByChance,
    /// It passes the pose by.
    Missed,
    /// No such pose was found.
    Unknown,
}

impl Meeting {
    /// Does it come to the pose?
    pub(super) fn is_reached(self) -> bool {
        matches!(self, Self::Reached | Self::ReachedByChance)
    }

    /// At a state in absolute coordinates. The gaps of the joints at a pose that is reached are written to `open`, m and rad.
    ///
    /// # Errors
    /// [`Cause::LockedAt`](crate::Cause::LockedAt) if a prescribed motion comes to its end before the interval does.
    #[inline(never)]
    pub(super) fn of<S: Real, M, const NQ: usize, const NC: usize, const NX: usize>(
        context: &Context<'_, M>,
        (full, singularity): (&[S; NX], Option<&SingularityDistance<S>>),
        open: &mut [DoubleDouble<S>; NC],
    ) -> Result<Self, Fault>
    where
        M: ExtendedPrecision<NQ, NC, NX, S = S>,
    {
        let (time, system) = (context.time, context.system);
        let (extended, _) = system.extended_with_inputs(&context.held);
        let (q, v) = split::<_, NX, NQ>(full);
        let at = Vector::from_fn(|i| DoubleDouble::of(q[i]));
        let Some(rows) = Rows::<M, NQ, NC, NX>::at(system, &extended, time, &at) else {
            return Ok(Self::Unknown);
        };
        let driven = largest(&rows.driven(time, &q)) > S::ZERO;
        // Beside the pose the motion is not known before the lengths are.
        let distance = singularity
            .and_then(SingularityDistance::distance)
            .filter(|distance| distance.abs() > UNCERTAIN.of::<S>());
        let way = distance
            .zip(singularity)
            .map_or(S::ZERO, |(distance, singularity)| singularity.signed_time_to(distance));
        let guess = Vector::from_fn(|i| DoubleDouble::of(q[i] + way * v[i]));
        let is_next = |critical: &Critical<S, NQ, NC>| {
            let off: [S; NQ] = Vector::from_fn(|i| q[i] - critical.q[i].rounded());
            size(&off, |i| S::lit(1.0) + q[i].abs()) < NEARBY.of::<S>()
        };
        let known = distance.is_some() || driven;
        let Some(critical) = rows.critical(time, &guess).filter(|critical| known || is_next(critical)) else {
            return Ok(Self::Unknown);
        };
        let critical = match if driven { rows.ends(time, critical) } else { Ends::Never(critical) } {
            Ends::At(end, critical) if end - resolution((time, end)) <= context.end => {
                return Err(rows.locked((end, system.flat_part(time, full)), &critical));
            }
            Ends::Touches(critical) => Some(critical),
            Ends::Never(critical) => Some(critical).filter(Critical::is_reached),
            Ends::At(..) => None,
        };
        Ok(match critical {
            Some(critical) => {
                *open = critical.open;
                let missed = dot(&critical.combination, &rows.in_metres(&critical.open));
                let is_chance = missed.largest_derivative() > MISSED * system.length().to_f64();
                if is_chance { Self::ReachedByChance } else { Self::Reached }
            }
            // With rows that repeat others it may be the pose of those that are left alone.
            None if rows.repeat() => Self::Unknown,
            None => Self::Missed,
        })
    }
}
