//! The four-bar linkage by its lengths: poses, and the functions of a pose.

mod class;
mod declaration;
mod defect;

use nalgebra::Complex;

pub use self::class::{Class, Limits};
pub use self::declaration::LinkMass;
pub(crate) use self::declaration::{Beside, Body};
pub use self::defect::{Defect, Demands};

/// A point of the plane, m.
pub type Point = [f64; 2];

/// A vector of the plane as a complex number, by which products are rotations.
pub(crate) type Vector = Complex<f64>;

pub(crate) fn vector([x, y]: Point) -> Vector {
    Vector::new(x, y)
}

pub(crate) fn point(z: Vector) -> Point {
    [z.re, z.im]
}

/// The unit vector of an angle.
pub(crate) fn unit(angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Vector::new(cos, sin)
}

/// Mirror image of the loop: the side of the pin of coupler and rocker, seen from the crank's pin towards the rocker's pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Image {
    /// The pin lies on the left.
    Left,
    /// The pin lies on the right.
    Right,
}

impl Image {
    /// 1 on the left, -1 on the right.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// The other image.
    pub(crate) fn mirrored(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// The image of a number that is positive on the left.
    pub(crate) fn of(sign: f64) -> Self {
        if sign < 0.0 { Self::Right } else { Self::Left }
    }
}

/// Four-bar linkage with a point on its coupler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    /// Pivots of the crank and of the rocker on the ground, m.
    pub pivots: [Point; 2],
    /// Length of the crank, m.
    pub crank: f64,
    /// Length of the coupler between its pins, m.
    pub coupler: f64,
    /// Length of the rocker, m.
    pub rocker: f64,
    /// Coupler point in the frame of the coupler, m: along the coupler from the crank's pin, and to the left of it.
    pub point: Point,
    /// Image on which the loop is assembled.
    pub image: Image,
}

/// Pose of a four-bar linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Angles of crank, coupler and rocker from the x-axis, rad; the rocker's from its pivot to its pin.
    pub angles: [f64; 3],
    /// Pins of the coupler at the crank and at the rocker, m.
    pub pins: [Point; 2],
    /// Coupler point, m.
    pub point: Point,
}

impl FourBar {
    /// Lengths of ground, crank, coupler and rocker, m.
    pub fn lengths(&self) -> [f64; 4] {
        [self.ground().norm(), self.crank, self.coupler, self.rocker]
    }

    /// From the crank's pivot to the rocker's.
    fn ground(&self) -> Vector {
        vector(self.pivots[1]) - vector(self.pivots[0])
    }

    /// Angle from the x-axis to the line from the crank's pivot to the rocker's, rad.
    pub fn ground_angle(&self) -> f64 {
        self.ground().arg()
    }

    /// Pose at an angle of the crank from the x-axis, rad. `None` where the loop does not close.
    pub fn pose(&self, angle: f64) -> Option<Pose> {
        self.pose_on(angle, self.image)
    }

    /// Pose at an angle of the crank on an image of the loop. `None` where the loop does not close.
    pub fn pose_on(&self, angle: f64, image: Image) -> Option<Pose> {
        let pin = vector(self.pivots[0]) + unit(angle) * self.crank;
        let pivot = vector(self.pivots[1]);
        let coupler = dyad(pivot - pin, self.coupler, self.rocker, image)?;
        let other = pin + coupler;
        let along = coupler / self.coupler;
        Some(Pose {
            angles: [angle, coupler.arg(), (other - pivot).arg()],
            pins: [point(pin), point(other)],
            point: point(pin + along * vector(self.point)),
        })
    }

    /// Both poses at an angle of the crank; none where the loop does not close.
    pub fn images(&self, angle: f64) -> Vec<Pose> {
        [Image::Left, Image::Right].into_iter().filter_map(|image| self.pose_on(angle, image)).collect()
    }

    /// Coupler point over a turn, or over the range that the crank has, at so many equally spaced angles of the crank.
    pub fn curve(&self, count: usize) -> Vec<Point> {
        let (from, to) = self.crank_limits().map_or((0.0, 0.0), Limits::range);
        let steps = count.saturating_sub(1).max(1) as f64;
        let angle = |k: usize| self.ground_angle() + from + (to - from) * k as f64 / steps;
        (0..count).filter_map(|k| self.pose(angle(k))).map(|pose| pose.point).collect()
    }

    /// Transmission angle of a pose: between coupler and rocker at their pin, 0 to pi, rad.
    pub fn transmission_angle(pose: &Pose) -> f64 {
        let [_, coupler, rocker] = pose.angles;
        (unit(coupler).conj() * unit(rocker)).arg().abs()
    }

    /// Rate of the rocker per rate of the crank, and of the coupler: `[coupler, rocker]`. Infinite at a dead point of the crank.
    pub fn velocity_ratios(&self, pose: &Pose) -> [f64; 2] {
        let [crank, coupler, rocker] = pose.angles;
        // Components of the pins' velocities along the coupler, and along the rocker, agree.
        let rocker_ratio = self.crank * (coupler - crank).sin() / (self.rocker * (coupler - rocker).sin());
        let coupler_ratio = self.crank * (rocker - crank).sin() / (self.coupler * (coupler - rocker).sin());
        [coupler_ratio, rocker_ratio]
    }

    /// Mechanical advantage of a pose: torque that the rocker gives per torque on the crank, without losses. Infinite at a toggle.
    pub fn mechanical_advantage(&self, pose: &Pose) -> f64 {
        1.0 / self.velocity_ratios(pose)[1]
    }
}

/// The first bar of a dyad that spans a vector: its lengths in the order of the way. `None` where they do not reach by more than the
/// rounding of the squares.
pub(crate) fn dyad(span: Vector, first: f64, second: f64, image: Image) -> Option<Vector> {
    let square = span.norm_sqr();
    let along = (first * first - second * second + square) / (2.0 * square);
    let height = first * first / square - along * along;
    let rounding = 16.0 * f64::EPSILON * along * along;
    (height >= -rounding).then(|| span * Vector::new(along, image.sign() * height.max(0.0).sqrt()))
}
