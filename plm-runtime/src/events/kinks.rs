//! Kinks of the rate: knots of tables, `abs`, `min`, `max`.
//!
//! Error control detects most kinks, but none that comes and goes between its stages: a step over a narrow peak of a table
//! proceeds as if there were none. Therefore signs are followed over the step, as those of guards, though not as finely; if they
//! change, the dense output is compared with the rate. It agrees if the kink is smaller than the tolerance; otherwise the step
//! ends at the kink.

use super::LEAST_ULPS;
use super::root::{Point, root};
use crate::enclosure::Enclosed;
use crate::fault::Fault;
use crate::method::{Context, Method, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{System, value};
use crate::vector::Vector;

/// Most halvings of a step.
const FINEST: u32 = 12;
/// Most intervals of a step that are examined.
const MOST: u32 = 64;
/// Most kinks that are followed in a step.
const FOLLOWED: usize = 8;
/// Part of a step after a kink, at the end of which its sign has changed, and nothing else yet. Signs are also evaluated so far
/// after the beginning of a step, which may be a kink.
const BESIDE: f64 = 1e-9;
/// Least size of that part, in units in the last place.
const BESIDE_ULPS: f64 = 64.0;
/// A kink matters if its contribution to the error of a step is more than so many tolerances: the derivative of the dense output
/// is several times less accurate than the step itself.
const MATTERS: f64 = 1.0;

/// Time of the first kink in the last step that is not smaller than the tolerance. If a condition seems to switch at `crossing`,
/// before all kinks, it is the first kink of any size: a guard that stays on its boundary up to the kink may leave it in the
/// dense output by less.
///
/// The rough output of the step tells if there is any kink, so that steps without kinks need no more evaluations.
pub(super) fn kink<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    (start, crossing): (M::S, Option<M::S>),
    relevant: u128,
) -> Result<Option<M::S>, Fault> {
    let (Some(tolerance), Some(path), true) =
        (method.tolerance(), method.path(), context.system.kink_count() > 0)
    else {
        return Ok(None);
    };
    let (system, held) = (context.system, context.held);
    // If there are guards, the dense output is known.
    let path = if context.system.guard_count() > 0 {
        path
    } else {
        if (Kinks { system, held, path, relevant }).first().is_none() {
            return Ok(None);
        }
        method.densify(context)?;
        let Some(path) = method.path() else { return Ok(None) };
        path
    };
    let least = M::S::lit(LEAST_ULPS) * M::S::EPSILON * start.abs().max(context.end.abs());
    // Steps are divided by values, since their lengths are values.
    let time = |theta: M::S| Some(path.time(value(theta))).filter(|time| *time - start > least);
    let kinks = Kinks { system, held, path, relevant };
    if let Some(crossing) = crossing
        && let Some(first) = kinks.first().and_then(time).filter(|first| crossing < *first)
    {
        return Ok(Some(first));
    }
    let mut outcome = Ok(());
    let theta = kinks.first_that_matters(tolerance, |t, x| {
        let mut rate = *x;
        outcome = context.rate(t, x, &mut rate);
        outcome.is_ok().then_some(rate)
    });
    outcome?;
    Ok(theta.and_then(time))
}

/// Kinks over a step.
pub(super) struct Kinks<'a, M: System> {
    pub(super) system: &'a M,
    pub(super) held: M::U,
    pub(super) path: Path<M::S, M::X>,
    /// Kinks that are examined, one bit each.
    pub(super) relevant: u128,
}

