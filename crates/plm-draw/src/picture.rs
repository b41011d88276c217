//! Pictures: the places of all ports on the screen.

use crate::names::PortName;

/// A point in absolute axes, m.
pub type Point = [f64; 2];

/// A port in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The port.
    pub name: PortName,
    /// Its place.
    pub at: Point,
    /// The angle of the axes of its body, rad; of the ground 0.
    pub angle: f64,
}

/// All ports of a picture at the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// In any order.
    pub ports: Vec<Placed>,
}

impl Picture {
    /// A port by its name.
    pub fn port(&self, name: &PortName) -> Option<&Placed> {
        self.ports.iter().find(|port| port.name == *name)
    }

    /// The angle of the axes of a body.
    pub(crate) fn angle(&self, body: &str) -> Option<f64> {
        self.ports.iter().find(|port| port.name.owner == body).map(|port| port.angle)
    }
}

/// From one point to another.
pub(crate) fn between(from: Point, to: Point) -> Point {
    [to[0] - from[0], to[1] - from[1]]
}

/// A vector turned by an angle.
pub(crate) fn turned([x, y]: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

/// The point of the line through two points that is nearest to a third one.
pub(crate) fn on_ray(from: Point, through: Point, point: Point) -> Point {
    let (along, to) = (between(from, through), between(from, point));
    let square = along[0] * along[0] + along[1] * along[1];
    let share = (along[0] * to[0] + along[1] * to[1]) / square;
    [from[0] + share * along[0], from[1] + share * along[1]]
}
