//! How far the next singular pose is along the motion.
//!
//! Near it, the smallest pivot of `phi_q M^-1 phi_q^T` is `c + k (s - s0)^2`. Three poses in the direction of the motion give the
//! parabola.

use super::ExtendedPrecision;
use super::equations::{Equations, Evaluated};
use crate::absolute::{nearest, smallest_pivot, split};
use crate::double_double::DoubleDouble;
use crate::scalar::Real;
use crate::tolerances::{APART, BEFORE_TURNING, FOLLOWS, NARROWEST, REFINEMENTS, VANISHES};
use crate::vector::Vector;

/// Predicted distance to the next singular pose along the motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct SingularityDistance<S> {
    /// Distance over which the parabola changes by its own size, rad.
    scale: S,
    /// Distance to its lowest point, negative behind.
    lowest: S,
    /// The lowest pivot may be zero.
    vanishes: bool,
    /// The fastest rate of a coordinate and its derivative, rad/s and rad/s^2.
    speed: S,
    acceleration: S,
}

impl<S: Real> SingularityDistance<S> {
    /// From a state and its rate.
    pub(super) fn of<M, const NQ: usize, const NC: usize, const NX: usize>(
        equations: &Equations<M, NQ, NC, NX>,
        (t, held): (S, &M::U),
        here: &Evaluated<S, NX>,
    ) -> Self
    where
        M: ExtendedPrecision<NQ, NC, NX, S = S>,
    {
        let fastest = |from: usize, of: &[S; NX]| {
            (0..NQ).fold(S::ZERO, |most: S, i| most.max((of.at(from + i) / equations.typical_of(i)).abs()))
        };
        let (speed, acceleration) = (fastest(NQ, &here.x), fastest(NQ, &here.dx));
        if speed * speed > APART.of::<S>() * acceleration {
            return Self::along(
                equations,
                (t, held),
                here,
                (&here.x, [speed, S::lit(1.0) / speed], [speed, acceleration]),
            );
        }
        // What is slow may turn soon, and come to a pose before.
        if speed > S::ZERO {
            let singularity = Self::along(
                equations,
                (t, held),
                here,
                (&here.x, [speed, S::lit(1.0) / speed], [speed, S::ZERO]),
            );
            let reach = BEFORE_TURNING.of::<S>() * speed * speed;
            if singularity.distance_ahead().is_some_and(|distance| distance * acceleration < reach) {
                return singularity;
            }
        }
        Self::along(equations, (t, held), here, (&here.dx, [acceleration, S::ZERO], [speed, acceleration]))
    }

    /// In the direction of velocities or accelerations, the largest of which is `most`, with the time that a distance takes.
    fn along<M, const NQ: usize, const NC: usize, const NX: usize>(
        equations: &Equations<M, NQ, NC, NX>,
        (t, held): (S, &M::U),
        here: &Evaluated<S, NX>,
        (of, [most, takes], [speed, acceleration]): (&[S; NX], [S; 2], [S; 2]),
    ) -> Self
    where
        M: ExtendedPrecision<NQ, NC, NX, S = S>,
    {
        let mut singularity =
            Self { scale: S::INFINITY, lowest: S::INFINITY, vanishes: false, speed, acceleration };
        if most <= S::ZERO {
            return singularity;
        }
        let (extended, _) = equations.system.extended_with_inputs(held);
        let constraints = equations.opened(&extended);
        let pivot = |distance: S| {
            let way = |i: usize| if i < NQ { distance * (of.at(NQ + i) / most) } else { S::ZERO };
            let mut x = Vector::from_fn(|i| DoubleDouble::of(here.x.at(i)) + DoubleDouble::of(way(i)));
            let t = t + distance * takes;
            // The pivots of joints that repeat others vanish on the constraints alone.
            nearest::<_, _, NQ, NC, NX>(&constraints, DoubleDouble::of(t), &mut x);
            smallest_pivot(&extended, DoubleDouble::of(t), &split::<_, NX, NQ>(&x).0).rounded()
        };
        let (mut apart, now) = (APART.of::<S>(), pivot(S::ZERO));
        for _ in 0..REFINEMENTS {
            let [before, after] = [-apart, apart].map(pivot);
            let slope = (after - before) / (apart + apart);
            let bend = (after + before - (now + now)) / (apart * apart);
            if bend > S::ZERO {
                singularity.scale = ((now + now) / bend).sqrt();
                singularity.lowest = -slope / bend;
                singularity.vanishes =
                    now + S::lit(0.5) * slope * singularity.lowest < VANISHES.of::<S>() * now;
            } else {
                (singularity.scale, singularity.lowest) = (S::INFINITY, S::INFINITY);
            }
            // False for NaN.
            let nearer = singularity.scale < apart;
            if !nearer {
                break;
            }
            apart = S::lit(0.5) * singularity.scale;
        }
        singularity
    }

