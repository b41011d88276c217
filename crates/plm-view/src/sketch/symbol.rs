//! Signs of parts without a place in the plane, as they stand in boxes.

use std::f64::consts::TAU;

mod hydraulics;

use self::hydraulics::Triangle;
use super::element::zigzag;
use super::paper::{Paper, Point};

/// Sign within a box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A zigzag over a damper.
    SpringDamper,
    /// A coil between two shafts.
    ShaftSpring,
    /// A block.
    Mass,
    /// A disc on a shaft.
    Rotor,
    /// A block between two stops.
    Stops,
    /// The hatched ground.
    Ground,
    /// A point that is moved.
    Motion,
    /// Two arcs that leave a gap.
    Orifice,
    /// A closed volume.
    Volume,
    /// One chamber and a rod.
    Piston,
    /// Two chambers and a rod.
    Cylinder,
    /// A circle with a triangle: a pump.
    Source,
    /// An open tank.
    Tank,
    /// A valve of three positions and four ports.
    Valve,
    /// A pipe.
    Line,
    /// A step response of first order.
    Lag,
    /// A step response that swings.
    Swing,
    /// A piecewise linear course.
    Ramps,
    /// A course that jumps at equal intervals.
    Samples,
    /// A loop of two levels.
    Hysteresis,
    /// A line between two bounds.
    Saturation,
    /// A circle with a triangle that points outwards, and a shaft.
    Pump,
    /// A circle with a triangle that points inwards, and a shaft.
    Motor,
    /// A ball in its seat.
    Check,
    /// A valve that a pressure opens against a spring.
    Relief,
    /// An orifice that is adjusted and compensated.
    FlowControl,
    /// A capsule with gas and oil.
    Accumulator,
    /// Two gears in mesh, seen from the side.
    Gears,
    /// A ring, a sun and planets.
    Planetary,
    /// A worm below its wheel.
    Worm,
    /// A nut on a thread.
    Screw,
    /// A rope over a drum, with both ends to one side or to both.
    Rope,
    /// A drum with a rope that leaves it.
    Winch,
    /// A rope that is wrapped round a drum.
    Capstan,
    /// An idler that bends a strand.
    Tensioner,
    /// A disc between linings.
    Brake,
    /// Two plates.
    Clutch,
    /// A ring with a wedge, which holds in one sense.
    Freewheel,
    /// A drum with two shoes.
    Drum,
    /// A circle with a letter.
    ElectricMotor,
    /// A text.
    Text(String),
}

impl Symbol {
    /// Draws it around a place, some 120 pixels wide; lines to ports go on to 86 pixels from it.
    pub(super) fn draw(&self, paper: &mut Paper, middle: Point) {
        let mut board = Board { paper, middle };
        match self {
            Symbol::SpringDamper => board.spring_damper(),
            Symbol::ShaftSpring => board.shaft_spring(),
            Symbol::Mass => board.mass(),
            Symbol::Rotor => board.rotor(),
            Symbol::Stops => board.stops(),
            Symbol::Ground => board.ground(),
            Symbol::Motion => board.motion(),
            Symbol::Orifice => board.orifice(),
            Symbol::Volume => board.volume(),
            Symbol::Piston => board.cylinder(36.0, &["p"]),
            Symbol::Cylinder => board.cylinder(56.0, &["p1", "p2"]),
            Symbol::Source => board.source(),
            Symbol::Tank => board.tank(),
            Symbol::Valve => board.valve(),
            Symbol::Line => board.pipe(),
            Symbol::Lag => board.curve(|t| 1.0 - (-4.0 * t).exp()),
            Symbol::Swing => {
                board.curve(|t| 1.0 - (-5.0 * t).exp() * ((14.0 * t).cos() + 0.36 * (14.0 * t).sin()));
            }
            Symbol::Ramps => board.ramps(),
            Symbol::Samples => board.samples(),
            Symbol::Hysteresis => board.hysteresis(),
            Symbol::Saturation => board.saturation(),
            Symbol::Pump => board.displacement(Triangle::Outward),
            Symbol::Motor => board.displacement(Triangle::Inward),
            Symbol::Check => board.check(),
            Symbol::Relief => board.relief(),
            Symbol::FlowControl => board.flow_control(),
            Symbol::Accumulator => board.accumulator(),
            Symbol::Gears => board.gears(),
            Symbol::Planetary => board.planetary(),
            Symbol::Worm => board.worm(),
            Symbol::Screw => board.screw(),
            Symbol::Rope => board.rope(),
            Symbol::Winch => board.winch(),
            Symbol::Capstan => board.capstan(),
            Symbol::Tensioner => board.tensioner(),
            Symbol::Brake => board.brake(),
            Symbol::Clutch => board.clutch(),
            Symbol::Freewheel => board.freewheel(),
            Symbol::Drum => board.drum(),
            Symbol::ElectricMotor => board.motor(),
            Symbol::Text(text) => board.paper.text("name", middle, text),
        }
    }
}

/// A paper with places from a middle, in pixels, y upwards.
pub(super) struct Board<'a> {
    pub(super) paper: &'a mut Paper,
    pub(super) middle: Point,
}

