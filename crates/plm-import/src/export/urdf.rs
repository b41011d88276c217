//! URDF, the format of ROS (wiki.ros.org/urdf/XML).

use super::frames::{Posed, in_file, sub, turned};
use super::pairs::Law;
use super::pictures::bars;
use super::tags::{Tags, numbers, unless_zeros};
use super::tree::{Joint, Link, Motion};
use super::{Drive, Export, drives};
use crate::notice::Notices;
use crate::number::exact;
use plm_compiler::InputTerm;

/// An effort, speed or place that bounds nothing.
const UNBOUNDED: f64 = 1e9;
/// The ground.
const WORLD: &str = "world";
/// The gravity that readers of URDF have, m/s².
const GRAVITY: [f64; 2] = [0.0, -9.81];

pub(super) fn text(export: &Export, file: &str, notices: &mut Notices) -> String {
    let mechanism = export.mechanism;
    let drives = drives(export, notices);
    tell(export, &drives, notices);
    let poses = export.tree.zero(mechanism, &export.pairs);
    let writer = Writer { export, posed: Posed { mechanism, poses: &poses } };
    let mut tags = Tags::default();
    tags.comment(&Export::comment(file, " It is drawn with all joints at zero."));
    tags.open("robot", &[("name", mechanism.name.clone())]);
    tags.empty("link", &[("name", WORLD.to_owned())]);
    for link in &export.tree.links {
        writer.link(link, &mut tags);
    }
    for link in &export.tree.links {
        writer.joints(link, &drives, &mut tags);
    }
    for Drive { name, joint, law, .. } in &drives {
        let Law::Motor(InputTerm { factor, .. }) = law else { continue };
        tags.element("transmission", &[("name", format!("{name}_transmission"))], |tags| {
            tags.with_text("type", "transmission_interface/SimpleTransmission");
            tags.empty("joint", &[("name", (*joint).to_owned())]);
            let actuator = [("name", name.clone())];
            tags.element("actuator", &actuator, |tags| {
                tags.with_text("mechanicalReduction", &exact(*factor));
            });
        });
    }
    tags.close("robot");
    tags.text
}

/// The greatest force or torque of the drive of a joint; none of a joint without.
fn effort(joint: &Joint, drives: &[Drive]) -> Option<f64> {
    let drive = drives.iter().find(|drive| drive.joint == joint.name)?;
    let Law::Motor(InputTerm { factor, range, .. }) = drive.law else { return None };
    Some(range.map_or(UNBOUNDED, |[_, high]| (factor * high).abs()))
}

/// Reports features that URDF does not have.
fn tell(export: &Export, drives: &[Drive], notices: &mut Notices) {
    let mechanism = export.mechanism;
    for drive in drives {
        let why = match drive.law {
            Law::Servo(_) => "is a servo, and URDF has motors alone",
            Law::Motor(InputTerm { range: Some([low, high]), .. }) if (low + high).abs() > 1e-12 * high => {
                "has other bounds on both sides, where URDF has one effort"
            }
            Law::Motor(_) => continue,
        };
        notices.error(&(export.place)(drive.span), format!("the drive of `{}` {why}", drive.joint));
    }
    for coupling in export.couplings.iter().filter(|coupling| coupling.of.is_none()) {
        let row = &mechanism.parts[coupling.part];
        let joint = &export.pairs[coupling.pair].name;
        notices.error(
            &(export.place)(row.span),
            format!("`{}` holds `{joint}`, which URDF does not have", row.name),
        );
    }
    for pair in export.tree.loops.iter().map(|k| &export.pairs[*k]) {
        notices.error(
            &(export.place)(pair.span),
            format!("`{}` closes a loop, which URDF does not have", pair.name),
        );
    }
    for joint in export.tree.joints(export) {
        let at = (export.place)(joint.span);
        if joint.acting.stiffness != 0.0 {
            notices.error(&at, format!("the spring of `{}` is not written: URDF has none", joint.name));
        }
        if joint.acting.armature != 0.0 {
            notices.error(&at, format!("the rotor of `{}` is not written: URDF has none", joint.name));
        }
        if joint.coordinate.abs() > 1e-9 {
            let start = crate::number::short(joint.coordinate);
            notices.warn(&at, format!("`{}` is drawn at 0 and not at its start, {start}", joint.name));
        }
    }
    if mechanism.gravity.iter().zip(GRAVITY).any(|(own, usual)| (own - usual).abs() > 1e-12) {
        let [x, y] = mechanism.gravity.map(crate::number::short);
        notices.warn(
            &(export.place)(mechanism.span),
            format!("gravity is ({x}, {y}) m/s^2: URDF has none, and readers take (0, -9.81)"),
        );
    }
    for body in mechanism.bodies.iter().filter(|body| body.name == WORLD) {
        notices.error(&(export.place)(body.span), "a body `world` would be the ground of URDF");
    }
}

