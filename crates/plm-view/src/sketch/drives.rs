//! Symbols of transmissions, drives and brakes.

use std::f64::consts::{FRAC_PI_2, PI};

use super::paper::Point;
use super::symbol::Board;

impl Board<'_> {
    fn disc(&mut self, class: &str, at: Point, radius: f64) {
        let at = self.at(at);
        self.paper.circle(class, at, radius);
    }

    /// Part of a circle, from one angle to another.
    fn arc(&mut self, class: &str, [x, y]: Point, radius: f64, [from, to]: [f64; 2]) {
        let angles = (0..=24).map(|k| from + (to - from) * f64::from(k) / 24.0);
        let points: Vec<Point> = angles.map(|a| [x + radius * a.cos(), y + radius * a.sin()]).collect();
        self.line(class, &points);
    }

    /// Both halves of a shaft, which ends at a distance from the middle.
    fn shafts(&mut self, end: f64) {
        for side in [-1.0, 1.0] {
            self.line("rail", &[[86.0 * side, 0.0], [end * side, 0.0]]);
        }
    }

    /// Ground on a side, with a stem that leads to it.
    fn stand(&mut self, from: Point) {
        self.line("", &[from, [from[0], -38.0]]);
        self.line("ground", &[[from[0] - 14.0, -38.0], [from[0] + 14.0, -38.0]]);
        self.hatch([from[0] - 14.0, -38.0], [7.0, 0.0], [-5.0, -6.0]);
    }

    pub(super) fn gears(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-60.0, 0.0], [-60.0, -20.0], [10.0, -20.0]]);
        self.line("rail", &[[86.0, 0.0], [60.0, 0.0], [60.0, 14.0], [-10.0, 14.0]]);
        self.plate("plate", [-6.0, -30.0], [6.0, -8.0]);
        self.plate("plate", [-6.0, -8.0], [6.0, 38.0]);
    }

    pub(super) fn planetary(&mut self) {
        self.disc("plate", [0.0, 0.0], 40.0);
        self.disc("white", [0.0, 0.0], 36.0);
        self.disc("plate", [0.0, 0.0], 13.0);
        for k in 0..3 {
            let angle = FRAC_PI_2 + 2.0 * PI * f64::from(k) / 3.0;
            self.line("rail", &[[0.0, 0.0], [24.5 * angle.cos(), 24.5 * angle.sin()]]);
            self.disc("plate", [24.5 * angle.cos(), 24.5 * angle.sin()], 11.0);
        }
        self.disc("black", [0.0, 0.0], 3.0);
    }

    pub(super) fn worm(&mut self) {
        self.line("rail", &[[-86.0, -24.0], [34.0, -24.0]]);
        self.line("", &[[-86.0, 0.0], [-86.0, -24.0]]);
        self.plate("plate", [-30.0, -34.0], [30.0, -14.0]);
        for k in 0..5 {
            let x = 11.0 * f64::from(k) - 26.0;
            self.line("", &[[x, -34.0], [x + 8.0, -14.0]]);
        }
        self.disc("plate", [0.0, 12.0], 26.0);
        self.line("rail", &[[0.0, 12.0], [86.0, 12.0], [86.0, 0.0]]);
        self.disc("black", [0.0, 12.0], 3.0);
    }

    pub(super) fn screw(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-58.0, 0.0]]);
        let teeth = (0..=14).map(|k| [8.0 * f64::from(k) - 58.0, if k % 2 == 0 { 7.0 } else { -7.0 }]);
        self.line("", &teeth.collect::<Vec<Point>>());
        self.plate("plate", [-4.0, -20.0], [26.0, 20.0]);
        self.line("rail", &[[26.0, 14.0], [86.0, 14.0], [86.0, 0.0]]);
    }

    pub(super) fn rope(&mut self) {
        self.disc("plate", [0.0, 6.0], 22.0);
        self.disc("black", [0.0, 6.0], 3.0);
        self.arc("rail", [0.0, 6.0], 22.0, [0.0, PI]);
        self.line("rail", &[[-22.0, 6.0], [-22.0, -36.0]]);
        self.line("rail", &[[22.0, 6.0], [22.0, -36.0]]);
    }

    pub(super) fn winch(&mut self) {
        self.line("rail", &[[86.0, 0.0], [0.0, 0.0]]);
        self.disc("plate", [0.0, 0.0], 26.0);
        self.disc("", [0.0, 0.0], 21.0);
        self.disc("black", [0.0, 0.0], 3.0);
        self.line("rail", &[[0.0, 26.0], [-72.0, 26.0], [-86.0, 0.0]]);
    }

    pub(super) fn capstan(&mut self) {
        self.disc("plate", [0.0, 0.0], 24.0);
        self.disc("black", [0.0, 0.0], 3.0);
        self.arc("rail", [0.0, 0.0], 24.0, [0.35 * PI, 0.65 * PI]);
        self.line("rail", &[[-10.9, 21.4], [-62.0, -5.0], [-86.0, 0.0]]);
        self.line("rail", &[[10.9, 21.4], [62.0, -5.0], [86.0, 0.0]]);
    }

    pub(super) fn tensioner(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-70.0, -14.0], [0.0, 16.0], [70.0, -14.0]]);
        self.disc("plate", [0.0, 4.0], 12.0);
        self.disc("black", [0.0, 4.0], 3.0);
        self.line("", &[[0.0, 4.0], [0.0, -24.0], [86.0, -24.0], [86.0, 0.0]]);
    }

    pub(super) fn brake(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [30.0, 0.0]]);
        self.plate("plate", [-5.0, -30.0], [5.0, 30.0]);
        for side in [-1.0, 1.0] {
            let (near, far) = (7.0 * side, 17.0 * side);
            self.plate("black", [near, 12.0], [far, 30.0]);
            self.arrow("force", [42.0 * side, 21.0], [20.0 * side, 21.0]);
        }
    }

    pub(super) fn clutch(&mut self) {
        self.shafts(6.0);
        for side in [-1.0, 1.0] {
            let (near, far) = (3.0 * side, 9.0 * side);
            self.plate("plate", [near, -30.0], [far, 30.0]);
        }
    }

    pub(super) fn freewheel(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [0.0, 0.0]]);
        self.line("rail", &[[34.0, 0.0], [86.0, 0.0]]);
        self.disc("", [0.0, 0.0], 34.0);
        self.disc("plate", [0.0, 0.0], 18.0);
        for k in 0..3 {
            let angle = FRAC_PI_2 + 2.0 * PI * f64::from(k) / 3.0;
            let corner =
                |radius: f64, turn: f64| [radius * (angle + turn).cos(), radius * (angle + turn).sin()];
            let wedge = [corner(18.0, 0.3), corner(33.0, -0.1), corner(20.0, -0.25)].map(|at| self.at(at));
            self.paper.polygon("black", &wedge);
        }
    }

    pub(super) fn drum(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [0.0, 0.0]]);
        self.disc("", [0.0, 0.0], 38.0);
        for side in [0.0, PI] {
            self.arc("rail", [0.0, 0.0], 34.0, [side - 0.35 * PI, side + 0.35 * PI]);
            self.arc("", [0.0, 0.0], 28.0, [side - 0.35 * PI, side + 0.35 * PI]);
        }
        self.disc("black", [0.0, -26.0], 3.0);
        for side in [-1.0, 1.0] {
            self.arrow("force", [2.0 * side, 22.0], [18.0 * side, 22.0]);
        }
    }

    pub(super) fn motor(&mut self) {
        self.line("rail", &[[30.0, 0.0], [86.0, 0.0]]);
        self.disc("plate", [0.0, 0.0], 30.0);
        self.text("name", [0.0, 0.0], "M");
        self.stand([0.0, -30.0]);
    }
}
