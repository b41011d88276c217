//! Random mechanisms: what is grown from the ground, rigid groups that are held too often, parallel cranks and guides, and
//! loops that are closed at random.

use std::fmt::Write;

#[path = "../../../../tests/support/random.rs"]
mod random;

pub(crate) use random::Random;

/// In -1 to 1, to three digits, so that sums of two are exact.
fn coarse(random: &mut Random) -> f64 {
    (1000.0 * random.unit()).round() / 1000.0
}

/// A point in the plane.
type Point = [f64; 2];

/// Joints of the library.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Revolute,
    Prismatic,
    PinSlot,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Kind::Revolute => "revolute",
            Kind::Prismatic => "prismatic",
            Kind::PinSlot => "pin_slot",
        }
    }
}

/// A mechanism and a pose in which it is closed. Body 0 is the ground.
pub(crate) struct Scene {
    /// x, y, theta.
    bodies: Vec<[f64; 3]>,
    /// By body: ports in its axes, and their angles.
    ports: Vec<Vec<(Point, f64)>>,
    joints: Vec<String>,
}

impl Scene {
    pub(crate) fn new(random: &mut Random) -> Scene {
        let mut scene = Scene { bodies: vec![[0.0; 3]], ports: vec![Vec::new()], joints: Vec::new() };
        for _ in 0..=random.below(3) {
            let onto = random.below(scene.bodies.len());
            match random.below(6) {
                0 | 1 => drop(scene.grow(onto, random)),
                2 => scene.truss(onto, random),
                3 => scene.cranks(random),
                4 => scene.guides(random),
                _ => scene.twice(onto, random),
            }
        }
        for _ in 0..random.below(3) {
            let (a, b) = (random.below(scene.bodies.len()), random.below(scene.bodies.len()));
            if a != b {
                let kind = [Kind::PinSlot, Kind::Revolute, Kind::PinSlot, Kind::Prismatic][random.below(4)];
                scene.join(kind, a, b, random);
            }
        }
        scene
    }

    /// Bodies that hang on each other with springs and dampers in all joints, and up to three loops among them.
    pub(crate) fn sprung(random: &mut Random) -> Scene {
        let mut scene = Scene { bodies: vec![[0.0; 3]], ports: vec![Vec::new()], joints: Vec::new() };
        for _ in 0..2 + random.below(5) {
            let onto = random.below(scene.bodies.len());
            scene.grow(onto, random);
        }
        for _ in 0..random.below(4) {
            let (a, b) = (random.below(scene.bodies.len()), random.below(scene.bodies.len()));
            if a != b {
                let kind = [Kind::PinSlot, Kind::Revolute, Kind::PinSlot, Kind::Prismatic][random.below(4)];
                scene.join(kind, a, b, random);
            }
        }
        for joint in &mut scene.joints {
            let turns = joint.starts_with(Kind::Revolute.name());
            let [stiffness, damping] = if turns { ["N*m/rad", "N*m*s/rad"] } else { ["N/m", "N*s/m"] };
            joint.pop();
            write!(joint, " {{ stiffness: 3 {stiffness}; damping: 0.5 {damping}; }}").unwrap();
        }
        scene
    }

    /// x, y, theta of each body.
    pub(crate) fn poses(&self) -> Vec<f64> {
        self.bodies.iter().skip(1).flatten().copied().collect()
    }

    pub(crate) fn text(&self) -> String {
        let mut text = String::from("pub Scene {\n    gravity: 9.81 m/s^2;\n");
        let mut bodies = self.bodies.iter().zip(&self.ports).enumerate();
        bodies
            .try_for_each(|(body, (pose, ports))| {
                match body {
                    0 => write!(text, "    ground {{")?,
                    _ => write!(text, "    body b{body} {{ mass: 1 kg; inertia: 0.1 kg*m^2;")?,
                }
                let axis = if body == 0 { "axis" } else { "angle" };
                for (k, ([x, y], angle)) in ports.iter().enumerate() {
                    write!(text, " port p{k}: ({x:?}, {y:?}) m, {axis}: {angle:?} rad;")?;
                }
                if body > 0 {
                    let [x, y, angle] = pose;
                    write!(text, " start x: {x:?} m; start y: {y:?} m; start angle: {angle:?} rad;")?;
                }
                text.push_str(" }\n");
                Ok::<(), std::fmt::Error>(())
            })
            .unwrap();
        text.extend(self.joints.iter().map(|joint| format!("    {joint}\n")));
        text + "}\n"
    }

    fn body(&mut self, pose: [f64; 3]) -> usize {
        self.bodies.push(pose);
        self.ports.push(Vec::new());
        self.bodies.len() - 1
    }

    /// A body anywhere.
    fn anywhere(&mut self, random: &mut Random) -> usize {
        let pose = [random.unit(), random.unit(), 3.0 * random.unit()];
        self.body(pose)
    }

    /// A port of a body at a place in absolute axes.
    fn port(&mut self, body: usize, [x, y]: Point, angle: f64) -> String {
        let [bx, by, theta] = self.bodies[body];
        let (sin, cos) = theta.sin_cos();
        let (dx, dy) = (x - bx, y - by);
        self.ports[body].push(([cos * dx + sin * dy, cos * dy - sin * dx], angle - theta));
        let owner = if body == 0 { "ground".to_owned() } else { format!("b{body}") };
        format!("{owner}.p{}", self.ports[body].len() - 1)
    }

