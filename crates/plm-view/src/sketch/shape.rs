//! Shapes that the declarations of parts ask for, and the forces of contact between circles and lines.

use std::f64::consts::{FRAC_PI_2, PI};

use super::paper::{Point, beside};
use super::stage::Stage;
use crate::{Frame, Part, Shape};

/// The unit of symbols, in pixels.
const UNIT: f64 = 6.0;
/// How far a surface goes on beyond its ends, in pixels.
const BEYOND: f64 = 70.0;
/// Length of the arrow of a force, in pixels.
const ARROW: f64 = 44.0;
/// Parts whose forces are called load and traction.
const LOADED: [&str; 4] = ["wheel", "tyre", "rolling", "rolling_on_circle"];

/// The frame of a shape.
fn frame_of(shape: &Shape) -> Frame {
    Frame { argument: String::new(), body: shape.body, port: shape.port }
}

/// Is it a surface along the whole x axis of its frame?
fn is_endless(shape: &Shape) -> bool {
    shape.look == "surface" && shape.points.is_empty()
}

/// The circle about a frame of a part, m.
fn radius_about(part: &Part, frame: &Frame) -> Option<f64> {
    let is_here = |shape: &&Shape| {
        shape.look == "circle" && !shape.symbol && (shape.body, shape.port) == (frame.body, frame.port)
    };
    part.shapes.iter().find(is_here).and_then(|shape| shape.points.last()).map(|at| at[0].abs())
}

impl Stage<'_> {
    /// Draws all shapes of a part, the forces of contact, and its name.
    pub(super) fn draw_shapes(&mut self, part: &Part) {
        if part.shapes.iter().all(|shape| shape.symbol)
            && let Some((a, b, _)) = self.ends(part)
        {
            self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
        }
        for shape in &part.shapes {
            self.draw_shape(part, shape);
        }
        if let Some((at, normal)) = self.touch(part).filter(|_| self.has_signs(part)) {
            let names =
                if LOADED.contains(&part.kind.as_str()) { ["load", "traction"] } else { ["push", "drag"] };
            let is_on_line = part.shapes.iter().any(is_endless);
            let tangent = if is_on_line { normal - FRAC_PI_2 } else { normal + FRAC_PI_2 };
            for (angle, name) in [(normal, names[0]), (tangent, names[1])] {
                let tip = beside(at, angle, ARROW);
                self.paper.arrow("force", beside(at, angle, 4.0), tip);
                self.name(name, "sign", tip, 4.0);
            }
        }
        let shape = part.shapes.last().map(frame_of);
        if let Some(spot) = part.frames.last().or(shape.as_ref()).and_then(|frame| self.frame(frame)) {
            self.name_of(&part.name, spot.at, 9.0);
        }
    }

    pub(super) fn draw_shape(&mut self, part: &Part, shape: &Shape) {
        if is_endless(shape) {
            return self.draw_axis(part, shape);
        }
        let Some(points) = self.points_of(shape) else { return };
        match shape.look.as_str() {
            "outline" => self.paper.polygon(&self.class(&part.name, "plate"), &points),
            "mark" => self.paper.polygon(&self.class(&part.name, "black"), &points),
            "circle" => self.draw_circle(part, shape),
            "surface" => self.draw_ground(part, shape, &points),
            _ => self.paper.line(&self.class(&part.name, ""), &points),
        }
    }

    /// The points of a shape on the paper; none where something has no finite place.
    pub(super) fn points_of(&self, shape: &Shape) -> Option<Vec<Point>> {
        let from = self.frame(&frame_of(shape))?;
        let (mut angle, mut along) = (from.angle, if shape.symbol { UNIT } else { self.scale });
        if let Some((body, port)) = shape.towards {
            let to = self.port(body, port)?;
            let [x, y] = [to.at[0] - from.at[0], from.at[1] - to.at[1]];
            angle = y.atan2(x);
            along = if shape.symbol { x.hypot(y) } else { along };
        }
        let across = if shape.symbol { UNIT } else { self.scale };
        let at = |origin: Point, x: f64, y: f64| beside(beside(origin, angle, x), angle + FRAC_PI_2, y);
        let (origin, points) = match &shape.points[..] {
            [[x, y], points @ ..] if shape.symbol || shape.look == "circle" => {
                (at(from.at, self.pixels(*x), self.pixels(*y)), points)
            }
            points => (from.at, points),
        };
        let places: Vec<Point> = points.iter().map(|[x, y]| at(origin, along * x, across * y)).collect();
        places.iter().flatten().all(|x| x.is_finite()).then_some(places)
    }

    /// The x axis of a frame, as long as what lies on it.
    fn draw_axis(&mut self, part: &Part, shape: &Shape) {
        let frame = frame_of(shape);
        let Some(a) = self.frame(&frame) else { return };
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

    /// A polyline with the solid on its right.
    fn draw_ground(&mut self, part: &Part, shape: &Shape, points: &[Point]) {
        for side in points.windows(2) {
            let [a, b] = [side[0], side[1]];
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            if shape.body.is_none() && length > 7.0 {
                let middle = [0, 1].map(|k| 0.5 * (a[k] + b[k]));
                self.hatch(middle, (a[1] - b[1]).atan2(b[0] - a[0]), 0.5 * length);
            }
        }
        self.paper
            .line(&self.class(&part.name, if shape.body.is_none() { "ground" } else { "rail" }), points);
    }

    /// A circle with its centre, and a radius that rotates with it.
    fn draw_circle(&mut self, part: &Part, shape: &Shape) {
        let (Some(spot), [[x, y], [radius, _]]) = (self.frame(&frame_of(shape)), &shape.points[..]) else {
            return;
        };
        let size = radius.abs() * if shape.symbol { UNIT } else { self.scale };
        let along = beside(spot.at, spot.angle, self.pixels(*x));
        let at = beside(along, spot.angle + FRAC_PI_2, self.pixels(*y));
        let rim: Vec<Point> =
            (0..=72).map(|k| beside(at, spot.angle + f64::from(k) * PI / 36.0, size)).collect();
        self.paper.line(&self.class(&part.name, ""), &rim);
        self.paper.line(&self.class(&part.name, "dash"), &[at, beside(at, spot.angle, size)]);
        self.paper.circle(&self.class(&part.name, "white"), at, 3.0);
    }

    /// The place of the contact, and the direction of the normal force on the last frame.
    fn touch(&self, part: &Part) -> Option<(Point, f64)> {
        let (a, b, _) = self.ends(part)?;
        let [first, second] =
            [&part.frames[0], &part.frames[1]].map(|frame| radius_about(part, frame).map(|r| self.pixels(r)));
        if part.shapes.iter().any(is_endless) {
            let normal = a.angle + FRAC_PI_2;
            return Some((beside(b.at, normal, -second.unwrap_or(0.0)), normal));
        }
        let rim = first?;
        let reach = [b.at[0] - a.at[0], a.at[1] - b.at[1]];
        let outwards = reach[1].atan2(reach[0]);
        let is_inside = second.is_some() && reach[0].hypot(reach[1]) < rim;
        let normal = if is_inside { outwards + PI } else { outwards };
        Some((beside(a.at, outwards, rim), normal))
    }
}
