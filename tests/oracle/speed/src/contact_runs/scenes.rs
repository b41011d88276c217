//! Scenes as systems with contact rows: those that other programs run too, and two of time stepping alone, a rope and a shaken table.

use plm_runtime::Scalar;
use plm_runtime::contact::{Law, Limit, Rows};

use crate::slider_crank;
use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

/// A block of 1 kg on a table or a floor: x and y of its centre, its angle. Its lower corners touch, with friction.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    half: [f64; 2],
    friction: f64,
    push: f64,
    tilt: f64,
}

impl Block {
    /// A block of 0.2 m by 0.2 m, pushed by 99 % of what friction can bear.
    pub fn pushed() -> Self {
        Self { half: [0.1, 0.1], friction: 0.3, push: 0.99 * 0.3 * GRAVITY, tilt: 0.0 }
    }

    /// Housner's block of 0.2 m by 1 m, on its right corner, tilted by half of the angle at which it falls.
    pub fn rocking() -> Self {
        Self { half: [0.1, 0.5], friction: 1.0, push: 0.0, tilt: 0.5 * 0.2_f64.atan() }
    }

    fn inertia(&self) -> f64 {
        let [b, h] = self.half;
        (b * b + h * h) / 3.0
    }

    /// Kinetic and potential energy, the latter above that of the block that stands upright.
    pub fn energy(&self, x: &[f64; 6]) -> f64 {
        let kinetic = x[3] * x[3] + x[4] * x[4] + self.inertia() * x[5] * x[5];
        0.5 * kinetic + GRAVITY * (x[1] - self.half[1])
    }
}

/// The gap of a corner over the floor, and its way along.
fn corner<T: Scalar>(q: [T; 3], v: [T; 3], at: [f64; 2]) -> [Row<T, 3>; 2] {
    let (sin, cos) = q[2].sin_cos();
    let [a, b] = at.map(T::lit);
    let arm = [a * cos - b * sin, a * sin + b * cos];
    let omega2 = v[2] * v[2];
    let row = |gap, direction, rest| Row { rest, ..Row::fixed(gap, direction) };
    [
        row(q[1] + arm[1], [T::ZERO, T::lit(1.0), arm[0]], -(omega2 * arm[1])),
        row(q[0] + arm[0], [T::lit(1.0), T::ZERO, -arm[1]], -(omega2 * arm[0])),
    ]
}

impl Scene<3, 4> for Block {
    fn laws(&self) -> [Law<f64>; 4] {
        let normal = Law::Unilateral { restitution: 0.0 };
        [normal, Law::Friction, normal, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3]) -> [T; 3] {
        [T::lit(self.push), T::lit(-GRAVITY), T::ZERO]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 3]) -> [[T; 3]; 3] {
        let (one, none) = (T::lit(1.0), T::ZERO);
        [[one, none, none], [none, one, none], [none, none, T::lit(1.0 / self.inertia())]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 3], v: [T; 3]) -> [Row<T, 3>; 4] {
        let [b, h] = self.half;
        let (left, right) = (corner(q, v, [-b, -h]), corner(q, v, [b, -h]));
        [left[0], left[1], right[0], right[1]]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 3], _v: [T; 3], rows: &mut Rows<T, 4>) {
        rows.set_friction(1, Limit::of(0, T::lit(self.friction)));
        rows.set_friction(3, Limit::of(2, T::lit(self.friction)));
    }
    fn start(&self) -> ([f64; 3], [f64; 3]) {
        let ([b, h], (sin, cos)) = (self.half, self.tilt.sin_cos());
        ([-b * cos + h * sin, b * sin + h * cos, -self.tilt], [0.0; 3])
    }
}

system!(Block, 3, 4);

/// A ball that falls 1 m, with a restitution of 0.8.
#[derive(Clone, Copy, Debug)]
pub struct Ball;

impl Scene<1, 1> for Ball {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.8 }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(-GRAVITY)]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        [Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([1.0], [0.0])
    }
}

system!(Ball, 1, 1);

/// A slider-crank in its crank angle: crank 0.1 m with 0.02 kg m^2, rod 0.3 m with 0.5 kg, slider 2 kg with 3 N against it.
#[derive(Clone, Copy, Debug)]
pub struct Crank;

impl Scene<1, 1> for Crank {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], v: [T; 1]) -> [T; 1] {
        let [mass, rate] = slider_crank::inertia(q[0]);
        [-(rate * v[0] * v[0]) / mass]
    }
    fn inverse_mass<T: Scalar>(&self, q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0) / slider_crank::inertia(q[0])[0]]]
    }
    // The friction acts against the crank: at a dead centre the slider has no rate, and no force on it could hold the crank.
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        [Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn friction<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1], rows: &mut Rows<T, 1>) {
        rows.set_friction(0, Limit::own(T::lit(3.0) * slider_crank::slider(q[0])[0].abs()));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([1.0], [20.0])
    }
}

system!(Crank, 1, 1);

/// 1 kg that falls beside a pin, 0.5 m away, until its rope of 1 m is taut; then it swings.
#[derive(Clone, Copy, Debug)]
pub struct Rope;

impl Rope {
    /// Energy above the lowest place once the rope is taut, J: the part of the velocity across the rope stays.
    pub fn energy_when_taut() -> f64 {
        let fall = 0.75_f64.sqrt();
        0.25 * GRAVITY * fall + GRAVITY * (1.0 - fall)
    }

    /// Energy above the lowest place, J.
    pub fn energy(x: &[f64; 4]) -> f64 {
        0.5 * (x[2] * x[2] + x[3] * x[3]) + GRAVITY * (x[1] + 1.0)
    }
}

impl Scene<2, 1> for Rope {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.0 }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 2], _v: [T; 2]) -> [T; 2] {
        [T::ZERO, T::lit(-GRAVITY)]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 2], v: [T; 2]) -> [Row<T, 2>; 1] {
        let gap = T::lit(0.5) * (T::lit(1.0) - q[0] * q[0] - q[1] * q[1]);
        [Row { rest: -(v[0] * v[0] + v[1] * v[1]), ..Row::fixed(gap, [-q[0], -q[1]]) }]
    }
    fn start(&self) -> ([f64; 2], [f64; 2]) {
        ([0.5, 0.0], [0.0; 2])
    }
}

system!(Rope, 2, 1);

/// A ball that falls 0.3 m onto a table which moves by 20 mm at 22 rad/s, with a restitution of 0.5. In the limit it bounces once in a
/// period of the table (P. J. Holmes, The dynamics of repeated impacts with a sinusoidally vibrating table, Journal of Sound and
/// Vibration 84, 1982).
#[derive(Clone, Copy, Debug)]
pub struct Shaken;

impl Scene<1, 1> for Shaken {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.5 }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(-GRAVITY)]
    }
    fn contact<T: Scalar>(&self, t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        let (rate, size) = (T::lit(22.0), T::lit(0.02));
        let (sin, cos) = (rate * t).sin_cos();
        let (drive, rest) = (-(size * rate * cos), size * rate * rate * sin);
        [Row { drive, rest, ..Row::fixed(q[0] - size * sin, [T::lit(1.0)]) }]
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([0.3], [0.0])
    }
}

system!(Shaken, 1, 1);
