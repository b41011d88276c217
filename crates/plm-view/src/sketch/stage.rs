//! A mechanism on paper: where its frames are in pixels, and what stands back.

use std::f64::consts::{FRAC_PI_2, PI};

use super::drawing::Drawing;
use super::label::{self, Label};
use super::paper::{Paper, Point, beside};
use super::{Sketch, WIDTH};
use crate::{Frame, Part, Shape};

/// Left and right end of the room for the mechanism, in pixels; on its left stand the axes.
const FIELD: [f64; 2] = [84.0, WIDTH - 10.0];
/// Room around the outermost ports for signs and names.
const ROOM: f64 = 62.0;
/// The largest height between ports.
const HEIGHT: f64 = 250.0;

/// A frame in the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) at: Point,
    /// Of its x axis, rad.
    pub(super) angle: f64,
}

/// A drawing while it is made.
pub(super) struct Stage<'a> {
    pub(super) sketch: &'a Sketch,
    pub(super) paper: Paper,
    pub(super) labels: Vec<Label>,
    /// Pixels in a metre, and where the origin of the mechanism is.
    pub(super) scale: f64,
    origin: Point,
}

impl<'a> Stage<'a> {
    pub(super) fn new(sketch: &'a Sketch) -> Self {
        let (paper, labels) = (Paper::default(), Vec::new());
        let mut stage = Self { sketch, paper, labels, scale: 1.0, origin: [0.0; 2] };
        let points = stage.points();
        let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| [0, 1].map(|axis| points.iter().map(|at| at[axis]).reduce(pick).unwrap_or(0.0)));
        let (width, height) = (high[0] - low[0], high[1] - low[1]);
        let fit = ((FIELD[1] - FIELD[0] - 2.0 * ROOM) / width).min(HEIGHT / height);
        stage.scale = if fit.is_finite() { fit } else { 1.0 };
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]) * stage.scale);
        stage.origin = [0.5 * (FIELD[0] + FIELD[1]) - middle[0], middle[1]];
        stage
    }

    /// Points that must be in the picture: ports, centres of gravity, outlines; in pixels from the origin at the scale 1, and y upwards.
    fn points(&self) -> Vec<Point> {
        let mechanism = &self.sketch.mechanism;
        let mut points = Vec::new();
        for (k, body) in mechanism.bodies.iter().enumerate() {
            let ports = (0..body.ports.len()).filter_map(|port| self.port(Some(k), Some(port)));
            points.extend(ports.chain(self.port(Some(k), None)).map(|spot| spot.at));
            points.extend(self.outline(k).into_iter().flatten());
        }
        points.extend(self.rims());
        points.extend(
            (0..mechanism.ground.len()).filter_map(|port| self.port(None, Some(port))).map(|spot| spot.at),
        );
        for shape in mechanism.parts.iter().flat_map(|part| &part.shapes).filter(|shape| !shape.symbol) {
            points.extend(self.extent(shape));
        }
        points.into_iter().map(|[x, y]| [x, -y]).collect()
    }

    /// Points of a shape, of a circle the corners around it.
    fn extent(&self, shape: &Shape) -> Vec<Point> {
        let (Some(spot), Some(places)) = (self.port(shape.body, shape.port), self.points_of(shape)) else {
            return Vec::new();
        };
        match (shape.look.as_str(), &shape.points[..]) {
            // About the frame, or near enough to it.
            ("circle", [_, [radius, _]]) => {
                [-radius.abs(), radius.abs()].map(|r| spot.at.map(|x| x + r)).to_vec()
            }
            _ => places,
        }
    }

    /// A place of the mechanism in the picture.
    fn place(&self, [x, y]: [f64; 2]) -> Point {
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    /// A length of the mechanism in the picture.
    pub(super) fn pixels(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// A port of a body or of the ground; without a port G or the origin.
    pub(super) fn port(&self, body: Option<usize>, port: Option<usize>) -> Option<Spot> {
        let mechanism = &self.sketch.mechanism;
        let [x, y, angle] = match (body, port) {
            (Some(body), port) => {
                let pose = *self.sketch.poses.get(body)?;
                let local = match port {
                    Some(port) => {
                        let port = mechanism.bodies.get(body)?.ports.get(port)?;
                        [port.x, port.y, port.angle]
                    }
                    None => [0.0; 3],
                };
                moved(pose, local)
            }
            (None, Some(port)) => {
                let port = mechanism.ground.get(port)?;
                [port.x, port.y, port.angle]
            }
            (None, None) => [0.0; 3],
        };
        let spot = Spot { at: self.place([x, y]), angle };
        (spot.at.iter().all(|x| x.is_finite()) && angle.is_finite()).then_some(spot)
    }

    pub(super) fn frame(&self, frame: &Frame) -> Option<Spot> {
        self.port(frame.body, frame.port)
    }

    /// The first two frames of a part, and whether the first is of the ground.
    pub(super) fn ends(&self, part: &Part) -> Option<(Spot, Spot, bool)> {
        let [a, b, ..] = &part.frames[..] else { return None };
        Some((self.frame(a)?, self.frame(b)?, a.body.is_none()))
    }

    /// The outline of a body, if it has one.
    pub(super) fn outline(&self, body: usize) -> Option<Vec<Point>> {
        self.placed(body, self.sketch.mechanism.bodies[body].contour.as_ref()?)
    }

    /// Points in the axes of a body, in the picture.
    pub(super) fn placed(&self, body: usize, points: &[[f64; 2]]) -> Option<Vec<Point>> {
        let pose = *self.sketch.poses.get(body)?;
        let place = |&[x, y]: &[f64; 2]| {
            let [x, y, _] = moved(pose, [x, y, 0.0]);
            self.place([x, y])
        };
        Some(points.iter().map(place).collect())
    }

    /// Does what has this name stand back?
    pub(super) fn is_back(&self, name: &str) -> bool {
        let focus = &self.sketch.focus;
        !focus.is_empty() && !focus.contains(top(name))
    }

    /// A class of shapes, with `back` after it for what stands back.
    pub(super) fn class(&self, name: &str, class: &str) -> String {
        format!("{class}{}", if self.is_back(name) { " back" } else { "" })
    }

    /// Are the senses of the part of this name shown?
    pub(super) fn has_signs(&self, part: &Part) -> bool {
        self.sketch.signs.contains(top(&part.name))
    }

    pub(super) fn name(&mut self, text: &str, class: &'static str, at: Point, reach: f64) {
        self.labels.push(Label { text: text.to_owned(), class, at, reach });
    }

    /// The name of a part or body beside a place; elements inside of a part have the name of the part.
    pub(super) fn name_of(&mut self, name: &str, at: Point, reach: f64) {
        let class = if self.is_back(name) { "given" } else { "name" };
        let is_known = name.contains('.') && self.labels.iter().any(|label| label.text == top(name));
        if !is_known {
            self.name(top(name), class, at, reach);
        }
    }

    /// Red lines below a base of the ground, which goes to both sides of a place at an angle.
    pub(super) fn hatch(&mut self, at: Point, angle: f64, half: f64) {
        let ends = [-half, half].map(|along| beside(at, angle, along));
        self.paper.line("ground", &ends);
        let strokes = (2.0 * half / 7.0).floor() as i32;
        for k in 0..=strokes {
            let from = beside(at, angle, 7.0 * f64::from(k) - half);
            self.paper.line("ground", &[from, beside(from, angle - 0.75 * PI, 9.0)]);
        }
    }

    /// All that was drawn, with texts, axes and gravity.
    pub(super) fn finish(mut self) -> Drawing {
        let order = |label: &Label| ["sign", "name", "given"].iter().position(|class| *class == label.class);
        self.labels.sort_by_key(|label| order(label).unwrap_or(3));
        label::draw(&self.labels, &mut self.paper, FIELD);
        let rows = self.paper.dots.iter().map(|dot| dot[1]);
        let (top, bottom) = rows.fold((0.0_f64, 0.0_f64), |(low, high), y| (low.min(y), high.max(y)));
        let (top, bottom) = (top.floor() - 34.0, bottom.ceil() + 14.0);
        let top = top.min(bottom - 190.0);
        self.draw_axes(bottom - 26.0);
        self.paper.text("title", [14.0, top + 18.0], &self.sketch.title);
        let title = self.sketch.title.clone();
        Drawing { title, marks: self.paper.marks, width: WIDTH, rows: [top, bottom] }
    }

    /// The absolute axes and gravity, left of all else.
    fn draw_axes(&mut self, bottom: f64) {
        let corner = [18.0, bottom];
        for (angle, name) in [(0.0, "x"), (FRAC_PI_2, "y")] {
            self.paper.arrow("axis", corner, beside(corner, angle, 36.0));
            self.paper.text("small", beside(corner, angle, 45.0), name);
        }
        let [x, y] = self.sketch.gravity;
        if x.hypot(y) > 0.0 {
            let (middle, angle) = ([36.0, bottom - 88.0], y.atan2(x));
            self.paper.arrow("force", beside(middle, angle, -18.0), beside(middle, angle, 18.0));
            self.paper.text("sign", beside(middle, angle + FRAC_PI_2, 12.0), "g");
        }
    }
}

/// A pose from another's axes in the absolute ones.
fn moved([x, y, theta]: [f64; 3], [px, py, angle]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = theta.sin_cos();
    [x + cos * px - sin * py, y + sin * px + cos * py, theta + angle]
}

/// The part of the declaration that a name is in.
pub(super) fn top(name: &str) -> &str {
    name.split('.').next().unwrap_or(name)
}