    /// The time in which a distance is covered.
    pub(super) fn time_to(&self, distance: S) -> S {
        let root = (self.speed * self.speed + S::lit(2.0) * self.acceleration * distance).sqrt();
        let h = (distance + distance) / (self.speed + root);
        if h.is_finite() { h } else { S::INFINITY }
    }

    /// The time in which a distance is covered, or was, if it is negative.
    pub(super) fn signed_time_to(&self, distance: S) -> S {
        let time = self.time_to(distance.abs());
        if distance < S::ZERO { -time } else { time }
    }

    /// Are the pivots those of the motion? Two that are small beside a flat pose amplify the rounding of a third: that of a row which
    /// repeats others is left out or not by chance then.
    pub(super) fn is_resolved(&self) -> bool {
        self.scale > NARROWEST.of::<S>() * S::EPSILON.sqrt()
    }

    /// The longest step that follows the parabola.
    pub(super) fn longest_step(&self) -> S {
        if self.scale < S::INFINITY { self.time_to(FOLLOWS.of::<S>() * self.scale) } else { S::INFINITY }
    }

    /// Distance over which the motion turns, rad.
    pub(super) fn scale(&self) -> S {
        self.scale
    }

    /// Distance to a singular pose, negative behind, if there may be one near.
    pub(super) fn distance(&self) -> Option<S> {
        (self.vanishes && self.lowest.is_finite()).then_some(self.lowest)
    }

    /// Distance to the singular pose, if there may be one ahead.
    pub(super) fn distance_ahead(&self) -> Option<S> {
        (self.vanishes && self.lowest > S::ZERO).then_some(self.lowest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SINGULARITY: SingularityDistance<f64> =
        SingularityDistance { scale: 5.0, lowest: 3.0, vanishes: true, speed: 2.0, acceleration: 0.5 };

    #[test]
    fn a_distance_takes_as_long_as_the_motion_does() {
        for (speed, acceleration) in [(2.0, 0.5), (2.0, 0.0), (0.0, 0.5)] {
            let singularity = SingularityDistance { speed, acceleration, ..SINGULARITY };
            for time in [0.1, 1.0, 7.0] {
                let distance = speed * time + 0.5 * acceleration * time * time;
                assert!(
                    (singularity.time_to(distance) - time).abs() < 1e-15 * time.max(1.0) * 4.0,
                    "{speed} {time}"
                );
            }
        }
        let resting = SingularityDistance { speed: 0.0, acceleration: 0.0, ..SINGULARITY };
        assert_eq!(resting.time_to(1.0), f64::INFINITY);
        // A step of 2 rad, and any where nothing bends.
        assert_eq!(SINGULARITY.longest_step(), SINGULARITY.time_to(2.0));
        assert_eq!(SingularityDistance { scale: f64::INFINITY, ..SINGULARITY }.longest_step(), f64::INFINITY);
    }

    #[test]
    fn a_pose_is_ahead_where_the_pivot_may_vanish() {
        assert_eq!(SINGULARITY.distance_ahead(), Some(3.0));
        for none in [
            SingularityDistance { vanishes: false, ..SINGULARITY },
            SingularityDistance { lowest: -3.0, ..SINGULARITY },
            SingularityDistance { lowest: 0.0, ..SINGULARITY },
        ] {
            assert_eq!(none.distance_ahead(), None, "{none:?}");
        }
    }
}
