//! MJCF, the format of MuJoCo (mujoco.readthedocs.io, "XML reference").

use super::frames::{Posed, in_file, sub, turned};
use super::pairs::{Kind, Law, Pair, Servo};
use super::pictures::bars;
use super::tags::{Tags, numbers, unless_zero, unless_zeros};
use super::tree::{Joint, Motion};
use super::{Drive, Export, drives};
use crate::notice::Notices;
use crate::number::exact;
use plm_compiler::InputTerm;

/// A limit that is none.
const UNBOUNDED: f64 = 1e9;
/// The axis of hinges.
const NORMAL: [f64; 3] = [0.0, -1.0, 0.0];

pub(super) fn text(export: &Export, file: &str, notices: &mut Notices) -> String {
    let mechanism = export.mechanism;
    let mut tags = Tags::default();
    tags.comment(&Export::comment(file, " Loops and limits of MuJoCo give way, those of plm do not."));
    tags.open("mujoco", &[("model", mechanism.name.clone())]);
    tags.empty("compiler", &[("angle", "radian".to_owned())]);
    let settings = [
        ("gravity", numbers(&in_file(mechanism.gravity))),
        ("integrator", "RK4".to_owned()),
        ("timestep", "0.001".to_owned()),
    ];
    tags.element("option", &settings, |tags| tags.empty("flag", &[("contact", "disable".to_owned())]));
    let poses: Vec<[f64; 3]> = mechanism.bodies.iter().map(|body| body.pose).collect();
    let writer = Writer { export, posed: Posed { mechanism, poses: &poses } };
    tags.open("worldbody", &[]);
    writer.sites(None, &mut tags);
    writer.children(None, &mut tags);
    tags.close("worldbody");
    if !export.tree.loops.is_empty() || !export.couplings.is_empty() {
        tags.open("equality", &[]);
        writer.loops(&mut tags, notices);
        writer.couplings(&mut tags);
        tags.close("equality");
    }
    let drives = drives(export, notices);
    if !drives.is_empty() {
        tags.open("actuator", &[]);
        for drive in &drives {
            actuator(drive, &mut tags);
        }
        tags.close("actuator");
    }
    tags.close("mujoco");
    tags.text
}

/// A motor; a servo is one whose force is affine, `position` where it is that of a spring to the input.
fn actuator(drive: &Drive, tags: &mut Tags) {
    let named = [("name", drive.name.clone()), ("joint", drive.joint.to_owned())];
    let (word, numbers) = match drive.law {
        Law::Motor(InputTerm { factor, range, .. }) => {
            let range = range.map_or(String::new(), |range| numbers(&range));
            ("motor", vec![("gear", exact(*factor)), ("ctrlrange", range)])
        }
        Law::Servo(Servo { gain, constant: 0.0, by_angle, by_speed, .. })
            if *by_angle == -gain && *by_speed <= 0.0 =>
        {
            ("position", vec![("kp", exact(*gain)), ("kv", unless_zero(-by_speed))])
        }
        Law::Servo(Servo { gain, constant, by_angle, by_speed, .. }) => {
            let bias = numbers(&[*constant, *by_angle, *by_speed]);
            let kind = ("biastype", "affine".to_owned());
            ("general", vec![("gainprm", exact(*gain)), kind, ("biasprm", bias)])
        }
    };
    tags.empty(word, &[&named[..], &numbers].concat());
}

struct Writer<'a> {
    export: &'a Export<'a>,
    posed: Posed<'a>,
}

