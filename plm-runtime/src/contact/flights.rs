//! Flights that are too low to follow: rows that leave so slowly count as at rest.

use super::event::{Event, moving_rows};
use super::multipliers::multipliers;
use super::rows::{Rows, below};
use super::{Contacts, Modal, lambda_of};
use crate::dual::Dual;
use crate::scalar::{Real, Scalar};

/// Height, in roundings of the length, below which a flight is ignored.
const LOWEST_FLIGHT: f64 = 1000.0;
/// Rows with a diagonal entry of D below this fraction of the own one are ignored in the search for the largest pull.
const LIGHT: f64 = 1e-6;

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// Rate below which a row is at rest: its flight would be lower than rounding. The pull on another row may act on it too: a block on
    /// a block falls as fast as that one, until it is held.
    pub(super) fn resting(&self, rows: &Rows<M::S, N>, row: usize) -> M::S {
        let row = below::<N>(row);
        let own = rows.delassus[row][row];
        let (mut pull, light) = (rows.free[row].abs(), M::S::lit(LIGHT) * own);
        for j in 0..N {
            if self.system.law(j).is_unilateral() && rows.delassus[j][j] > light {
                pull = pull.max(rows.free[j].abs() * (own / rows.delassus[j][j]).sqrt());
            }
        }
        (M::S::lit(2.0) * pull * self.lowest_flight()).sqrt()
    }

    /// Height below which a flight is ignored.
    fn lowest_flight(&self) -> M::S {
        M::S::lit(LOWEST_FLIGHT) * M::S::EPSILON * self.system.length()
    }

    /// Rate below which the flight of a row whose impact was not located would end within a step, or below zero after a penetration.
    pub(super) fn short(&self, rows: &Rows<M::S, N>, row: usize) -> M::S {
        let row = below::<N>(row);
        let (zero, pull) = (M::S::ZERO, rows.free[row].abs());
        let depth = if self.step > zero { (-rows.gap[row]).max(zero) } else { zero };
        (M::S::lit(0.5) * self.step * pull).max((M::S::lit(2.0) * pull * depth).sqrt())
    }

    /// True for rows that leave for a flight that is too low to follow, with acceleration and jerk. If two bodies on springs of one
    /// frequency strike each other, nothing pulls them together at that moment, and the flight is as high as it is fast.
    pub(super) fn returns_at_once(
        &self,
        rows: &Rows<M::S, N>,
        (u, x): (&M::U, &M::X),
        touches: impl Fn(usize) -> bool,
    ) -> [bool; N] {
        let leaves = |i: usize| touches(i) && rows.rate[i] > M::S::ZERO;
        if !(0..N).any(leaves) {
            return [false; N];
        }
        let moving = moving_rows(self.system, (self.t, u), x, &lambda_of(rows, u.modes()));
        let Some(found) = multipliers(&moving, &u.modes().of) else { return [false; N] };
        let lowest = self.lowest_flight();
        core::array::from_fn(|i| {
            let acceleration: Dual<M::S, 1> = moving.acceleration(i, &found.lambda);
            leaves(i)
                && highest(rows.rate[i], acceleration.value, acceleration.tangents[0])
                    .is_some_and(|height| height <= lowest)
        })
    }
}

/// Height of a flight that begins with this rate, acceleration and jerk; `None` if the row does not return.
fn highest<S: Real>(rate: S, acceleration: S, jerk: S) -> Option<S> {
    let (half, sixth) = (S::lit(0.5), S::lit(1.0 / 6.0));
    // The first root of rate + acceleration t + jerk t^2/2.
    let square = acceleration * acceleration - S::lit(2.0) * jerk * rate;
    let slowed = square.max(S::ZERO).sqrt() - acceleration;
    let time = S::lit(2.0) * rate / slowed;
    let comes_back = square >= S::ZERO && slowed > S::ZERO && time.is_finite();
    comes_back.then(|| time * (rate + time * (half * acceleration + time * sixth * jerk)))
}

#[cfg(test)]
mod tests {
    use super::highest;

    #[test]
    fn flights_end_by_acceleration_or_by_jerk() {
        let is = |height: Option<f64>, expected: f64| {
            height.is_some_and(|height| (height - expected).abs() < 1e-15)
        };
        // A throw: v^2/2g.
        assert!(is(highest(2.0, -9.81, 0.0), 4.0 / 19.62));
        // Without acceleration v t/1.5 at t = sqrt(2 v/j).
        assert!(is(highest(0.5, 0.0, -4.0), 0.5 * 0.5 / 1.5));
        assert_eq!(highest(1.0, 0.1, 0.0), None);
        assert_eq!(highest(1.0, -0.1, 10.0), None);
        assert_eq!(highest(1.0, 0.0, 0.0), None);
        assert_eq!(highest(f64::NAN, -1.0, 0.0), None);
    }
}
