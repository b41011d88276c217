//! A four-bar as a declaration of the language.

use super::{FourBar, Point, Pose, Vector, point, unit, vector};

/// Mass of a link in its frame: at the crank's pivot, at the coupler's pin with the crank, at the rocker's pivot, each with the x-axis
/// through the other joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkMass {
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about the centre of gravity, kg m^2.
    pub inertia: f64,
    /// Centre of gravity, m.
    pub centre: Point,
}

/// A link on its way into the text.
pub(crate) struct Body {
    pub(crate) name: &'static str,
    pub(crate) ports: Vec<(&'static str, Point)>,
    /// Origin of the frame, and its angle.
    pub(crate) place: Point,
    pub(crate) angle: f64,
    pub(crate) mass: Option<LinkMass>,
}

/// Elements of a linkage beside its four-bar.
#[derive(Default)]
pub(crate) struct Beside {
    /// Ports of ground, crank, coupler and rocker.
    pub(crate) ports: [Vec<(&'static str, Point)>; 4],
    /// Links.
    pub(crate) bodies: Vec<Body>,
    /// Lines after the joints of the four-bar, and outputs.
    pub(crate) lines: String,
}

impl Body {
    /// The body; ports count from the centre of gravity.
    pub(crate) fn text(&self) -> String {
        let centre = self.mass.map_or(Vector::from(0.0), |mass| vector(mass.centre));
        let ports = self.ports.iter().map(|&(name, place)| {
            let [x, y] = point(vector(place) - centre);
            format!(" port {name}: ({x:?}, {y:?}) m;")
        });
        let mass = self.mass.map_or_else(String::new, |LinkMass { mass, inertia, .. }| {
            format!(" mass: {mass:?} kg; inertia: {inertia:?} kg*m^2;")
        });
        let [x, y] = point(vector(self.place) + unit(self.angle) * centre);
        format!(
            "    body {} {{
       {}{mass}
        start x: {x:?} m; start y: {y:?} m; start angle: {:?} rad;
    }}
",
            self.name,
            ports.collect::<String>(),
            self.angle
        )
    }
}

impl FourBar {
    /// Declaration of the linkage: the inside of a call of `mechanism!`, and a text for `plm-dynamic` and the playground. Its crank
    /// begins at an angle from the x-axis, rad, and turns at the parameter `speed`, rad/s. The coupler's port `tracer` is the coupler
    /// point, whose position is an output. `None` where the loop does not close at that angle.
    pub fn declaration(&self, name: &str, angle: f64) -> Option<String> {
        let pose = self.pose(angle)?;
        Some(self.text(name, &pose, None, Beside::default()))
    }

    /// As [`declaration`](Self::declaration), with masses of crank, coupler and rocker, and the forces at the pivots as outputs.
    pub fn declaration_with_masses(&self, name: &str, angle: f64, masses: &[LinkMass; 3]) -> Option<String> {
        let pose = self.pose(angle)?;
        Some(self.text(name, &pose, Some(masses), Beside::default()))
    }

    pub(crate) fn text(
        &self,
        name: &str,
        pose: &Pose,
        masses: Option<&[LinkMass; 3]>,
        beside: Beside,
    ) -> String {
        let [[x0, y0], [x1, y1]] = self.pivots;
        let [crank, coupler, rocker] = pose.angles;
        let mass = |link: usize| masses.map(|masses| masses[link]);
        let start = [0.0, 0.0];
        let mut bodies = vec![
            Body {
                name: "crank",
                ports: vec![("motor", start), ("pin", [self.crank, 0.0])],
                place: self.pivots[0],
                angle: crank,
                mass: mass(0),
            },
            Body {
                name: "coupler",
                ports: vec![("pin", start), ("wrist", [self.coupler, 0.0]), ("tracer", self.point)],
                place: pose.pins[0],
                angle: coupler,
                mass: mass(1),
            },
            Body {
                name: "rocker",
                ports: vec![("pivot", start), ("wrist", [self.rocker, 0.0])],
                place: self.pivots[1],
                angle: rocker,
                mass: mass(2),
            },
        ];
        let [ground, of_bodies @ ..] = beside.ports;
        for (body, ports) in bodies.iter_mut().zip(of_bodies) {
            body.ports.extend(ports);
        }
        bodies.extend(beside.bodies);
        let ground = ground.into_iter().map(|(name, [x, y])| format!(" port {name}: ({x:?}, {y:?}) m;"));
        let ground: String = ground.collect();
        let lines = beside.lines;
        let kind = if lines.is_empty() { "four" } else { "six" };
        let forces = if masses.is_some() { "    output motor.force, pivot.force;\n" } else { "" };
        format!(
            "/// A {kind}-bar whose crank turns.
pub {name} {{
    param speed = 1 rad/s;
    ground {{ port motor: ({x0:?}, {y0:?}) m; port pivot: ({x1:?}, {y1:?}) m;{ground} }}
{}    revolute motor(ground.motor, crank.motor);
    revolute pin(crank.pin, coupler.pin);
    revolute wrist(coupler.wrist, rocker.wrist);
    revolute pivot(ground.pivot, rocker.pivot);
    constraint drive: crank.angle = {crank:?} rad + speed*t;
    output coupler.tracer.position, coupler.angle, rocker.angle;
{lines}{forces}}}
",
            bodies.iter().map(Body::text).collect::<String>()
        )
    }
}