impl Writer<'_> {
    /// Bodies that hang on a body or on the ground. Where one ends, the next one of the same parent follows.
    fn children(&self, of: Option<usize>, tags: &mut Tags) {
        let hanging = |parent: Option<usize>| {
            let links = self.export.tree.links.iter().enumerate().rev();
            links.filter(move |(_, link)| link.parent == parent).map(|(k, _)| Some(k))
        };
        // Nothing recurses: a chain may be long. `None` ends a body.
        let mut waiting: Vec<Option<usize>> = hanging(of).collect();
        while let Some(next) = waiting.pop() {
            let Some(link) = next.map(|k| self.export.tree.links[k]) else {
                tags.close("body");
                continue;
            };
            self.body(link.body, link.parent, tags);
            for joint in link.joints(&self.export.pairs, self.posed) {
                self.joint(&joint, link.body, tags);
            }
            if link.pair.is_none() {
                self.free(link.body, tags);
            }
            self.contents(link.body, tags);
            waiting.push(None);
            waiting.extend(hanging(Some(link.body)));
        }
    }

    /// The origin of a body in the plane; of the ground zero.
    fn origin(&self, body: Option<usize>) -> [f64; 2] {
        let Some(number) = body else { return [0.0; 2] };
        let [x, y] = self.posed.mechanism.bodies[number].centre;
        self.posed.point(body, [-x, -y])
    }

    /// A point of the plane in the axes of a body, from its origin.
    fn local(&self, body: Option<usize>, at: [f64; 2]) -> [f64; 2] {
        turned(sub(at, self.origin(body)), -self.posed.pose(body)[2])
    }

    fn depth(&self, body: Option<usize>) -> f64 {
        body.map_or(0.0, |body| self.posed.mechanism.bodies[body].depth)
    }

    /// Begins a body.
    fn body(&self, body: usize, parent: Option<usize>, tags: &mut Tags) {
        let [x, _, z] = in_file(self.local(parent, self.origin(Some(body))));
        // The normal of the plane is −y.
        let across = self.depth(parent) - self.depth(Some(body));
        let turn = self.posed.pose(Some(body))[2] - self.posed.pose(parent)[2];
        tags.open(
            "body",
            &[
                ("name", self.posed.mechanism.bodies[body].name.clone()),
                ("pos", unless_zeros(&[x, across, z])),
                ("euler", unless_zeros(&[0.0, -turn, 0.0])),
            ],
        );
    }

    fn joint(&self, joint: &Joint, body: usize, tags: &mut Tags) {
        let acting = joint.acting;
        let at = in_file(self.local(Some(body), joint.at));
        let (kind, axis, at) = match joint.motion {
            Motion::Hinge { sign } => ("hinge", NORMAL.map(|part| sign * part), unless_zeros(&at)),
            Motion::Slide { along } => {
                ("slide", in_file(turned(along, -self.posed.poses[body][2])), String::new())
            }
        };
        let range = match (acting.lower, acting.upper) {
            (None, None) => String::new(),
            (lower, upper) => numbers(&[lower.unwrap_or(-UNBOUNDED), upper.unwrap_or(UNBOUNDED)]),
        };
        tags.empty(
            "joint",
            &[
                ("name", joint.name.clone()),
                ("type", kind.to_owned()),
                ("axis", numbers(&axis)),
                ("pos", at),
                ("ref", unless_zeros(&[joint.coordinate])),
                ("stiffness", unless_zero(acting.stiffness)),
                ("springref", if acting.stiffness == 0.0 { String::new() } else { unless_zero(acting.rest) }),
                ("damping", unless_zero(acting.damping)),
                ("frictionloss", unless_zero(acting.friction)),
                ("armature", unless_zero(acting.armature)),
                ("range", range),
            ],
        );
    }

    /// The three coordinates of a body that nothing holds to the ground.
    fn free(&self, body: usize, tags: &mut Tags) {
        let name = &self.posed.mechanism.bodies[body].name;
        let axis = |along: [f64; 2]| in_file(turned(along, -self.posed.poses[body][2]));
        let [x, y] = [axis([1.0, 0.0]), axis([0.0, 1.0])];
        for (word, kind, axis) in [("x", "slide", x), ("y", "slide", y), ("turn", "hinge", NORMAL)] {
            let name = format!("{name}_{word}");
            tags.empty("joint", &[("name", name), ("type", kind.to_owned()), ("axis", numbers(&axis))]);
        }
    }

    /// Mass, picture and ports of a body.
    fn contents(&self, number: usize, tags: &mut Tags) {
        let body = &self.posed.mechanism.bodies[number];
        let across = body.inertia / 2.0;
        let inertia = [across, body.inertia, across];
        tags.empty(
            "inertial",
            &[
                ("pos", numbers(&in_file(body.centre))),
                ("mass", exact(body.mass.unwrap_or_default())),
                ("diaginertia", numbers(&inertia)),
            ],
        );
        for bar in bars(body) {
            let [length, width, depth] = bar.half;
            tags.empty(
                "geom",
                &[
                    ("type", "box".to_owned()),
                    ("size", numbers(&[length, depth, width])),
                    ("pos", unless_zeros(&in_file([bar.at[0] + body.centre[0], bar.at[1] + body.centre[1]]))),
                    ("euler", unless_zeros(&[0.0, -bar.angle, 0.0])),
                ],
            );
        }
        self.sites(Some(number), tags);
    }

    /// Ports of a body or of the ground that no joint has.
    fn sites(&self, body: Option<usize>, tags: &mut Tags) {
        let mechanism = self.posed.mechanism;
        let (ports, host, centre) = match body.map(|body| &mechanism.bodies[body]) {
            None => (&mechanism.ground, "ground", [0.0; 2]),
            Some(body) => (&body.ports, body.name.as_str(), body.centre),
        };
        for (k, port) in ports.iter().enumerate() {
            let is_it = |pair: &Pair| pair.frames.iter().any(|frame| frame.body == body && frame.port == k);
            if self.export.pairs.iter().any(is_it) {
                continue;
            }
            let [x, y, angle] = port.place;
            tags.empty(
                "site",
                &[
                    ("name", format!("{host}.{}", port.name)),
                    ("pos", unless_zeros(&in_file([x + centre[0], y + centre[1]]))),
                    ("euler", unless_zeros(&[0.0, -angle, 0.0])),
                ],
            );
        }
    }

    /// The points that close loops.
    fn loops(&self, tags: &mut Tags, notices: &mut Notices) {
        let export = self.export;
        for pair in export.tree.loops.iter().map(|k| &export.pairs[*k]) {
            if pair.kind != Kind::Revolute || !pair.is_plain() {
                let why = "MJCF closes loops by points that coincide, in which nothing acts";
                notices.error(&(export.place)(pair.span), format!("`{}` closes a loop: {why}", pair.name));
            }
            // The first body has to be one; a loop may be closed on the ground.
            let [a, b] = pair.frames;
            let (first, second) = if a.body.is_some() { (a, b) } else { (b, a) };
            let name = |body: Option<usize>| {
                body.map_or(String::new(), |body| self.posed.mechanism.bodies[body].name.clone())
            };
            let [x, y, _] = self.posed.frame(first);
            tags.empty(
                "connect",
                &[
                    ("name", pair.name.clone()),
                    ("body1", name(first.body)),
                    ("body2", name(second.body)),
                    ("anchor", numbers(&in_file(self.local(first.body, [x, y])))),
                ],
            );
        }
    }

    /// Hinges that follow others, as polynomials of what the others have turned from the start.
    fn couplings(&self, tags: &mut Tags) {
        let export = self.export;
        for coupling in &export.couplings {
            let (other, ratio) = match coupling.of {
                Some((pair, ratio)) => (export.pairs[pair].name.clone(), ratio),
                None => (String::new(), 0.0),
            };
            tags.empty(
                "joint",
                &[
                    ("name", export.mechanism.parts[coupling.part].name.clone()),
                    ("joint1", export.pairs[coupling.pair].name.clone()),
                    ("joint2", other),
                    ("polycoef", numbers(&[0.0, ratio, 0.0, 0.0, 0.0])),
                ],
            );
        }
    }
}