    /// A joint at a place; what slides stands `slide` along an axis.
    fn joint(&mut self, kind: Kind, [a, b]: [usize; 2], at: Point, (slide, axis): (f64, f64)) {
        let (sin, cos) = axis.sin_cos();
        let end = if kind == Kind::Revolute { at } else { [at[0] + slide * cos, at[1] + slide * sin] };
        let (first, second) = (self.port(a, at, axis), self.port(b, end, axis));
        self.joints.push(format!("{} j{}({first}, {second});", kind.name(), self.joints.len()));
    }

    /// A joint anywhere.
    fn join(&mut self, kind: Kind, a: usize, b: usize, random: &mut Random) {
        let at = [random.unit(), random.unit()];
        let along = (random.unit(), 3.0 * random.unit());
        self.joint(kind, [a, b], at, along);
    }

    /// A body on another.
    fn grow(&mut self, onto: usize, random: &mut Random) -> usize {
        let body = self.anywhere(random);
        let kind = [Kind::Revolute, Kind::Revolute, Kind::PinSlot, Kind::Prismatic][random.below(4)];
        self.join(kind, onto, body, random);
        body
    }

    /// A triangle of bodies, or a square with both diagonals, and a joint within that says what is said already.
    fn truss(&mut self, onto: usize, random: &mut Random) {
        let first = self.grow(onto, random);
        let mut group = vec![first];
        if random.below(2) == 0 {
            let (second, third) = (self.anywhere(random), self.anywhere(random));
            group.extend([second, third]);
            for (a, b) in [(first, second), (second, third), (third, first)] {
                self.join(Kind::Revolute, a, b, random);
            }
        } else {
            // Bars between four points, of which the first body holds two.
            let points: Vec<Point> = (0..4).map(|_| [random.unit(), random.unit()]).collect();
            for (i, j) in [(1, 2), (2, 3), (3, 0), (0, 2)] {
                let bar = self.anywhere(random);
                let at = |body: Option<usize>, point: usize| (body.unwrap_or(bar), points[point]);
                group.push(bar);
                let hub = |point: usize, group: &[usize]| match point {
                    0 | 1 => first,
                    2 => group[1],
                    _ => group[2],
                };
                for point in [i, j] {
                    let (other, place) = at(Some(hub(point, &group)), point);
                    if other != bar {
                        self.joint(Kind::Revolute, [other, bar], place, (0.0, 0.0));
                    }
                }
            }
        }
        for _ in 0..random.below(3) {
            let (a, b) = (group[random.below(group.len())], group[random.below(group.len())]);
            if a != b {
                self.join(if random.below(3) == 0 { Kind::Revolute } else { Kind::PinSlot }, a, b, random);
            }
        }
    }

    /// Parallel cranks of one length that carry a platform.
    fn cranks(&mut self, random: &mut Random) {
        let turn = 3.0 * random.unit();
        let length = 0.2 + 0.3 * coarse(random).abs();
        let (sin, cos) = turn.sin_cos();
        let platform = self.body([length * cos, length * sin, 0.0]);
        for _ in 0..2 + random.below(3) {
            let foot = [coarse(random), coarse(random)];
            let crank = self.body([foot[0], foot[1], turn]);
            let name = |scene: &Scene, body: usize| match body {
                0 => format!("ground.p{}", scene.ports[0].len() - 1),
                _ => format!("b{body}.p{}", scene.ports[body].len() - 1),
            };
            let pin = |scene: &mut Scene, body: usize, local: Point| {
                scene.ports[body].push((local, 0.0));
                name(scene, body)
            };
            let (ground, heel) = (pin(self, 0, foot), pin(self, crank, [0.0, 0.0]));
            let (tip, carried) = (pin(self, crank, [length, 0.0]), pin(self, platform, foot));
            for (a, b) in [(ground, heel), (tip, carried)] {
                self.joints.push(format!("revolute j{}({a}, {b});", self.joints.len()));
            }
        }
    }

    /// A carriage on parallel guides.
    fn guides(&mut self, random: &mut Random) {
        let axis = coarse(random);
        let carriage = self.body([coarse(random), coarse(random), 0.0]);
        for _ in 0..2 + random.below(2) {
            let kind = [Kind::Prismatic, Kind::Prismatic, Kind::PinSlot][random.below(3)];
            self.joint(kind, [0, carriage], [coarse(random), coarse(random)], (random.unit(), axis));
        }
    }

    /// Two joints where one would do.
    fn twice(&mut self, onto: usize, random: &mut Random) {
        let body = self.anywhere(random);
        let (at, along) = ([random.unit(), random.unit()], (random.unit(), random.unit()));
        match random.below(3) {
            0 => {
                self.joint(Kind::Revolute, [onto, body], at, along);
                self.joint(Kind::PinSlot, [onto, body], at, (0.0, along.1));
            }
            1 => {
                self.joint(Kind::Revolute, [onto, body], at, along);
                self.joint(Kind::Revolute, [onto, body], at, along);
            }
            _ => {
                self.joint(Kind::Prismatic, [onto, body], at, along);
                self.joint(Kind::PinSlot, [onto, body], at, along);
            }
        }
    }
}
