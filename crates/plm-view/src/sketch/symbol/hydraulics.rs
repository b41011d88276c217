//! Symbols of pumps, valves and accumulators, after ISO 1219-1.

use std::f64::consts::PI;

use super::{Board, Point};
use crate::sketch::element::zigzag;

/// Direction of the triangle in the circle of a displacement machine.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Triangle {
    /// Energy leaves with the oil.
    Outward,
    /// Energy comes with the oil.
    Inward,
}

impl Board<'_> {
    /// A circle between two lines, with its shaft above.
    pub(super) fn displacement(&mut self, triangle: Triangle) {
        self.line("", &[[-86.0, 0.0], [86.0, 0.0]]);
        self.line("rail", &[[0.0, 20.0], [0.0, 46.0]]);
        self.paper.circle("plate", self.middle, 20.0);
        let head = match triangle {
            Triangle::Outward => [[20.0, 0.0], [8.0, 7.0], [8.0, -7.0]],
            Triangle::Inward => [[-8.0, 0.0], [-20.0, 7.0], [-20.0, -7.0]],
        };
        self.paper.polygon("black", &head.map(|at| self.at(at)));
    }

    /// A ball in its seat.
    pub(super) fn check(&mut self) {
        self.line("", &[[-86.0, 0.0], [-16.0, 0.0]]);
        self.line("rail", &[[0.0, 18.0], [-16.0, 0.0], [0.0, -18.0]]);
        self.paper.circle("plate", self.at([-4.0, 0.0]), 8.0);
        self.line("", &[[4.0, 0.0], [86.0, 0.0]]);
    }

    /// A square with an arrow that a spring holds beside the line.
    pub(super) fn relief(&mut self) {
        self.line("", &[[-86.0, 0.0], [-20.0, 0.0]]);
        self.line("", &[[20.0, 0.0], [86.0, 0.0]]);
        self.plate("plate", [-20.0, -20.0], [20.0, 20.0]);
        self.arrow("axis", [-20.0, 8.0], [20.0, 8.0]);
        self.paper.line("", &zigzag(self.at([0.0, -20.0]), self.at([0.0, -44.0])));
        self.line("dash", &[[-40.0, 0.0], [-40.0, 32.0], [0.0, 32.0], [0.0, 20.0]]);
    }

    /// An orifice under an arrow: adjustable, and compensated.
    pub(super) fn flow_control(&mut self) {
        self.orifice();
        self.arrow("axis", [-26.0, -30.0], [26.0, 30.0]);
        self.arrow("axis", [-40.0, 0.0], [40.0, 0.0]);
    }

    /// A capsule with gas above oil.
    pub(super) fn accumulator(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-60.0, 0.0], [-60.0, -40.0], [0.0, -40.0], [0.0, -32.0]]);
        let half = |from: f64, middle: f64| {
            (0..=12).map(move |k| {
                let (sin, cos) = (from + PI * f64::from(k) / 12.0).sin_cos();
                [18.0 * cos, middle + 18.0 * sin]
            })
        };
        let capsule: Vec<Point> = half(0.0, 14.0).chain(half(PI, -14.0)).map(|at| self.at(at)).collect();
        self.paper.polygon("plate", &capsule);
        self.line("", &[[-18.0, 0.0], [18.0, 0.0]]);
        self.text("small", [0.0, 14.0], "gas");
    }
}
