//! Shapes of parts of contact and rolling: circles by their sizes, lines by the frame of that name, and the forces between them.
//!
//! A size `radius` is that of the frame `circle`, `wheel` or `hub`, a size `radius_a` that of the frame `a`. The x axis of a frame `line` is
//! a surface.

use std::f64::consts::FRAC_PI_2;

use plm_view::{Frame, Part};

use super::paper::{Point, beside};
use super::stage::{Spot, Stage};

/// Frames that a size `radius` belongs to.
const ROUND: [&str; 3] = ["circle", "wheel", "hub"];
/// Frames of bodies whose outline is the shape.
const OUTLINED: [&str; 4] = ["profile", "curve", "cam", "carrier"];
/// How far a surface goes on behind its ends, in pixels.
const BEYOND: f64 = 70.0;
/// Length of the arrow of a force, in pixels.
const ARROW: f64 = 44.0;
/// Parts whose forces are called load and traction.
const LOADED: [&str; 4] = ["wheel", "tyre", "rolling", "rolling_on_circle"];

/// Circles of a part: frames and radii, m.
pub(super) fn circles(part: &Part) -> impl Iterator<Item = (&Frame, f64)> {
    part.frames.iter().filter_map(|frame| {
        let name = frame.argument.as_str();
        let of_name = part.sizes.get(&format!("radius_{name}"));
        let size = of_name.or_else(|| part.sizes.get("radius").filter(|_| ROUND.contains(&name)));
        size.filter(|radius| **radius > 0.0).map(|radius| (frame, *radius))
    })
}

/// Has a part shapes of its own, or is it between outlines of bodies?
pub(super) fn has_shape(part: &Part) -> bool {
    let is_between_outlines = part.frames.iter().any(|frame| OUTLINED.contains(&frame.argument.as_str()));
    is_between_outlines || line(part).is_some() || circles(part).next().is_some()
}

fn line(part: &Part) -> Option<&Frame> {
    part.frames.iter().find(|frame| frame.argument == "line")
}

impl Stage<'_> {
    pub(super) fn draw_shape(&mut self, part: &Part) {
        if let Some(frame) = line(part) {
            self.draw_surface(part, frame);
        }
        for (frame, radius) in circles(part) {
            if let Some(spot) = self.frame(frame) {
                self.draw_circle(part, spot, radius);
            }
        }
        if let Some((at, normal)) = self.touch(part).filter(|_| self.has_signs(part)) {
            let names =
                if LOADED.contains(&part.kind.as_str()) { ["load", "traction"] } else { ["push", "drag"] };
            let tangent = if line(part).is_some() { normal - FRAC_PI_2 } else { normal + FRAC_PI_2 };
            for (angle, name) in [(normal, names[0]), (tangent, names[1])] {
                let tip = beside(at, angle, ARROW);
                self.paper.arrow("force", beside(at, angle, 4.0), tip);
                self.name(name, "sign", tip, 4.0);
            }
        }
        if let Some(spot) = part.frames.last().and_then(|frame| self.frame(frame)) {
            self.name_of(&part.name, spot.at, 9.0);
        }
    }

    /// The x axis of a frame, as long as what lies on it.
    fn draw_surface(&mut self, part: &Part, frame: &Frame) {
        let Some(a) = self.frame(frame) else { return };
        let others = part.frames.iter().filter_map(|frame| self.frame(frame));
        let places =
            others.map(|b| (b.at[0] - a.at[0]) * a.angle.cos() - (b.at[1] - a.at[1]) * a.angle.sin());
        let (low, high) = places.fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
        let (from, to) = (low - BEYOND, high + BEYOND);
        let ends = [from, to].map(|along| beside(a.at, a.angle, along));
        if frame.body.is_none() {
            self.hatch(beside(a.at, a.angle, 0.5 * (from + to)), a.angle, 0.5 * (to - from));
        } else {
            self.paper.line(&self.class(&part.name, "rail"), &ends);
        }
        let tick = [-6.0, 6.0].map(|side| beside(a.at, a.angle + FRAC_PI_2, side));
        self.paper.line(&self.class(&part.name, ""), &tick);
    }

    /// A circle with its centre, and a radius that turns with it.
    fn draw_circle(&mut self, part: &Part, spot: Spot, radius: f64) {
        let size = self.pixels(radius);
        let rim: Vec<Point> =
            (0..=72).map(|k| beside(spot.at, spot.angle + f64::from(k) * 5_f64.to_radians(), size)).collect();
        self.paper.line(&self.class(&part.name, ""), &rim);
        self.paper.line(&self.class(&part.name, "dash"), &[spot.at, beside(spot.at, spot.angle, size)]);
        self.paper.circle(&self.class(&part.name, "white"), spot.at, 3.0);
    }

    /// The place of the contact, and the direction of the normal force on the last frame.
    fn touch(&self, part: &Part) -> Option<(Point, f64)> {
        let (a, b, _) = self.ends(part)?;
        let radius = |frame: &Frame| {
            circles(part).find(|(of, _)| std::ptr::eq(*of, frame)).map(|(_, size)| self.pixels(size))
        };
        let [first, second] = [&part.frames[0], &part.frames[1]].map(radius);
        if line(part).is_some() {
            let normal = a.angle + FRAC_PI_2;
            return Some((beside(b.at, normal, -second.unwrap_or(0.0)), normal));
        }
        let rim = first?;
        let reach = [b.at[0] - a.at[0], a.at[1] - b.at[1]];
        let outwards = reach[1].atan2(reach[0]);
        let is_inside = second.is_some() && reach[0].hypot(reach[1]) < rim;
        let normal = if is_inside { outwards + 2.0 * FRAC_PI_2 } else { outwards };
        Some((beside(a.at, outwards, rim), normal))
    }
}
