//! Flights that are none: rows that leave so slowly that they rest.

use super::event::{Event, moving_rows};
use super::multipliers::multipliers;
use super::rows::{Rows, below};
use super::{Contacts, Modal, lambda_of};
use crate::dual::Dual;
use crate::scalar::{Real, Scalar};

/// A flight of a height below so many roundings of the length is none.
const LOWEST_FLIGHT: f64 = 1000.0;
/// A row with a smaller fraction of the own entry of D says nothing of what pulls others.
const LIGHT: f64 = 1e-6;

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// Slower than this a row rests: its flight would be lower than rounding. What pulls it may be what pulls others: a block on a block
    /// falls as fast as that, until it is held.
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

    /// A flight of a smaller height is none.
    fn lowest_flight(&self) -> M::S {
        M::S::lit(LOWEST_FLIGHT) * M::S::EPSILON * self.system.length()
    }

    /// Slower than this the flight of a row whose impact was not located would end within a step, or below zero where it has begun.
    pub(super) fn short(&self, rows: &Rows<M::S, N>, row: usize) -> M::S {
        let row = below::<N>(row);
        let (zero, pull) = (M::S::ZERO, rows.free[row].abs());
        let depth = if self.step > zero { (-rows.gap[row]).max(zero) } else { zero };
        (M::S::lit(0.5) * self.step * pull).max((M::S::lit(2.0) * pull * depth).sqrt())
    }

    /// Does a row leave for a flight that is too low to be one, as acceleration and jerk shape it? Where two bodies on springs of one
    /// frequency strike each other nothing pulls them together at that moment, and the flight is as high as it is fast.
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

/// The height of a flight that begins with this rate, acceleration and jerk; none where these lead it away.
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