impl<M: System<S: Real>> Kinks<'_, M> {
    /// First fraction of the step at which a sign changes.
    fn first(&self) -> Option<M::S> {
        self.after(beside()).map(|(theta, _)| theta)
    }

    /// First kink that matters, by the error of the dense output beyond it in units of `tolerance`; `rate` evaluates the rate.
    fn first_that_matters(
        &self,
        tolerance: M::S,
        mut rate: impl FnMut(M::S, &M::X) -> Option<M::X>,
    ) -> Option<M::S> {
        let (one, half) = (M::S::lit(1.0), M::S::lit(0.5));
        let (first, mut behind) = self.after(beside())?;
        let (mut from, mut sum) = (first, M::S::ZERO);
        for _ in 0..FOLLOWED {
            let next = self.after(behind).unwrap_or((one, one));
            // Simpson's rule from kink to kink; at the first the dense output still fits.
            let (to, middle) = (next.0, half * (from + next.0));
            let part = (to - from) * M::S::lit(1.0 / 6.0);
            let fourfold = M::S::lit(4.0) * self.defect(middle, &mut rate)?;
            sum = sum + part * (self.defect(from, &mut rate)? + fourfold + self.defect(to, &mut rate)?);
            if sum > M::S::lit(MATTERS) * tolerance {
                return Some(first);
            }
            (from, behind) = next;
            if behind >= one {
                break;
            }
        }
        None
    }

    /// Difference of the dense output's slope from the rate, times the step, over the sizes of the state: the largest component.
    fn defect(&self, theta: M::S, rate: &mut impl FnMut(M::S, &M::X) -> Option<M::X>) -> Option<M::S> {
        let (x, typical) = (self.path.at(theta), self.system.typical());
        let rate = rate(self.path.time(theta), &x)?;
        let slope = self.path.slope(theta);
        let mut most = M::S::ZERO;
        for i in 0..M::X::LEN {
            let off = (self.path.h * rate.at(i) - slope.at(i)).abs() / (typical.at(i) + x.at(i).abs());
            most = if off <= most { most } else { off };
        }
        Some(most)
    }

    /// First fraction of the step after `begin` at which a sign changes, and a fraction shortly after it.
    fn after(&self, begin: M::S) -> Option<(M::S, M::S)> {
        self.found(begin).map(|(first, _)| (first, first + beside()))
    }

    /// First fraction of the step after `begin` at which a sign changes, and the kink.
    pub(super) fn found(&self, begin: M::S) -> Option<(M::S, usize)> {
        let half = M::S::lit(0.5);
        let positive = self.signs(begin);
        let (mut level, mut index, mut width, mut spent) = (0_u32, 0_u32, M::S::lit(1.0), 0_u32);
        let mut from = M::S::ZERO;
        loop {
            let to = from + width;
            if to > begin {
                let start = from.max(begin);
                spent += 1;
                let changed = self.signs(to) ^ positive;
                let open = self.open(start, to, positive, changed);
                if open && level < FINEST && spent < MOST {
                    (level, index, width) = (level + 1, 2 * index, half * width);
                    continue;
                }
                if changed != 0 {
                    return Some(self.crossing(start, to, changed));
                }
            }
            (from, index) = (to, index + 1);
            while level > 0 && index % 2 == 0 {
                (level, index, width) = (level - 1, index / 2, width + width);
            }
            if level == 0 {
                return None;
            }
        }
    }

    /// True if a sign may change more than once in an interval.
    fn open(&self, from: M::S, to: M::S, positive: u128, changed: u128) -> bool {
        let half = M::S::lit(0.5);
        let (middle, radius) = (half * (from + to), half * (to - from));
        let (time, x) = self.path.around(middle, radius);
        let mut open = false;
        let known = self.system.guards_within(time, &self.held, &x, &mut |i, guard: Enclosed<M::S>| {
            let bit = bit(i.wrapping_sub(M::G::LEN)).filter(|bit| bit & self.relevant != 0);
            let Some(bit) = bit else { return };
            let range = guard.range(radius);
            let stays = changed & bit == 0
                && if positive & bit == 0 { range.high <= M::S::ZERO } else { range.low > M::S::ZERO };
            let monotone = guard.slope.low >= M::S::ZERO || guard.slope.high <= M::S::ZERO;
            open |= !(stays || monotone);
        });
        open || !known
    }

    /// Earliest change of the signs that have `changed` over an interval.
    fn crossing(&self, from: M::S, to: M::S, changed: u128) -> (M::S, usize) {
        let tolerance = M::S::EPSILON * M::S::lit(16.0);
        let mut first = (to, changed.trailing_zeros() as usize);
        for i in (0..128).filter(|i| bit(*i).is_some_and(|bit| changed & bit != 0)) {
            let sign = if self.value(from, i) > M::S::ZERO { M::S::lit(1.0) } else { M::S::lit(-1.0) };
            let point = |at: M::S| Point { at, value: sign * self.value(at, i) };
            let (a, b) = (point(from), point(to));
            if a.value > M::S::ZERO {
                let theta = root(a, b, tolerance, &mut |theta| sign * self.value(theta, i));
                first = if theta < first.0 { (theta, i) } else { first };
            }
        }
        first
    }

    /// Value of one kink.
    fn value(&self, theta: M::S, index: usize) -> M::S {
        let mut found = M::S::ZERO;
        self.system.kinks(self.path.time(theta), &self.held, &self.path.at(theta), &mut |i, value| {
            if i == index {
                found = value;
            }
        });
        found
    }

    /// Kinks that are positive, of the first 128, one bit each.
    fn signs(&self, theta: M::S) -> u128 {
        let mut signs = 0;
        self.system.kinks(self.path.time(theta), &self.held, &self.path.at(theta), &mut |i, value| {
            if let (Some(bit), true) = (bit(i), value > M::S::ZERO) {
                signs |= bit & self.relevant;
            }
        });
        signs
    }
}

/// Distance after a kink at which its sign is evaluated, as a part of the step.
fn beside<S: Real>() -> S {
    S::lit(BESIDE).max(S::lit(BESIDE_ULPS) * S::EPSILON)
}

/// Bit of a kink; kinks after the first 128 are left to error control.
pub(super) fn bit(index: usize) -> Option<u128> {
    u32::try_from(index).ok().and_then(|index| 1_u128.checked_shl(index))
}
