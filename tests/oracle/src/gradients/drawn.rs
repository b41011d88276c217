//! Places of bodies as a drawing has them.

use std::f64::consts::PI;

use crate::draw::Draw;

/// A point, m.
pub(super) type Point = [f64; 2];

/// How a drawing is laid: mirrored, turned.
pub(super) struct Laid {
    mirrored: bool,
    cosine: f64,
    sine: f64,
}

impl Laid {
    pub(super) fn new(draw: &mut Draw) -> Self {
        let any = draw.rounded(-180.0, 180.0);
        let degrees = *draw.one_of(&[0.0, 0.0, 90.0, 180.0, 37.0, any]);
        let (sine, cosine) = match degrees {
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            _ => f64::sin_cos(degrees * PI / 180.0),
        };
        Self { mirrored: draw.chance(0.5), cosine, sine }
    }

    pub(super) fn point(&self, [x, y]: Point) -> Point {
        let y = if self.mirrored { -y } else { y };
        // No negative zeros: people do not write them.
        [self.cosine * x - self.sine * y + 0.0, self.sine * x + self.cosine * y + 0.0]
    }

    /// The direction of the x axis of the drawing, rad.
    pub(super) fn turned(&self) -> f64 {
        self.sine.atan2(self.cosine)
    }
}

/// A bar from a point of the drawing to another one, with its centre of mass between them.
pub(super) struct Bar<'a> {
    pub(super) name: &'a str,
    pub(super) from: Point,
    pub(super) to: Point,
    /// Its length, by a parameter or a number.
    pub(super) length: &'a str,
    /// Its mass, likewise.
    pub(super) mass: &'a str,
    /// Does assembly keep the angle?
    pub(super) locked: bool,
    /// More items.
    pub(super) more: &'a str,
}

impl Bar<'_> {
    /// As drawn, with ports `a` and `b` at its ends.
    pub(super) fn text(&self, laid: &Laid) -> String {
        let Self { name, length, mass, more, .. } = self;
        let ([ax, ay], [bx, by]) = (laid.point(self.from), laid.point(self.to));
        let (x, y, angle) = (0.5 * (ax + bx), 0.5 * (ay + by), (by - ay).atan2(bx - ax));
        let lock = if self.locked { ", locked" } else { "" };
        format!(
            "    body {name} {{
        mass: {mass}; inertia: 0.1*{mass}*{length}^2;
        port a: (-0.5*{length}, 0 m); port b: (0.5*{length}, 0 m);
        start x: {x:?} m; start y: {y:?} m; start angle: {angle:?} rad{lock};{more}
    }}
"
        )
    }
}

/// How far two points are apart, m.
pub(super) fn distance([ax, ay]: Point, [bx, by]: Point) -> f64 {
    (bx - ax).hypot(by - ay)
}
