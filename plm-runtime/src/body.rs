//! Readable pose and velocity of a body, and conversion of its start values from its origin to its centre of gravity.

use core::fmt;
use core::ops::Deref;

use crate::axes::{to_absolute, turned};
use crate::scalar::{Real, Scalar};
use crate::start::{BodyStart, Start};

/// Pose and velocity of a body at a moment, to be read: `sim.arm().angle`.
///
/// It is a copy. Its numbers cannot be set, since that would move no body: where a mechanism starts is said by `start`.
#[derive(Clone, Copy, PartialEq)]
#[must_use = "it is a copy of what the mechanism does"]
pub struct BodyState<S>(BodyMotion<S>);

impl<S> BodyState<S> {
    /// Of (x, y, angle) and (vx, vy, omega).
    #[inline]
    pub fn of([x, y, angle]: [S; 3], [vx, vy, omega]: [S; 3]) -> Self {
        Self(BodyMotion { x, y, angle, vx, vy, omega })
    }

    /// Of the body with this number, from 0, among poses and velocities of all: three numbers each.
    pub fn among(q: &[S], v: &[S], body: usize) -> Option<Self>
    where
        S: Copy,
    {
        let of = |all: &[S]| all.as_chunks::<3>().0.get(body).copied();
        Some(Self::of(of(q)?, of(v)?))
    }
}

impl<S> Deref for BodyState<S> {
    type Target = BodyMotion<S>;

    #[inline]
    fn deref(&self) -> &BodyMotion<S> {
        &self.0
    }
}

impl<S: fmt::Debug> fmt::Debug for BodyState<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The numbers of a [`BodyState`]: pose and velocity of the centre of gravity, in absolute axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion<S> {
    /// Position, m.
    pub x: S,
    /// Position, m.
    pub y: S,
    /// Angle of the body axes, rad.
    pub angle: S,
    /// Velocity, m/s.
    pub vx: S,
    /// Velocity, m/s.
    pub vy: S,
    /// Angular velocity, rad/s.
    pub omega: S,
}

impl<S: Copy> BodyMotion<S> {
    /// (x, y, angle, vx, vy, omega).
    pub fn components(&self) -> [S; 6] {
        [self.x, self.y, self.angle, self.vx, self.vy, self.omega]
    }
}

impl<S: Scalar> BodyMotion<S> {
    /// Absolute position of a point of the body that stands at (`x`, `y`) from G in the body's axes, m.
    pub fn point(&self, x: S, y: S) -> [S; 2] {
        to_absolute([x, y], [self.x, self.y], self.angle)
    }
}

impl<S: Real> BodyStart<S> {
    /// Start of (x, y, angle) of G, which stands at `centre` from the origin O in the body's axes:
    /// G = O + R(angle) centre. A lock of O's x locks G's x (manual, section 4.3.4: states stand at G).
    pub fn of_centre(&self, centre: [S; 2]) -> [Start<S>; 3] {
        let [dx, dy] = turned(centre, self.angle.value);
        [moved(self.x, dx), moved(self.y, dy), self.angle]
    }

    /// Start of (vx, vy, omega) of G at the assembled `angle`: v_G = v_O + omega x (G - O).
    pub fn velocity_of_centre(&self, centre: [S; 2], angle: S) -> [Start<S>; 3] {
        let [dx, dy] = turned(centre, angle);
        let omega = self.omega.value;
        [moved(self.vx, -(omega * dy)), moved(self.vy, omega * dx), self.omega]
    }

    /// The start of O that puts G, at `centre` in the body's axes, to a pose (x, y, angle) and gives it a velocity
    /// (vx, vy, omega); locks stay.
    #[must_use]
    pub fn with_centre_at(self, centre: [S; 2], [x, y, angle]: [S; 3], [vx, vy, omega]: [S; 3]) -> Self {
        let [dx, dy] = turned(centre, angle);
        self.at([x - dx, y - dy, angle], [vx + omega * dy, vy - omega * dx, omega])
    }
}

fn moved<S: Scalar>(start: Start<S>, by: S) -> Start<S> {
    start.at(start.value + by)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocities_of_the_origin_are_carried_over_to_the_centre() {
        let start = BodyStart { omega: Start::free(2.0), vx: Start::locked(1.0), ..BodyStart::default() };
        let [vx, vy, omega] = start.velocity_of_centre([0.5, 0.0], 0.0);
        assert_eq!((vx, vy, omega), (Start::locked(1.0), Start::free(1.0), Start::free(2.0)));
    }

    #[test]
    fn the_start_of_a_centre_leads_to_that_centre() {
        let (centre, pose, velocity) = ([0.5, -0.25], [1.0, 2.0, 0.7], [0.1, -0.2, 3.0]);
        let start = BodyStart { x: Start::locked(9.0), ..BodyStart::default() };
        let start = start.with_centre_at(centre, pose, velocity);
        let near = |got: [Start<f64>; 3], want: [f64; 3]| {
            got.iter().zip(want).all(|(got, want)| (got.value - want).abs() < 1e-15)
        };
        assert!(near(start.of_centre(centre), pose));
        assert!(near(start.velocity_of_centre(centre, 0.7), velocity));
        assert!(start.x.locked && !start.y.locked);
    }
}
