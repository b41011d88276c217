//! Force elements and sensors: springs, jacks, forces, and user-defined parts.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::Sense;
use super::paper::{Point, beside};
use super::stage::Stage;
use crate::Part;

/// Length of the arrow of a sense, in pixels.
const ARROW: f64 = 50.0;
/// From a port to the letter of its sensor.
const LEAD: f64 = 52.0;

impl Stage<'_> {
    pub(super) fn draw_elements(&mut self) {
        let parts = &self.sketch.mechanism.parts;
        let is_somewhere = |part: &&Part| !part.frames.is_empty() || !part.shapes.is_empty();
        for part in parts.iter().filter(|part| part.pair.is_none()).filter(is_somewhere) {
            let is_made_of_others = parts
                .iter()
                .any(|other| other.name.strip_prefix(&part.name).is_some_and(|rest| rest.starts_with('.')));
            match (part.kind.as_str(), part.frames.len()) {
                ("force", _) => self.draw_force(part),
                ("frame_axes", _) => self.draw_axes_of(part),
                ("position_sensor", _) => self.draw_sensor(part, "x"),
                ("velocity_sensor", _) => self.draw_sensor(part, "v"),
                ("acceleration_sensor", _) => self.draw_sensor(part, "a"),
                ("gear" | "rack" | "belt" | "elastic_belt" | "chain", _) => self.draw_wheels(part),
                ("fall", _) => self.draw_fall(part),
                ("spring", _) => self.draw_link(part),
                _ if !part.shapes.is_empty() => self.draw_shapes(part),
                (_, 2..) if !is_made_of_others => self.draw_link(part),
                _ => {}
            }
        }
    }

    /// A part between two frames.
    fn draw_link(&mut self, part: &Part) {
        let Some((a, b, on_ground)) = self.ends(part) else { return };
        let length = (b.at[0] - a.at[0]).hypot(b.at[1] - a.at[1]);
        let angle = (a.at[1] - b.at[1]).atan2(b.at[0] - a.at[0]);
        // A place by its part of the way and its distance to the left.
        let at = |part: f64, left: f64| beside(beside(a.at, angle, part * length), angle + FRAC_PI_2, left);
        let class = self.class(&part.name, "");
        let width = match part.kind.as_str() {
            "spring" if part.shapes.is_empty() => {
                self.paper.line(&class, &zigzag(a.at, b.at));
                9.0
            }
            "jack" | "gas_spring" => {
                let barrel = [at(0.06, 9.0), at(0.62, 9.0), at(0.62, -9.0), at(0.06, -9.0)];
                self.paper.line(&class, &[a.at, at(0.06, 0.0)]);
                self.paper.polygon(&self.class(&part.name, "plate"), &barrel);
                self.paper.line(&self.class(&part.name, "rail"), &[at(0.42, -9.0), at(0.42, 9.0)]);
                self.paper.line(&self.class(&part.name, "rail"), &[at(0.42, 0.0), b.at]);
                9.0
            }
            "spring" => {
                part.shapes.iter().for_each(|shape| self.draw_shape(part, shape));
                9.0
            }
            _ => {
                self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
                3.0
            }
        };
        self.support(a.at, on_ground, angle);
        self.support(b.at, part.frames[1].body.is_none(), angle + PI);
        for end in [a, b] {
            self.paper.circle(&self.class(&part.name, "white"), end.at, 3.5);
        }
        if self.has_signs(part) && matches!(part.kind.as_str(), "spring" | "jack" | "gas_spring") {
            let aside = width + 9.0;
            self.paper.arrow("force", at(0.62, aside), at(0.98, aside));
            self.paper.arrow("force", at(0.38, aside), at(0.02, aside));
            self.name("force", "sign", at(0.8, aside), 4.0);
        }
        self.name_of(&part.name, at(0.5, 0.0), width + 2.0);
    }

    fn draw_force(&mut self, part: &Part) {
        let Some(spot) = part.frames.first().and_then(|frame| self.frame(frame)) else { return };
        let along = |angle: f64, name: &str| Sense::Along(angle, name.to_owned());
        let usual = vec![along(0.0, "x"), along(FRAC_PI_2, "y")];
        let senses = self.sketch.senses.get(&part.name).unwrap_or(&usual);
        for sense in senses {
            match sense {
                Sense::Along(angle, text) => self.draw_sense(spot.at, *angle, text),
                Sense::Turn(text) => self.draw_turn(spot.at, text),
            }
        }
        self.name_of(&part.name, spot.at, 9.0);
    }

    /// A positive direction at a place.
    fn draw_sense(&mut self, at: Point, angle: f64, text: &str) {
        let [from, tip] = [9.0, ARROW].map(|distance| beside(at, angle, distance));
        self.paper.arrow("force", from, tip);
        self.name(text, "sign", tip, 4.0);
    }

    /// The directions of a frame as ports of their own.
    fn draw_axes_of(&mut self, part: &Part) {
        let Some(spot) = part.frames.first().and_then(|frame| self.frame(frame)) else { return };
        for (angle, name) in [(0.0, "x"), (FRAC_PI_2, "y")] {
            self.draw_sense(spot.at, angle, name);
        }
        self.draw_turn(spot.at, "shaft");
        self.name_of(&part.name, spot.at, 9.0);
    }

    /// A dashed line from the port to the letter of the measured quantity, away from the body.
    fn draw_sensor(&mut self, part: &Part, letter: &str) {
        let Some(frame) = part.frames.first() else { return };
        let (Some(spot), Some(centre)) = (self.frame(frame), self.port(frame.body, None)) else { return };
        let from = [spot.at[0] - centre.at[0], centre.at[1] - spot.at[1]];
        let away = if from[0].hypot(from[1]) > 5.0 { from[1].atan2(from[0]) } else { FRAC_PI_4 };
        let aside = if self.has_signs(part) { 3.0 * FRAC_PI_4 } else { FRAC_PI_4 };
        let [rim, at] = [LEAD - 11.0, LEAD].map(|distance| beside(spot.at, away + aside, distance));
        if self.has_signs(part) {
            self.draw_sense(spot.at, 0.0, "x");
            self.draw_sense(spot.at, FRAC_PI_2, "y");
            self.draw_turn(spot.at, "rotary");
        }
        self.paper.line(&self.class(&part.name, "dash"), &[spot.at, rim]);
        self.paper.circle(&self.class(&part.name, "white"), at, 11.0);
        self.paper.text("name", at, letter);
        self.name_of(&part.name, at, 11.0);
    }
}

/// The line of a spring between two points: teeth of one size, straight ends.
pub(super) fn zigzag(a: Point, b: Point) -> Vec<Point> {
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let angle = (a[1] - b[1]).atan2(b[0] - a[0]);
    let teeth = ((length - 24.0) / 9.0).floor().clamp(4.0, 14.0);
    let lead = 0.5 * (length - 9.0 * teeth).max(0.2 * length);
    let pitch = (length - 2.0 * lead) / teeth;
    let tooth = |k: f64| {
        let side = if k as i64 % 2 == 0 { 7.5 } else { -7.5 };
        beside(beside(a, angle, lead + pitch * (k + 0.5)), angle + FRAC_PI_2, side)
    };
    let between = (0..teeth as i64).map(|k| tooth(k as f64));
    let ends = [0.0, lead, length - lead, length].map(|along| beside(a, angle, along));
    [ends[0], ends[1]].into_iter().chain(between).chain([ends[2], ends[3]]).collect()
}