struct Writer<'a> {
    export: &'a Export<'a>,
    posed: Posed<'a>,
}

/// A box or an inertia at a place in the axes of a link.
fn origin(at: [f64; 3], angle: f64, tags: &mut Tags) {
    let (xyz, rpy) = (unless_zeros(&at), unless_zeros(&[0.0, -angle, 0.0]));
    if !xyz.is_empty() || !rpy.is_empty() {
        tags.empty("origin", &[("xyz", if xyz.is_empty() { "0 0 0".to_owned() } else { xyz }), ("rpy", rpy)]);
    }
}

impl Writer<'_> {
    /// The origin of a link, from G in the axes of its body: the port that its joint has.
    fn frame(&self, link: &Link) -> [f64; 2] {
        let Some((pair, is_second)) = link.pair else { return [0.0; 2] };
        let [x, y, _] = self.posed.port(self.export.pairs[pair].frames[usize::from(is_second)]);
        [x, y]
    }

    /// The origin of the link of a body in the plane; of the ground zero.
    fn origin_of(&self, body: Option<usize>) -> [f64; 2] {
        let link = body.and_then(|body| self.export.tree.links.iter().find(|link| link.body == body));
        link.map_or([0.0; 2], |link| self.posed.point(body, self.frame(link)))
    }

    fn name(&self, body: Option<usize>) -> String {
        body.map_or(WORLD.to_owned(), |body| self.posed.mechanism.bodies[body].name.clone())
    }

    fn link(&self, link: &Link, tags: &mut Tags) {
        let body = &self.posed.mechanism.bodies[link.body];
        let centre = self.frame(link).map(|part| -part);
        let across = exact(body.inertia / 2.0);
        tags.open("link", &[("name", body.name.clone())]);
        tags.element("inertial", &[], |tags| {
            origin(in_file(centre), 0.0, tags);
            tags.empty("mass", &[("value", exact(body.mass.unwrap_or_default()))]);
            let zero = || "0".to_owned();
            tags.empty(
                "inertia",
                &[
                    ("ixx", across.clone()),
                    ("ixy", zero()),
                    ("ixz", zero()),
                    ("iyy", exact(body.inertia)),
                    ("iyz", zero()),
                    ("izz", across),
                ],
            );
        });
        for bar in bars(body) {
            let [length, width, depth] = bar.half.map(|half| 2.0 * half);
            tags.element("visual", &[], |tags| {
                origin(in_file([bar.at[0] + centre[0], bar.at[1] + centre[1]]), bar.angle, tags);
                tags.element("geometry", &[], |tags| {
                    tags.empty("box", &[("size", numbers(&[length, depth, width]))]);
                });
            });
        }
        tags.close("link");
    }

    /// The joints from the parent of a link to it, with the links without mass between two of them.
    fn joints(&self, link: &Link, drives: &[Drive], tags: &mut Tags) {
        let joints = link.joints(&self.export.pairs, self.posed);
        let (parent, child) = (self.name(link.parent), self.name(Some(link.body)));
        let offset = sub(self.origin_of(Some(link.body)), self.origin_of(link.parent));
        let outer = self.posed.pose(link.parent)[2];
        let turn = self.posed.poses[link.body][2] - outer;
        let [x, _, z] = in_file(turned(offset, -outer));
        let depth = |body: Option<usize>| body.map_or(0.0, |body| self.posed.mechanism.bodies[body].depth);
        let at = [x, depth(link.parent) - depth(Some(link.body)), z];
        let held = |name: &str, kind: &str, tags: &mut Tags| {
            tags.element("joint", &[("name", name.to_owned()), ("type", kind.to_owned())], |tags| {
                ends(&parent, &child, tags);
                origin(at, turn, tags);
            });
        };
        match (link.pair, &joints[..]) {
            (None, _) => held(&format!("{child}_free"), "floating", tags),
            (Some((pair, _)), []) => held(&self.export.pairs[pair].name, "fixed", tags),
            (_, [only]) => self.joint(only, [&parent, &child], (at, turn), effort(only, drives), link, tags),
            (_, [first, second, ..]) => {
                let carriage = format!("{}_carriage", first.label);
                tags.empty("link", &[("name", carriage.clone())]);
                self.joint(first, [&parent, &carriage], (at, turn), effort(first, drives), link, tags);
                self.joint(second, [&carriage, &child], ([0.0; 3], 0.0), effort(second, drives), link, tags);
            }
        }
    }

    /// Joint that a joint follows: `q = multiplier q_of + offset`.
    fn mimic(&self, joint: &Joint, tags: &mut Tags) {
        let Export { pairs, couplings, .. } = self.export;
        let followed = couplings.iter().find(|coupling| pairs[coupling.pair].name == joint.name);
        let Some((of, ratio)) = followed.and_then(|coupling| coupling.of) else { return };
        let at_start = |name: &str| {
            let joints = self.export.tree.joints(self.export);
            joints.iter().find(|own| own.name == name).map_or(0.0, |own| own.coordinate)
        };
        let offset = at_start(&joint.name) - ratio * at_start(&pairs[of].name);
        tags.empty(
            "mimic",
            &[("joint", pairs[of].name.clone()), ("multiplier", exact(ratio)), ("offset", exact(offset))],
        );
    }

    fn joint(
        &self,
        joint: &Joint,
        [parent, child]: [&str; 2],
        (at, turn): ([f64; 3], f64),
        effort: Option<f64>,
        link: &Link,
        tags: &mut Tags,
    ) {
        let acting = joint.acting;
        let has_limits = acting.lower.is_some() || acting.upper.is_some();
        let (kind, axis) = match joint.motion {
            Motion::Hinge { sign } => (if has_limits { "revolute" } else { "continuous" }, [0.0, -sign, 0.0]),
            Motion::Slide { along } => ("prismatic", in_file(turned(along, -self.posed.poses[link.body][2]))),
        };
        tags.element("joint", &[("name", joint.name.clone()), ("type", kind.to_owned())], |tags| {
            ends(parent, child, tags);
            origin(at, turn, tags);
            tags.empty("axis", &[("xyz", numbers(&axis))]);
            if kind != "continuous" || effort.is_some() {
                let bound = |limit: Option<f64>, usual: f64| {
                    if kind == "continuous" { String::new() } else { exact(limit.unwrap_or(usual)) }
                };
                tags.empty(
                    "limit",
                    &[
                        ("lower", bound(acting.lower, -UNBOUNDED)),
                        ("upper", bound(acting.upper, UNBOUNDED)),
                        ("effort", exact(effort.unwrap_or_default())),
                        ("velocity", exact(UNBOUNDED)),
                    ],
                );
            }
            if acting.damping != 0.0 || acting.friction != 0.0 {
                let dynamics = [("damping", exact(acting.damping)), ("friction", exact(acting.friction))];
                tags.empty("dynamics", &dynamics);
            }
            self.mimic(joint, tags);
        });
    }
}

fn ends(parent: &str, child: &str, tags: &mut Tags) {
    tags.empty("parent", &[("link", parent.to_owned())]);
    tags.empty("child", &[("link", child.to_owned())]);
}
