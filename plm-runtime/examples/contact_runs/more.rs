//! Scenes of steps alone: a mass on a belt, a mass that a rope catches, a ball on a shaken table. Their references are event-driven runs.

use plm_runtime::Scalar;
use plm_runtime::contact::{Law, Limit, Rows};

use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

/// 1 kg on a belt of 0.1 m/s, held by 100 N/m: it sticks up to 3.924 N, and slips with 2.4525 N.
#[derive(Clone, Copy, Debug)]
pub struct Belt;

impl Belt {
    const SPEED: f64 = 0.1;
}

impl Scene<1, 1> for Belt {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(-100.0) * q[0]]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0)]]
    }
    fn contact<T: Scalar>(&self, t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        let speed = T::lit(Self::SPEED);
        [Row { drive: -speed, ..Row::fixed(q[0] - speed * t, [T::lit(1.0)]) }]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1], rows: &mut Rows<T, 1>) {
        rows.set_adhesion(0, Limit::own(T::lit(2.4525)), Limit::own(T::lit(3.924)));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([0.0], [Self::SPEED])
    }
}

system!(Belt, 1, 1);

/// 1 kg that falls beside a pin, 0.5 m away, until its rope of 1 m is taut; then it swings.
#[derive(Clone, Copy, Debug)]
pub struct Rope;

impl Rope {
    /// What is lost as the rope becomes taut leaves this energy above the lowest place, J: of the speed there the part across the rope.
    pub fn energy_behind() -> f64 {
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
    fn inverse_mass<T: Scalar>(&self, _q: [T; 2]) -> [[T; 2]; 2] {
        [[T::lit(1.0), T::ZERO], [T::ZERO, T::lit(1.0)]]
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

/// A ball that falls 0.3 m onto a table which moves by 20 mm at 22 rad/s, with a restitution of 0.5. It comes to bounce once in a period of the
/// table (P. J. Holmes, The dynamics of repeated impacts with a sinusoidally vibrating table, Journal of Sound and Vibration 84, 1982).
#[derive(Clone, Copy, Debug)]
pub struct Shaken;

impl Scene<1, 1> for Shaken {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Unilateral { restitution: 0.5 }]
    }
    fn free<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(-GRAVITY)]
    }
    fn inverse_mass<T: Scalar>(&self, _q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0)]]
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
