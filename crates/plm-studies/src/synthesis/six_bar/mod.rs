//! Six-bars: poses, defects, declarations, and synthesis by least squares.
//!
//! A dyad between two links of a four-bar makes a six-bar; which links decides the chain. Four of the five are driven by the crank of the
//! four-bar. Stephenson's second chain is the third one with the second bar of the dyad fixed in place of the four-bar's ground, which
//! turns as its crank: by the crank's angle its pose has no closed form, by that of the first link of the four-bar it has.

mod declaration;
mod defect;
mod kernel;
mod moving;
mod problem;
mod search;

use self::kernel::{Dimensions, Z};
pub use self::problem::{Bounds, Found, NoSixBar, Problem, Task};
use crate::synthesis::four_bar::{FourBar, Image, Point, Pose, Vector, point, unit, vector};

/// Link of a four-bar. A point in its frame counts from the crank's pivot along the ground, from the crank's pivot along the crank, from
/// the crank's pin along the coupler, or from the rocker's pivot along the rocker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// The ground.
    Ground,
    /// The crank.
    Crank,
    /// The coupler.
    Coupler,
    /// The rocker.
    Rocker,
}

/// Chain of a six-bar, by the two links of the four-bar that carry the dyad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chain {
    /// Watt's chain with a binary ground: coupler and rocker.
    WattOne,
    /// Watt's chain with a ternary ground: rocker and ground, two four-bars in series.
    WattTwo,
    /// Stephenson's chain with a binary ground: crank and rocker.
    StephensonOne,
    /// Stephenson's chain with a ternary ground: coupler and ground.
    StephensonThree,
    /// Stephenson's chain with a binary ground in its five-bar loops: coupler and crank. The four-bar moves: its ground is the crank of the
    /// six-bar, and turns about the first of its `pivots`, at which the second bar of the dyad is fixed. The line of the pivots is the
    /// direction of that bar, and their distance that of the pins of the crank. The angle of poses and defects is that of the first link of
    /// the four-bar, from the line of the crank's pins.
    StephensonTwo,
}

impl Chain {
    /// The links that carry the first and the second bar of the dyad.
    pub fn hosts(self) -> [Host; 2] {
        match self {
            Self::WattOne => [Host::Coupler, Host::Rocker],
            Self::WattTwo => [Host::Rocker, Host::Ground],
            Self::StephensonOne => [Host::Crank, Host::Rocker],
            Self::StephensonThree | Self::StephensonTwo => [Host::Coupler, Host::Ground],
        }
    }
}

/// Six-bar with a point on the first bar of its dyad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixBar {
    /// The four-bar.
    pub four_bar: FourBar,
    /// Links that carry the dyad.
    pub chain: Chain,
    /// Ends of the dyad in the frames of their links, m.
    pub ends: [Point; 2],
    /// Lengths of the bars of the dyad, m.
    pub bars: [f64; 2],
    /// Image of the dyad: the side of its pin, seen from the first end towards the second.
    pub image: Image,
    /// Point in the frame of the first bar, m: along it from its end, and to the left of it. Of Stephenson's second chain, whose first bar
    /// turns about the ground, in the frame of the coupler.
    pub point: Point,
}

/// Pose of a six-bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixBarPose {
    /// Pose of the four-bar.
    pub four_bar: Pose,
    /// Ends of the dyad, and its pin, m.
    pub pins: [Point; 3],
    /// Angles of both bars of the dyad from the x-axis, each from its end to the pin, rad.
    pub angles: [f64; 2],
    /// The point, m.
    pub point: Point,
    /// Angle of the crank from the x-axis, rad.
    pub crank: f64,
}

impl SixBar {
    fn dimensions(&self) -> Dimensions<f64> {
        Dimensions {
            chain: self.chain,
            lengths: self.four_bar.lengths(),
            ends: self.ends.map(|[x, y]| Z::new(x, y)),
            bars: self.bars,
            images: [self.four_bar.image, self.image],
        }
    }

    /// Pose at an angle of the crank from the x-axis, rad; of [`Chain::StephensonTwo`] of the first link of its four-bar, from the line of the
    /// crank's pins. `None` where a loop does not close.
    pub fn pose(&self, angle: f64) -> Option<SixBarPose> {
        if self.chain == Chain::StephensonTwo {
            return self.moving_pose(angle);
        }
        let four_bar = self.four_bar.pose(angle)?;
        let ground = self.four_bar.ground_angle();
        let solved = self.dimensions().solve(angle - ground)?;
        let complex = |z: Z<f64>| Vector::new(z.re, z.im);
        let place = |z: Z<f64>| vector(self.four_bar.pivots[0]) + unit(ground) * complex(z);
        let [first, second] = solved.bars.map(|bar| unit(ground) * complex(bar.along));
        let [from, to] = solved.ends.map(place);
        Some(SixBarPose {
            four_bar,
            pins: [point(from), point(to), point(from + first * self.bars[0])],
            angles: [first.arg(), second.arg()],
            point: point(from + first * vector(self.point)),
            crank: angle,
        })
    }
}