impl Board<'_> {
    pub(super) fn at(&self, [x, y]: Point) -> Point {
        [self.middle[0] + x, self.middle[1] - y]
    }

    pub(super) fn line(&mut self, class: &str, points: &[Point]) {
        let points: Vec<Point> = points.iter().map(|at| self.at(*at)).collect();
        self.paper.line(class, &points);
    }

    pub(super) fn arrow(&mut self, class: &str, from: Point, to: Point) {
        self.paper.arrow(class, self.at(from), self.at(to));
    }

    /// A rectangle between two corners.
    pub(super) fn plate(&mut self, class: &str, [left, low]: Point, [right, high]: Point) {
        let corners = [[left, high], [right, high], [right, low], [left, low]].map(|at| self.at(at));
        self.paper.polygon(class, &corners);
    }

    pub(super) fn text(&mut self, class: &str, at: Point, text: &str) {
        self.paper.text(class, self.at(at), text);
    }

    /// Five strokes of the ground.
    pub(super) fn hatch(&mut self, first: Point, step: Point, stroke: Point) {
        for k in 0..5 {
            let from = [0, 1].map(|axis| first[axis] + f64::from(k) * step[axis]);
            self.line("ground", &[from, [from[0] + stroke[0], from[1] + stroke[1]]]);
        }
    }

    fn spring_damper(&mut self) {
        for side in [-1.0, 1.0] {
            self.line("rail", &[[86.0 * side, 0.0], [62.0 * side, 0.0]]);
            self.line("", &[[62.0 * side, 18.0], [62.0 * side, -18.0]]);
        }
        self.paper.line("", &zigzag(self.at([-62.0, 18.0]), self.at([62.0, 18.0])));
        self.line("", &[[-62.0, -18.0], [-18.0, -18.0]]);
        self.line("", &[[22.0, -9.0], [-18.0, -9.0], [-18.0, -27.0], [22.0, -27.0]]);
        self.line("rail", &[[6.0, -11.0], [6.0, -25.0]]);
        self.line("", &[[6.0, -18.0], [62.0, -18.0]]);
    }

    fn shaft_spring(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-45.0, 0.0]]);
        self.line("rail", &[[45.0, 0.0], [86.0, 0.0]]);
        let turns = (0..=60).map(|k| f64::from(k) / 60.0);
        let coil: Vec<Point> = turns
            .map(|k| {
                let (sin, cos) = (5.0 * TAU * k).sin_cos();
                [90.0 * k - 52.0 + 7.0 * cos, 15.0 * sin]
            })
            .collect();
        self.line("", &coil);
    }

    fn mass(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-34.0, 0.0]]);
        self.plate("plate", [-34.0, -22.0], [34.0, 22.0]);
        self.text("name", [0.0, 0.0], "mass");
    }

    fn rotor(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [30.0, 0.0]]);
        self.plate("plate", [-9.0, -34.0], [9.0, 34.0]);
        for (side, out) in [(4.0, 1.0), (-4.0, -1.0)] {
            self.line("ground", &[[18.0, side], [46.0, side]]);
            self.hatch([19.0, side], [6.0, 0.0], [5.0, 7.0 * out]);
        }
    }

    fn stops(&mut self) {
        self.line("rail", &[[-86.0, -26.0], [64.0, -26.0]]);
        self.line("", &[[-86.0, 0.0], [-86.0, -26.0]]);
        for x in [-58.0, 64.0] {
            self.line("rail", &[[x, 14.0], [x, -26.0]]);
        }
        self.plate("plate", [-14.0, -16.0], [10.0, 8.0]);
        self.line("rail", &[[10.0, 0.0], [86.0, 0.0]]);
        for (from, to, text) in [(-14.0, -56.0, "gap2"), (10.0, 62.0, "gap1")] {
            self.arrow("axis", [from, 14.0], [to, 14.0]);
            self.text("small", [0.5 * (from + to), 27.0], text);
        }
    }

    pub(super) fn ground(&mut self) {
        self.line("rail", &[[0.0, 0.0], [86.0, 0.0]]);
        self.line("ground", &[[0.0, 24.0], [0.0, -24.0]]);
        self.hatch([0.0, 24.0], [0.0, -10.0], [-9.0, -9.0]);
    }

    fn motion(&mut self) {
        self.line("rail", &[[0.0, 0.0], [86.0, 0.0]]);
        self.arrow("axis", [-40.0, 20.0], [40.0, 20.0]);
        self.paper.circle("black", self.middle, 5.0);
    }

    fn orifice(&mut self) {
        self.line("", &[[-86.0, 0.0], [86.0, 0.0]]);
        for side in [-1.0, 1.0] {
            let arc: Vec<Point> = (-8..=8)
                .map(|k| f64::from(k) / 8.0)
                .map(|k| [22.0 * k, side * (6.0 + 12.0 * k * k)])
                .collect();
            self.line("rail", &arc);
        }
    }

    fn volume(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [-34.0, 0.0]]);
        self.plate("plate", [-34.0, -26.0], [34.0, 26.0]);
        self.text("name", [0.0, 0.0], "p, V");
    }

    /// A barrel that ends at `end`, with its rod to the right and one chamber or two; two are closed.
    fn cylinder(&mut self, end: f64, chambers: &[&str]) {
        let barrel = [[end, 22.0], [-62.0, 22.0], [-62.0, -22.0], [end, -22.0]];
        self.line("", &barrel);
        if let [_, second] = chambers {
            self.line("", &[[end, 22.0], [end, -22.0]]);
            self.text("small", [0.5 * (end + 6.0), 11.0], second);
            for x in [-43.0, 43.0] {
                self.line("", &[[x, 22.0], [x, 46.0]]);
            }
        } else {
            self.line("", &[[-62.0, 0.0], [-86.0, 0.0]]);
        }
        self.plate("plate", [-6.0, -21.0], [6.0, 21.0]);
        self.line("rail", &[[6.0, 0.0], [86.0, 0.0]]);
        self.text("small", [-34.0, 0.0], chambers[0]);
    }

    fn source(&mut self) {
        self.line("rail", &[[20.0, 0.0], [86.0, 0.0]]);
        self.paper.circle("plate", self.middle, 20.0);
        let head = [[20.0, 0.0], [8.0, 7.0], [8.0, -7.0]].map(|at| self.at(at));
        self.paper.polygon("black", &head);
    }

    fn tank(&mut self) {
        self.line("rail", &[[-86.0, 0.0], [0.0, 0.0], [0.0, -16.0]]);
        self.line("rail", &[[-26.0, -6.0], [-26.0, -28.0], [26.0, -28.0], [26.0, -6.0]]);
        self.line("", &[[-26.0, -13.0], [26.0, -13.0]]);
    }

    /// The three positions: straight, closed, crossed.
    fn valve(&mut self) {
        for left in [-66.0, -22.0, 22.0] {
            self.plate("plate", [left, -20.0], [left + 44.0, 20.0]);
        }
        self.arrow("axis", [-54.0, -18.0], [-54.0, 18.0]);
        self.arrow("axis", [-34.0, 18.0], [-34.0, -18.0]);
        for x in [-10.0, 10.0] {
            for side in [-1.0, 1.0] {
                self.line("", &[[x, 20.0 * side], [x, 10.0 * side]]);
                self.line("", &[[x - 5.0, 10.0 * side], [x + 5.0, 10.0 * side]]);
            }
        }
        self.arrow("axis", [34.0, -18.0], [54.0, 18.0]);
        self.arrow("axis", [34.0, 18.0], [54.0, -18.0]);
    }

    fn pipe(&mut self) {
        for side in [-8.0, 8.0] {
            self.line("rail", &[[-86.0, side], [86.0, side]]);
        }
        self.arrow("force", [-30.0, 0.0], [30.0, 0.0]);
    }

    fn axes(&mut self) {
        self.arrow("axis", [-56.0, -28.0], [60.0, -28.0]);
        self.arrow("axis", [-56.0, -28.0], [-56.0, 32.0]);
        self.text("small", [66.0, -28.0], "t");
    }

    fn ramps(&mut self) {
        self.axes();
        let stages =
            [[-56.0, -28.0], [-36.0, -28.0], [-16.0, 14.0], [12.0, 14.0], [12.0, -4.0], [40.0, -28.0]];
        self.line("rail", &stages);
    }

    fn samples(&mut self) {
        self.axes();
        let height = |k: u32| 22.0 * (f64::from(k) * 0.9).sin();
        let steps = (0..7_u32).flat_map(|k| {
            let x = 15.0 * f64::from(k) - 52.0;
            [[x, height(k)], [x + 15.0, height(k)]]
        });
        let steps: Vec<Point> = steps.collect();
        self.line("rail", &steps);
    }

    fn hysteresis(&mut self) {
        self.line("rail", &[[-56.0, -20.0], [24.0, -20.0], [24.0, 20.0], [56.0, 20.0]]);
        self.line("rail", &[[24.0, 20.0], [-24.0, 20.0], [-24.0, -20.0]]);
        self.arrow("axis", [24.0, -16.0], [24.0, 6.0]);
        self.arrow("axis", [-24.0, 16.0], [-24.0, -6.0]);
    }

    fn saturation(&mut self) {
        self.arrow("axis", [-60.0, 0.0], [60.0, 0.0]);
        self.arrow("axis", [0.0, -34.0], [0.0, 36.0]);
        self.line("rail", &[[-56.0, -22.0], [-24.0, -22.0], [24.0, 22.0], [56.0, 22.0]]);
    }

    /// A course over the time from 0 to 1, whose end is some 1.
    fn curve(&mut self, of: impl Fn(f64) -> f64) {
        self.axes();
        let at = |t: f64, y: f64| [100.0 * t - 56.0, 36.0 * y - 28.0];
        self.line("dash", &[at(0.0, 1.0), at(1.0, 1.0)]);
        let points: Vec<Point> = (0..=40).map(|k| f64::from(k) / 40.0).map(|t| at(t, of(t))).collect();
        self.line("rail", &points);
    }
}
