//! Marks of what stops, catches, holds and gives way between two frames.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use plm_view::Part;

use super::paper::{Point, beside};
use super::stage::{Spot, Stage};

/// Radius of a bush and of a toothed wheel, in pixels.
const BUSH: f64 = 14.0;
const WHEEL: f64 = 17.0;
/// Half the width of a face.
const FACE: f64 = 18.0;

impl Stage<'_> {
    /// The mark of a part between two frames, and how far it reaches; nothing for a part without one.
    pub(super) fn draw_mark(&mut self, part: &Part, a: Spot, b: Spot) -> Option<f64> {
        match part.kind.as_str() {
            "stop" => self.draw_face(part, a, b),
            "clearance" => self.draw_bush(part, a, b),
            "bushing" => self.draw_bushing(part, a),
            "latch" => self.draw_bolt(part, a, b),
            "lock" => self.draw_padlock(part, a, b),
            "ratchet" => self.draw_ratchet(part, b),
            "torque_limiter" => self.draw_discs(part, b),
            "bristle_friction" => self.draw_bristles(part, a, b),
            _ => return None,
        }
        Some(WHEEL)
    }

    /// A hatched face across the axis of `a`, and the way that is left to it.
    fn draw_face(&mut self, part: &Part, a: Spot, b: Spot) {
        self.hatch(a.at, a.angle - FRAC_PI_2, FACE);
        self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
    }

    /// A bush and the journal in it.
    fn draw_bush(&mut self, part: &Part, a: Spot, b: Spot) {
        self.paper.circle(&self.class(&part.name, "white"), a.at, BUSH);
        self.paper.circle(&self.class(&part.name, "plate"), b.at, 0.6 * BUSH);
    }

    /// Two rings with rubber between them.
    fn draw_bushing(&mut self, part: &Part, a: Spot) {
        self.paper.circle(&self.class(&part.name, "white"), a.at, BUSH + 2.0);
        for k in 0..12 {
            let at = |radius: f64| beside(a.at, a.angle + TAU * f64::from(k) / 12.0, radius);
            self.paper.line(&self.class(&part.name, ""), &[at(6.0), at(BUSH + 2.0)]);
        }
        self.paper.circle(&self.class(&part.name, "plate"), a.at, 6.0);
    }

    /// A bolt beside the axis of `a`, whose slope lets pass and whose face holds.
    fn draw_bolt(&mut self, part: &Part, a: Spot, b: Spot) {
        self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
        let at = |along: f64, down: f64| beside(beside(a.at, a.angle, along), a.angle - FRAC_PI_2, down);
        let bolt = [at(0.0, 3.0), at(0.0, 26.0), at(-14.0, 26.0), at(-14.0, 17.0)];
        self.paper.polygon(&self.class(&part.name, "plate"), &bolt);
    }

    fn draw_padlock(&mut self, part: &Part, a: Spot, b: Spot) {
        self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
        let middle = [0, 1].map(|k| 0.5 * (a.at[k] + b.at[k]));
        let at = |x: f64, y: f64| [middle[0] + x, middle[1] + y];
        let shackle: Vec<Point> =
            (0..=8).map(|k| beside(at(0.0, -7.0), PI * f64::from(k) / 8.0, 7.0)).collect();
        let shackle: Vec<Point> =
            [at(7.0, -3.0)].into_iter().chain(shackle).chain([at(-7.0, -3.0)]).collect();
        self.paper.line(&self.class(&part.name, ""), &shackle);
        let case = [at(-10.0, -3.0), at(10.0, -3.0), at(10.0, 11.0), at(-10.0, 11.0)];
        self.paper.polygon(&self.class(&part.name, "plate"), &case);
    }

    /// A wheel that turns left under a pawl.
    fn draw_ratchet(&mut self, part: &Part, b: Spot) {
        let tooth = |k: u32, radius: f64| beside(b.at, b.angle + TAU * f64::from(k) / 12.0, radius);
        let teeth: Vec<Point> = (0..12).flat_map(|k| [tooth(k, WHEEL), tooth(k, WHEEL - 5.0)]).collect();
        self.paper.polygon(&self.class(&part.name, "plate"), &teeth);
        self.paper.circle(&self.class(&part.name, "white"), b.at, 4.0);
        let tip = beside(b.at, b.angle + FRAC_PI_2, WHEEL - 4.0);
        let foot = beside(tip, b.angle + FRAC_PI_4, 26.0);
        self.paper.line(&self.class(&part.name, "rail"), &[foot, tip]);
        self.paper.circle(&self.class(&part.name, "white"), foot, 3.5);
    }

    /// Two discs of one axis with linings between them, and the sense of the torque on `b`.
    fn draw_discs(&mut self, part: &Part, b: Spot) {
        self.paper.circle(&self.class(&part.name, "plate"), b.at, WHEEL + 3.0);
        self.paper.circle(&self.class(&part.name, "white"), b.at, 0.6 * WHEEL);
        for k in 0..6 {
            let at = |radius: f64, turn: f64| beside(b.at, TAU * f64::from(k) / 6.0 + turn, radius);
            let (inner, outer) = (0.6 * WHEEL, WHEEL);
            let lining = [at(inner, -0.2), at(outer, -0.2), at(outer, 0.2), at(inner, 0.2)];
            self.paper.polygon(&self.class(&part.name, "black"), &lining);
        }
        if self.has_signs(part) {
            self.draw_turn(b.at, "torque");
        }
    }

    /// Bristles on the axis of `a` below `b`.
    fn draw_bristles(&mut self, part: &Part, a: Spot, b: Spot) {
        self.paper.line(&self.class(&part.name, "dash"), &[a.at, b.at]);
        let at = |along: f64, down: f64| beside(beside(b.at, a.angle, along), a.angle - FRAC_PI_2, down);
        self.paper.line(&self.class(&part.name, "rail"), &[at(-24.0, 26.0), at(24.0, 26.0)]);
        for k in -3..=3 {
            let along = 7.0 * f64::from(k);
            self.paper.line(&self.class(&part.name, ""), &[at(along, 26.0), at(along + 4.0, 14.0)]);
        }
    }
}
