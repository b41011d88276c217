//! Wheels of gears, racks, belts and chains by their pitch circles, and what runs on them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::paper::{Point, beside};
use super::stage::{Spot, Stage};
use crate::Part;

/// A wheel: where its centre is, its signed radius in pixels, and its frame in the part.
#[derive(Clone, Copy)]
struct Wheel {
    spot: Spot,
    radius: f64,
}

impl Stage<'_> {
    /// The wheels of a part: frame `a` with `radius_a` or `radius`, frame `b` with `radius_b`.
    fn wheels(&self, part: &Part) -> Vec<Wheel> {
        let sizes = [("a", ["radius_a", "radius"]), ("b", ["radius_b", "radius_b"])];
        let known = sizes.into_iter().filter_map(|(argument, names)| {
            let frame = part.frames.iter().find(|frame| frame.argument == argument)?;
            let radius = names.into_iter().find_map(|name| part.sizes.get(name))?;
            Some(Wheel { spot: self.frame(frame)?, radius: radius * self.scale })
        });
        known.collect()
    }

    /// Points on the rims of all wheels, which must be in the picture.
    pub(super) fn rims(&self) -> Vec<Point> {
        let wheels = self.sketch.mechanism.parts.iter().flat_map(|part| self.wheels(part));
        let rims = wheels.flat_map(|wheel| {
            [0.0, FRAC_PI_2, PI, -FRAC_PI_2].map(|angle| beside(wheel.spot.at, angle, wheel.radius))
        });
        rims.collect()
    }

    pub(super) fn draw_wheels(&mut self, part: &Part) {
        let wheels = self.wheels(part);
        let is_toothed = matches!(part.kind.as_str(), "gear" | "rack");
        let class = self.class(&part.name, if is_toothed { "dash" } else { "" });
        for wheel in &wheels {
            self.paper.circle(&class, wheel.spot.at, wheel.radius.abs());
            if is_toothed {
                self.draw_teeth(part, wheel);
            }
        }
        let strands = if let [a, b] = wheels[..] { Self::strands(part, a, b) } else { [].into() };
        for strand in strands {
            self.paper.line(&self.class(&part.name, "rail"), &strand);
        }
        if part.kind == "rack" {
            self.draw_line(part);
        }
        if self.has_signs(part) {
            let texts = if part.kind == "rack" { ["torque", ""] } else { ["torque_a", "torque_b"] };
            for (wheel, text) in wheels.iter().zip(texts) {
                self.draw_turn(wheel.spot.at, text);
            }
        }
        if let Some(wheel) = wheels.first() {
            self.name_of(&part.name, beside(wheel.spot.at, -FRAC_PI_2, wheel.radius.abs()), 9.0);
        }
    }

    /// Strokes across the pitch circle.
    fn draw_teeth(&mut self, part: &Part, wheel: &Wheel) {
        let radius = wheel.radius.abs();
        let count = (radius / 3.0).round().clamp(12.0, 60.0);
        let class = self.class(&part.name, "");
        for k in 0..count as i32 {
            let angle = wheel.spot.angle + TAU * f64::from(k) / count;
            let ends = [-3.5, 3.5].map(|over| beside(wheel.spot.at, angle, radius + over));
            self.paper.line(&class, &ends);
        }
    }

    /// Tangents of both strands, from the wheel of `a` to that of `b`.
    fn strands(part: &Part, a: Wheel, b: Wheel) -> Vec<[Point; 2]> {
        if part.kind == "gear" {
            return Vec::new();
        }
        let [x, y] = [b.spot.at[0] - a.spot.at[0], a.spot.at[1] - b.spot.at[1]];
        let (line, distance) = (y.atan2(x), x.hypot(y));
        let inclined = ((a.radius - b.radius) / distance).clamp(-1.0, 1.0).asin();
        let side = |sense: f64| {
            let normal = line + sense * (FRAC_PI_2 - inclined);
            [a, b].map(|wheel| beside(wheel.spot.at, normal, wheel.radius))
        };
        [1.0, -1.0].map(side).to_vec()
    }

    /// The pitch line of a rack: the x axis of its frame, under the pinion.
    fn draw_line(&mut self, part: &Part) {
        let frames = ["a", "b"].map(|name| part.frames.iter().find(|frame| frame.argument == name));
        let [Some(pinion), Some(rack)] = frames.map(|frame| frame.and_then(|frame| self.frame(frame))) else {
            return;
        };
        let [x, y] = [pinion.at[0] - rack.at[0], rack.at[1] - pinion.at[1]];
        let along = x * rack.angle.cos() + y * rack.angle.sin();
        let ends = [-70.0, 70.0].map(|more| beside(rack.at, rack.angle, along + more));
        self.paper.line(&self.class(&part.name, "rail"), &ends);
        let class = self.class(&part.name, "");
        for k in -6..=6 {
            let foot = beside(rack.at, rack.angle, along + 10.0 * f64::from(k));
            let ends = [-4.0, 4.0].map(|over| beside(foot, rack.angle + FRAC_PI_2, over));
            self.paper.line(&class, &ends);
        }
    }

    /// A straight part of a rope.
    pub(super) fn draw_fall(&mut self, part: &Part) {
        let Some((a, b, on_ground)) = self.ends(part) else { return };
        self.paper.line(&self.class(&part.name, "rail"), &[a.at, b.at]);
        let angle = (a.at[1] - b.at[1]).atan2(b.at[0] - a.at[0]);
        self.support(a.at, on_ground, angle);
        self.support(b.at, part.frames[1].body.is_none(), angle + PI);
        if self.has_signs(part) {
            for (from, towards) in [(a.at, angle), (b.at, angle + PI)] {
                let from = beside(from, towards + FRAC_PI_2, 9.0);
                self.paper.arrow("force", beside(from, towards, 6.0), beside(from, towards, 46.0));
            }
            self.name("tension", "sign", beside(beside(a.at, angle, 30.0), angle + FRAC_PI_2, 9.0), 5.0);
        }
        let middle = [0, 1].map(|k| 0.5 * (a.at[k] + b.at[k]));
        self.name_of(&part.name, middle, 6.0);
    }
}
