//! A mass of 1 kg on a spring of 100 N/m, with dry friction on a table or on a belt.

use plm_runtime::Scalar;
use plm_runtime::contact::{Law, Limit, Rows};

use crate::support::{Row, Scene, system};

const GRAVITY: f64 = 9.81;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Oscillator {
    /// Coefficients of friction while it slips and while it sticks.
    kinetic: f64,
    adhesion: f64,
    /// Speed of the belt, m/s.
    belt: f64,
    /// Place and velocity.
    start: [f64; 2],
}

impl Oscillator {
    /// On a table, released at 0.1 m: a friction of 0.981 N.
    pub(crate) const RELEASED: Self = Self { kinetic: 0.1, adhesion: 0.1, belt: 0.0, start: [0.1, 0.0] };
    /// On a belt of 0.1 m/s: it sticks up to 3.924 N, and slips with 2.4525 N.
    pub(crate) const ON_BELT: Self = Self { kinetic: 0.25, adhesion: 0.4, belt: 0.1, start: [0.0, 0.1] };
}

impl Scene<1, 1> for Oscillator {
    fn laws(&self) -> [Law<f64>; 1] {
        [Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [T; 1] {
        [T::lit(-100.0) * q[0]]
    }
    fn contact<T: Scalar>(&self, t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 1] {
        let belt = T::lit(self.belt);
        [Row { drive: -belt, ..Row::fixed(q[0] - belt * t, [T::lit(1.0)]) }]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1], rows: &mut Rows<T, 1>) {
        let limit = |coefficient: f64| Limit::own(T::lit(coefficient * GRAVITY));
        rows.set_adhesion(0, limit(self.kinetic), limit(self.adhesion));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([self.start[0]], [self.start[1]])
    }
}

system!(Oscillator, 1, 1);
