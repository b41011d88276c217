//! Six-bar chains of one degree of freedom, with joints at random places, as declarations.

use std::fmt::Write;

use plm_oracle::Random;

/// A six-bar mechanism: a chain whose link `ground` is fixed. Links 0 and 1 have three joints, the others two.
#[derive(Debug)]
pub struct Topology {
    pub name: &'static str,
    /// The two links of each joint.
    joints: [[usize; 2]; 7],
    ground: usize,
}

/// Watt's chain: the ternary links share a joint.
const WATT: [[usize; 2]; 7] = [[0, 1], [0, 2], [2, 3], [3, 1], [0, 4], [4, 5], [5, 1]];
/// Stephenson's chain: the ternary links share none.
const STEPHENSON: [[usize; 2]; 7] = [[0, 2], [2, 1], [0, 3], [3, 1], [0, 4], [4, 5], [5, 1]];

/// The five six-bar mechanisms (J. M. McCarthy, G. S. Soh, Geometric Design of Linkages, 2nd edition, 2011).
pub const TOPOLOGIES: [Topology; 5] = [
    Topology { name: "Watt I", joints: WATT, ground: 2 },
    Topology { name: "Watt II", joints: WATT, ground: 0 },
    Topology { name: "Stephenson I", joints: STEPHENSON, ground: 2 },
    Topology { name: "Stephenson II", joints: STEPHENSON, ground: 4 },
    Topology { name: "Stephenson III", joints: STEPHENSON, ground: 0 },
];

const LINKS: [&str; 6] = ["plate_a", "plate_b", "bar_a", "bar_b", "bar_c", "bar_d"];

/// A point of a link that does not touch the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Number among the bodies of the declaration.
    pub body: usize,
    /// In the link's frame, mm.
    pub at: [i32; 2],
}

/// A six-bar in the pose in which it was drawn; the frame of each link has its origin in the link's first joint.
#[derive(Debug)]
pub struct SixBar {
    pub topology: &'static Topology,
    /// The driven link, which touches the ground.
    crank: usize,
    /// Places of the joints, mm.
    places: [[i32; 2]; 7],
    /// Points whose paths are rated: joints of couplers, and some by chance.
    pub points: Vec<Point>,
}

/// Points by chance on each coupler.
const POINTS: usize = 12;
/// Joints lie in a square of this half width, mm.
const HALF: f64 = 500.0;
/// Those of the crank lie in a square of this half width about its pivot, mm.
const CRANK: f64 = 160.0;
/// No two joints are nearer to each other, mm.
const APART: f64 = 40.0;

impl SixBar {
    /// The six-bar of a seed and a number.
    pub fn random(seed: u64, number: u64) -> Self {
        let mut random = Random::new(seed, number);
        let topology = random.one_of(&TOPOLOGIES);
        let pivots: Vec<usize> = (0..7).filter(|k| topology.joints[*k].contains(&topology.ground)).collect();
        let pivot = *random.one_of(&pivots);
        let crank = topology.joints[pivot].into_iter().find(|link| *link != topology.ground).unwrap_or(0);
        let mut places = [[0; 2]; 7];
        let order = std::iter::once(pivot).chain((0..7).filter(|k| *k != pivot));
        for (count, k) in order.clone().enumerate() {
            places[k] = loop {
                let near = topology.joints[k].contains(&crank) && k != pivot;
                let (centre, half) = if near { (places[pivot], CRANK) } else { ([0; 2], HALF) };
                let place = centre.map(|centre| centre + random.between(-half, half).round() as i32);
                if order.clone().take(count).all(|other| distance(place, places[other]) >= APART) {
                    break place;
                }
            };
        }
        let mut six_bar = Self { topology, crank, places, points: Vec::new() };
        six_bar.points = six_bar.draw_points(&mut random);
        six_bar
    }

    /// Moving links, in the order of the declaration.
    fn bodies(&self) -> impl Iterator<Item = usize> {
        (0..6).filter(|link| *link != self.topology.ground)
    }

    fn joints_of(&self, link: usize) -> impl Iterator<Item = usize> {
        (0..7).filter(move |k| self.topology.joints[*k].contains(&link))
    }

