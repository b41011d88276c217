//! Bodies: links through their ports, or their outlines; centres of gravity.

use std::f64::consts::{FRAC_PI_2, PI};

use super::joint::BESIDE_BLOCK;
use super::paper::{Point, beside};
use super::stage::Stage;
use crate::Part;

/// A body whose ports are nearer to each other is a disc, in pixels.
const POINT: f64 = 12.0;
/// A hull that is flatter is a line.
const FLAT: f64 = 3.0;
const DISC: f64 = 17.0;
/// Of more bodies the names of joints and ports have no room.
const MOST_BODIES: usize = 8;

impl Stage<'_> {
    pub(super) fn draw_bodies(&mut self) {
        for body in 0..self.sketch.mechanism.bodies.len() {
            self.draw_body(body);
        }
    }

    fn draw_body(&mut self, body: usize) {
        let name = self.sketch.mechanism.bodies[body].name.as_str();
        let Some(centre) = self.port(Some(body), None) else { return };
        if let Some(outline) =
            self.outline(body).filter(|outline| outline.as_flattened().iter().all(|x| x.is_finite()))
        {
            let holes = &self.sketch.mechanism.bodies[body].holes;
            let holes = holes.iter().filter_map(|hole| self.placed(body, hole));
            let rings: Vec<Vec<Point>> = [outline].into_iter().chain(holes).collect();
            self.paper.rings(&self.class(name, "plate"), &rings);
        }
        let points = self.of(body);
        let hull = hull(points);
        let size = hull.iter().map(|at| distance(*at, hull[0])).fold(0.0, f64::max);
        let has_outline = self.sketch.mechanism.bodies[body].contour.is_some();
        if size < POINT {
            if !has_outline && !self.is_block(body) {
                self.paper.circle(&self.class(name, "plate"), centre.at, DISC);
            }
        } else if !has_outline {
            for class in ["edge", "link"] {
                self.paper.polygon(&self.class(name, class), &hull);
            }
        }
    }

    /// Ports and centre of gravity.
    fn of(&self, body: usize) -> Vec<Point> {
        let ports = 0..self.sketch.mechanism.bodies[body].ports.len();
        let spots =
            ports.filter_map(|port| self.port(Some(body), Some(port))).chain(self.port(Some(body), None));
        spots.map(|spot| spot.at).collect()
    }

    /// Is it the block of a slider, which its joint draws?
    fn is_block(&self, body: usize) -> bool {
        self.sketch.mechanism.parts.iter().any(|part| {
            let slides = part.pair.as_deref() == Some("prismatic");
            slides && part.frames.get(1).is_some_and(|frame| frame.body == Some(body))
        })
    }

    /// Names of bodies and ports, and the marks of centres of gravity.
    pub(super) fn draw_names(&mut self) {
        let mechanism = &self.sketch.mechanism;
        for (k, body) in mechanism.bodies.iter().enumerate() {
            let Some(centre) = self.port(Some(k), None) else { continue };
            if !self.is_at_joint(k, centre.at) {
                self.draw_centre(&body.name, centre.at, centre.angle);
            }
            if self.is_crowded() {
                self.name(&body.name, "small", centre.at, 8.0);
                continue;
            }
            self.name_of(&body.name, centre.at, if self.is_block(k) { BESIDE_BLOCK } else { 9.0 });
            for (j, port) in body.ports.iter().enumerate() {
                let is_plain = self.sketch.focus.is_empty() && !body.name.contains('.');
                self.name_port(&port.name, Some(k), j, is_plain);
            }
        }
        if !self.is_crowded() {
            for (k, port) in mechanism.ground.iter().enumerate() {
                self.name_port(&port.name, None, k, false);
            }
        }
    }

    /// Are there too many bodies for all names?
    pub(super) fn is_crowded(&self) -> bool {
        self.sketch.mechanism.bodies.len() > MOST_BODIES
    }

    /// Names a port that parts in question join, or any that is plain to see; not those inside of parts.
    fn name_port(&mut self, name: &str, body: Option<usize>, port: usize, is_plain: bool) {
        let joins = |part: &&Part| {
            let here = part.frames.iter().any(|frame| frame.body == body && frame.port == Some(port));
            here && !self.is_back(&part.name) && !part.name.contains('.')
        };
        let is_shown = is_plain || self.sketch.mechanism.parts.iter().any(|part| joins(&part));
        if let Some(spot) = self.port(body, Some(port)).filter(|_| is_shown) {
            self.name(name, "small", spot.at, 8.0);
        }
    }

    /// Does a joint of the body stand at this place?
    fn is_at_joint(&self, body: usize, at: Point) -> bool {
        let joints = self
            .sketch
            .mechanism
            .parts
            .iter()
            .filter(|part| matches!(part.pair.as_deref(), Some("revolute" | "weld" | "pin_slot")));
        let mut spots = joints.flat_map(|joint| &joint.frames).filter(|frame| frame.body == Some(body));
        spots.any(|frame| self.frame(frame).is_some_and(|spot| distance(spot.at, at) < 8.0))
    }

    /// A circle with two black quarters, in the axes of the body.
    fn draw_centre(&mut self, name: &str, at: Point, angle: f64) {
        const RADIUS: f64 = 5.0;
        self.paper.circle(&self.class(name, "white"), at, RADIUS);
        for from in [angle, angle + PI] {
            let rim = (0..=4).map(|k| beside(at, from + f64::from(k) * FRAC_PI_2 / 4.0, RADIUS));
            let quarter: Vec<Point> = rim.chain([at]).collect();
            self.paper.polygon(&self.class(name, "black"), &quarter);
        }
    }
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The convex hull, by A. M. Andrew's chain (Another efficient algorithm for convex hulls in two dimensions, 1979); its two
/// ends where it is flat.
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turn = |a: Point, b: Point, c: Point| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for at in points {
            while let [.., a, b] = chain[..] {
                if turn(a, b, at) > FLAT * distance(a, at) {
                    break;
                }
                chain.pop();
            }
            chain.push(at);
        }
        chain
    };
    let mut around = chain(&mut points.iter().copied());
    let back = chain(&mut points.iter().rev().copied());
    around.pop();
    around.extend(back);
    around.pop();
    if around.is_empty() { points } else { around }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_has_the_outer_points() {
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
        assert_eq!(hull(square.to_vec()).len(), 4);
        assert_eq!(hull(vec![[5.0, 5.1], [0.0, 0.0], [10.0, 10.0]]), [[0.0, 0.0], [10.0, 10.0]]);
        assert_eq!(hull(vec![[1.0, 1.0]]).len(), 1);
    }
}
