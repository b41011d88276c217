//! Kinematic pairs: a circle for a revolute, a rail with a block for a prismatic, a slot with a pin, a square for a weld.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::paper::{Point, beside};
use super::stage::{Spot, Stage, top};
use crate::Part;

const PIN: f64 = 6.0;
/// Half of a block's length and width, in pixels.
const BLOCK: (f64, f64) = (21.0, 12.0);
/// How far from its middle the name of a block stands.
pub(super) const BESIDE_BLOCK: f64 = 19.0;
/// Half the width of a slot.
const SLOT: f64 = 8.5;
/// How far a rail goes on beyond its ends.
const BEYOND: f64 = 44.0;
/// Radius of the arc of a positive angle.
const ARC: f64 = 25.0;

impl Stage<'_> {
    /// Draws the rails, which lie under the bodies.
    pub(super) fn draw_rails(&mut self) {
        for part in &self.sketch.mechanism.parts {
            if part.pair.as_deref() == Some("prismatic") {
                self.draw_rail(part);
            }
        }
    }

    pub(super) fn draw_joints(&mut self) {
        for part in &self.sketch.mechanism.parts {
            let Some((a, b, on_ground)) = self.ends(part) else { continue };
            match part.pair.as_deref() {
                Some("revolute") => self.draw_revolute(part, a, b, on_ground),
                Some("prismatic") => self.draw_block(part, a, b),
                Some("pin_slot") => self.draw_slot(part, a, b, on_ground),
                Some("weld") => self.draw_weld(part, a, on_ground),
                _ => {}
            }
        }
    }

    fn draw_revolute(&mut self, part: &Part, a: Spot, b: Spot, on_ground: bool) {
        let towards = self.away(part, 1, a.at).unwrap_or(FRAC_PI_2);
        self.support(a.at, on_ground, towards);
        self.paper.circle(&self.class(&part.name, "white"), a.at, PIN);
        if self.has_signs(part) {
            self.draw_angle(part, a, b);
        }
        self.name_joint(part, a.at, PIN);
    }

    fn draw_weld(&mut self, part: &Part, a: Spot, on_ground: bool) {
        let square = [1.0, 3.0, 5.0, 7.0].map(|k| beside(a.at, a.angle + k * PI / 4.0, 9.0));
        self.paper.polygon(&self.class(&part.name, "black"), &square);
        let towards = self.away(part, 1, a.at).unwrap_or(FRAC_PI_2);
        self.support(a.at, on_ground, towards);
        self.name_joint(part, a.at, 9.0);
    }

    /// The angle of `b` against `a` at the point of `b`: from axis to axis where both can be seen, else a turn before the body.
    fn draw_angle(&mut self, part: &Part, a: Spot, b: Spot) {
        let between = (b.angle - a.angle).rem_euclid(TAU);
        if (0.35..2.8).contains(&between) {
            let axis = [14.0, 1.9 * ARC].map(|along| beside(b.at, a.angle, along));
            self.paper.line("dash", &axis);
            self.paper.turn("force", b.at, 1.6 * ARC, [a.angle, b.angle - 8.0 / (1.6 * ARC)]);
            self.name("angle", "sign", beside(b.at, a.angle + 0.5 * between, 1.6 * ARC), 5.0);
        } else {
            let towards = self.away(part, 1, b.at).unwrap_or(b.angle + 0.9);
            self.paper.turn("force", b.at, ARC, [towards - 1.5, towards - 0.25]);
            self.name("angle", "sign", beside(b.at, towards - 0.9, ARC), 3.0);
        }
    }

    /// The name of a joint, unless there are too many.
    fn name_joint(&mut self, part: &Part, at: Point, reach: f64) {
        if !self.is_crowded() {
            self.name_of(&part.name, at, reach);
        }
    }

    /// The direction in which the body of a frame lies from a place, rad; none where it lies there.
    fn away(&self, part: &Part, frame: usize, at: Point) -> Option<f64> {
        let body = part.frames.get(frame)?.body?;
        let ports = 0..self.sketch.mechanism.bodies.get(body)?.ports.len();
        let spots = ports.map(Some).chain([None]).filter_map(|port| self.port(Some(body), port));
        let reach = |spot: &Spot| (spot.at[0] - at[0]).hypot(spot.at[1] - at[1]);
        let farthest =
            spots.max_by(|a, b| reach(a).total_cmp(&reach(b))).filter(|spot| reach(spot) > 10.0)?;
        Some((at[1] - farthest.at[1]).atan2(farthest.at[0] - at[0]))
    }

    /// A pin's base on the ground, below it; above where what it holds hangs down (`towards`, rad).
    pub(super) fn support(&mut self, at: Point, on_ground: bool, towards: f64) {
        if on_ground {
            let down = if towards.sin() < -0.7 { FRAC_PI_2 } else { -FRAC_PI_2 };
            let base = beside(at, down, 18.0);
            let feet = [-11.0, 11.0].map(|side| [base[0] + side, base[1]]);
            self.paper.polygon("ground", &[at, feet[0], feet[1]]);
            self.hatch(base, down + FRAC_PI_2, 17.5);
        }
    }

    /// Coordinate of `b` along the x axis of `a`, in pixels.
    fn along(a: Spot, b: Spot) -> f64 {
        (b.at[0] - a.at[0]) * a.angle.cos() - (b.at[1] - a.at[1]) * a.angle.sin()
    }

    fn draw_rail(&mut self, part: &Part) {
        let Some((a, b, on_ground)) = self.ends(part) else { return };
        let along = Self::along(a, b);
        let (from, to) = (along.min(0.0) - BEYOND, along.max(0.0) + BEYOND);
        let ends = [from, to].map(|along| beside(a.at, a.angle, along));
        self.paper.line(&self.class(&part.name, "rail"), &ends);
        if on_ground {
            let middle = beside(beside(a.at, a.angle, 0.5 * (from + to)), a.angle - FRAC_PI_2, 2.0);
            self.hatch(middle, a.angle, 0.5 * (to - from));
        }
        let tick = [-6.0, 6.0].map(|side| beside(a.at, a.angle + FRAC_PI_2, side));
        self.paper.line(&self.class(&part.name, ""), &tick);
    }

    fn draw_block(&mut self, part: &Part, a: Spot, b: Spot) {
        let corner =
            |x: f64, y: f64| beside(beside(b.at, a.angle, x * BLOCK.0), a.angle + FRAC_PI_2, y * BLOCK.1);
        let block = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        self.paper.polygon(&self.class(&part.name, "plate"), &block);
        self.draw_displacement(part, a, b, BLOCK.1 + 13.0);
        let known = self.sketch.mechanism.bodies.iter().any(|body| top(&body.name) == top(&part.name));
        if !known {
            self.name_joint(part, b.at, BESIDE_BLOCK);
        }
    }

    fn draw_slot(&mut self, part: &Part, a: Spot, b: Spot, on_ground: bool) {
        let along = Self::along(a, b);
        let (from, to) = (along.min(0.0) - BEYOND, along.max(0.0) + BEYOND);
        let rim = |along: f64, turn: f64| {
            let centre = beside(a.at, a.angle, along);
            (0..=8).map(move |k| beside(centre, a.angle + turn + PI * f64::from(k) / 8.0, SLOT))
        };
        let outline: Vec<Point> = rim(to, -FRAC_PI_2).chain(rim(from, FRAC_PI_2)).collect();
        self.paper.polygon(&self.class(&part.name, ""), &outline);
        if on_ground {
            let middle = beside(beside(a.at, a.angle, 0.5 * (from + to)), a.angle - FRAC_PI_2, SLOT + 2.0);
            self.hatch(middle, a.angle, 0.5 * (to - from));
        }
        let tick = [-SLOT, SLOT].map(|side| beside(a.at, a.angle + FRAC_PI_2, side));
        self.paper.line(&self.class(&part.name, "dash"), &tick);
        self.paper.circle(&self.class(&part.name, "white"), b.at, PIN);
        self.draw_displacement(part, a, b, SLOT + 15.0);
        if self.has_signs(part) {
            self.draw_angle(part, a, b);
        }
        self.name_joint(part, b.at, SLOT + 3.0);
    }

    /// An arrow beside the axis from `a` to `b`; along it where they meet.
    fn draw_displacement(&mut self, part: &Part, a: Spot, b: Spot, aside: f64) {
        let parts = &self.sketch.mechanism.parts;
        let outer = parts.iter().find(|other| other.name == top(&part.name)).unwrap_or(part);
        let text = match outer.kind.as_str() {
            _ if !self.has_signs(part) => return,
            "sliding_mass" => "position",
            _ => "displacement",
        };
        let (along, up) = (Self::along(a, b), a.angle + FRAC_PI_2);
        let to = if along.abs() < 24.0 { 46.0 } else { along };
        let shown = [0.0, to].map(|along| beside(beside(a.at, a.angle, along), up, aside));
        let foot = [-5.0, 5.0].map(|side| beside(shown[0], up, side));
        self.paper.line("force", &foot);
        self.paper.arrow("force", shown[0], shown[1]);
        let middle = [0, 1].map(|k| 0.5 * (shown[0][k] + shown[1][k]));
        self.name(text, "sign", middle, 4.0);
    }

    /// A turn about a place, counter-clockwise.
    pub(super) fn draw_turn(&mut self, at: Point, text: &str) {
        self.paper.turn("force", at, ARC, [0.55 * TAU, 0.9 * TAU]);
        self.name(text, "sign", beside(at, 0.9 * TAU, ARC), 4.0);
    }
}
