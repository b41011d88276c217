//! Motion generation: dyads and four-bars that guide a body through poses (Burmester's theory).
//!
//! A dyad has a centre point G on the ground and a circle point W on the body, at one distance in all poses. With the displacement of the
//! body from its first pose to pose j, a rotation A and a translation d, the distances are equal where
//! `G·(A - 1)W + G·d - d·A W - d·d/2 = 0`: bilinear in G and W, which are both taken at the first pose.

mod dyads;
mod linkages;

use nalgebra::Complex;

pub use self::dyads::{
    CurvePoint, Dyad, NoDyads, burmester_curves, centre_point, circle_point, five_pose_dyads,
};
pub use self::linkages::{Guide, guides};

use crate::synthesis::four_bar::{Vector, point, unit, vector};

/// Pose of a body: place of its origin, m, and angle, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPose {
    /// Place of the origin, m.
    pub place: [f64; 2],
    /// Angle from the x-axis, rad.
    pub angle: f64,
}

/// Displacement from the first pose: points turn by a unit vector, then move.
#[derive(Clone, Copy, Debug)]
struct Displacement {
    turn: Vector,
    shift: Vector,
}

impl Displacement {
    fn between(from: &BodyPose, to: &BodyPose) -> Self {
        let turn = unit(to.angle - from.angle);
        Self { turn, shift: vector(to.place) - turn * vector(from.place) }
    }

    fn of(&self, point: Vector) -> Vector {
        self.turn * point + self.shift
    }

    /// Coefficients of G, real and imaginary, and the right side, for a circle point: `2 G·(D(W) - W) = |D(W)|^2 - |W|^2`, halved.
    fn centre_row(&self, circle: Vector) -> [f64; 3] {
        let moved = self.of(circle);
        let way = moved - circle;
        [way.re, way.im, 0.5 * (moved.norm_sqr() - circle.norm_sqr())]
    }

    /// Residual of equal distances, halved.
    fn residual(&self, centre: Vector, circle: Vector) -> f64 {
        let [x, y, right] = self.centre_row(circle);
        centre.re * x + centre.im * y - right
    }
}

/// Displacements from the first pose to each further one.
fn displacements(poses: &[BodyPose]) -> Vec<Displacement> {
    let Some((first, rest)) = poses.split_first() else { return Vec::new() };
    rest.iter().map(|pose| Displacement::between(first, pose)).collect()
}

/// Middle and extent of the places of poses: the units in which equations are solved.
fn frame(poses: &[BodyPose]) -> (Vector, f64) {
    let places = poses.iter().map(|pose| vector(pose.place));
    let middle = places.clone().sum::<Complex<f64>>() / poses.len().max(1) as f64;
    let extent = places.map(|place| (place - middle).norm()).fold(0.0, f64::max);
    (middle, if extent > 0.0 { extent } else { 1.0 })
}

/// Poses in the units of their frame.
fn scaled(poses: &[BodyPose], (middle, extent): (Vector, f64)) -> Vec<BodyPose> {
    let place = |pose: &BodyPose| (vector(pose.place) - middle) / extent;
    poses.iter().map(|pose| BodyPose { place: point(place(pose)), angle: pose.angle }).collect()
}