    /// The place of a joint in a link's frame, mm.
    fn port(&self, link: usize, joint: usize) -> [i32; 2] {
        let origin = if link == self.topology.ground { [0; 2] } else { self.origin(link) };
        [0, 1].map(|axis| self.places[joint][axis] - origin[axis])
    }

    fn origin(&self, link: usize) -> [i32; 2] {
        self.joints_of(link).next().map_or([0; 2], |joint| self.places[joint])
    }

    fn is_coupler(&self, link: usize) -> bool {
        let ground = self.topology.ground;
        self.topology.joints.iter().all(|pair| !(pair.contains(&link) && pair.contains(&ground)))
    }

    /// Joints of couplers, and on each coupler points in a square about its joints.
    fn draw_points(&self, random: &mut Random) -> Vec<Point> {
        let mut points = Vec::new();
        for (body, link) in self.bodies().enumerate().filter(|(_, link)| self.is_coupler(*link)) {
            let ports: Vec<[i32; 2]> = self.joints_of(link).map(|joint| self.port(link, joint)).collect();
            let reach = 1.5 * ports.iter().map(|port| distance([0; 2], *port)).fold(0.0, f64::max);
            points.extend(ports.iter().map(|at| Point { body, at: *at }));
            points.extend(
                (0..POINTS).map(|_| Point {
                    body,
                    at: [0, 1].map(|_| random.between(-reach, reach).round() as i32),
                }),
            );
        }
        points
    }

    /// The greatest distance between two points of a link, mm: its joints, and the traced point.
    pub fn size(&self, traced: Point) -> f64 {
        let mut size = 0.0_f64;
        for (body, link) in
            (0..6).filter(|link| *link != self.topology.ground).chain([self.topology.ground]).enumerate()
        {
            let mut all: Vec<[i32; 2]> = self.joints_of(link).map(|joint| self.port(link, joint)).collect();
            all.extend((traced.body == body).then_some(traced.at));
            for (k, one) in all.iter().enumerate() {
                size = all[..k].iter().fold(size, |size, other| size.max(distance(*one, *other)));
            }
        }
        size
    }

    /// The declaration, in which the crank makes a turn in a second, with the path of a point as its output.
    pub fn declaration(&self, traced: Option<Point>) -> String {
        let mut text = format!("/// A six-bar: {}.\npub SixBar {{\n    ground {{", self.topology.name);
        for joint in self.joints_of(self.topology.ground) {
            let [x, y] = self.places[joint];
            let _ = write!(text, " port p{joint}: ({x}, {y}) mm;");
        }
        text.push_str(" }\n");
        let mut output = String::new();
        for (body, link) in self.bodies().enumerate() {
            let (name, [x, y]) = (LINKS[link], self.origin(link));
            let _ = write!(text, "    body {name} {{ mass: 1 kg; inertia: 0.01 kg*m^2;");
            for joint in self.joints_of(link) {
                let [x, y] = self.port(link, joint);
                let _ = write!(text, " port p{joint}: ({x}, {y}) mm;");
            }
            if let Some(Point { at: [x, y], .. }) = traced.filter(|traced| traced.body == body) {
                let _ = write!(text, " port traced: ({x}, {y}) mm;");
                output = format!("    output {name}.traced.position in mm;\n");
            }
            let _ = writeln!(text, " start x: {x} mm; start y: {y} mm; start angle: 0 deg; }}");
        }
        for (joint, pair) in self.topology.joints.iter().enumerate() {
            let [one, other] =
                pair.map(|link| if link == self.topology.ground { "ground" } else { LINKS[link] });
            let _ = writeln!(text, "    revolute j{joint}({one}.p{joint}, {other}.p{joint});");
        }
        let _ = writeln!(text, "    constraint turn: {}.angle = 2*pi*t/(1 s);", LINKS[self.crank]);
        text.push_str(&output);
        text.push('}');
        text
    }
}

fn distance(one: [i32; 2], other: [i32; 2]) -> f64 {
    f64::from(one[0] - other[0]).hypot(f64::from(one[1] - other[1]))
}
