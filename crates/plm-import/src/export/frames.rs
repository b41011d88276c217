//! Places of frames in the plane, and planar vectors in the axes of a file.

use plm_compiler::Assembled;
use plm_compiler::model::FrameRef;

/// A vector of the plane in the axes of the file: x is x, y is z.
pub(super) fn in_file([x, y]: [f64; 2]) -> [f64; 3] {
    [x, 0.0, y]
}

/// A vector, turned by an angle, rad.
pub(super) fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

pub(super) fn add([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a + c, b + d]
}

pub(super) fn sub([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a - c, b - d]
}

/// The mechanism with its bodies at some poses: x, y of G and angle.
#[derive(Clone, Copy)]
pub(super) struct Posed<'a> {
    pub(super) mechanism: &'a Assembled,
    pub(super) poses: &'a [[f64; 3]],
}

impl Posed<'_> {
    /// The pose of a body; of the ground zero.
    pub(super) fn pose(&self, body: Option<usize>) -> [f64; 3] {
        body.map_or([0.0; 3], |body| self.poses[body])
    }

    /// A port from G, in the axes of its body: place and angle.
    pub(super) fn port(&self, frame: FrameRef) -> [f64; 3] {
        let ports = frame.body.map_or(&self.mechanism.ground, |body| &self.mechanism.bodies[body].ports);
        ports[frame.port].place
    }

    /// A point from G, in the axes of a body, in the plane.
    pub(super) fn point(&self, body: Option<usize>, at: [f64; 2]) -> [f64; 2] {
        let [x, y, angle] = self.pose(body);
        add([x, y], turned(at, angle))
    }

    /// A frame in the plane: place and angle.
    pub(super) fn frame(&self, frame: FrameRef) -> [f64; 3] {
        let [x, y, angle] = self.port(frame);
        let [x, y] = self.point(frame.body, [x, y]);
        [x, y, self.pose(frame.body)[2] + angle]
    }
}
